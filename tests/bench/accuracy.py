"""accuracy.py - compares every method with the truth on many small scenes."""
import os
import random

import balls
import exact
import judge
import trunnion
from measure import say

STEPS = [0.1, 0.01, 0.001, 0.0001]
TOLERANCES = [1.0, 0.1, 0.01, 0.001, 0.0001]

# Seconds: a sampled method is not run at a step that would take longer.
LIMIT = 1


def scenes(out, seed, count):
    """Walls, arms and balls in turn, from one seed."""
    rng, cache = random.Random(seed), {}
    for i in range(count):
        one = rng.randrange(1 << 30)
        folder = os.path.join(out, '%s-%d' % (('wall', 'arm', 'nick')[i % 3], i))
        if i % 3 == 0:
            yield exact.wall(folder, one)
        elif i % 3 == 1:
            yield exact.arm(folder, one)
        else:
            pick = random.Random(one)
            yield balls.make(folder, one, pick.choice([1000, 8000, 50000]),
                             pick.choice([0.1, 0.3, 1, 3, 10, 30, 100, 300]), pick.choice([0.01, 0.1, 1, 10]),
                             pick.choice([0, 0.3, 1]), pick.choice([100, 1000]),
                             pick.choice([0, 0.02, 0.2, 1, 3]), pick.choice([600, 3000, 12000]), cache)


def certified_rows(tools, truth, runs):
    return [judge.own(tools, truth, 'certified', e, runs)[0] for e in TOLERANCES]


def sampled_rows(tools, truth, steps, limit, runs, peer):
    """From coarse to fine. A step whose run would pass the limit (seconds) is extrapolated from the last one."""
    rows = []
    for method in ['conventional', 'interpolated'] + (['fcl'] if peer else []):
        last, spent = None, 0
        for step in steps:
            if last and spent * 10 > limit:
                row = judge.row_of(truth.scene, method, step, truth)
                factor = last['setting'] / step
                row.update(extrapolated=1, blocks=last['blocks'], seconds=last['seconds'] * factor,
                           seconds_per_block='%.6g' % (last['seconds'] * factor / last['blocks']))
            else:
                row, spent = (judge.peer(tools, truth, step, limit) if method == 'fcl' else
                              judge.own(tools, truth, method, step, runs))
                last = row if row['seconds'] != '' else None
            rows.append(row)
    return rows


def run(tools, out, seed, count, quick):
    rows = []
    for number, scene in enumerate(list(scenes(out, seed, count)) + list(trunnion.examples(out))):
        say('accuracy: %d of %d, %s' % (number + 1, count + 6, scene.name))
        truth = judge.Truth(tools, scene)
        runs = 0 if quick else 1
        rows += certified_rows(tools, truth, runs)
        rows += sampled_rows(tools, truth, STEPS[:2] if quick else STEPS, LIMIT, runs, 'fcl' in tools.peers)
    return rows


def summary(rows):
    """Method, setting, scenes, misses, false alarms, largest error in first block and in motion."""
    out = []
    for key in dict.fromkeys((r['method'], r['setting']) for r in rows):
        mine = [r for r in rows if (r['method'], r['setting']) == key and r['verdict']]
        errors = [abs(float(r['motion_error_mm'])) for r in mine if r['motion_error_mm'] != '']
        blocks = [abs(int(r['first_block_error'])) for r in mine if r['first_block_error'] != '']
        out.append([key[0], key[1], len(mine), sum(r['truth'] == 'contact' for r in mine), sum(r['miss'] for r in mine),
                    sum(r['false_alarm'] for r in mine), max(blocks or [0]), '%.4g' % max(errors or [0])])
    return out
