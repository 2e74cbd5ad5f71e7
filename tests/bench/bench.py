#!/usr/bin/env python3
"""bench.py - run time against error: fivecheck's proof, the paper's two methods, FCL. See README.md beside this."""
import argparse
import csv
import os
import platform
import sys

import ablation
import accuracy
import figures
import peers
import readme
import real
import series
import stock
import targets
import trunnion
from measure import Tools, say, timed

HERE = os.path.dirname(os.path.abspath(__file__))
PARTS = ['accuracy', 'targets', 'series', 'ablation', 'real', 'stock']
LIBRARIES = ['fcl', 'ode', 'coal']


def write(tools, name, columns, rows):
    with open(os.path.join(tools.out, name), 'w', newline='') as out:
        table = csv.DictWriter(out, columns, lineterminator='\n')
        table.writeheader()
        table.writerows(rows)


def read(tools, name):
    path = os.path.join(tools.out, name)
    if not os.path.exists(path):
        return []
    with open(path, newline='') as text:
        return list(csv.DictReader(text))


def first_of(path, key):
    with open(path) as text:
        return next((line.split(':', 1)[1].strip() for line in text if line.startswith(key)), '?')


def describe(tools, compiler):
    rows = [('processor', first_of('/proc/cpuinfo', 'model name')), ('cores', str(os.cpu_count())),
            ('memory', first_of('/proc/meminfo', 'MemTotal')), ('system', platform.platform()),
            ('compiler', compiler), ('runs', str(tools.runs)),
            ('libraries', ', '.join(tools.peers) or 'skipped'),
            ('rs274', 'yes' if tools.rs274 else 'skipped: not found')]
    with open(os.path.join(tools.out, 'computer.txt'), 'w') as out:
        out.writelines('%s: %s\n' % row for row in rows)
    return rows


def show(rows):
    """A table whose columns are as wide as their contents."""
    rows = [[str(x) for x in row] for row in rows]
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    for row in rows:
        print('  '.join(x.ljust(w) for x, w in zip(row, widths)).rstrip())
    print()


def keep(tools, name, columns, rows):
    write(tools, name, columns, rows)
    show([columns] + [[r[c] for c in columns] for r in rows])


def show_accuracy(rows):
    print('Against the truth (misses and errors of what was run, not of what was extrapolated):')
    show([['method', 'setting', 'scenes', 'contacts', 'misses', 'false alarms', 'blocks off', 'mm off']] +
         accuracy.summary(rows))


def wrong(rows):
    return [r for r in rows if r['method'] == 'certified' and (r['miss'] or r['false_alarm'])]


def run_parts(tools, arguments):
    scenes, results = os.path.join(tools.out, 'scenes'), {}
    chosen = arguments.only.split(',') if arguments.only else PARTS
    os.makedirs(scenes, exist_ok=True)
    if 'accuracy' in chosen:
        rows = timed('accuracy', lambda: accuracy.run(tools, scenes, arguments.seed, arguments.scenes, False))
        write(tools, 'accuracy.csv', accuracy.judge.COLUMNS, rows)
        show_accuracy(rows)
        results['wrong'] = wrong(rows)
    if 'targets' in chosen:
        figured = targets.Targets(tools, scenes, arguments.blocks)
        keep(tools, 'targets.csv', targets.COLUMNS, timed('targets', figured.all))
        keep(tools, 'peers.csv', peers.COLUMNS, figured.peer_rows)
    if 'series' in chosen:
        write(tools, 'cost.csv', series.COLUMNS, timed('cost', lambda: series.cost_rows(tools, scenes, 2)))
        write(tools, 'steps.csv', series.STEP_COLUMNS, timed('steps', lambda: series.step_rows(tools, scenes)))
        keep(tools, 'paper.csv', series.PAPER_COLUMNS, timed('paper', lambda: series.paper_rows(tools)))
    if 'ablation' in chosen:
        chosen_scenes = [
            trunnion.inside(os.path.join(scenes, 'ablate-blades'), tools), next(trunnion.examples(scenes)),
            trunnion.tight(os.path.join(scenes, 'ablate-tight'), 20000),
            trunnion.far(os.path.join(scenes, 'ablate-far'), 100000)]
        chosen_scenes += list(real.scenes(tools, scenes)) if tools.real else []
        keep(tools, 'ablation.csv', ablation.COLUMNS,
             timed('ablation', lambda: ablation.rows(tools, arguments.source, chosen_scenes)))
    if 'real' in chosen and tools.real:
        keep(tools, 'real.csv', real.COLUMNS, timed('real', lambda: real.rows(tools, scenes)))
    if 'stock' in chosen:
        keep(tools, 'stock.csv', stock.COLUMNS,
             timed('stock', lambda: stock.rows(tools, scenes, arguments.blocks)))
    figures.draw(tools.out, read(tools, 'accuracy.csv'), read(tools, 'cost.csv'), read(tools, 'steps.csv'))
    print(readme.write_table(tools.out))
    return results.get('wrong', [])


def main():
    parser = argparse.ArgumentParser(description=__doc__.split('\n')[0])
    parser.add_argument('--quick', action='store_true', help='correctness only, in less than two minutes')
    parser.add_argument('--build', required=True, help='folder of fivecheck; results go to its bench/')
    parser.add_argument('--source', default=os.path.normpath(os.path.join(HERE, '..', '..')))
    parser.add_argument('--rs274', default='')
    parser.add_argument('--compiler', default='')
    parser.add_argument('--real', default='')
    parser.add_argument('--old', default='', help='another fivecheck to compare tight work with')
    parser.add_argument('--only', default='', help='some of ' + ','.join(PARTS))
    parser.add_argument('--seed', type=int, default=1)
    parser.add_argument('--scenes', type=int, default=0)
    parser.add_argument('--runs', type=int, default=3)
    parser.add_argument('--blocks', type=int, default=1000000, help='of the long program')
    arguments = parser.parse_args()
    out = os.path.join(os.path.abspath(arguments.build), 'bench')
    programs = {} if arguments.quick else {name: os.path.join(out, 'peer_' + name) for name in LIBRARIES}
    tools = Tools(os.path.abspath(arguments.build), out, {n: p for n, p in programs.items() if os.path.exists(p)},
                  arguments.rs274 or None, arguments.real, arguments.old or None, arguments.runs)
    arguments.scenes = arguments.scenes or 45
    show(describe(tools, arguments.compiler))
    if arguments.quick:
        os.makedirs(os.path.join(out, 'scenes'), exist_ok=True)
        rows = accuracy.run(tools, os.path.join(out, 'scenes'), arguments.seed, arguments.scenes, True)
        write(tools, 'quick.csv', accuracy.judge.COLUMNS, rows)
        show_accuracy(rows)
        bad = wrong(rows)
    else:
        bad = run_parts(tools, arguments)
    for row in bad:
        say('bench: certified is wrong on %s at %s: %s' % (row['scene'], row['setting'], row))
    return 1 if bad else 0


if __name__ == '__main__':
    sys.exit(main())
