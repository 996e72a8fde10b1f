#!/usr/bin/env python3
"""What two membranes, or a membrane and the walls of a throat, have between them, from the points of a case at a time

    gap.py pair CASE TIME RANGE STRENGTH    least distance of both curves, and the energy of their contact by the law
    gap.py throat CASE TIME                 least distance of the curve from the walls"""

import cmath
import math
import re
import sys


def points(case, time, name):
    """Points of a membrane"""
    text = open('%s/%s/uniform/membranes/%s' % (case, time, name)).read()
    text = text[text.index('points'):]
    n = int(re.search(r'\n(\d+)', text).group(1))
    found = re.findall(r'\((\S+) (\S+) (\S+)\)', text)[:n]
    return [complex(float(x), float(y)) for x, y, z in found]


def curve(x, finer=8):
    """The trigonometric curve through an odd number of points, with finer points"""
    n = len(x)
    waves = range(-(n//2), n//2 + 1)
    c = [sum(x[j]*cmath.exp(-2j*math.pi*k*j/n) for j in range(n))/n for k in waves]
    return [sum(a*cmath.exp(2j*math.pi*k*i/(n*finer)) for a, k in zip(c, waves)) for i in range(n*finer)]


def between(x, a, b):
    """Distance of a point from the segment a, b"""
    t = ((x - a)*(b - a).conjugate()).real/abs(b - a)**2
    return abs(x - a - min(max(t, 0), 1)*(b - a))


def pair(case, time, reach, strength):
    left, right = (curve(points(case, time, name)) for name in ('left', 'right'))
    gaps = [min(abs(x - y) for y in right) for x in left]
    energy = 0
    for i, g in enumerate(gaps):
        length = 0.5*abs(left[(i + 1) % len(left)] - left[i - 1])
        if g < reach:
            energy += length*strength*(reach**2/g - g - 2*reach*math.log(reach/g))
    print(min(gaps), energy)


def throat(case, time):
    walls = [0 + 1j, 2 + 1j, 2 + 0.5j, 2.5 + 0.5j, 2.5 + 1j, 4 + 1j]
    x = points(case, time, 'capsule')
    x = curve(x) if len(x) % 2 else x
    print(min(between(complex(p.real, abs(p.imag)), a, b) for p in x for a, b in zip(walls, walls[1:])))


if sys.argv[1] == 'pair':
    pair(*sys.argv[2:4], *[float(a) for a in sys.argv[4:]])
else:
    throat(*sys.argv[2:])
