"""measure.py - runs programs and measures their time and memory."""
import os
import re
import statistics
import subprocess
import sys
import time


class Spent:
    """One run: seconds of processor time and of wall time, peak memory in bytes, status, and what it printed."""

    def __init__(self, figures, out, err):
        user, system, self.wall, peak, status = (float(x) for x in figures.split())
        self.cpu, self.peak, self.status = user + system, 1024 * peak, int(status)
        self.out, self.err = out, err

    def phases(self):
        """Seconds of load, interpret, check, and the number of blocks, from a text report."""
        found = re.search(r'time +([\d.]+) s load, ([\d.]+) s interpret, ([\d.]+) s check', self.out)
        # Older programs print a table.
        blocks = re.search(r'^(?: *blocks +)?(\d+) (?:blocks?[,;]|in \d+ lines)', self.out, re.MULTILINE)
        if not found or not blocks:
            raise SystemExit('bench: no statistics in: %s%s' % (self.out, self.err))
        return [float(x) for x in found.groups()] + [int(blocks.group(1))]

    def _share(self, seconds):
        """Processor time of a run with one thread, whose statistics give the wall time."""
        return seconds * min(1, self.cpu / max(self.wall, 1e-9))

    def reading(self):
        """Seconds of processor time of reading and interpreting the program."""
        return self._share(self.phases()[1])

    def checking(self):
        """Seconds of processor time of the check alone."""
        return self._share(self.phases()[2])


class Tools:
    """The programs of the benchmark and its folder."""

    def __init__(self, build, out, peers, rs274, real, old, runs):
        """peers: programs by the library's name. old: another fivecheck to compare with, or None."""
        self.build, self.out, self.real, self.runs = build, out, real, runs
        self.fivecheck = os.path.join(build, 'fivecheck')
        self.truth, self.spend = os.path.join(out, 'truth'), os.path.join(out, 'spend')
        self.peers, self.rs274, self.old = peers, rs274, old

    def run(self, command, stdin=None, env=None):
        """Time and memory of a run; the caller checks the status."""
        figures = os.path.join(self.out, 'spent')
        run = subprocess.run([self.spend, figures] + command, capture_output=True, text=True, errors='replace',
                             stdin=stdin, env=env)
        if run.returncode:
            raise SystemExit('bench: %s: %s' % (command[0], run.stderr))
        with open(figures) as text:
            return Spent(text.read(), run.stdout, run.stderr)

    def check(self, scene, options=(), programs=None, expect=(0, 1), fivecheck=None, before=()):
        """One run of fivecheck on a scene; `before`: a command that runs the command after it."""
        spent = self.run(list(before) + [fivecheck or self.fivecheck] + list(options) + scene.operands() +
                         (programs or [scene.program]))
        if spent.status not in expect:
            raise SystemExit('bench: %s: fivecheck ended with status %d: %s%s' %
                             (scene.name, spent.status, spent.err, spent.out[:2000]))
        return spent

    def check_twice(self, scene, options=(), programs=None):
        """Two runs at once; their time shows what a second processor gains on this machine."""
        return self.check(scene, options, programs, before=['sh', '-c', '"$@" & "$@"; wait $!', 'sh'])


def say(text):
    """Prints the progress."""
    print(text, file=sys.stderr, flush=True)


def timed(title, action):
    """Returns the action's result and prints its time."""
    start = time.monotonic()
    result = action()
    say('    %.0f s: %s' % (time.monotonic() - start, title))
    return result


def median(values):
    return statistics.median(values)


def rounds(count, *actions):
    """Runs all actions in turn, count times, so that a disturbance affects all. Returns a list of results for each."""
    results = [[] for _ in actions]
    for _ in range(count):
        for result, action in zip(results, actions):
            result.append(action())
    return results


def ratio(over, under):
    """The median of the ratios of runs that were made side by side."""
    return median([a / max(b, 1e-9) for a, b in zip(over, under)])
