"""peers.py - the usual libraries, at samples of 0.01 s and at samples as exact as the proof."""
import judge
from measure import median, say

COLUMNS = ['scene', 'peer', 'samples', 'us_per_block', 'times', 'extrapolated']
STEP = 0.01
# mm: the error of the proof at its default tolerance, and of samples that are as exact.
ERROR = 0.001
# Seconds for one run of a library; the other samples are extrapolated from those spread over the path.
LIMIT = 3


def kinds(tools):
    """Name, library, and whether the last distance allows samples to be skipped; ODE gives no distance."""
    for name in tools.peers:
        yield name, name, False
        if name != 'ode':
            yield name + ' skipping', name, True


def step_of_error(tools, scene):
    """Seconds between samples between which no pair moves by more than ERROR, on average over the path."""
    out = tools.run([tools.truth, 'travel', scene.plain, scene.path])
    return float(judge.position_at_end(scene)) * ERROR / float(out.out)


def rows(tools, scenes):
    """`times`: the time relative to the certified check; only its checking phase counts."""
    result = []
    for title, scene in scenes:
        say('peers: ' + title)
        scene.prepare(tools)
        blocks = judge.blocks_until(scene, None)
        own = median([judge.check_seconds(tools, scene, [], 1) / blocks for _ in range(tools.runs)])
        result.append(dict(zip(COLUMNS, (title, 'certified', '', '%.4g' % (1e6 * own), 1, 0))))
        for samples, step in (('0.01 s', STEP), ('0.001 mm', step_of_error(tools, scene))):
            for kind, name, skip in kinds(tools):
                row, _ = judge.peer(tools, judge.Clear(scene), step, LIMIT, name, skip)
                each = float(row['seconds_per_block'])
                result.append(dict(zip(COLUMNS, (title, kind, samples, '%.4g' % (1e6 * each), '%.3g' % (each / own),
                                                 row['extrapolated']))))
    return result
