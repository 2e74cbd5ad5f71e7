"""reference.py - runs a program in rs274 and in fivecheck, and compares the motion of the axes."""
import math
import os
import re
import resource
import shutil
import signal
import subprocess
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
LINEAR = [True] * 3 + [False] * 3
INCH = 25.4
# rs274 prints four decimals in the active unit.
HALF_DIGIT = 5.01e-5
# A program that takes more processor time counts as endless.
SECONDS = 5

# The variables that rs274 keeps between runs: all offsets and reference points are 0, G54 is active.
VARIABLES = ([n + i for n in (5161, 5181) for i in range(9)] + list(range(5210, 5221)) +
             [n + i for n in range(5221, 5400, 20) for i in range(10)])


class Move:
    """A canonical move: its end (mm, degrees), how exactly the end is known, and its arc, if it is one."""

    def __init__(self, end, exact, arc=None):
        self.end, self.exact, self.arc = end, exact, arc


def numbers(text):
    return [float(x) for x in re.findall(r'-?\d+(?:\.\d+)?', text)]


def slots(values, unit):
    values = (values + [0.0] * 6)[:6]
    return [v * unit if LINEAR[i] else v for i, v in enumerate(values)]


class Canon:
    """Follows the canonical calls of rs274."""

    def __init__(self):
        self.unit, self.plane = INCH, 'XY'
        self.offsets = {}
        self.moves = []

    def total(self):
        return [sum(o[0][i] for o in self.offsets.values()) for i in range(6)]

    def exactness(self):
        result = []
        for i in range(6):
            sizes = [self.unit] + [o[1] for o in self.offsets.values() if o[0][i] != 0]
            result.append(sum(HALF_DIGIT * (s if LINEAR[i] else 1) for s in sizes))
        return result

    def straight(self, values):
        end = [a + b for a, b in zip(slots(values, self.unit), self.total())]
        self.moves.append(Move(end, self.exactness()))

    def arc(self, values):
        first, second, centre1, centre2, turns, rise = values[:6]
        a, b, n = {'XY': (0, 1, 2), 'XZ': (2, 0, 1), 'YZ': (1, 2, 0)}[self.plane]
        total = self.total()
        end = [0.0] * 6
        for slot, value in ((a, first), (b, second), (n, rise)):
            end[slot] = value * self.unit + total[slot]
        for i, value in enumerate((values[6:] + [0.0] * 3)[:3]):
            end[3 + i] = value + total[3 + i]
        centre = (centre1 * self.unit + total[a], centre2 * self.unit + total[b])
        self.moves.append(Move(end, self.exactness(), (a, b, centre, int(turns))))

    def call(self, name, text):
        if name == 'USE_LENGTH_UNITS':
            self.unit = INCH if 'INCH' in text else 1.0
        elif name == 'SELECT_PLANE':
            self.plane = {'ZX': 'XZ', 'ZY': 'YZ'}.get(text.split('_')[-1], text.split('_')[-1])
        elif name == 'SET_G5X_OFFSET':
            self.offsets[name] = (slots(numbers(text)[1:], self.unit), self.unit)
        elif name in ('SET_G92_OFFSET', 'USE_TOOL_LENGTH_OFFSET'):
            self.offsets[name] = (slots(numbers(text), self.unit), self.unit)
        elif name in ('STRAIGHT_TRAVERSE', 'STRAIGHT_FEED', 'STRAIGHT_PROBE'):
            self.straight(numbers(text))
        elif name == 'RIGID_TAP':
            # To the end and back.
            start = self.moves[-1] if self.moves else Move([0.0] * 6, [0.0] * 6)
            self.straight(numbers(text)[:3])
            self.moves.append(Move(start.end, start.exact))
        elif name == 'ARC_FEED':
            self.arc(numbers(text))


class Endless(Exception):
    """A program was stopped after SECONDS of processor time."""


def run(command, folder=None):
    limit = lambda: resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS + 1))
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, errors='replace', preexec_fn=limit)
    if done.returncode in (-signal.SIGXCPU, -signal.SIGKILL):
        raise Endless(' '.join(command))
    return done


class Programs:
    """The two programs, and a folder to run them in."""

    def __init__(self, fivecheck, rs274):
        self.fivecheck, self.rs274 = os.path.abspath(fivecheck), rs274
        self.folder = tempfile.mkdtemp(prefix='rs274-')
        self.variables = ''.join(f'{n}\t{1.0 if n == 5220 else 0.0:f}\n' for n in VARIABLES)

    def close(self):
        shutil.rmtree(self.folder)

    def run_reference(self, path):
        """rs274: whether it accepted the program, the moves, the messages."""
        variables = os.path.join(self.folder, 'rs274.var')
        with open(variables, 'w') as out:
            out.write(self.variables)
        tools = os.path.join(HERE, 'tools.tbl')
        done = run([self.rs274, '-g', '-v', variables, '-t', tools, os.path.basename(path)], os.path.dirname(path))
        canon = Canon()
        for line in done.stdout.splitlines():
            call = re.match(r' *\d+ +N\S* +([A-Z_0-9]+)\((.*)\)$', line)
            if call:
                canon.call(call.group(1), call.group(2))
        return done.returncode == 0, canon.moves, done.stderr

    def run_ours(self, path):
        """fivecheck: whether it accepted the program, the ends of the spans, the messages."""
        done = run([self.fivecheck, '--dump-path', '--tolerance=0.01', '--max-blocks=100000',
                    '--setup', os.path.join(HERE, 'setup.xml'), os.path.join(HERE, 'machine.xml'), path])
        rows = [[float(x) for x in line.split('\t')[3:9]] for line in done.stdout.splitlines()[1:]]
        return done.returncode == 0, rows, done.stderr


def is_at(position, move):
    return all(abs(p - e) <= x + 1e-9 for p, e, x in zip(position, move.end, move.exact))


def rests(last, move):
    """Is the move so short that it may be no move at all, as exactly as its two ends are known?"""
    return all(abs(s - e) <= x + y for s, e, x, y in zip(last.end, move.end, last.exact, move.exact))


def sweep_of(last, move):
    """The angle of an arc, in radians. Between two ends that may be the same, as exactly as they are known, it is a
    full turn."""
    a, b, centre, turns = move.arc
    start = math.atan2(last.end[b] - centre[1], last.end[a] - centre[0])
    end = math.atan2(move.end[b] - centre[1], move.end[a] - centre[0])
    sign = 1 if turns > 0 else -1
    angle = (sign * (end - start)) % (2 * math.pi)
    if all(abs(last.end[i] - move.end[i]) <= last.exact[i] + move.exact[i] for i in (a, b)):
        angle = 2 * math.pi
    return sign * (angle + 2 * math.pi * (abs(turns) - 1))


def follow_arc(last, move, rows):
    """Takes the chords of an arc from rows. The value is a description of the difference, or None."""
    a, b, centre, _ = move.arc
    position, expected, swept = last.end, sweep_of(last, move), 0.0
    while rows:
        row = rows.pop(0)
        step = (math.atan2(row[b] - centre[1], row[a] - centre[0]) -
                math.atan2(position[b] - centre[1], position[a] - centre[0]))
        swept += (step + math.pi) % (2 * math.pi) - math.pi
        position = row
        if is_at(row, move) and abs(swept - expected) < 0.01:
            return None
        if abs(swept) > abs(expected) + 0.01:
            break
    return f'an arc to {move.end} with a sweep of {math.degrees(expected):.3f}: swept {math.degrees(swept):.3f}'


def difference(moves, rows, to_the_end=True):
    """Describes the first move that the rows do not make, or None. Rows that stop early are compared as far as they go.
    """
    last, rows = Move([0.0] * 6, [0.0] * 6), list(rows)
    for i, move in enumerate(moves):
        if not rows and not to_the_end:
            return None
        if move.arc:
            wrong = follow_arc(last, move, rows)
            if wrong:
                return f'move {i + 1}: {wrong}'
        elif rows and is_at(rows[0], move):
            rows.pop(0)
        elif not rests(last, move):
            return f'move {i + 1} goes to {move.end}, not to {rows[0] if rows else "anywhere"}'
        else:
            continue
        last = move
    # Moves that are too short to be distinguished from none may be left.
    end = Move(last.end, [2 * x for x in last.exact])
    left = [row for row in rows if not is_at(row, end)]
    return f'{len(left)} more moves, the first to {left[0]}' if left else None


# LinuxCNC 2.9 compares exactly, later versions treat nearly equal numbers as equal; and where a sine vanishes, the sine
# of LinuxCNC may have either sign. fivecheck refuses programs that depend on either.
VERSIONS_DISAGREE = re.compile(r': error: ((EQ|NE|LE|GE) of numbers that differ by only \S+: versions of LinuxCNC disagree|'
                               'the rounding error of a sine)')


def stops_where_versions_disagree(programs, path):
    """Does fivecheck stop, according to its message, at a comparison that versions of LinuxCNC answer differently?"""
    accepted, _, messages = programs.run_ours(path)
    return not accepted and VERSIONS_DISAGREE.search(messages) is not None


def compare(programs, path):
    """None if both agree, up to the place where versions of LinuxCNC disagree; otherwise a description of the
    difference."""
    accepted, moves, complaint = programs.run_reference(path)
    ours, rows, messages = programs.run_ours(path)
    if accepted and not ours and VERSIONS_DISAGREE.search(messages):
        return difference(moves, rows, to_the_end=False)
    if accepted != ours:
        if accepted:
            return f'rs274 accepts it, fivecheck says: {messages.strip()}'
        return f'fivecheck accepts it, rs274 says: {complaint.strip()}'
    return difference(moves, rows) if accepted else None
