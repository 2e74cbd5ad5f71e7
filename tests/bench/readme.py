#!/usr/bin/env python3
"""readme.py - the README's table of costs, from the tables of a run.

  readme.py FOLDER README     puts FOLDER/readme.md, which the run wrote, in the place of the table
"""
import csv
import os
import sys

HEAD = '| figure | reached |\n|---|---|\n'

# The text of a row, and the figures in it: (file, column, the value of each column that picks the row).
TARGET = 'targets.csv'


def target(figure):
    return TARGET, 'reached', {'figure': figure}


def peer(scene, name, samples='0.01 s'):
    return 'peers.csv', 'times', {'scene': scene, 'peer': name, 'samples': samples}


def real(name, column='checked_by_read'):
    return 'real.csv', column, {'program': name}


BLADES, BORE, FAR, JOB = 'between the blades', 'in a bore', 'far apart', 'clear.nc of the A/C machine'
LARGE = 'one large program', 'one large program between the blades'
FASTEST = 'fastest library at %s / certified, %s'
ROWS = [
    ('`-v`, `--clearance-report`, `--report` against the plain check, bodies near each other all the time',
     [target('%s / plain, tight work' % o) for o in ('-v', '--clearance-report', '--report')]),
    ('the same on a real program: a nozzle that slides tenths of a mm above the table (34,453 lines)',
     [target('%s / plain, model_1.ngc' % o) for o in ('-v', '--clearance-report', '--report')]),
    ('certified check against `--parse-only`: that program; one of 41,680 lines on the same machine',
     [real('model_1.ngc'), real('simple_curve.ngc')]),
    ('the same two, checked with loading and reading, one thread',
     [real(name, 'checked_a_second') for name in ('model_1.ngc', 'simple_curve.ngc')]),
    ('certified check of many five-axis blocks between an impeller\'s blades, against `--parse-only` of the same',
     [target('certified / --parse-only')]),
    ('two threads: eight programs; one program, read by one and checked by the other; one between the blades',
     [target('-j 2, eight programs')] + [target('-j 2, ' + p) for p in LARGE]),
    ('the eight with two threads against two processes at once that check four each',
     [target('-j 2 / two processes at once, eight programs')]),
    ('processor time of two threads against one: the same three',
     [target('-j 2, processor time, eight programs')] + [target('-j 2, processor time, ' + p) for p in LARGE]),
    ('1,000 to 1,000,000 triangles, a block: checking alone; with its reading',
     [target('1,000 to 1,000,000 triangles, a block%s' % what) for what in (', checking alone', '')]),
    ('a library that looks at samples of 0.01 s against the certified check, the fastest on each scene (FCL or ODE, '
     'boxes first; FCL also skipping samples by its own distances; Coal where it was there): between the blades, where '
     'a block is an eighth of a sample long on average; far apart; `clear.nc` of the A/C machine; a probe at work in a '
     'bore, over and over the same paths',
     [target(FASTEST % ('0.01 s', s)) for s in (BLADES, FAR, JOB, BORE)]),
    ('the same on the two real programs',
     [target(FASTEST % ('0.01 s', s)) for s in ('model_1.ngc', 'simple_curve.ngc')]),
    ('the same six at samples of 0.001 mm, as exact as the proof (extrapolated)',
     [target(FASTEST % ('0.001 mm', s)) for s in (BLADES, FAR, JOB, BORE, 'model_1.ngc', 'simple_curve.ngc')]),
    ('the conventional method at 0.01 s against the certified check: in the bore, between the blades',
     [target('conventional at 0.01 s / certified, ' + s) for s in (BORE, BLADES)]),
    ('a ball 0.15 to 0.85 mm from a post, A and C turning, blocks of 0.1 mm', [target('tight work')]),
    ('loading 1,000,000 triangles; with two threads',
     [target('loading 1,000,000 triangles'), target('the same with two threads')]),
    ('start to exit: a small machine and program', [target('small machine, start to exit')]),
    ('start to exit, one thread: the A/C machine with its setup; with 30 tools and 10 fixtures',
     [target('A/C machine with its setup, start to exit'), target('30 tools and 10 fixtures, start to exit')]),
    ('memory a triangle; the longest program of the run against the shortest',
     [target('peak memory a triangle'), target('peak memory, longest / shortest program')]),
    ('reading, against LinuxCNC\'s rs274, which prints what it reads',
     [target('interpretation, blocks/s against rs274')]),
]


def read(folder, name):
    path = os.path.join(folder, name)
    if not os.path.exists(path):
        return []
    with open(path, newline='') as text:
        return list(csv.DictReader(text))


def shown(value):
    """A figure with its unit; large figures have three digits."""
    number = value.rstrip('abcdefghijklmnopqrstuvwxyz/ ')
    unit = value[len(number):]
    x = float(number)
    text = '{:,.0f}'.format(float('%.2g' % x if x >= 1000 else '%.3g' % x)) if x >= 100 else '%.2g' % x
    return text + unit


def figure_of(tables, file, column, wanted):
    """The figure of the wanted row, or None. A figure without a unit is a ratio."""
    value = next((r[column] for r in tables[file] if all(r[k] == v for k, v in wanted.items())), '')
    return shown(value if value[-1].isalpha() else value + 'x') if value else None


def write_table(folder):
    """Writes FOLDER/readme.md; a row that lacks a figure is left out. Returns the table."""
    tables = {name: read(folder, name) for name in (TARGET, 'peers.csv', 'real.csv')}
    table = HEAD
    for text, figures in ROWS:
        values = [figure_of(tables, *f) for f in figures]
        if all(values):
            table += '| %s | %s |\n' % (text, '; '.join(values))
    with open(os.path.join(folder, 'readme.md'), 'w') as out:
        out.write(table)
    return table


def renew(folder, readme):
    """Replaces the README's table; removes old rows that were not measured, and names them."""
    with open(os.path.join(folder, 'readme.md')) as text:
        table = text.read()
    with open(readme) as text:
        whole = text.read()
    begin = whole.index(HEAD)
    end = whole.index('\n\n', begin) + 1
    measured = {row.rsplit(' | ', 1)[0] for row in table.splitlines()}
    for row in whole[begin:end].splitlines():
        if row.rsplit(' | ', 1)[0] not in measured:
            print('readme: not measured, and removed: ' + row, file=sys.stderr)
    with open(readme, 'w') as out:
        out.write(whole[:begin] + table + whole[end:])


if __name__ == '__main__':
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    renew(sys.argv[1], sys.argv[2])
