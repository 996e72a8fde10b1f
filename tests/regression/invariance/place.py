#!/usr/bin/env python3
"""Writes a case that lies elsewhere: a cell in a channel, shifted, turned or mirrored as a whole

    place.py CASE [key=value ...]

shift=X,Y    the case's origin
turn=DEGREES anticlockwise
mirror=1     about the channel's axis, before it is turned
ratio=R      viscosity inside over outside (5)
rho=R        density (1): the Reynolds number with mean velocity and height 1
centre=X,Y   of the cell in the channel (1.2,0.05): off the axis, so that it also turns
ddt=SCHEME   of U (backward)
solver=NAME  of the flow (direct)
end=T        of the run (0.1), five steps

    place.py -compare A B

prints the largest difference of two such runs, each put back where the first lies: points and velocities of the cell over
their largest distance and velocity, energy and Taylor deformation, and the extremes of the pressure over its range."""

import json
import math
import os
import sys

HEADER = 'FoamFile { version 2.0; format ascii; class %s; object %s; }\n'
LENGTH, CELLS = 2.4, 20


class Place:
    """Takes points and vectors of the channel, which starts at the origin along x, to where the case lies"""

    def __init__(self, shift, turn, mirror):
        self.shift, self.angle, self.sign = shift, math.radians(turn), -1 if mirror else 1
        # Exact at right angles
        self.cos, self.sin = [round(f(self.angle), 15) for f in (math.cos, math.sin)]

    def vector(self, x, y):
        y *= self.sign
        return self.cos*x - self.sin*y, self.sin*x + self.cos*y

    def point(self, x, y):
        u, v = self.vector(x, y)
        return u + self.shift[0], v + self.shift[1]

    def unvector(self, u, v):
        return self.cos*u + self.sin*v, self.sign*(self.cos*v - self.sin*u)

    def unpoint(self, u, v):
        return self.unvector(u - self.shift[0], v - self.shift[1])


def write(case, name, kind, text):
    path = os.path.join(case, name)
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, 'w') as f:
        f.write(HEADER % (kind, os.path.basename(name)) + text)


def make(case, options):
    o = dict({'shift': '0,0', 'turn': '0', 'mirror': '0', 'ratio': '5', 'rho': '1', 'centre': '1.2,0.05', 'ddt': 'backward',
              'solver': 'direct', 'end': '0.1'}, **dict(a.split('=') for a in options))
    shift = [float(x) for x in o['shift'].split(',')]
    place = Place(shift, float(o['turn']), int(o['mirror']))
    number = '%.17g'

    def point(x, y, z):
        return '(' + ' '.join(number % c for c in (*place.point(x, y), z)) + ')'

    corners = [(0, -0.5), (LENGTH, -0.5), (LENGTH, 0.5), (0, 0.5)]
    # A mirrored block is right-handed with front and back exchanged
    depths = (0.1, 0) if int(o['mirror']) else (0, 0.1)
    vertices = ' '.join(point(x, y, z) for z in depths for x, y in corners)
    write(case, 'system/blockMeshDict', 'dictionary', '''scale 1;
vertices (%s);
blocks (hex (0 1 2 3 4 5 6 7) (%d %d 1) simpleGrading (1 1 1)); edges ();
boundary ( inlet { type patch; faces ((0 4 7 3)); } outlet { type patch; faces ((1 2 6 5)); } walls { type wall; faces ((0 1 5 4) (3 7 6 2)); } frontAndBack { type empty; faces ((0 3 2 1) (4 5 6 7)); } );
''' % (vertices, round(LENGTH*CELLS), CELLS))
    write(case, 'system/controlDict', 'dictionary', '''application capsuleFoam; startFrom startTime; startTime 0; stopAt endTime; endTime %s; deltaT 0.02;
writeControl runTime; writeInterval %s; writeFormat ascii; writePrecision 17; timePrecision 10;
functions { measures { type membraneMeasures; libs (capsule); writeControl timeStep; } }
''' % (o['end'], o['end']))
    write(case, 'system/fvSchemes', 'dictionary', '''ddtSchemes { default backward; ddt(U) %s; }
gradSchemes { default Gauss linear; } divSchemes { default Gauss linear; } laplacianSchemes { default Gauss linear orthogonal; }
interpolationSchemes { default linear; } snGradSchemes { default orthogonal; }
''' % o['ddt'])
    write(case, 'system/fvSolution', 'dictionary', '''solvers { U { solver GAMG; smoother symGaussSeidel; tolerance 0; relTol 0.05; } p { solver GAMG; smoother GaussSeidel; tolerance 0; relTol 0.05; } }
capsuleFoam { flow { solver %s; tolerance 1e-11; pRefPoint %s; pRefValue 0; } }
''' % (o['solver'], point(LENGTH - 0.01, 0.45, 0.05)))
    ratio = float(o['ratio'])
    # A cell that is its own mirror image but for its angle
    write(case, 'constant/membraneProperties', 'dictionary', '''membranes { cell { viscosity %s;
    shape { type biconcave; centre %s; angle %s; radius 0.2333; }
    elasticLaw { type neoHookean; shearModulus 4; } bending { type Helfrich; bendingModulus 1e-3; } } }
coupling { type quasiNewton; stressTolerance 1e-9; displacementTolerance 1e-10; failedStep stop; }
''' % (number % ratio, point(*[float(x) for x in o['centre'].split(',')], 0.05), number % (math.degrees(place.angle) + place.sign*15)))
    write(case, 'constant/transportProperties', 'dictionary', 'rho %s; mu 1;\n' % o['rho'])
    # A shear flow through: uniform inlet, the walls move with different velocities
    uniform = '(' + ' '.join(number % c for c in place.vector(1, 0)) + ' 0)'
    write(case, '0/U', 'volVectorField', '''dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0);
boundaryField { inlet { type fixedValue; value uniform %s; } outlet { type zeroGradient; } walls { type noSlip; } frontAndBack { type empty; } }
''' % uniform)
    write(case, '0/p', 'volScalarField', '''dimensions [1 -1 -2 0 0 0 0]; internalField uniform 0;
boundaryField { inlet { type zeroGradient; } outlet { type fixedValue; value uniform 0; } walls { type zeroGradient; } frontAndBack { type empty; } }
''')
    with open(os.path.join(case, 'place'), 'w') as f:
        json.dump({'shift': shift, 'turn': float(o['turn']), 'mirror': int(o['mirror']), 'end': o['end']}, f)


def lists(path, names):
    """The lists of vectors or numbers that entries of a file hold, of each the first"""
    with open(path) as f:
        text = f.read()
    found = []
    for name in names:
        start = text.index('(', text.index(name) + len(name)) + 1
        words = text[start:text.index(';', start)].replace('(', ' ').replace(')', ' ').split()
        found.append([float(w) for w in words])
    return found


def run(case):
    """Points, velocities, measures that do not depend on the place, extremes of the pressure"""
    with open(os.path.join(case, 'place')) as f:
        p = json.load(f)
    place = Place(p['shift'], p['turn'], p['mirror'])
    x, u = lists(os.path.join(case, p['end'], 'uniform/membranes/cell'), ['points', 'velocity'])
    pairs = [list(zip(a[::3], a[1::3])) for a in (x, u)]
    points, velocities = [[f(*v) for v in vs] for f, vs in zip((place.unpoint, place.unvector), pairs)]
    if p['mirror']:
        # Anticlockwise still: the same points the other way round, from the first
        points, velocities = [[v[0]] + v[:0:-1] for v in (points, velocities)]
    with open(os.path.join(case, 'postProcessing/measures/0/cell.dat')) as f:
        row = [float(w) for w in f.readlines()[-1].split()]
    pressure = lists(os.path.join(case, p['end'], 'p'), ['internalField'])[0]
    return points, velocities, [row[i] for i in (5, 6, 11, 12)], [min(pressure), max(pressure)]


def largest(a, b):
    assert len(a) == len(b) > 0
    return max(math.dist(p, q) for p, q in zip(a, b))


def compare(a, b):
    (xA, uA, mA, pA), (xB, uB, mB, pB) = run(a), run(b)
    middle = [sum(c)/len(c) for c in zip(*xA)]
    found = [
        largest(xA, xB)/max(math.dist(x, middle) for x in xA),
        largest(uA, uB)/max(math.hypot(*u) for u in uA),
        max(abs(p - q)/abs(p) for p, q in zip(mA, mB)),
        max(abs(p - q) for p, q in zip(pA, pB))/(pA[1] - pA[0])]
    print('%.3e' % max(found), *('%.1e' % f for f in found))


if sys.argv[1] == '-compare':
    compare(*sys.argv[2:])
else:
    make(sys.argv[1], sys.argv[2:])
