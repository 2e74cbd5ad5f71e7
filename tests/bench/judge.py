"""judge.py - one method on one scene: its result compared with the truth, and its cost."""
import json

from measure import median

# mm: the error of the search that finds the truth.
GRAIN = 5e-5
# Runs of a short check; the mean counts.
SHORT_RUNS = 5

COLUMNS = ['scene', 'method', 'setting', 'blocks', 'seconds', 'seconds_per_block', 'extrapolated', 'truth', 'verdict',
           'miss', 'false_alarm', 'first_block_error', 'motion_error_mm', 'distance_mm']


class Truth:
    """contact: None, or (line, time, a, b)."""

    def __init__(self, tools, scene):
        self.tools, self.scene = tools, scene
        scene.prepare(tools)
        out = tools.run([tools.truth, 'first', scene.plain, scene.path])
        if out.status:
            raise SystemExit('bench: truth of %s: %s' % (scene.name, out.err))
        rows = [line.split('\t') for line in out.out.splitlines()]
        contacts = [(float(r[4]), int(r[3]), r[1], r[2]) for r in rows if r[0] == 'contact']
        self.contact = min(contacts) if contacts else None
        self.least = min([float(r[3]) for r in rows if r[0] == 'least'] or [0.0])
        self.against_formula()

    def against_formula(self):
        """The search and the formula must agree; otherwise neither is reliable."""
        known = self.scene.known
        if known is None:
            return
        if known == 'clear':
            good = not self.contact
        else:
            rate = 2e-4     # mm, at up to 1 m/s
            good = self.contact and known[0] - rate / 100 <= self.contact[0] <= known[1] + rate / 100
        if not good:
            raise SystemExit('bench: %s: the truth %s is not what the formula says, %s' %
                             (self.scene.name, self.contact, known))

    def compare(self, a, b, time, positions):
        """The distance of two bodies at the positions, and their motion between `time` and the true contact."""
        until = self.contact[0] if self.contact else time
        out = self.tools.run([self.tools.truth, 'at', self.scene.plain, self.scene.path, a, b] +
                             [repr(x) for x in [time, until] + positions])
        if out.status:
            raise SystemExit('bench: truth of %s: %s' % (self.scene.name, out.err))
        distance, motion = (float(x) for x in out.out.split())
        return distance, motion if time >= until else -motion


def axes_of(scene):
    with open(scene.plain) as text:
        return [line.split()[1] for line in text if line.startswith('axis ')]


def row_of(scene, method, setting, truth):
    row = dict.fromkeys(COLUMNS, '')
    row.update(scene=scene.name, method=method, setting=setting, extrapolated=0,
               truth='contact' if truth.contact else 'clear')
    return row


def judge(row, truth, finding, tolerance):
    """finding: None, or (line, time, a, b, axis positions as in the scene). tolerance: the method's promised error."""
    scene = truth.scene
    row['verdict'] = 'contact' if finding else 'clear'
    row['miss'], row['false_alarm'] = int(bool(truth.contact and not finding)), 0
    if not finding:
        return row
    line, time, a, b, positions = finding
    distance, motion = truth.compare(a, b, time, positions)
    row['distance_mm'] = '%.9g' % distance
    row['false_alarm'] = int(distance > tolerance + scene.slack + GRAIN)
    if truth.contact:
        row['first_block_error'] = line - truth.contact[1]
        row['motion_error_mm'] = '%.9g' % motion
        # A proof may stop early where the bodies are within the tolerance, but never late.
        if tolerance and motion > tolerance + scene.slack + GRAIN:
            row['miss'] = 1
    return row


def findings_of(spent):
    lines = [json.loads(line) for line in spent.out.splitlines() if line.startswith('{')]
    return [line for line in lines if line['kind'] not in ('header', 'program', 'summary')]


def finding_of(scene, rows):
    """The first finding that FCL can make, too: its pairs do not include a cutter in the part at rapid."""
    for row in rows:
        if row['kind'] in ('collision', 'clearance'):
            return row['line'], row['time'], row['a'], row['b'], [row['axes'][x] for x in axes_of(scene)]
    return None


def check_seconds(tools, scene, options, count, fivecheck=None, runs=1):
    """
    Seconds of processor time of checking alone, with one thread. A report counts milliseconds: a short check is the
    mean of several runs, and a very short one is repeated within one run, in which later checks save about a seventh,
    because some models of bodies exist by then.
    """
    def once():
        return tools.check(scene, ['-j', '1'] + options, [scene.program] * count, fivecheck=fivecheck).checking()

    times = []
    for _ in range(runs):
        seconds = once()
        if seconds < 0.01 and count < 64:
            return check_seconds(tools, scene, options, 8 * count, fivecheck, runs)
        if seconds < 0.05:
            seconds = (seconds + sum(once() for _ in range(SHORT_RUNS - 1))) / SHORT_RUNS
        times.append(seconds / count)
    return median(times)


def blocks_until(scene, finding):
    """Blocks that a check has to look at."""
    if finding:
        return finding[0]
    with open(scene.program) as text:
        return sum(1 for line in text if line.strip())


def own(tools, truth, method, setting, runs=1):
    """One of fivecheck's methods."""
    scene = truth.scene
    options = ['--method', method, '--tolerance' if method == 'certified' else '--step', repr(setting)]
    spent = tools.check(scene, options + ['-f', 'ndjson', '-q'])
    rows = findings_of(spent)
    finding = finding_of(scene, rows)
    stopped = finding
    if rows and not finding:
        # A finding that is not compared stopped the check: the whole program is checked and counted.
        options += ['--all']
        spent = tools.check(scene, options + ['-f', 'ndjson', '-q'])
        finding = finding_of(scene, findings_of(spent))
    row = judge(row_of(scene, method, setting, truth), truth, finding, setting if method == 'certified' else 0)
    row['blocks'] = blocks_until(scene, stopped)
    if runs:
        row['seconds'] = check_seconds(tools, scene, options, 1, runs=runs)
        row['seconds_per_block'] = '%.6g' % (row['seconds'] / row['blocks'])
    return row, spent.cpu


class Clear:
    """The truth of a scene that is known to be clear."""

    def __init__(self, scene):
        self.scene, self.contact = scene, None


def peer(tools, truth, step, limit, name='fcl', skip=False):
    """A library, for at most `limit` seconds; the rest is extrapolated."""
    scene = truth.scene
    out = tools.run([tools.peers[name], scene.plain, scene.path, repr(step), repr(limit)] + ['skip'] * skip)
    if out.status:
        raise SystemExit('bench: %s on %s: %s' % (name, scene.name, out.err))
    total, looked, seconds, _, a, b, line, time = out.out.rstrip('\n').split('\t')
    row = row_of(scene, name, step, truth)
    if a == '-' and looked != total:
        row.update(extrapolated=1, blocks=blocks_until(scene, None),
                   seconds=float(seconds) * float(total) / float(looked))
    else:
        finding = (int(line), float(time), a, b, position_at(scene, float(time))) if a != '-' else None
        judge(row, truth, finding, 0)
        row.update(seconds=float(seconds), blocks=blocks_until(scene, finding))
    row['seconds_per_block'] = '%.6g' % (row['seconds'] / row['blocks'])
    return row, float(seconds)


def moves(scene):
    with open(scene.path) as text:
        return bool(text.readline() and text.readline())


def position_at(scene, time):
    """The axes on the path, in the scene's order."""
    with open(scene.path) as text:
        header = text.readline().rstrip('\n').split('\t')
        last = None
        for line in text:
            row = [float(x) for x in line.split('\t')]
            t = header.index('time')
            if row[t] >= time and last:
                s = (time - last[t]) / (row[t] - last[t]) if row[t] > last[t] else 1
                row = [(1 - s) * x + s * y for x, y in zip(last, row)]
                break
            if row[t] >= time:
                break
            last = row
    return [row[header.index(x)] for x in axes_of(scene)]


def position_at_end(scene):
    """Seconds of machining."""
    with open(scene.path) as text:
        header = text.readline().rstrip('\n').split('\t')
        for line in text:
            last = line
    return float(last.split('\t')[header.index('time')])
