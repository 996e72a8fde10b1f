#!/usr/bin/python3
"""Largest relative difference of two runs at a time: fields, states of membranes, and what function objects wrote

    compare.py A B TIME [field ...]

prints one number a line: its name, and the largest difference over the largest value. Fields (default U p phi) are
compared inside and on the patches, the states in uniform/membranes by field and time level, the function objects' .dat
files row by row up to TIME (rows of B alone when it started later). What is missing is an error."""

import glob
import os
import re
import sys

import numpy as np


def numbers(data, start, binary):
    """The number or list of numbers that an entry holds at start"""
    m = re.compile(rb'\s*(?:non)?(?:uniform\s+)?(?:List<(\w+)>\s*)?').match(data, start)
    if not m.group(1):
        text = data[m.end():data.index(b';', m.end())]
        return np.array([float(w) for w in re.sub(rb'[()]', b' ', text).split()])
    width = {b'vector': 3, b'scalar': 1}[m.group(1)]
    head = re.compile(rb'(\d+)\s*([({]?)').match(data, m.end())
    count = int(head.group(1))
    if head.group(2) == b'(' and binary:
        return np.frombuffer(data, '<f8', count*width, head.end())
    if not head.group(2):
        return np.zeros(0)
    text = data[head.end():data.index(b';', head.end())]
    values = np.array([float(w) for w in re.sub(rb'[(){}]', b' ', text).split()])
    return np.tile(values, count) if head.group(2) == b'{' else values


def lists(path, keys):
    """All values of an OpenFOAM file under the given keys, in order"""
    with open(path, 'rb') as f:
        data = f.read()
    binary = b'binary;' in data[:1000]
    found = []
    for m in re.finditer(rb'^\s*(' + '|'.join(keys).encode() + rb')\s+(?=[-(\d]|uniform|nonuniform|List)', data, re.M):
        found.append((m.group(1).decode(), numbers(data, m.end(), binary)))
    assert found, path
    return found


def relative(a, b, scale=None):
    assert a.shape == b.shape, (a.shape, b.shape)
    scale = np.abs(a).max() if scale is None else scale
    return np.abs(a - b).max()/max(scale, 1e-300) if a.size else 0.0


def field(path):
    """Values inside, and those of the patches"""
    all_ = lists(path, ['internalField', 'value'])
    return all_[0][1], np.concatenate([v for k, v in all_[1:]] or [np.zeros(0)])


def main():
    a, b, time = sys.argv[1:4]
    for name in sys.argv[4:] or ['U', 'p', 'phi']:
        (inA, onA), (inB, onB) = [field(os.path.join(run, time, name)) for run in (a, b)]
        scale = np.abs(inA).max()
        if name == 'p':
            scale = inA.max() - inA.min()
        print(name, max(relative(inA, inB, scale), relative(onA, onB, scale)))

    states = sorted(glob.glob(os.path.join(a, time, 'uniform/membranes/*')))
    assert states or '-' in sys.argv, a
    for path in states:
        other = os.path.join(b, os.path.relpath(path, a))
        keys = ['points', 'interface', 'force', 'inertia', 'velocity', 'inner']
        worst = {}
        for (key, x), (_, y) in zip(lists(path, keys), lists(other, keys)):
            worst[key] = max(worst.get(key, 0), relative(x, y))
        for key in worst:
            print(os.path.basename(path) + '.' + key, worst[key])

    for path in sorted(glob.glob(os.path.join(a, 'postProcessing/**/*.dat'), recursive=True)):
        folder, name = os.path.relpath(os.path.dirname(os.path.dirname(path)), a), os.path.basename(path)
        rows = []
        for run in (a, b):
            table = {}
            for part in glob.glob(os.path.join(run, folder, '*', name.replace('.dat', '*.dat'))):
                for row in np.atleast_2d(np.loadtxt(part)):
                    if len(row) and row[0] <= float(time)*(1 + 1e-9):
                        table['%.9g' % row[0]] = row
            rows.append(table)
        assert rows[0] and set(rows[0]) <= set(rows[1]), (path, sorted(rows[0]), sorted(rows[1]))
        x, y = [np.array([t[k] for k in sorted(rows[0])]) for t in rows]
        print(folder, max(relative(x[:, i], y[:, i]) for i in range(x.shape[1])))


main()
