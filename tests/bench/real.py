"""real.py - programs that somebody else wrote: BENCH_REAL/machine/{machine,setup}.xml with BENCH_REAL/nc/*."""
import os

import judge
import peers
from measure import median, rounds, say
from scene import Scene

COLUMNS = ['program', 'blocks', 'certified', 'conventional', 'interpolated', 'parse_only', 'checked_by_read',
           'checked_a_second', 'library', 'library_seconds', 'verdict']


def scenes(tools, out):
    folder = os.path.join(tools.real, 'machine')
    machine, setup = (os.path.join(folder, x + '.xml') for x in ('machine', 'setup'))
    for name in sorted(os.listdir(os.path.join(tools.real, 'nc'))):
        program = os.path.join(tools.real, 'nc', name)
        scene = Scene(name, os.path.join(out, name), machine, setup if os.path.exists(setup) else None, program)
        # A program for another machine is an error here.
        spent = tools.run([tools.fivecheck, '--parse-only', '-q'] + scene.operands() + [program])
        if spent.status == 2:
            say('real: %s is not for this machine: %s' % (name, spent.err.split('\n')[0]))
        else:
            yield scene


def fastest(tools, scene, verdict):
    """
    The library that is the fastest at samples of 0.01 s, in its fastest way, and its seconds a block; '' where it would
    stop at a contact.
    """
    if not tools.peers or verdict != 'clear':
        return '', ''
    times = [(float(judge.peer(tools, judge.Clear(scene), peers.STEP, peers.LIMIT, name, skip)[0]['seconds_per_block']),
              kind) for kind, name, skip in peers.kinds(tools)]
    each, kind = min(times)
    return kind, '%.6g' % each


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
        *runs, read = rounds(
            tools.runs, *[lambda m=m: tools.check(scene, ['-j', '1', '--method', m]) for m in methods],
            lambda: tools.check(scene, ['--parse-only']).cpu)
        blocks = judge.blocks_until(scene, None)
        times = ['%.6g' % (median([s.checking() for s in run]) / blocks) for run in runs]
        whole = [s.cpu for s in runs[0]]
        read_by = '%.3g' % (median(whole) / max(median(read), 1e-9))
        a_second = '%.3g blocks/s' % (blocks / max(median(whole), 1e-9))
        verdict = ('clear', 'contact')[runs[0][0].status]
        result.append(dict(zip(COLUMNS, [scene.name, blocks] + times +
                               ['%.6g' % (median(read) / blocks), read_by, a_second,
                                *fastest(tools, scene, verdict), verdict])))
    return result
