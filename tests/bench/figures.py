"""figures.py - the CSV files as gnuplot figures, SVG and PNG. Without gnuplot there are none."""
import os
import shutil
import subprocess

from measure import say

METHODS = ['certified', 'conventional', 'interpolated', 'fcl']
HEAD = '''set terminal %s
set output "%s"
set grid
set key outside right
set format "%%g"
set title "%s"
set xlabel "%s"
set ylabel "%s"
'''
TERMINALS = {'svg': 'svg size 900,600 background "white"', 'png': 'pngcairo size 900,600'}


class Figure:
    """Series of points with a name each; axes are logarithmic where `log` says so."""

    def __init__(self, name, title, x, y, log='xy', lines=True):
        self.name, self.title, self.x, self.y, self.log, self.lines = name, title, x, y, log, lines
        self.series = {}

    def add(self, series, x, y):
        if y > 0 or 'y' not in self.log:
            self.series.setdefault(series, []).append((x, y))

    def write(self, folder):
        if not self.series:
            return
        blocks = '\n\n\n'.join('\n'.join('%.9g %.9g' % p for p in points) for points in self.series.values())
        data = os.path.join(folder, self.name + '.dat')
        with open(data, 'w') as out:
            out.write(blocks + '\n')
        style = 'linespoints' if self.lines else 'points'
        plots = ', '.join('"%s" index %d title "%s" with %s pointtype %d' % (data, i, name, style, i + 4)
                          for i, name in enumerate(self.series))
        for kind, terminal in TERMINALS.items():
            script = HEAD % (terminal, os.path.join(folder, '%s.%s' % (self.name, kind)), self.title, self.x, self.y)
            if self.log:
                script += 'set logscale %s\n' % self.log
            # If the plotter fails, the measurements are still good.
            subprocess.run(['gnuplot'], input=script + 'plot ' + plots + '\n', text=True, check=False)
        os.remove(data)


# mm: where misses are drawn.
MISSED = 1000.0


def error_figure(rows):
    figure = Figure('time-against-error', 'Run time against error (%g mm: missed)' % MISSED, 'checking time a block, s',
                    'error of the instant of contact, mm of motion', lines=False)
    for row in rows:
        if row['truth'] != 'contact' or not row['verdict'] or row['seconds_per_block'] == '':
            continue
        # An error below that of the truth itself has no meaning.
        error = MISSED if int(row['miss']) else max(abs(float(row['motion_error_mm'] or 0)), 1e-6)
        if float(row['seconds_per_block']) > 0:
            figure.add(row['method'], float(row['seconds_per_block']), error)
    return figure


def cost_figure(rows, varied, name, title, label):
    figure = Figure(name, title, label, 'checking time a block, s')
    for row in rows:
        if row['varied'] == varied:
            figure.add(row['method'], max(float(row['value']), 0.01), float(row['seconds_per_block']))
    return figure


def step_figures(rows):
    """The paper's two: each method's time for one step of each motion."""
    for method in ('conventional', 'interpolated'):
        figure = Figure('step-' + method, 'Time a motion step, ' + method, 'motion', 'time a step, s', log='y')
        for row in rows:
            figure.add('step %g s' % float(row['step']), int(row['motion']), float(row[method]))
        yield figure


def draw(folder, accuracy, costs, steps):
    if not shutil.which('gnuplot'):
        say('figures: skipped: no gnuplot')
        return
    figures = [error_figure(accuracy),
               cost_figure(costs, 'triangles', 'cost-against-triangles', 'Cost against triangles', 'triangles'),
               cost_figure(costs, 'blocks', 'cost-against-length', 'Cost against program length', 'blocks'),
               cost_figure(costs, 'gap', 'cost-against-clearance', 'Cost against clearance', 'clearance, mm'),
               cost_figure(costs, 'length', 'cost-against-block-length', 'Cost against block length', 'block, mm')]
    for figure in figures + list(step_figures(steps)):
        figure.write(folder)
