"""series.py - cost against one thing at a time, the paper's two figures, and what each part of the proof is worth."""
import os
import subprocess

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

# What is left out, and how a build does without it.
ABLATIONS = [
    ('nothing', '', ''),
    ('budget', 'BUDGET', ''),
    ('kept budgets', 'KEPT_BUDGETS', ''),
    ('travelling planes', 'PLANES', ''),
    ('chunks', 'CHUNKS', ''),
    ('stretches', 'MERGED_STEPS', ''),
    ('cached axes', 'CACHED_AXES', ''),
    ('supports', 'SUPPORTS', ''),
    ('interpolated axes', 'INTERPOLATED_AXES', ''),
    ('second order', 'SECOND_ORDER', ''),
    ('SIMD', 'SIMD', '-fno-tree-vectorize'),
]


class Clear:
    """The truth of a scene that a formula tells to be clear."""

    def __init__(self, scene):
        self.scene, self.contact = scene, None


def cost_rows(tools, out, limit):
    """One thing varied at a time; a sampled method that would take longer than `limit` seconds is left out."""
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
            if tools.peer:
                scene.prepare(tools)
                row, _ = judge.peer(tools, Clear(scene), 0.01, limit)
                rows.append(dict(zip(COLUMNS, (varied, value, 'fcl', 0.01, row['seconds_per_block'], '',
                                               row['extrapolated']))))
    return rows


STEP_COLUMNS = ['motion', 'step', 'samples', 'conventional', 'interpolated']


def step_rows(tools, out):
    """Seconds a sample within one motion, all pairs: the paper's comparison."""
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


ABLATION_COLUMNS = ['without', 'scene', 'seconds_per_block', 'times', 'verdict']


def build_without(tools, source, macro, flags):
    build = os.path.join(tools.out, 'without-' + (macro.lower() or 'nothing'))
    command = ['make', '-s', '-C', source, 'BUILD=' + build, 'OPTIMISE=-O2 -g ' + flags]
    subprocess.run(command + (['CPPFLAGS=-DFIVECHECK_WITHOUT_' + macro] if macro else []), check=True,
                   stdout=subprocess.DEVNULL)
    return os.path.join(build, 'fivecheck')


def ablation_rows(tools, source, scenes):
    """Every part left out in turn, on each scene; all builds must say the same."""
    builds = []
    for name, macro, flags in ABLATIONS:
        say('ablation: building without ' + name)
        builds.append((name, build_without(tools, source, macro, flags)))
    rows, whole = [], {}
    for scene in scenes:
        verdicts = {}
        for name, program in builds:
            say('ablation: %s without %s' % (scene.name, name))
            spent = tools.check(scene, ['-f', 'ndjson', '-q'], fivecheck=program)
            verdicts[name] = spent.status
            if verdicts[name] != verdicts['nothing']:
                raise SystemExit('bench: %s: another verdict without %s' % (scene.name, name))
            seconds = judge.check_seconds(tools, scene, [], 1, program, tools.runs) / judge.blocks_until(scene, None)
            whole.setdefault(scene.name, seconds)
            rows.append(dict(zip(ABLATION_COLUMNS, (name, scene.name, '%.6g' % seconds,
                                                    '%.3g' % (seconds / max(whole[scene.name], 1e-12)),
                                                    'contact' if spent.status else 'clear'))))
    return rows
