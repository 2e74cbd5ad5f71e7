"""series.py - cost against one thing at a time, and the paper's two figures."""
import os

import balls
import judge
import trunnion
from measure import median, say

BASE = {'triangles': 20000, 'gap': 10.0, 'length': 0.1, 'share': 1.0, 'blocks': 10000}
RANGES = {
    'triangles': [1000, 10000, 100000, 1000000],
    'gap': [0.1, 1.0, 10.0, 100.0, 300.0],
    'length': [0.01, 0.1, 1.0, 10.0],
    'share': [0.0, 0.25, 0.5, 1.0],
    'blocks': [1000, 10000, 100000, 1000000],
}
COLUMNS = ['varied', 'value', 'method', 'setting', 'seconds_per_block', 'peak_bytes', 'extrapolated']


def cost_rows(tools, out, limit):
    """Varies one thing at a time; a sampled method that would take longer than `limit` seconds is left out."""
    rows, cache = [], {}
    for varied, values in RANGES.items():
        for value in values:
            say('series: %s %g' % (varied, value))
            figures = dict(BASE, **{varied: value})
            scene = balls.make(os.path.join(out, '%s-%g' % (varied, value)), 1, cache=cache, **figures)
            for method in ('certified', 'conventional', 'interpolated'):
                setting = 0.001 if method == 'certified' else 0.01
                options = ['--method', method, '--tolerance' if method == 'certified' else '--step', repr(setting)]
                peak = tools.check(scene, options).peak
                seconds = judge.check_seconds(tools, scene, options, 1, runs=tools.runs) / figures['blocks']
                rows.append(dict(zip(COLUMNS, (varied, value, method, setting, '%.6g' % seconds, int(peak), 0))))
            if 'fcl' in tools.peers:
                scene.prepare(tools)
                row, _ = judge.peer(tools, judge.Clear(scene), 0.01, limit)
                rows.append(dict(zip(COLUMNS, (varied, value, 'fcl', 0.01, row['seconds_per_block'], '',
                                               row['extrapolated']))))
    return rows


STEP_COLUMNS = ['motion', 'step', 'samples', 'conventional', 'interpolated']


def step_rows(tools, out):
    """Seconds per sample within one motion, all pairs: the paper's comparison."""
    rows = []
    for number, (start, end, feed) in enumerate(trunnion.MOTIONS):
        say('series: motion %d' % (number + 1))
        whole = trunnion.motion(os.path.join(out, 'motion-%d' % number), start, end, feed)
        way = trunnion.motion(os.path.join(out, 'motion-%d-start' % number), start)
        for step in (0.1, 0.01, 0.001):
            samples = (whole.figures['seconds'] - way.figures['seconds']) / step
            row = [number + 1, step, round(samples)]
            for method in ('conventional', 'interpolated'):
                options = ['--method', method, '--step', repr(step)]
                both, approach = (judge.check_seconds(tools, s, options, 1, runs=tools.runs) for s in (whole, way))
                row.append('%.6g' % (max(both - approach, 0) / samples))
            rows.append(dict(zip(STEP_COLUMNS, row)))
    return rows


PAPER_COLUMNS = ['triangles', 'step', 'method', 'ms', 'times', 'false_alarms']


def paper_rows(tools):
    """The paper's comparison on its own terms: whole meshes, every pair, no trees (paper.c). `times`: as long as `kept`."""
    rows = []
    for triangles in (110, 330):
        say('series: the paper\'s terms, %d x %d triangles' % (triangles, triangles))
        runs = [[line.split('\t') for line in tools.run([os.path.join(tools.out, 'paper'), str(triangles), '0.01'])
                 .out.splitlines()] for _ in range(min(tools.runs, 3))]
        times = {run[i][0]: median([float(r[i][1]) for r in runs]) for run in runs for i in range(len(run))}
        for name, _, _, meeting in runs[0]:
            rows.append(dict(zip(PAPER_COLUMNS, (triangles, 0.01, name, '%.4g' % times[name],
                                                 '%.3g' % (times[name] / times['kept']), meeting))))
    return rows
