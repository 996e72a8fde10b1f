#!/usr/bin/env python3
"""Reads the surface of a membrane, a legacy VTK file, and prints its volume over a given one, less 1

    readSurface.py FILE VOLUME

An error where the file does not hold what it says, or the surface is not closed, every edge seen once each way."""

import math
import sys

words = open(sys.argv[1]).read().split()
assert words[:5] == ['#', 'vtk', 'DataFile', 'Version', '2.0'], words[:5]
at = words.index('DATASET')
assert words[at - 1] == 'ASCII' and words[at + 1] == 'POLYDATA', words[at - 1:at + 2]


def take(n, kind=float):
    global at
    found = [kind(w) for w in words[at:at + n]]
    at += n
    assert len(found) == n and all(math.isfinite(x) for x in found)
    return found


def keyword(*expected):
    global at
    found = words[at:at + len(expected)]
    assert found == list(expected), (found, expected)
    at += len(expected)


at += 2
keyword('POINTS')
n, = take(1, int)
keyword('float')
x = take(3*n)
points = [x[i:i + 3] for i in range(0, 3*n, 3)]
keyword('POLYGONS')
count, size = take(2, int)
numbers = take(size, int)
polygons = []
i = 0
for _ in range(count):
    polygons.append(numbers[i + 1:i + 1 + numbers[i]])
    i += 1 + numbers[i]
assert i == size and {p for polygon in polygons for p in polygon} == set(range(n))
keyword('POINT_DATA', str(n))
for name in ('velocity', 'force'):
    keyword('VECTORS', name, 'float')
    take(3*n)
for name in ('stretch', 'tension', 'hoopStretch', 'hoopTension', 'curvature'):
    keyword('SCALARS', name, 'float', '1', 'LOOKUP_TABLE', 'default')
    take(n)
assert at == len(words), words[at:at + 5]

edges = [(p[i - 1], p[i]) for p in polygons for i in range(len(p))]
assert len(set(edges)) == len(edges), "an edge twice"
seen = set(edges)
assert all((b, a) in seen for a, b in edges), 'not closed'

origin = points[0]
volume = 0
for p in polygons:
    a = [u - o for u, o in zip(points[p[0]], origin)]
    for j in range(1, len(p) - 1):
        b, c = [[u - o for u, o in zip(points[k], origin)] for k in (p[j], p[j + 1])]
        volume += (a[0]*(b[1]*c[2] - b[2]*c[1]) + a[1]*(b[2]*c[0] - b[0]*c[2]) + a[2]*(b[0]*c[1] - b[1]*c[0]))/6
print('%.3e' % (volume/float(sys.argv[2]) - 1))
