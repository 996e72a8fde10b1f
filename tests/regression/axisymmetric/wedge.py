#!/usr/bin/env python3
"""Writes a capsule on the axis of a round tube, a wedge of it, with Stokes flow unless said; tube's diameter, mean velocity, viscosity 1

    wedge.py CASE [key=value ...]

axis=XY      directions of the axis and away from it: xy, yz, zx, xz, yx or zy
shift=A,R,C  the case's origin: along the axis, the second coordinate of the axis, across the wedge
half=TAN     tangent of half the angle of the wedge (0.01)
cells=N      across the diameter (16), the length
length=L     of the tube (2), N L cells
ends=open    or periodic
drive=TEXT   of a periodic tube, constant/drivingForce with vectors as A (type meanVelocity; velocity 1;)
flow=U       mean velocity at the inlet (1); 0 without
centre=X     of the capsule (0.8)
shape=TEXT   (type ellipsoid; semiAxes (0.3 0.36);)
law=TEXT     (type neoHookean; form incompressible; shearModulus 8;)
bending=TEXT (type Helfrich; bendingModulus 2e-3;)
ratio=R      viscosity inside over outside (5)
rho=R        density (1)
ddt=SCHEME   of U (steadyState)
solver=NAME  of the flow (direct); linear=Krylov: of its sweeps, with fewer messages between ranks than multigrid
tolerance=T  of the flow (1e-11), coupling=TEXT of the membrane
functions=TEXT  beside the measures
moved=X      the capsule starts that much further along a periodic tube
deltaT=T     (0.02), end=T (0.1), write=T (the end)

    wedge.py -compare A B

prints the largest difference of two such runs, each put back where the first lies: points and velocities of the capsule over
their largest distance and velocity, the measures, and the pressure's extremes over its range or, of capsules that are moved,
its ranges."""

import json
import math
import os
import sys

HEADER = 'FoamFile { version 2.0; format ascii; class %s; object %s; }\n'
LINEAR = {
    'GAMG': ('solver GAMG; smoother symGaussSeidel;', 'solver GAMG; smoother GaussSeidel;'),
    'Krylov': ('solver PBiCGStab; preconditioner diagonal;', 'solver PCG; preconditioner DIC;')}
DEFAULTS = {
    'axis': 'xy', 'shift': '0,0,0', 'half': '0.01', 'cells': '16', 'length': '2', 'ends': 'open',
    'drive': 'type meanVelocity; velocity 1;', 'flow': '1', 'centre': '0.8', 'shape': 'type ellipsoid; semiAxes (0.3 0.36);',
    'law': 'type neoHookean; form incompressible; shearModulus 8;', 'bending': 'type Helfrich; bendingModulus 2e-3;',
    'ratio': '5', 'rho': '1', 'ddt': 'steadyState', 'solver': 'direct', 'linear': 'GAMG', 'tolerance': '1e-11',
    'coupling': 'type quasiNewton; stressTolerance 1e-9; displacementTolerance 1e-10;', 'functions': '', 'moved': '0', 'deltaT': '0.02',
    'end': '0.1', 'write': ''}


class Place:
    """Takes points of the tube, (along the axis, away from it, across the wedge), to where the case lies"""

    def __init__(self, axis, shift):
        self.first, self.second = ['xyz'.index(c) for c in axis]
        self.across = 3 - self.first - self.second
        # A rotation: where the order of the directions is not cyclic, across is turned round
        self.sign = 1 if (self.second - self.first) % 3 == 1 else -1
        self.shift = shift

    def vector(self, a, r, c=0):
        v = [0, 0, 0]
        v[self.first], v[self.second], v[self.across] = a, r, self.sign*c
        return v

    def point(self, a, r, c=0):
        return [x + s for x, s in zip(self.vector(a, r, c), self.vector(*self.shift))]

    def unvector(self, v):
        return v[self.first], v[self.second]

    def unpoint(self, x):
        a, r = self.unvector(x)
        return a - self.shift[0], r - self.shift[1]


def text(values):
    return '(' + ' '.join('%.17g' % v for v in values) + ')'


def write(case, name, kind, content):
    path = os.path.join(case, name)
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, 'w') as f:
        f.write(HEADER % (kind, os.path.basename(name)) + content)


def parabola(n):
    """The profile 2 (1 - r^2) at the centres of n faces of the inlet, over its mean there, and twice one over the mean"""
    edges = [i/n for i in range(n + 1)]
    areas = [b**2 - a**2 for a, b in zip(edges, edges[1:])]
    centres = [2/3*(b**3 - a**3)/area for a, b, area in zip(edges, edges[1:], areas)]
    mean = sum(2*(1 - r**2)*area for r, area in zip(centres, areas))
    return [2*(1 - r**2)/mean for r in centres], 2/mean


def make(case, options):
    given = dict(a.split('=', 1) for a in options)
    assert not set(given) - set(DEFAULTS), given
    o = dict(DEFAULTS, **given)
    place = Place(o['axis'], [float(x) for x in o['shift'].split(',')])
    length, cells, half = float(o['length']), int(o['cells']), 0.5*float(o['half'])
    ends = ['inlet { type %s; faces ((0 3 5 0)); }', 'outlet { type %s; faces ((1 2 4 1)); }']
    periodic = o['ends'] == 'periodic'
    for i, other in enumerate(('outlet', 'inlet')):
        ends[i] %= 'cyclic; neighbourPatch ' + other if periodic else 'patch'
    vertices = [(0, 0, 0), (length, 0, 0), (length, 0.5, -half), (0, 0.5, -half), (length, 0.5, half), (0, 0.5, half)]
    write(case, 'system/blockMeshDict', 'dictionary', '''scale 1;
vertices (%s);
blocks (hex (0 1 2 3 0 1 4 5) (%d %d 1) simpleGrading (1 1 1)); edges ();
boundary ( %s walls { type wall; faces ((3 2 4 5)); } back { type wedge; faces ((0 3 2 1)); } front { type wedge; faces ((0 1 4 5)); } axis { type empty; faces ((0 1 1 0)); } );
''' % (' '.join(text(place.point(*v)) for v in vertices), round(length*cells), cells//2, ' '.join(ends)))
    write(case, 'system/controlDict', 'dictionary', '''application capsuleFoam; startFrom latestTime; startTime 0; stopAt endTime;
endTime %s;
deltaT %s;
writeControl runTime; writeInterval %s; writeFormat ascii; writePrecision 17; timePrecision 10;
functions { measures { type membraneMeasures; libs (capsule); lines true; writeControl timeStep; writePrecision 16; } %s }
''' % (o['end'], o['deltaT'], o['write'] or o['end'], o['functions']))
    write(case, 'system/fvSchemes', 'dictionary', '''ddtSchemes { default backward; ddt(U) %s; }
gradSchemes { default Gauss linear; } divSchemes { default Gauss linear; } laplacianSchemes { default Gauss linear orthogonal; }
interpolationSchemes { default linear; } snGradSchemes { default orthogonal; }
''' % o['ddt'])
    write(case, 'system/fvSolution', 'dictionary', '''solvers { U { %s tolerance 0; relTol 0.05; } p { %s tolerance 0; relTol 0.05; } }
capsuleFoam { flow { solver %s; tolerance %s; maxIter 300; pRefPoint %s; pRefValue 0; } }
''' % (*LINEAR[o['linear']], o['solver'], o['tolerance'], text(place.point(length - 0.3/cells, 0.5 - 0.3/cells))))
    write(case, 'constant/membraneProperties', 'dictionary', '''membranes
{
    capsule
    {
        viscosity %s;
        shape { %s centre %s; }
        elasticLaw { %s }
        bending { %s }
    }
}
coupling { %s }
''' % (o['ratio'], o['shape'], text(place.point(float(o['centre']) + float(o['moved']), 0)), o['law'], o['bending'], o['coupling']))
    write(case, 'constant/transportProperties', 'dictionary', 'rho %s;\nmu 1;\n' % o['rho'])
    if periodic:
        # The number before each semicolon is along the axis
        words = []
        for word in o['drive'].split():
            number = word.rstrip(';')
            try:
                words.append(text(place.vector(float(number), 0)) + ';')
            except ValueError:
                words.append(word)
        write(case, 'constant/drivingForce', 'dictionary', ' '.join(words) + '\n')
    x = 'xyz'
    profile = ['0', '0', '0']
    velocities, most = parabola(cells//2)
    profile[place.first] = '%.17g*(1 - 4*sqr(pos().%s() - %.17g))' % (float(o['flow'])*most, x[place.second], place.shift[1])
    # The outlet starts from the profile, too
    start = ' '.join(text(place.vector(float(o['flow'])*v, 0)) for v in velocities for _ in range(round(length*cells)))
    if periodic:
        U = p = '"(inlet|outlet)" { type cyclic; }'
    else:
        U = '''inlet { type exprFixedValue; value uniform (0 0 0); valueExpr "vector(%s)"; }
    outlet { type extrapolatedOutlet; value uniform (0 0 0); }''' % ', '.join(profile)
        p = '"(inlet|outlet)" { type zeroGradient; }'
    wedges = '"(front|back)" { type wedge; }'
    write(case, '0/U', 'volVectorField', '''dimensions [0 1 -1 0 0 0 0];
internalField nonuniform List<vector>
%d
(%s)
;
boundaryField
{
    %s
    walls { type noSlip; } %s
}
''' % (round(length*cells)*(cells//2), start, U, wedges))
    write(case, '0/p', 'volScalarField', '''dimensions [1 -1 -2 0 0 0 0];
internalField uniform 0;
boundaryField { %s walls { type zeroGradient; } %s }
''' % (p, wedges))
    with open(os.path.join(case, 'place'), 'w') as f:
        json.dump({'axis': o['axis'], 'shift': place.shift, 'moved': float(o['moved']), 'end': o['end']}, f)


def lists(path, names):
    """The lists of vectors or numbers that entries of a file hold, of each the first"""
    with open(path) as f:
        content = f.read()
    found = []
    for name in names:
        start = content.index('(', content.index(name) + len(name)) + 1
        words = content[start:content.index(';', start)].replace('(', ' ').replace(')', ' ').split()
        found.append([float(w) for w in words])
    return found


def run(case):
    """Points, velocities, measures, extremes of the pressure, and how far the capsule was moved"""
    with open(os.path.join(case, 'place')) as f:
        p = json.load(f)
    place = Place(p['axis'], [p['shift'][0] + p['moved'], *p['shift'][1:]])
    x, u = lists(os.path.join(case, p['end'], 'uniform/membranes/capsule'), ['points', 'velocity'])
    points, velocities = [[g(a[i:i + 3]) for i in range(0, len(a), 3)] for a, g in ((x, place.unpoint), (u, place.unvector))]
    with open(os.path.join(case, 'postProcessing/measures/0/capsule.dat')) as f:
        row = [float(w) for w in f.readlines()[-1].split()]
    assert len(row) == 19, row
    row[1] -= place.shift[0]
    pressure = lists(os.path.join(case, p['end'], 'p'), ['internalField'])[0]
    return points, velocities, row[1:], [min(pressure), max(pressure)], p['moved']


def largest(a, b):
    assert len(a) == len(b) > 0
    return max(math.dist(p, q) for p, q in zip(a, b))


def span(pressures):
    return pressures[1] - pressures[0]


def compare(a, b):
    (xA, uA, mA, pA, movedA), (xB, uB, mB, pB, movedB) = run(a), run(b)
    middle = [sum(c)/len(c) for c in zip(*xA)]
    found = [
        largest(xA, xB)/max(math.dist(x, middle) for x in xA),
        largest(uA, uB)/max(math.hypot(*u) for u in uA),
        max(abs(p - q)/max(abs(p), 1e-6) for p, q in zip(mA, mB)),
        abs(span(pA) - span(pB))/span(pA) if movedA != movedB else max(abs(p - q) for p, q in zip(pA, pB))/span(pA)]
    print('%.3e' % max(found), *('%.1e' % f for f in found))


if sys.argv[1] == '-compare':
    compare(*sys.argv[2:])
else:
    make(sys.argv[1], sys.argv[2:])
