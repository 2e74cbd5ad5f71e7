"""real.py - programs that somebody else wrote: BENCH_REAL/machine/{machine,setup}.xml with BENCH_REAL/nc/*."""
import os

import judge
from measure import median, rounds, say
from scene import Scene

COLUMNS = ['program', 'blocks', 'certified', 'conventional', 'interpolated', 'parse_only', 'checked_by_read',
           'checked_a_second', 'fcl', 'verdict']


def scenes(tools, out):
    folder = os.path.join(tools.real, 'machine')
    machine, setup = (os.path.join(folder, x + '.xml') for x in ('machine', 'setup'))
    for name in sorted(os.listdir(os.path.join(tools.real, 'nc'))):
        program = os.path.join(tools.real, 'nc', name)
        scene = Scene(name, os.path.join(out, name), machine, setup if os.path.exists(setup) else None, program)
        # What another machine was meant for stops here, and not quietly.
        spent = tools.run([tools.fivecheck, '--parse-only', '-q'] + scene.operands() + [program])
        if spent.status == 2:
            say('real: %s is not for this machine: %s' % (name, spent.err.split('\n')[0]))
        else:
            yield scene


def fcl(tools, scene, verdict):
    """Seconds a block of FCL at samples of 0.01 s; '' without FCL, or where it would stop at a contact."""
    if 'fcl' not in tools.peers or verdict != 'clear':
        return ''
    return judge.peer(tools, judge.Clear(scene), 0.01, 5)[0]['seconds_per_block']


def rows(tools, out):
    result = []
    for scene in scenes(tools, out):
        say('real: ' + scene.name)
        status = tools.check(scene, ['-q'], expect=(0, 1, 2)).status
        if status == 2:
            say('real: %s is not checked to its end, and left out' % scene.name)
            continue
        if status == 0:
            scene.prepare(tools)
            if not judge.moves(scene):
                say('real: %s moves no axis, and is left out' % scene.name)
                continue
        methods = ['certified', 'conventional', 'interpolated']
        runs = rounds(tools.runs, *[lambda m=m: tools.check(scene, ['-j', '1', '--method', m]) for m in methods])
        read = [tools.check(scene, ['--parse-only']).cpu for _ in range(tools.runs)]
        blocks = judge.blocks_until(scene, None)
        times = ['%.6g' % (median([s.checking() for s in run]) / blocks) for run in runs]
        whole = [s.cpu for s in runs[0]]
        read_by = '%.3g' % (median(whole) / max(median(read), 1e-9))
        a_second = '%.3g blocks/s' % (blocks / max(median(whole), 1e-9))
        verdict = ('clear', 'contact')[runs[0][0].status]
        result.append(dict(zip(COLUMNS, [scene.name, blocks] + times +
                               ['%.6g' % (median(read) / blocks), read_by, a_second,
                                fcl(tools, scene, verdict), verdict])))
    return result
