#!/usr/bin/env python3
"""Mutates every entry of capsuleFoam's dictionaries and judges how the run ends.

    fuzz.py CASES [-only WORD] [-timeout SECONDS]

CASES is a folder of meshed cases: case, which has run, with a state to restart from; those of APART. A mutation must end with a fatal error that names
entry and file, unless it is listed as valid below: then with End and finite numbers. Never a signal, a hang or NaN. The words of what OpenFOAM itself
refuses while it reads a file are its own, another release has others: there any fatal error will do.
Prints a line for each file and kind of mutation, and counts; -only runs the mutations whose name contains WORD.
"""

import argparse
import collections
import concurrent.futures
import itertools
import os
import re
import resource
import shutil
import signal
import subprocess
import sys
import threading

TRANSPORT = 'constant/transportProperties'
MEMBRANES = 'constant/membraneProperties'
SOLUTION = 'system/fvSolution'
SCHEMES = 'system/fvSchemes'
CONTROL = 'system/controlDict'
DRIVING = 'constant/drivingForce'

# Where our entries are: dictionaries of OpenFOAM's own are left alone
OURS = {
    TRANSPORT: '',
    MEMBRANES: '',
    SOLUTION: 'capsuleFoam',
    SCHEMES: 'ddtSchemes',
    CONTROL: 'functions',
    DRIVING: '',
}

# Variants that have a case of their own, and the file mutated there
APART = {
    'meanVelocity': DRIVING,
    'meanPressureGradient': DRIVING,
    'PISO': SOLUTION,
}

# Entries of function objects that OpenFOAM reads, and its scheme for all other terms
FOREIGN = r'functions(\.\w+)?|functions\.\w+\.(type|libs|writeControl)|ddtSchemes|ddtSchemes\.default'

# Laws without tension by stretch permit no other
UNSTRETCHED = ('initialStretch  1.05', 'initialStretch  1')

# Other types, whose own entries are mutated: replacements of text, and the entries
VARIANTS = {
    'circle': (MEMBRANES, [('biconcave', 'circle')], r'shape\.radius'),
    'ellipse': (MEMBRANES, [('biconcave', 'ellipse'), ('radius  ', 'semiAxes'), ('0.25;', '(0.3 0.2);')], r'shape\.semiAxes'),
    'points': (MEMBRANES, [('biconcave', 'points'), ('radius ', 'file '), ('0.25;', '"constant/outline";')], r'shape\.file'),
    'Hookean': (MEMBRANES, [('neoHookean', 'Hookean'), ('shearModulus', 'elasticModulus')], r'elasticLaw\.'),
    'surfaceTension': (MEMBRANES, [('neoHookean', 'surfaceTension'), ('shearModulus', 'surfaceTension'), UNSTRETCHED], r'elasticLaw\.'),
    'incompressible': (MEMBRANES, [('neoHookean;', 'neoHookean;\n            form            incompressible;')], r'elasticLaw\.(form|shearModulus)'),
    'Skalak': (MEMBRANES, [('neoHookean;', 'Skalak;\n            C               10;')], r'elasticLaw\.(C|shearModulus)'),
    'noTension': (MEMBRANES, [('neoHookean', 'none'), UNSTRETCHED], r'elasticLaw\.'),
    'noBending': (MEMBRANES, [('Helfrich', 'none')], r'bending\.'),
    'curvature': (MEMBRANES, [('referenceCurvature none', 'referenceCurvature 4')], r'bending\.referenceCurvature'),
    'load': (MEMBRANES, [('points  ', 'load { type none; }\n        points  ')], r'cell\.load'),
    'fixedPoint': (MEMBRANES, [('quasiNewton;', 'fixedPoint;\n    relaxation              0.5;')], r'coupling\.relax'),
    'explicit': (MEMBRANES, [('quasiNewton;', 'explicit;')], r'coupling\.type'),
    'fractionalStep': (SOLUTION, [('direct;', 'fractionalStep;')], r'flow\.(solver|tolerance)'),
    'pRefCell': (SOLUTION, [('pRefPoint       (1.97 0.48 0.05)', 'pRefCell        7')], r'flow\.pRefCell'),
    'steadyState': (SCHEMES, [('ddt(U)          backward', 'ddt(U)          steadyState')], r'ddt\(U\)'),
    'Euler': (SCHEMES, [('ddt(membranes)  backward', 'ddt(membranes)  Euler')], r'ddt\(membranes\)'),
}

# Mutations that leave the case a valid one: variant, entry and mutation as regular expressions
VALID = [
    (r'base|circle|ellipse|points|fractionalStep', r'cell\.(points|levelSet)|angle|clustering|initialStretch|referenceCurvature|coupling\.(\w+Tolerance|maxIter|conserveArea)|flow\.(tolerance|maxIter|directions|refactor)', 'removed'),
    ('fixedPoint', 'relaxation', 'removed'),
    ('load', r'cell\.load', 'removed'),
    ('.*', r'ddt\((U|membranes)\)', 'removed'),
    ('.*', r'measures\.lines|energy\.largestImbalance', 'removed'),
    ('.*', r'energy\.largestImbalance', 'small'),
    ('incompressible', r'elasticLaw\.form', 'removed'),
    ('Skalak', r'elasticLaw\.C', 'zero|tiny|small'),
    ('noTension', r'elasticLaw\.shearModulus', '(?!misspelt|beyond).*'),
    ('noBending', r'bending\.(bendingModulus|referenceCurvature)', '(?!misspelt|beyond).*'),
    ('base', r'bending\.referenceCurvature', 'wrong type: a number'),
    ('curvature', r'bending\.referenceCurvature', 'removed|zero|negative|tiny|small'),
    ('.*', 'angle', 'zero|negative|tiny|small'),
    ('.*', 'clustering', 'zero|tiny|small'),
    ('.*', 'pRefValue', 'zero|negative|tiny|small'),
    # The corner of the mesh
    ('.*', 'pRefPoint', '(zero|tiny|small)(, second)?'),
    ('.*', 'pRefCell', 'zero'),
    ('.*', r'conserveArea|measures\.lines|momentumPredictor', 'zero|wrong type: a number'),
    ('PISO', r'nCorrectors|nNonOrthogonalCorrectors|momentumPredictor', 'removed'),
    ('PISO', 'nNonOrthogonalCorrectors', 'zero'),
    # Along the channel any sign will do; across it nothing but what rounding leaves
    ('mean.*', 'velocity|pressureGradient', '(zero|tiny|small)(, second)?|negative'),
    ('mean.*', '', 'missing'),
    ('base', '^membranes', 'wrong type: empty'),
    ('base', '', 'truncated after the end'),
    ('base', r'membranes\.cell', 'removed|misspelt'),
]

# Mutations that OpenFOAM lets pass with a warning, or ours do in dictionaries that OpenFOAM shares
WARNED = [
    ('.*', r'ddt\((U|membranes)\)|measures\.lines|energy\.largestImbalance', 'misspelt'),
]

# Finite results and an error that names the entry are both right: far from what is usual, within the bounds
EITHER = [
    ('.*', r'rho|mu|viscosity|Modulus|\.surfaceTension|^velocity|^pressureGradient', 'large|small'),
]

# Refused by OpenFOAM before our code sees the entry: no whole file, no whole list, or no number at all
UNREADABLE = r'truncated \d.*|truncated near the end|empty|missing|binary|wrong type: an open list|wrong units: open bracket|beyond the range.*'

# What the undefined-behaviour sanitizer finds in OpenFOAM's octrees: the shift of a negative label
OPENFOAMS = r'/OpenFOAM/lnInclude/labelBits\.H'

LOCK = threading.Lock()
Mutation = collections.namedtuple('Mutation', 'variant file entry kind what text')


class Entry:
    """An entry of a dictionary in a text: name with those above it, span of all, of the key and of the value"""

    def __init__(self, name, start, end, key, value, isDict):
        self.name, self.start, self.end = name, start, end
        self.key, self.value, self.isDict = key, value, isDict


def entries(text):
    """All entries of a dictionary file but the header's"""
    found, above, pending = [], [], None
    token = re.compile(r'//[^\n]*|/\*.*?\*/|"[^"]*"|[{}();]|[^\s{}();"]+(?:\([^\s()]*\))?', re.S)
    depth, key, first = 0, None, None
    for m in token.finditer(text):
        t = m.group()
        if t.startswith(('//', '/*')):
            continue
        if t in '{}' and (depth > 0 or first is not None):
            # A list of one value, 31{0}
            depth += (t == '{') - (t == '}')
        elif t == '{' and depth == 0:
            above.append(key)
            found.append(Entry('.'.join(k[0] for k in above), key[1], None, (key[1], key[2]), (m.start(), None), True))
            key = None
        elif t == '}' and depth == 0:
            name = '.'.join(k[0] for k in above)
            above.pop()
            e = next(e for e in reversed(found) if e.name == name and e.end is None)
            e.end, e.value = m.end(), (e.value[0], m.end())
        elif t == ';' and depth == 0:
            name = '.'.join([k[0] for k in above] + [key[0]])
            found.append(Entry(name, key[1], m.end(), (key[1], key[2]), (first, m.start()), False))
            key = first = None
        elif key is None:
            key = (t, m.start(), m.end())
        else:
            first = m.start() if first is None else first
            depth += (t == '(') - (t == ')')
    return [e for e in found if not e.name.startswith('FoamFile')]


def mutations(variant, file, text):
    """All mutations of the entries of a dictionary"""
    for e in entries(text):
        if not e.name.startswith(OURS[file]) or re.fullmatch(FOREIGN, e.name):
            continue

        def become(kind, what, value, end=';'):
            new = text[:e.key[1]] + ' ' + value + end + text[e.end:]
            return Mutation(variant, file, e.name, kind, what, new)

        yield Mutation(variant, file, e.name, 'removed', 'removed', text[:e.start] + text[e.end:])
        name = text[e.key[0]:e.key[1]]
        other = name[:-1] + 'x' + name[-1]
        yield Mutation(variant, file, e.name, 'misspelt', 'misspelt', text[:e.key[0]] + other + text[e.key[1]:])
        if e.isDict:
            yield become('wrong type', 'wrong type: a number', '1')
            yield become('wrong type', 'wrong type: a word', 'rubber')
            yield become('wrong type', 'wrong type: empty', '{}', '')
            continue

        value = text[e.value[0]:e.value[1]].strip()
        numbers = re.findall(r'[-+]?[0-9][-+.0-9e]*', re.sub(r'\[.*?\]', '', value))
        isNumber = bool(re.fullmatch(r'(\[.*\] *)?[-+]?[0-9][-+.0-9e]*', value))
        isList = value.startswith('(')
        yield become('wrong type', 'wrong type: a dictionary', '{ a 1; }', '')
        yield become('wrong type', 'wrong type: nothing', '')
        yield become('wrong type', 'wrong type: two values', value + ' ' + value)
        yield become('wrong type', 'wrong type: a word', 'rubber')
        yield become('wrong type', 'wrong type: a list of words', '(a b c)')
        if not isNumber:
            yield become('wrong type', 'wrong type: a number', '1')
        if not isNumber and not isList:
            yield become('wrong type', 'wrong type: a string', '"rub ber"')
            yield become('huge', 'huge', '1e300')
            continue
        if isList:
            yield become('wrong type', 'wrong type: a long list', '(1 1 1 1 1)')
            yield become('wrong type', 'wrong type: an open list', '(1 1')

        def each(kind, what, new):
            # Each number of a list in turn
            for i in range(min(2, len(numbers))):
                if isNumber:
                    yield become(kind, what, new)
                else:
                    changed = numbers[:i] + [new] + numbers[i + 1:]
                    yield become(kind, what + ', second'*i, '(' + ' '.join(changed) + ')')
                if isNumber:
                    break

        isLabel = isNumber and re.search(r'points|maxIter|directions|refactor|pRefCell|Correctors', e.name)
        cases = [('zero', 'zero', '0'), ('negative', 'negative', '-1'), ('not a number', 'nan', 'nan'),
                 ('not a number', '-nan', '-nan'), ('not a number', 'inf', 'inf'), ('huge', 'huge', '1e300'),
                 ('huge', 'beyond the range', '1e999'),
                 ('huge', 'large', '1e25'), ('tiny', 'tiny', '1e-300'), ('tiny', 'small', '1e-25')]
        if isLabel:
            cases += [('wrong type', 'wrong type: a fraction', '2.5'), ('huge', 'beyond the range', '3000000000'),
                      ('huge', 'huge', '2147483647')]
        for case in cases:
            yield from each(*case)
        if not isLabel:
            one = '1' if isNumber else value
            yield become('wrong units', 'wrong units', '[1 2 3 0 0 0 0] ' + one)
            yield become('wrong units', 'wrong units: none', '[0 0 0 0 0 0 0] ' + one)
            yield become('wrong units', 'wrong units: open bracket', '[1 -1 1')


def truncations(variant, file, text, parts):
    """A file that ends too early, or holds something else"""
    for i in range(1, parts):
        yield Mutation(variant, file, '', 'truncated', 'truncated %d/%d' % (i, parts), text[:len(text)*i//parts])
    yield Mutation(variant, file, '', 'truncated', 'empty', '')
    yield Mutation(variant, file, '', 'truncated', 'missing', None)
    yield Mutation(variant, file, '', 'truncated', 'binary', '\x00\x01\xff{;(' * 50)


def states(file, text):
    """Damage of the state of a membrane"""
    yield from truncations('base', file, text, 25)
    end = text.index(';', text.index('digest'))
    for i in (1, 2, 20, 41, 50, 60):
        yield Mutation('base', file, '', 'truncated', 'truncated near the end', text[:end + 1 - i])
    yield Mutation('base', file, '', 'truncated', 'truncated after the end', text[:end + 1])
    body = text.index('oldLevels')
    for e in entries(text):
        for what, new in (('removed', ''), ('misspelt', 'x' + text[e.start:e.end])):
            yield Mutation('base', file, e.name, what, what, text[:e.start] + new + text[e.end:])
    for m in itertools.islice(re.finditer(r'^\d+$', text[body:], re.M), 0, None, 6):
        # The address sanitizer does not let a program go on without memory
        for n in ('30', '32', '0', '-1') + (() if 'ASAN_OPTIONS' in os.environ else ('2000000000',)):
            new = text[:body + m.start()] + n + text[body + m.end():]
            yield Mutation('base', file, '', 'wrong count', 'count ' + n, new)
    for n in ('0', '1', '3', '-1', '1e300', 'nan', '2.5'):
        new = re.sub(r'oldLevels( +)2', r'oldLevels\g<1>' + n, text)
        yield Mutation('base', file, 'oldLevels|digest', 'wrong count', 'oldLevels ' + n, new)
    numbers = list(re.finditer(r'[-0-9.e]{8,}', text[body:]))
    for m in numbers[::len(numbers)//4]:
        for kind, n in (('not a number', 'nan'), ('not a number', 'inf'), ('huge', '1e300'), ('huge', '-1e300'),
                        ('huge', '1e999'), ('one digit', m.group()[:4] + '7' + m.group()[5:])):
            if n != m.group():
                yield Mutation('base', file, '', kind, kind, text[:body + m.start()] + n + text[body + m.end():])


def listed(table, m):
    return any(re.fullmatch(v, m.variant) and re.search('(' + e + ')$', m.entry) and re.fullmatch(w, m.what)
               for v, e, w in table)


def finite(directory, log):
    """No NaN, no infinity in the log and in what the function objects have written"""
    texts = [log]
    for folder, _, files in os.walk(os.path.join(directory, 'postProcessing-dry-run')):
        texts += [open(os.path.join(folder, f)).read() for f in files]
    return not any(re.search(r'(?<![\w"])[-+]?(nan|inf)(?!\w)', t, re.I) for t in texts)


def run(directory, m, timeout):
    """The outcome of a mutation: a word and the log"""
    shutil.rmtree(os.path.join(directory, 'postProcessing-dry-run'), ignore_errors=True)
    path = os.path.join(directory, m.file)
    with open(path, encoding='latin-1') as f:
        original = f.read()
    if m.text is None:
        os.remove(path)
    else:
        with open(path, 'w', encoding='latin-1') as f:
            f.write(m.text)
    try:
        # Processor time, which a busy machine does not change; and a lock waits for ever
        done = subprocess.run(['capsuleFoam', '-dry-run'], cwd=directory, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, timeout=20*timeout,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (timeout, timeout)),
                              env=dict(os.environ, PWD=os.path.abspath(directory)))
        log = done.stdout.decode('latin-1')
        code = done.returncode
    except subprocess.TimeoutExpired as e:
        return 'hangs', (e.stdout or b'').decode('latin-1')
    finally:
        with open(path, 'w', encoding='latin-1') as f:
            f.write(original)

    if os.path.isdir(os.path.join(directory, '0.02')):
        shutil.rmtree(os.path.join(directory, '0.02'))
        return 'dry run writes', log
    if re.search(r'AddressSanitizer|^(?!.*%s).*runtime error:' % OPENFOAMS, log, re.M):
        return 'sanitizer', log
    if code == -signal.SIGXCPU or code == -signal.SIGKILL:
        return 'hangs', log
    if code < 0 or code >= 128 or 'sigFpe::' in log or 'sigSegv::' in log:
        return 'signal %d' % code, log
    if re.search('The run ends at time', log):
        return 'diverges', log
    if 'FOAM FATAL' in log:
        message = log[log.index('FOAM FATAL'):]
        if re.fullmatch(UNREADABLE, m.what) and 'capsule::' not in message:
            return 'error', log
        last = m.entry.split('.')[-1]
        named = not last or any(re.search(r'(?<![\w])' + word + r'(?![\w])', message)
                                for word in (re.escape(last), re.escape(last[:-1] + 'x' + last[-1]), last))
        if os.path.basename(m.file) not in message:
            return 'error without file', log
        return ('error' if named else 'error without entry'), log
    if code != 0 or not re.search(r'^End', log, re.M):
        return 'no End', log
    if not finite(directory, log):
        return 'not finite', log
    last = m.entry.split('.')[-1]
    for warning in re.findall(r'FOAM (?:IO )?Warning.*?\n\n', log, re.S):
        if last and last[:-1] + 'x' + last[-1] in warning and os.path.basename(m.file) in warning:
            return 'warning', log
    return 'valid', log


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('cases')
    parser.add_argument('-only', default='')
    parser.add_argument('-timeout', type=int, default=20)
    args = parser.parse_args()

    def read(file, case='case'):
        with open(os.path.join(args.cases, case, file)) as f:
            return f.read()

    # The base case starts from its shape; the state is that of its second step
    work = []
    for file in [f for f in OURS if f != DRIVING]:
        work += mutations('base', file, read(file))
        work += truncations('base', file, read(file), 10)
    for case, file in APART.items():
        work.append(Mutation(case, file, '', 'unchanged', 'unchanged', read(file, case)))
        work += mutations(case, file, read(file, case))
    work += truncations('meanVelocity', DRIVING, read(DRIVING, 'meanVelocity'), 10)
    for variant, (file, changes, only) in VARIANTS.items():
        text = read(file)
        for old, new in changes:
            assert old in text, (variant, old)
            text = text.replace(old, new)
        base = Mutation(variant, file, 'type', 'unchanged', 'unchanged', text)
        work += [base]*(variant != 'load') + [m for m in mutations(variant, file, text) if re.search(only, m.entry)]
    restart = '0.04/uniform/membranes/cell'
    work += states(restart, read(restart))
    work.append(Mutation('base', restart, '', 'unchanged', 'unchanged', read(restart)))
    work = [m for m in work if args.only in ' '.join([m.variant, m.file, m.entry, m.what])]

    workers = 2
    for fresh in range(workers):
        for case in ['restart', 'start', *APART]:
            target = os.path.join(args.cases, 'work', '%d' % fresh, case)
            shutil.rmtree(target, ignore_errors=True)
            shutil.copytree(os.path.join(args.cases, case if case in APART else 'case'), target)
            if case == 'start':
                shutil.rmtree(os.path.join(target, '0.04'))
    free = list(range(workers))

    def judge(m):
        with LOCK:
            worker = free.pop()
        try:
            case = m.variant if m.variant in APART else 'restart' if m.file == restart else 'start'
            outcome, log = run(os.path.join(args.cases, 'work', str(worker), case), m, args.timeout)
        finally:
            with LOCK:
                free.append(worker)
        if m.what == 'unchanged' or listed(VALID, m):
            wanted = ('valid',)
        elif listed(WARNED, m):
            wanted = ('warning',)
        elif listed(EITHER, m):
            wanted = ('error', 'valid', 'diverges')
        else:
            wanted = ('error',)
        # The load's library is none of ours: its type is always wrong
        if m.variant == 'load' and m.what != 'removed':
            wanted = ('error',)
        return m, outcome, wanted, log

    counts = collections.Counter()
    groups = collections.OrderedDict()
    with concurrent.futures.ThreadPoolExecutor(workers) as pool:
        for m, outcome, wanted, log in pool.map(judge, work):
            counts[outcome] += 1
            good, all_ = groups.setdefault((os.path.basename(m.file) if m.file != restart else 'state', m.kind), [0, 0])
            ok = outcome in wanted
            groups[os.path.basename(m.file) if m.file != restart else 'state', m.kind] = [good + ok, all_ + 1]
            if not ok:
                print('    %s: %s %s %s [%s], wanted %s' % (outcome, m.file, m.entry, m.what, m.variant, wanted[0]))
                shown = log[log.index('FOAM FATAL'):] if 'FOAM FATAL' in log else log[-600:]
                print('        | ' + '\n        | '.join(shown.strip().splitlines()[:12]))

    for (file, kind), (good, all_) in groups.items():
        print('%s fuzz %s, %s: %d of %d as expected' % ('PASS' if good == all_ else 'FAIL', file, kind, good, all_))
    print('%d mutations: %s' % (sum(counts.values()), ', '.join('%s %d' % c for c in counts.most_common())))


if __name__ == '__main__':
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    sys.stdout.reconfigure(line_buffering=True)
    main()
