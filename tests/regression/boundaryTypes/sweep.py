#!/usr/bin/env python3
"""Every boundary condition that OpenFOAM has, at an inlet and at an outlet, for U and for p: it works or is refused.

    sweep.py CASE [-only WORD]

CASE is a meshed case; its types are asked of the solver, by a type that there is not. Of each a step is taken with a set of entries
that suits most. It must end with an error before that step, which names the file of the field and the type, or with End, finite
fields and as much flow in as out. Never with a signal (but OpenFOAM's abort after its own message), a stack trace, a hang, a flow that does not solve, or mass that vanishes.
"""

import concurrent.futures
import os
import re
import resource
import shutil
import signal
import subprocess
import sys

TIME = '0.02'
# Entries that the types read, beside those of their own below; OpenFOAM ignores the others
COMMON = {
    'U': '''value uniform (1 0 0); refValue uniform (1 0 0); refGradient uniform (0 0 0); valueFraction uniform 1; gradient uniform (0 0 0);
        inletValue uniform (1 0 0); outletValue uniform (1 0 0); freestreamValue uniform (1 0 0); fieldInf (1 0 0); lInf 1;
        uniformValue constant (1 0 0); uniformInletValue constant (1 0 0); meanValue constant (1 0 0); tangentialVelocity uniform (0 0 0);
        massFlowRate constant 0.1; volumetricFlowRate constant 0.1; rho rho; rhoInlet 1; rhoOutlet 1; refValue uniform -1; profile constant 1;
        origin (0 0.5 0); centre (0 0.5 0); axis (1 0 0); axialVelocity constant 1; radialVelocity constant 0; rpm constant 0; omega constant 0;
        inletDirection uniform (1 0 0); fluctuationScale (0 0 0); referenceField uniform (1 0 0); alpha 0; inletPatch inlet;
        valueExpr "vector(1, 0, 0)"; profile constant (1 0 0); tangentialMagnitude 0;''',
    'p': '''value uniform 0; refValue uniform 0; refGradient uniform 0; valueFraction uniform 1; gradient uniform 0; p0 uniform 0; p uniform 0;
        inletValue uniform 0; outletValue uniform 0; freestreamValue uniform 0; fieldInf 0; lInf 1; uniformValue constant 0; meanValue constant 0;
        uniformInletValue constant 0; rho rho; psi none; gamma 1; direction out; fanCurve constant 0; profile constant 0; pressure constant 0;
        valueExpr "0"; kw 0; reference 0;''',
}


def text(path):
    with open(path) as f:
        return f.read()


def patch(case, field, name, type_, entries):
    """Give a patch another type"""
    path = os.path.join(case, '0', field)
    found, n = re.subn(r'(\n    %s\s*\{)[^}]*\}' % name, r'\g<1> type %s; %s }' % (type_, entries.replace('\\', '')), text(path))
    assert n == 1, (path, name)
    with open(path, 'w') as f:
        f.write(found)


def solve(case):
    try:
        done = subprocess.run(['capsuleFoam'], cwd=case, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=600,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (30, 30)),
                              env=dict(os.environ, PWD=os.path.abspath(case)))
        return done.returncode, done.stdout.decode('latin-1')
    except subprocess.TimeoutExpired:
        return -1, 'hangs'


def numbers(path):
    """All numbers of a field: its own, and lists by patch"""
    data = text(path)
    assert not re.search(r'\bnan\b|\binf\b', data), 'not finite'
    patches = {}
    for m in re.finditer(r'\n    (\w+)\s*\{([^}]*)\}', data[data.index('boundaryField'):]):
        value = re.search(r'value\s+(?:nonuniform\s+List<scalar>\s*\d*\s*\(([^)]*)\)|uniform\s+(\S+);)', m.group(2))
        patches[m.group(1)] = (value.group(1), value.group(2)) if value else None
    return patches


def flux(entry, faces):
    return 0 if entry is None else sum(map(float, entry[0].split())) if entry[0] is not None else faces*float(entry[1])


def judge(case, field, type_):
    """What a run ends with: valid, refused, or what is wrong with it"""
    code, log = solve(case)
    stepped = re.search(r'^Time = ', log, re.M)
    message = log[log.index('FOAM FATAL'):] if 'FOAM FATAL' in log else ''
    # OpenFOAM ends some of its own refusals by abort, after the message; our code none
    refusal, *aborts = message.split('FOAM aborting')
    aborts = aborts and code == -signal.SIGABRT and 'capsule::' not in refusal
    if (code < 0 and not aborts) or code >= 128 or 'sigFpe::' in log or 'sigSegv::' in log or 'printStack' in log.split('FOAM FATAL')[0]:
        return 'signal %d' % code, log
    if message:
        named = re.search(r'\b0/%s\b|\bfield %s\b' % (field, field), message) or type_ in message
        return ('stops in the step' if stepped else 'refused' if named else 'not named'), log
    if code != 0 or not re.search('^End', log, re.M):
        return 'no End', log
    if re.search('above the tolerance|NOT converged|failed', log):
        return 'not solved', log
    try:
        numbers(os.path.join(case, TIME, 'U')), numbers(os.path.join(case, TIME, 'p'))
        phi = numbers(os.path.join(case, TIME, 'phi'))
    except AssertionError as e:
        return str(e), log
    through = [flux(phi[name], 16) for name in ('inlet', 'outlet', 'walls')]
    if abs(sum(through)) > 1e-5*max(map(abs, through)) + 1e-9:
        return 'mass vanishes: %s' % through, log
    return 'valid', log


def types(case, field, work):
    """The types that the solver knows for a field"""
    target = os.path.join(work, 'types' + field)
    shutil.copytree(case, target)
    patch(target, field, 'outlet', 'noSuchType', 'value uniform 0;')
    log = solve(target)[1]
    listed = log[log.index('noSuchType'):]
    return re.findall(r'^(\w+)$', listed[listed.index('(') + 1:listed.index('\n)')], re.M)


def main():
    case = sys.argv[1]
    only = sys.argv[sys.argv.index('-only') + 1] if '-only' in sys.argv else ''
    work = os.path.join(os.path.dirname(case), 'work')
    shutil.rmtree(work, ignore_errors=True)
    os.makedirs(work)
    # Values from files in constant/boundaryData, which the case does not have
    tried = [(f, place, t) for f in 'Up' for t in types(case, f, work) for place in ('inlet', 'outlet')
             if t != 'timeVaryingMappedFixedValue']
    tried = [t for t in tried if only in ' '.join(t)]

    def run(item):
        field, place, type_ = item
        target = os.path.join(work, '-'.join(item))
        shutil.copytree(case, target)
        patch(target, field, place, type_, COMMON[field])
        # A condition of one goes with the usual one of the other
        if field == 'U' and place == 'outlet':
            patch(target, 'p', 'outlet', 'fixedValue', 'value uniform 0;')
        if field == 'p' and place == 'outlet':
            patch(target, 'U', 'outlet', 'zeroGradient', '')
        if field == 'p' and place == 'inlet':
            patch(target, 'U', 'inlet', 'zeroGradient', '')
        result = judge(target, field, type_)
        shutil.rmtree(target)
        return item, result

    bad, valid = 0, []
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        for item, (outcome, log) in pool.map(run, tried):
            if outcome == 'valid':
                valid.append('%s %s %s' % item)
            elif outcome != 'refused':
                bad += 1
                shown = log[log.index('FOAM FATAL'):] if 'FOAM FATAL' in log else log[-400:]
                print('    %s: %s' % (' '.join(item), outcome))
                print('        | ' + '\n        | '.join(shown.strip().splitlines()[:4]))
    print('valid: ' + ', '.join(valid))
    print('%s boundary types that neither work nor are refused: %d of %d' % ('FAIL' if bad or not tried else 'PASS', bad, len(tried)))
    print('%s boundary types that work: %d' % ('PASS' if len(valid) > 10 or only else 'FAIL', len(valid)))


main()
