#!/usr/bin/env python3
"""space.py DIR [key=value ...]: a capsule in a box with a linear flow at its boundary, see the defaults; or
space.py -compare A B: largest distance of the points of the last times, each put back, over the capsule's size"""
import os
import re
import sys

DEFAULTS = dict(
    cells=16, size=2.4, periodic='', axes='xyz', shift='0,0,0', centre='0.03,0.05,0.02',
    shape='type ellipsoid; semiAxes (0.55 0.4 0.45);', turn='axis (0.3 0 1); direction (1 0.2 0);',
    law='type neoHookean; form incompressible; shearModulus 4;', bending='type none;', ratio=5, degree='degree 5;', more='',
    flow='vector(k*y, 0, 0)', rate=1, ddt='steadyState', rho=1, deltaT=0.05, end=0.15, write=0.05, tolerance=1e-10,
    coupling='type quasiNewton; stressTolerance 1e-9; displacementTolerance 1e-9; maxIter 60;', functions='', ratios='1 1 1',
    mesh='0,0,0', startTime=0)


def head(kind, name):
    return 'FoamFile { version 2.0; format ascii; class %s; object %s; }\n' % (kind, name)


def write(path, text):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, 'w') as f:
        f.write(text)


def make(case, o):
    # Coordinates of the case (x y z) lie along these directions of the mesh
    place = ['xyz'.index(c) for c in o['axes']]
    shift = [float(v) for v in o['shift'].split(',')]

    def put(v, moved=True):
        r = [0, 0, 0]
        for i in range(3):
            r[place[i]] = v[i]
        return [r[i] + shift[i] for i in range(3)] if moved else r

    mesh = [float(v) for v in o['mesh'].split(',')]

    def text(v):
        return '(%s)' % ' '.join('%.17g' % c for c in v)

    def turned(m):
        return '(%s)' % ' '.join('%.17g' % c for c in put([float(c) for c in m.group(1).split()], False))

    h = o['size']/2
    corner = [(-h, -h, -h), (h, -h, -h), (h, h, -h), (-h, h, -h), (-h, -h, h), (h, -h, h), (h, h, h), (-h, h, h)]
    right = (place in ([0, 1, 2], [1, 2, 0], [2, 0, 1]))
    order = list(range(8)) if right else [4, 5, 6, 7, 0, 1, 2, 3]
    faces = dict(x0=(0, 4, 7, 3), x1=(1, 2, 6, 5), y0=(0, 1, 5, 4), y1=(3, 7, 6, 2), z0=(0, 3, 2, 1), z1=(4, 5, 6, 7))
    patches = []
    for name, f in faces.items():
        other = name[0] + '10'[int(name[1])]
        kind = 'cyclic; neighbourPatch ' + other if name[0] in o['periodic'] else 'patch'
        patches.append('%s { type %s; faces ((%s)); }' % (name, kind, ' '.join(map(str, f if right else f[::-1]))))
    n = int(o['cells'])
    write(case + '/system/blockMeshDict', head('dictionary', 'blockMeshDict')
          + 'vertices (%s);\nblocks (hex (%s) (%d %d %d) simpleGrading (%s));\nboundary (%s);\n'
          % ('\n'.join(text([a + b for a, b in zip(put(c), mesh)]) for c in corner), ' '.join(map(str, order)), n, n, n, o['ratios'], '\n'.join(patches)))

    # The flow, in the coordinates of the case
    names = ['pos().%s()' % c for c in o['axes']]
    variables = ''.join('"%s = %s - (%.17g)" ' % (c, names[i], shift[place[i]]) for i, c in enumerate('xyz'))
    parts = [p.strip() for p in re.match(r'vector\((.*)\)$', o['flow']).group(1).split(',')]
    flow = 'vector(%s)' % ', '.join(put(parts, False))
    u, p = [], []
    for name in faces:
        if name[0] in o['periodic']:
            u.append('%s { type cyclic; }' % name)
            p.append(u[-1])
        else:
            u.append('%s { type exprFixedValue; variables ("k = %s" %s); valueExpr "%s"; value uniform (0 0 0); }'
                     % (name, o['rate'], variables, flow))
            p.append('%s { type zeroGradient; }' % name)
    write(case + '/0/U', head('volVectorField', 'U') + 'dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0);\n'
          'boundaryField { %s }\n' % '\n'.join(u))
    write(case + '/0/p', head('volScalarField', 'p') + 'dimensions [1 -1 -2 0 0 0 0]; internalField uniform 0;\n'
          'boundaryField { %s }\n' % '\n'.join(p))
    centre = put([float(v) for v in o['centre'].split(',')])
    write(case + '/constant/membraneProperties', head('dictionary', 'membraneProperties')
          + 'membranes\n{\n    capsule\n    {\n        viscosity %s;\n        shape { %s centre %s; %s }\n        elasticLaw { %s }\n'
          '        bending { %s }\n        %s %s\n    }\n}\ncoupling { %s }\nstartTime %s;\n'
          % (o['ratio'], o['shape'], text(centre), re.sub(r'\(([^)]*)\)', turned, o['turn']), o['law'], o['bending'], o['degree'], o['more'],
             o['coupling'], o['startTime']))
    write(case + '/constant/transportProperties', head('dictionary', 'transportProperties') + 'rho %s; mu 1;\n' % o['rho'])
    write(case + '/system/controlDict', head('dictionary', 'controlDict')
          + 'application capsuleFoam;\nstartFrom latestTime;\nstartTime 0;\nstopAt endTime;\nendTime %s;\ndeltaT %s;\nwriteControl runTime;\n'
          'writeInterval %s;\nwriteFormat ascii;\nwritePrecision 16;\ntimePrecision 8;\n'
          'functions { measures { type membraneMeasures; libs (capsule); writeControl timeStep; } %s }\n'
          % (o['end'], o['deltaT'], o['write'], o['functions']))
    write(case + '/system/fvSchemes', head('dictionary', 'fvSchemes')
          + 'ddtSchemes { default backward; ddt(U) %s; }\ngradSchemes { default Gauss linear; }\ndivSchemes { default Gauss linear; }\n'
          'laplacianSchemes { default Gauss linear orthogonal; }\ninterpolationSchemes { default linear; }\n'
          'snGradSchemes { default orthogonal; }\n' % o['ddt'])
    write(case + '/system/fvSolution', head('dictionary', 'fvSolution')
          + 'solvers\n{\n    U { solver GAMG; smoother GaussSeidel; tolerance 0; relTol 0.01; minIter 1; maxIter 2; }\n'
          '    p { solver GAMG; smoother GaussSeidel; tolerance 0; relTol 0.01; minIter 1; maxIter 2; }\n}\n'
          'capsuleFoam { flow { solver fractionalStep; tolerance %s; pRefCell 0; pRefValue 0; } }\n' % o['tolerance'])
    write(case + '/put.back', '%s %s %s' % (o['axes'], o['shift'], o['periodic'] and o['size']))


def points(case):
    axes, shift = open(case + '/put.back').read().split()[:2]
    shift = [float(v) for v in shift.split(',')]
    times = [t for t in os.listdir(case) if re.match(r'[0-9.e-]+$', t) and os.path.isdir(case + '/%s/uniform/membranes' % t)]
    text = open('%s/%s/uniform/membranes/capsule' % (case, max(times, key=float))).read()
    found = re.search(r'points\s+(?:List<vector>|nonuniform List<vector>)?\s*\d+\s*\((.*?)\)\s*;', text, re.S).group(1)
    result = []
    for v in re.findall(r'\(([^)]*)\)', found + ')'):
        v = [float(c) for c in v.split()]
        result.append([v['xyz'.index(c)] - shift['xyz'.index(c)] for c in axes])
    return result


if sys.argv[1] == '-compare':
    a, b = points(sys.argv[2]), points(sys.argv[3])
    print('%.3e' % (max(max(abs(p - q) for p, q in zip(x, y)) for x, y in zip(a, b)) if len(a) == len(b) else 1e9))
else:
    options = dict(DEFAULTS)
    for argument in sys.argv[2:]:
        key, _, value = argument.partition('=')
        if key not in options:
            sys.exit('space.py: no option ' + key)
        options[key] = value
    for key in ('size', 'cells'):
        options[key] = float(options[key])
    make(sys.argv[1], options)
