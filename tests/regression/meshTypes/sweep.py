#!/usr/bin/env python3
"""Meshes as users bring them: each runs, or is refused before the first step with a word on what is permitted.

    sweep.py CASE WORK [-only WORD]

CASE is a channel of 2 x 1 with a cell in it, WORK a folder for the runs. Each mesh below says what is expected: 'runs' (End, all steps
converged), or words that the error has. What runs and stands for the channel itself must give the channel's own answer."""

import concurrent.futures
import math
import os
import re
import resource
import shutil
import subprocess
import sys

BOUNDARY = '''inlet { type patch; faces (%s); } outlet { type patch; faces (%s); } walls { type wall; faces (%s); }
    frontAndBack { type empty; faces (%s); }'''


def mesh(vertices, blocks, boundary, extra=''):
    return 'FoamFile { version 2.0; format ascii; class dictionary; object blockMeshDict; }\nvertices (%s);\nblocks (%s);\nedges ();\nboundary (%s);\n%s\n' % (
        ' '.join('(%.17g %.17g %.17g)' % v for v in vertices), ' '.join(blocks), boundary, extra)


def channel(cells=(32, 16, 1), grading='simpleGrading (1 1 1)', place=lambda x, y, z: (x, y, z), patches=None, depth=0.1):
    corners = [place(x, y, z) for z in (0, depth) for x, y in ((0, 0), (2, 0), (2, 1), (0, 1))]
    faces = ('(0 4 7 3)', '(1 2 6 5)', '(0 1 5 4) (3 7 6 2)', '(0 3 2 1) (4 5 6 7)')
    return mesh(corners, ['hex (0 1 2 3 4 5 6 7) (%d %d %d) %s' % (*cells, grading)], (patches or BOUNDARY) % faces)


def grid(xs, ys, holes, cells, names):
    """Blocks between lines, but for holes; the faces at their ends by the names that a function gives to a face's middle"""
    nx, ny = len(xs), len(ys)
    vertices = [(x, y, z) for z in (0, 0.1) for y in ys for x in xs]
    at = lambda i, j, k: (k*ny + j)*nx + i
    blocks, sides, flat = [], {}, []
    for j in range(ny - 1):
        for i in range(nx - 1):
            if (i, j) in holes:
                continue
            low, high = [[at(i, j, k), at(i + 1, j, k), at(i + 1, j + 1, k), at(i, j + 1, k)] for k in (0, 1)]
            blocks.append('hex (%s) (%d %d 1) simpleGrading (1 1 1)' % (' '.join(map(str, low + high)), cells[0][i], cells[1][j]))
            flat += [low[::-1], high]
            for a, b, other in ((0, 1, (i, j - 1)), (1, 2, (i + 1, j)), (2, 3, (i, j + 1)), (3, 0, (i - 1, j))):
                inside = 0 <= other[0] < nx - 1 and 0 <= other[1] < ny - 1 and other not in holes
                if not inside:
                    middle = [0.5*(vertices[low[a]][c] + vertices[low[b]][c]) for c in (0, 1)]
                    sides.setdefault(names(*middle), []).append([low[a], low[b], high[b], high[a]])
    show = lambda faces: ' '.join('(%s)' % ' '.join(map(str, f)) for f in faces)
    return mesh(vertices, blocks, BOUNDARY % tuple(show(s) for s in (sides['inlet'], sides['outlet'], sides.get('walls', []), flat)))


def ends(x, y):
    return 'inlet' if x == 0 else 'outlet' if x == 2 else 'walls'


def turned(degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return lambda x, y, z: (c*x - s*y, s*x + c*y, z)


# Name, blockMeshDict, what is expected; changes: centre of the cell, turn of centre and inflow, inflow, commands after blockMesh
MESHES = [
    ('plain', channel(), 'runs', {}),
    ('finer along', channel((64, 16, 1)), 'runs', {}),
    ('cells 2 to 1', channel((32, 32, 1)), 'runs', {}),
    ('cells 3 to 1', channel((24, 36, 1)), 'runs', {}),
    ('cells 5 to 1', channel((16, 40, 1)), 'orthogonal|times as long|hexahedra', {}),
    ('graded along', channel((32, 16, 1), 'simpleGrading (3 1 1)'), 'runs', {}),
    ('graded across', channel((32, 24, 1), 'simpleGrading (1 ((0.5 0.5 2) (0.5 0.5 0.5)) 1)'), 'runs', {}),
    ('thin slab', channel(depth=1e-6), 'runs', {}),
    ('thick slab', channel(depth=50), 'runs', {}),
    ('in the plane x z', channel(place=lambda x, y, z: (x, -z, y)), 'runs', {'turn': lambda v: (v[0], 0, v[1])}),
    ('in the plane y z', channel(place=lambda x, y, z: (z, x, y)), 'runs', {'turn': lambda v: (0, v[0], v[1])}),
    ('turned by 30 degrees', channel(place=turned(30)), 'runs', {'turn': lambda v: turned(30)(v[0], v[1], 0)}),
    ('three dimensions, plane shape', channel((16, 8, 8), patches=BOUNDARY.replace('empty', 'wall')), 'angle.*permitted.*axis', {'front': 'zeroGradient'}),
    ('two cells across the plane', channel((32, 16, 2)), 'one cell', {}),
    ('one-dimensional', channel((32, 1, 1)), 'cells across|two-dimensional|closer|touches', {}),
    ('skewed', channel(place=lambda x, y, z: (x + 0.4*y, y, z)), 'orthogonal', {'centre': (1.1, 0.5)}),
    ('skewed far from the cell', mesh(
        [(x, y, z) for z in (0, 0.1) for x, y in ((0, 0), (1.4, 0), (2, 0), (2.3, 1), (1.4, 1), (0, 1))],
        ['hex (0 1 4 5 6 7 10 11) (22 16 1) simpleGrading (1 1 1)', 'hex (1 2 3 4 7 8 9 10) (10 16 1) simpleGrading (1 1 1)'],
        BOUNDARY % ('(0 6 11 5)', '(2 3 9 8)', '(0 1 7 6) (1 2 8 7) (3 4 10 9) (4 5 11 10)', '(0 5 4 1) (1 4 3 2) (6 7 10 11) (7 8 9 10)')),
        'runs', {}),
    ('bent, cell inside', grid([0, 1, 2], [0, 1, 2], [(1, 1)], ([16, 16], [16, 16]),
        lambda x, y: 'inlet' if y == 2 else 'outlet' if x == 2 else 'walls'), 'runs', {'centre': (0.5, 1.2), 'flow': '(0 -1 0)'}),
    ('bent, cell outside', grid([0, 1, 2], [0, 1, 2], [(1, 1)], ([16, 16], [16, 16]),
        lambda x, y: 'inlet' if y == 2 else 'outlet' if x == 2 else 'walls'), 'cell .*outside', {'centre': (1.5, 1.5), 'flow': '(0 -1 0)'}),
    ('hole, cell in it', grid([0, 0.4, 1.2, 2], [0, 0.1, 0.9, 1], [(1, 1)], ([8, 16, 16], [2, 16, 2]), ends), 'cell ', {}),
    ('hole, cell around it', grid([0, 0.75, 0.85, 2], [0, 0.45, 0.55, 1], [(1, 1)], ([12, 2, 18], [7, 2, 7]), ends), 'cell ', {}),
    ('post beside the cell', grid([0, 1.3, 1.4, 2], [0, 0.45, 0.55, 1], [(1, 1)], ([21, 2, 10], [7, 2, 7]), ends), 'runs', {'centre': (0.9, 0.5)}),
    ('throat beside the cell', grid([0, 1.2, 1.5, 2], [0, 0.25, 0.75, 1], [(1, 0), (1, 2)], ([19, 5, 8], [4, 8, 4]), ends), 'runs', {'centre': (0.7, 0.5)}),
    ('renumbered', channel(), 'runs', {'after': ['renumberMesh -overwrite']}),
]


def prepare(case, target, dict_, changes):
    shutil.copytree(case, target)
    with open(os.path.join(target, 'system/blockMeshDict'), 'w') as f:
        f.write(dict_)
    turn = changes.get('turn', lambda v: (v[0], v[1], 0))
    path = os.path.join(target, 'constant/membraneProperties')
    with open(path) as f:
        text = f.read()
    centre = turn(changes.get('centre', (0.8, 0.5)))
    with open(path, 'w') as f:
        f.write(re.sub(r'centre .*;', 'centre (%s);' % ' '.join('%.17g' % c for c in centre), text))
    path = os.path.join(target, '0/U')
    with open(path) as f:
        text = f.read()
    with open(path, 'w') as f:
        flow = changes.get('flow', '(%s)' % ' '.join('%.17g' % c for c in turn((1, 0))))
        f.write(text.replace('(1 0 0)', flow))
    for field in 'Up' if 'front' in changes else '':
        path = os.path.join(target, '0', field)
        with open(path) as f:
            text = f.read()
        with open(path, 'w') as f:
            f.write(re.sub(r'empty;', changes['front'] + ';', text))


def run(case, target, dict_, changes):
    prepare(case, target, dict_, changes)
    env = dict(os.environ, PWD=os.path.abspath(target))
    log = ''
    for command in ['blockMesh', *changes.get('after', []), 'capsuleFoam']:
        done = subprocess.run(command, shell=True, cwd=target, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, env=env,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (60, 60)))
        log = done.stdout.decode('latin-1')
        if command != 'capsuleFoam' and done.returncode != 0:
            return '%s fails' % command, log
    if done.returncode < 0 or done.returncode >= 128 or 'sigFpe::' in log or 'sigSegv::' in log:
        return 'signal %d' % done.returncode, log
    if 'FOAM FATAL' in log:
        message = log[log.index('FOAM FATAL'):]
        return ('stops in the run: ' if re.search('^Time = ', log, re.M) else 'refused: ') + message, log
    if done.returncode != 0 or not re.search('^End', log, re.M):
        return 'no End', log
    if re.search('NOT converged|above the tolerance', log):
        return 'not solved', log
    return 'runs', log


def measures(target):
    with open(os.path.join(target, 'postProcessing/measures/0/cell.dat')) as f:
        return [float(w) for w in f.readlines()[-1].split()]


def main():
    case, work = sys.argv[1:3]
    only = sys.argv[sys.argv.index('-only') + 1] if '-only' in sys.argv else ''
    shutil.rmtree(work, ignore_errors=True)
    os.makedirs(work)
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        tried = [m for m in MESHES if only in m[0]]
        for m, (outcome, log) in zip(tried, pool.map(lambda m: run(case, os.path.join(work, m[0].replace(' ', '_')), m[1], m[3]), tried)):
            name, expected = m[0], m[2]
            good = outcome == 'runs' if expected == 'runs' else \
                (outcome.startswith('refused') and re.search(expected, outcome, re.S)) or (expected.startswith('runs|') and outcome == 'runs')
            print('%s mesh, %s: %s' % ('PASS' if good else 'FAIL', name, expected if expected == 'runs' and good else 'refused' if good and outcome != 'runs' else outcome[:300]))


main()
