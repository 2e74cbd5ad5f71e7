"""targets.py - the project's own targets, each measured in one run together with what it is compared with."""
import math
import os

import balls
import judge
import meshes
import peers
import real
import trunnion
from measure import median, ratio, rounds, say, timed
from scene import Scene

COLUMNS = ['figure', 'target', 'reached', 'met', 'how']
MEGA = 1000000
PLAIN_BLOCKS = 500000
# Blocks of each of eight programs, and of one program, for two threads.
EIGHTH_BLOCKS = 250000
LARGE_BLOCKS = 800000
# The first lines, one block, the last lines.
WORDS = 'N%d G1 X%.3f Y%.3f Z%.3f\n'
PLAIN = {
    'linuxcnc': ('G21 G90 G17 G40 G61 G94 F1000\n', WORDS, 'M2\n'),
    'fanuc': ('%\nO1\nG21 G90 G17 G40 G54 G94 F1000.\n', WORDS, 'M30\n%\n'),
    'haas': ('%\nO1\nG21 G90 G17 G40 G54 G94 F1000.\n', WORDS, 'M30\n%\n'),
    'sinumerik': ('G500 G71 G90 G17 G40 G60 G94 F1000\n', WORDS, 'M30\n'),
    'klartext': ('0 BEGIN PGM PLAIN MM\n', '%d L X%+.3f Y%+.3f Z%+.3f R0 F1000\n', 'END PGM PLAIN MM\n'),
}


class Targets:
    def __init__(self, tools, out, blocks):
        self.tools, self.out, self.blocks, self.rows, self.peer_rows = tools, out, blocks, [], []

    def folder(self, name):
        return os.path.join(self.out, name)

    def add(self, figure, target, reached, met, how):
        self.rows.append(dict(zip(COLUMNS, (figure, target, reached, 'yes' if met else 'no', how))))
        say('  %s: %s, target %s' % (figure, reached, target))

    def skip(self, figure, target, why):
        self.rows.append(dict(zip(COLUMNS, (figure, target, '', 'skipped', why))))
        say('  %s: skipped: %s' % (figure, why))

    def at_most(self, figure, limit, value, how, unit='x'):
        self.add(figure, '<= %g%s' % (limit, unit), '%.3g%s' % (value, unit), value <= limit, how)

    def at_least(self, figure, limit, value, how, unit='x'):
        self.add(figure, '>= %g%s' % (limit, unit), '%.4g%s' % (value, unit), value >= limit, how)

    def per_block(self, scene, *options):
        """Seconds of the checking phase only."""
        return judge.check_seconds(self.tools, scene, list(options), 1) / judge.blocks_until(scene, None)

    def old_per_block(self, scene):
        return self.tools.old and (judge.check_seconds(self.tools, scene, [], 1, self.tools.old) /
                                   judge.blocks_until(scene, None))

    def against_reading(self):
        say('targets: a long program against reading it')
        self.long = trunnion.inside(self.folder('inside-long'), self.tools, self.blocks)
        checked, read = rounds(self.tools.runs, lambda: self.tools.check(self.long, ['-j', '1']).cpu,
                               lambda: self.tools.check(self.long, ['--parse-only']).cpu)
        self.at_most('certified / --parse-only', 2, ratio(checked, read),
                     '%d blocks, five axes; processor time of whole runs, one thread, %.2f s and %.2f s' %
                     (self.blocks, median(checked), median(read)))

    def scenes_of_peers(self):
        """The scenes for the libraries and the sampled methods: (title, scene, target of the fastest library)."""
        self.lap = trunnion.inside(self.folder('inside-lap'), self.tools)
        self.probe = trunnion.bore(self.folder('bore'), 20000)
        found = [('between the blades', self.lap, 2), ('in a bore', self.probe, 1),
                 ('far apart', trunnion.far(self.folder('far'), 100000), 1),
                 ('clear.nc of the A/C machine', next(trunnion.examples(self.out)), 15)]
        if self.tools.real:
            limits = {'model_1.ngc': 20, 'simple_curve.ngc': 25}
            found += [(s.name, s, limits[s.name]) for s in real.scenes(self.tools, self.out) if s.name in limits]
        return found

    def peers(self):
        """The fastest library on each scene; all of them are in peers.csv."""
        scenes = self.scenes_of_peers()
        self.peer_rows = peers.rows(self.tools, [(title, scene) for title, scene, _ in scenes])
        for title, _, limit in scenes:
            for samples, target in (('0.01 s', limit), ('0.001 mm', 1e5)):
                figure = 'fastest library at %s / certified, %s' % (samples, title)
                rows = [r for r in self.peer_rows if r['scene'] == title and r['samples'] == samples]
                if not rows:
                    self.skip(figure, '>= %g' % target, 'neither libfcl-dev nor libode-dev')
                    continue
                best = min(rows, key=lambda r: float(r['times']))
                self.at_least(figure, target, float(best['times']),
                              ', '.join('%s %s' % (r['peer'], r['times']) for r in rows))

    def sampled(self):
        say('targets: against the sampled methods')
        for title, scene in (('between the blades', self.lap), ('in a bore', self.probe)):
            ours, theirs, paper = rounds(self.tools.runs, lambda: self.per_block(scene),
                                         lambda: self.per_block(scene, '--method', 'conventional'),
                                         lambda: self.per_block(scene, '--method', 'interpolated'))
            self.at_least('conventional at 0.01 s / certified, ' + title, 300, ratio(theirs, ours), 'checking alone')
            self.at_least('conventional / interpolated at 0.01 s, ' + title, 4.5, ratio(theirs, paper),
                          'checking alone')

    def tight(self):
        say('targets: tight work')
        scene = trunnion.tight(self.folder('tight'), 40000)
        times, old = rounds(self.tools.runs, lambda: self.per_block(scene), lambda: self.old_per_block(scene))
        self.at_least('tight work', 200000, 1 / median(times), 'checking alone', ' blocks/s')
        figure = 'tight work, blocks/s against the old program'
        if self.tools.old:
            self.at_least(figure, 3, ratio(old, times), 'checking alone')
        else:
            self.skip(figure, '>= 3x', 'BENCH_OLD names none')

    def loading(self):
        say('targets: loading')
        machine, _ = balls.write_machine(self.folder('mega'), MEGA)
        program = os.path.join(self.out, 'step.nc')
        with open(program, 'w') as out:
            out.write('G21 G90 G0 X1\nM2\n')
        mega = Scene('mega', self.folder('mega'), machine, None, program)
        small_machine, _ = balls.write_machine(self.folder('small'), 1000)
        small = Scene('small', self.folder('small'), small_machine, None, program)
        loads = [self.tools.check(mega) for _ in range(self.tools.runs)]
        smalls = [self.tools.check(small) for _ in range(10 * self.tools.runs)]
        single, double, pair = rounds(self.tools.runs, lambda: self.tools.check(mega, ['-j', '1']),
                                      lambda: self.tools.check(mega, ['-j', '2']),
                                      lambda: self.tools.check_twice(mega, ['-j', '1']))
        one, two = ([s.phases()[0] for s in runs] for runs in (single, double))
        self.at_most('loading 1,000,000 triangles', 0.25, median(one), 'files in memory, wall time', ' s')
        # Two processes share only the machine: two threads must lose at least as much time as each of them loses.
        self.at_most('the same with two threads', 0.5, ratio(two, one),
                     'wall time against one thread; two processes at once, each with one thread, take %.3gx a load' %
                     (0.5 * ratio([s.wall for s in pair], [s.wall for s in single])))
        self.at_most('small machine, start to exit', 10, 1e3 * median([s.wall for s in smalls]),
                     '1,000 triangles', ' ms')
        bytes_each = (median([s.peak for s in loads]) - median([s.peak for s in smalls])) / (MEGA - 1000)
        self.at_most('peak memory a triangle', 150, bytes_each, 'more than with 1,000', ' bytes')

    def starting(self):
        """From start to verdict of a program of one move: one thread, processor time."""
        say('targets: starting')
        program = os.path.join(self.out, 'step.nc')
        with open(program, 'w') as out:
            out.write('G21 G90 G0 X1\nM2\n')
        for title, setup, limit in (
                ('A/C machine with its setup', os.path.join(trunnion.JOB, 'setup.xml'), 40),
                ('30 tools and 10 fixtures', trunnion.crowded_setup(self.folder('crowded')), 60)):
            scene = Scene('start', self.out, trunnion.MACHINE, setup, program)
            times = [self.tools.check(scene, ['-j', '1', '-q']).cpu for _ in range(4 * self.tools.runs)]
            self.at_most(title + ', start to exit', limit, 1e3 * median(times), 'processor time, one thread', ' ms')

    def outputs(self):
        """The cost of -v and --clearance-report if bodies are near each other all the time."""
        say('targets: what measuring costs')
        scenes = [('tight work', trunnion.tight(self.folder('tight-outputs'), 20000))]
        if self.tools.real:
            scenes += [(s.name, s) for s in real.scenes(self.tools, self.out)
                       if s.name in ('model_1.ngc', 'simple_curve.ngc')]
        for title, scene in scenes:
            for option, file in (('-v', ''), ('--clearance-report', 'clearances.tsv'), ('--report', 'report.html')):
                argument = option + ('=' + os.path.join(self.out, file) if file else '')
                plain, measured = rounds(self.tools.runs, lambda: self.tools.check(scene, ['-j', '1']).cpu,
                                         lambda: self.tools.check(scene, ['-j', '1', argument]).cpu)
                self.at_most('%s / plain, %s' % (option, title), 2, ratio(measured, plain),
                             'processor time of whole runs')

    def memory(self):
        """Programs of 10^4 to 10^7 blocks on a pipe; the same lap over and over."""
        say('targets: memory against length')
        with open(self.lap.program) as text:
            lines = text.read().split('\n')
        # The head ends with the approach; the last lines are M2 and an empty line. Without them a lap is closed.
        head, lap = lines[:8], '\n'.join(lines[8:10008]) + '\n'
        back = '\n'.join(reversed(lines[8:10008])) + '\n'
        peaks = {}
        for count in (1, 10, 100, 1000):
            if count * 10000 > 10 * self.blocks:
                continue
            path = os.path.join(self.out, 'length.nc')
            with open(path, 'w') as out:
                out.write('\n'.join(head) + '\n')
                for i in range(count):
                    out.write(back if i % 2 else lap)
                out.write('M2\n')
            with open(path) as program:
                spent = self.tools.run([self.tools.fivecheck] + self.lap.operands() + ['-'], stdin=program)
            if spent.status:
                raise SystemExit('bench: %s' % spent.err)
            peaks[count * 10000] = spent.peak
            os.remove(path)
        self.at_most('peak memory, longest / shortest program', 1.05, max(peaks.values()) / min(peaks.values()),
                     ', '.join('%d: %.1f MB' % (n, p / 1e6) for n, p in peaks.items()))

    def growth(self):
        """A report has a resolution of 1 ms, so the program is long."""
        say('targets: growth')
        alone, whole = [], []
        cache = {}
        for triangles in (1000, MEGA):
            scene = balls.make(self.folder('growth-%d' % triangles), 1, triangles, 10.0, 0.1, 1.0, 200000, cache=cache)
            runs = [self.tools.check(scene, ['-j', '1']) for _ in range(2 * self.tools.runs)]
            alone.append([spent.checking() for spent in runs])
            whole.append([spent.reading() + spent.checking() for spent in runs])
        self.at_most('1,000 to 1,000,000 triangles, a block', 4, ratio(whole[1], whole[0]),
                     'read and checked; balls 10 mm apart, 0.1 mm blocks')
        self.at_most('1,000 to 1,000,000 triangles, a block, checking alone', 4, ratio(alone[1], alone[0]),
                     'the same, without reading')

    def threads(self):
        """Programs so long that start and load times hardly count, whatever --blocks says."""
        say('targets: two threads')
        eight = trunnion.inside(self.folder('inside-eight'), self.tools, EIGHTH_BLOCKS)
        large = trunnion.tight(self.folder('tight-long'), LARGE_BLOCKS)
        gain, processes = self.two_threads('eight programs', eight, [eight.program] * 8, 4, 1.9)
        self.at_least('-j 2 / two processes at once, eight programs', 1, gain / processes,
                      'four of the programs each: %.4gx and %.4gx' % (gain, processes))
        self.two_threads('one large program', large, [large.program], 1, 1.8)
        blades = trunnion.inside(self.folder('inside-large'), self.tools, LARGE_BLOCKS)
        self.two_threads('one large program between the blades', blades, [blades.program], 1, 1.8)

    def two_threads(self, title, scene, programs, share, target):
        """The gain of -j 2, and that of two processes at once that each check `share` of the programs."""
        runs = 4 * self.tools.runs
        with open(os.path.join(self.out, 'step.nc'), 'w') as out:
            out.write('G21 G90 G0 X1\nM2\n')
        one, two, pair, start = rounds(
            runs, lambda: self.tools.check(scene, ['-j', '1', '-f', 'ndjson'], programs),
            lambda: self.tools.check(scene, ['-j', '2', '-f', 'ndjson'], programs),
            lambda: self.tools.check_twice(scene, ['-j', '1', '-f', 'ndjson'], programs[:share]),
            lambda: self.tools.check(scene, ['-j', '1', '-f', 'ndjson'], [out.name]))
        wall = min(s.wall for s in one)
        gain = wall / min(s.wall for s in two)
        processes = 2 * share / len(programs) * wall / min(s.wall for s in pair)
        self.at_most('-j 2, processor time, ' + title, 1.05, min(s.cpu for s in two) / min(s.cpu for s in one),
                     'against -j 1, the least of %d runs each' % runs)
        self.at_least('-j 2, ' + title, target, gain,
                      'wall time, the least of %d runs each; %.0f of %.0f ms are starting and loading; two processes '
                      'at once: %.4gx; output %s' %
                      (runs, 1e3 * min(s.wall for s in start), 1e3 * wall, processes,
                       'the same' if one[0].out + one[0].err == two[0].out + two[0].err else 'DIFFERS'))
        return gain, processes

    def reading(self):
        say('targets: reading against rs274')
        figure = 'interpretation, blocks/s against rs274'
        if not self.tools.rs274:
            self.skip(figure, '>= 25x', 'no rs274')
            return
        program = os.path.join(self.out, 'read.ngc')
        with open(self.long.program) as text, open(program, 'w') as out:
            out.writelines([line for line in text if line[:2] in ('G2', 'G9', 'G1', 'G0', ' X')][:200000] + ['M2\n'])
        scene = Scene('read', self.out, trunnion.MACHINE, None, program)
        ours, theirs = rounds(self.tools.runs, lambda: self.tools.check(scene, ['--parse-only', '-q']).cpu,
                              lambda: self.reference(program))
        self.at_least(figure, 25, ratio(theirs, ours),
                      'processor time of whole runs, %.2f s and %.2f s; rs274 prints its calls' %
                      (median(ours), median(theirs)))

    def dialects(self):
        say('targets: reading plain motion in each dialect')
        for name, form in sorted(PLAIN.items()):
            program = os.path.join(self.out, 'plain.' + name)
            with open(program, 'w') as out:
                out.write(form[0])
                for i in range(PLAIN_BLOCKS):
                    out.write(form[1] % (i + 1, 50 * math.cos(i / 500), 50 * math.sin(i / 700), math.sin(i / 90) - 10))
                out.write(form[2])
            scene = Scene('plain', self.out, trunnion.MACHINE, None, program)
            times, = rounds(self.tools.runs, lambda: self.tools.check(scene, ['--parse-only', '-q',
                                                                              '--dialect=' + name]).cpu)
            self.at_least('reading plain motion, ' + name, 500000, PLAIN_BLOCKS / median(times),
                          'processor time of whole runs of %d blocks' % PLAIN_BLOCKS, ' blocks/s')

    def reference(self, program):
        variables = os.path.join(self.out, 'rs274.var')
        numbers = ([n + i for n in (5161, 5181) for i in range(9)] + list(range(5210, 5221)) +
                   [n + i for n in range(5221, 5400, 20) for i in range(10)])
        with open(variables, 'w') as out:
            out.writelines('%d\t%f\n' % (n, n == 5220) for n in numbers)
        tools = os.path.join(trunnion.ROOT, 'tests', 'rs274', 'tools.tbl')
        spent = self.tools.run(['sh', '-c', 'exec "$@" >/dev/null', 'sh', self.tools.rs274, '-g', '-v', variables,
                                '-t', tools, program])
        if spent.status:
            raise SystemExit('bench: rs274: %s' % spent.err[-300:])
        return spent.cpu

    def all(self):
        for part in (self.against_reading, self.peers, self.sampled, self.tight, self.loading, self.starting,
                     self.outputs, self.memory, self.growth, self.threads, self.reading,
                     self.dialects):
            timed('targets, ' + part.__name__, part)
        return self.rows
