#!/usr/bin/env python3
"""Places the circle of force modes in a square mesh that is turned or has cells that are longer than wide

    mode.py CASE CELLS TURN LONGER RATIO

CASE is a copy of tests/verification/circle; CELLS across the square along the shorter side of the cells; TURN [degrees];
LONGER, the cells' length over their width; RATIO, the viscosity inside over that outside"""

import math
import os
import re
import sys

case, cells, turn, longer, ratio = sys.argv[1], int(sys.argv[2]), *map(float, sys.argv[3:6])
cos, sin = math.cos(math.radians(turn)), math.sin(math.radians(turn))


def turned(x, y):
    return cos*x - sin*y, sin*x + cos*y


def edit(file, *changes):
    path = os.path.join(case, file)
    with open(path) as f:
        text = f.read()
    for pattern, replacement in changes:
        text, n = re.subn(pattern, replacement, text, flags=re.S | re.M)
        assert n == 1, (file, pattern, n)
    with open(path, 'w') as f:
        f.write(text)


corners = [turned(x, y) for x, y in ((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5))]
points = ' '.join('(%.17g %.17g %g)' % (*p, z) for z in (0, 0.1) for p in corners)
edit('system/blockMeshDict', (r'vertices\s*\(.*?\n\);', 'vertices (%s);' % points),
     (r'\(\$cells \$cells 1\)', '(%d %d 1)' % (round(cells/longer), cells)))
edit('system/caseParameters', (r'^cells .*?;', 'cells %d;' % cells), (r'^viscosityIn .*?;', 'viscosityIn %g;' % ratio),
     (r'^centre .*?;', 'centre (%.17g %.17g 0);' % turned(0.013, 0.027)))
edit('system/solution', (r'normal\s.*?;', 'normal 1;'), (r'tangential\s.*?;', 'tangential 0.5;'))
