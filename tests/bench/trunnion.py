"""trunnion.py - scenes on machines/ac-trunnion: at work inside the trunnion, far from everything, and tight work."""
import math
import os

import meshes
from nc import Axis, Program
from scene import Scene

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.normpath(os.path.join(HERE, '..', '..'))
MACHINE = os.path.join(ROOT, 'machines', 'ac-trunnion', 'machine.xml')
JOB = os.path.join(ROOT, 'examples', 'ac-trunnion')
AXES = [Axis('Y', False, 30000), Axis('X', False, 30000), Axis('Z', False, 24000), Axis('A', True, 7200),
        Axis('C', True, 14400)]

# As in the example: tool 1 goes along the shroud, tool 2 between the blades, tool 3 into the arbor's bores.
TOOLS = '''  <tool number="1" name="ball 10" length="130">
    <holder>
      <section length="26" diameter="63"/>
      <section length="34" diameter="44" diameter_end="34"/>
    </holder>
    <shank><section length="30" diameter="12"/></shank>
    <cutter tip="ball"><section length="40" diameter="10"/></cutter>
  </tool>
  <tool number="2" name="ball 6" length="140">
    <holder>
      <section length="26" diameter="63"/>
      <section length="44" diameter="40" diameter_end="27"/>
    </holder>
    <shank><section length="30" diameter="14" diameter_end="6.5"/></shank>
    <cutter tip="ball"><section length="40" diameter="6"/></cutter>
  </tool>
  <tool number="3" name="probe 6" length="150">
    <holder>
      <section length="26" diameter="63"/>
      <section length="54" diameter="40"/>
    </holder>
    <shank><section length="20" diameter="10"/></shank>
    <cutter tip="ball"><section length="50" diameter="6"/></cutter>
  </tool>
'''


def write_setup(folder, bodies):
    os.makedirs(folder, exist_ok=True)
    setup = os.path.join(folder, 'setup.xml')
    with open(setup, 'w') as out:
        out.write('<setup version="1" units="mm">\n  <work_offset name="G54"/>\n%s%s</setup>\n' % (bodies, TOOLS))
    return setup


def job_setup(folder):
    return write_setup(folder, '  <fixture name="arbor" mesh="%s/arbor.stl"/>\n'
                       '  <part name="impeller" mesh="%s/impeller.stl" location="0 0 55"/>\n' % (JOB, JOB))


def crowded_setup(folder, tools=30, fixtures=10):
    """Ball cutters of several sizes and lengths in a magazine, clamps around the table, and the impeller."""
    os.makedirs(folder, exist_ok=True)
    meshes.write(os.path.join(folder, 'clamp.stl'), meshes.box((-10, -15, 0), (10, 15, 40)))
    with open(os.path.join(folder, 'setup.xml'), 'w') as out:
        out.write('<setup version="1" units="mm">\n  <work_offset name="G54"/>\n')
        for i in range(fixtures):
            angle = 2 * math.pi * i / fixtures
            out.write('  <fixture name="clamp %d" mesh="clamp.stl" location="%.3f %.3f 0"/>\n' %
                      (i + 1, 120 * math.cos(angle), 120 * math.sin(angle)))
        out.write('  <part name="impeller" mesh="%s/impeller.stl" location="0 0 55"/>\n' % JOB)
        for i in range(tools):
            diameter, length = (4, 6, 8, 10, 12, 16, 20)[i % 7], 100 + 10 * (i * i % 6)
            flutes = max(15, 2 * diameter)
            out.write('  <tool number="%d" name="ball %d" length="%d">\n'
                      '    <holder><section length="26" diameter="63"/>'
                      '<section length="%d" diameter="40"/></holder>\n'
                      '    <shank><section length="20" diameter="%d"/></shank>\n'
                      '    <cutter tip="ball"><section length="%d" diameter="%d"/></cutter>\n  </tool>\n' %
                      (i + 1, diameter, length, length - 46 - flutes, diameter, flutes, diameter))
        out.write('</setup>\n')
    return os.path.join(folder, 'setup.xml')


def finishing(tools, tool):
    """The work of one tool of the example: axis positions at the ends of its spans, each with its seconds."""
    path = os.path.join(tools.out, 'example.tsv')
    spent = tools.run([tools.fivecheck, '--dump-path', '-o', path, '-s', os.path.join(JOB, 'setup.xml'), MACHINE,
                       os.path.join(JOB, 'clear.nc')])
    if spent.status:
        raise SystemExit('bench: ' + spent.err)
    with open(path) as text:
        rows = [[float(x) for x in line.split('\t')] for line in list(text)[1:]]
    # The columns are line, move, tool, X, Y, Z, A, C, time, deviation.
    seconds = {row[8]: row[8] - last[8] for last, row in zip(rows, rows[1:])}
    rows = [r for r in rows if r[2] == tool]
    low = [i for i, r in enumerate(rows) if r[5] < -100]
    return [(dict(zip('XYZAC', r[3:8])), seconds.get(r[8], 0.0)) for r in rows[low[0]:low[-1] + 1]]


def cut(points, length):
    """The same path in pieces of about `length` mm, a turn of C counted as at 50 mm from its axis."""
    out = [points[0]]
    for (p, _), (q, seconds) in zip(points, points[1:]):
        way = math.sqrt(sum((q[x] - p[x]) ** 2 for x in 'XYZ') + (math.radians(q['C'] - p['C']) * 50) ** 2)
        count = max(1, round(way / length))
        out += [({x: p[x] + (q[x] - p[x]) * k / count for x in 'XYZAC'}, max(seconds / count, 1e-4))
                for k in range(1, count + 1)]
    return out


def approach(program, p):
    """From home, with the spindle up."""
    program.rapid(A=p['A'], C=p['C'])
    program.rapid(X=p['X'], Y=p['Y'])
    program.rapid(Z=p['Z'])


def shuttle(program, points, blocks):
    """Moves there and back until there are this many blocks. A piece takes the same time in both directions."""
    period = 2 * (len(points) - 1)
    for i in range(1, blocks + 1):
        at = i % period
        back = at >= len(points)
        at = period - at if back else at
        # Going back, piece k ends at point k - 1; at 0 a period closes.
        seconds = points[at + 1 if back or not at else at][1]
        if seconds:
            program.timed(seconds, **points[at][0])
        else:
            program.feed(**points[at][0])


def finish(scene_folder, program, setup, **figures):
    nc = os.path.join(scene_folder, 'part.nc')
    program.write(nc)
    # Tools made of sections are up to 0.01 mm larger than the true tools; those of plain.py are as much smaller.
    return Scene(os.path.basename(scene_folder), scene_folder, MACHINE, setup, nc, None, 'clear', 0.03, **figures)


def started(feed, tool=1):
    return Program(AXES, feed, None, ['T%d M6' % tool, 'S8000 M3'])


def inside(folder, tools, blocks=None, length=0.1, tool=2):
    """Work inside the trunnion with five axes at once; without `blocks`, once there and back."""
    setup, points = job_setup(folder), cut(finishing(tools, tool), length)
    program = started(1000.0, tool)
    approach(program, points[0][0])
    shuttle(program, points, blocks or 2 * (len(points) - 1))
    return finish(folder, program, setup, length=length, blocks=blocks)


def far(folder, blocks):
    """The spindle up, everything far apart, blocks of 0.01 s and more, five axes."""
    program = started(6000.0)
    # 1 mm at 6 m/min.
    points = [({'X': 60 * math.cos(t), 'Y': 60 * math.sin(t), 'Z': -20 + 15 * math.sin(3 * t),
                'A': -20 + 10 * math.cos(t), 'C': 30 * math.sin(t)}, 0.0) for t in (i / 40 for i in range(1000))]
    approach(program, points[0][0])
    shuttle(program, points, blocks)
    return finish(folder, program, job_setup(folder), blocks=blocks)


POST, HEIGHT = 15.0, 90.0   # of the fixture, mm


def tight(folder, blocks, length=0.1, feed=1500.0):
    """A ball of 5 mm goes along a post on the table, 0.15 to 0.85 mm from it, while A swings and C turns.

    The post stands on the crossing of A and C, z = 120, 40 mm below it. Leaning toward -y by the angle -A it keeps
    its upper side to the tool, which stands upright: the ball's middle is POST + 5 + gap above its axis.
    """
    os.makedirs(folder, exist_ok=True)
    meshes.write(os.path.join(folder, 'post.stl'),
                 meshes.revolve([(POST, HEIGHT * i / 30) for i in range(31)], 96))
    setup = write_setup(folder, '  <fixture name="post" mesh="post.stl"/>\n')
    program, points = started(feed), []
    count = 4000
    for i in range(count):
        t = i * length
        gap, along = 0.5 + 0.35 * math.sin(t / 7), 20 + 15 * math.sin(t / 40)
        lean = math.radians(42 + 12 * math.cos(t / 60))
        out = POST + 5 + gap
        # Along the post (0, -sin, cos), out from it (0, cos, sin), and a little to the side.
        side = math.radians(8 * math.sin(t / 25))
        y = -math.sin(lean) * along + math.cos(lean) * math.cos(side) * out
        z = 120 + math.cos(lean) * along + math.sin(lean) * math.cos(side) * out
        # Gauge point at z = 520, 130 mm to the tip, which is 5 mm below the ball's middle.
        points.append(({'X': out * math.sin(side), 'Y': y, 'Z': z - 5 + 130 - 520, 'A': -math.degrees(lean),
                        'C': math.degrees(t / 20)}, 0.0))
    approach(program, points[0][0])
    shuttle(program, points, blocks)
    return finish(folder, program, setup, length=length, blocks=blocks)


# The paper's block with its last word read as C, and the probe at the rim and in a bore of the arbor: from, to, feed.
BORE = {'X': 140, 'Y': 45, 'Z': -246, 'A': 0, 'C': 0}
MOTIONS = [
    ({'X': 0, 'Y': 0, 'Z': 0, 'A': 0, 'C': 0}, {'X': 300, 'Y': -200, 'Z': -200, 'A': -3, 'C': -3}, 15000),
    ({'X': 0, 'Y': -18, 'Z': -164, 'A': -90, 'C': 0}, {'Z': -169.5}, 150),
    (BORE, {'Y': 50}, 150),
    (BORE, {'X': 145}, 150),
    (BORE, {'X': 141, 'Y': 46, 'Z': -244, 'A': -0.2, 'C': 0.4}, 150),
]


def bore(folder, blocks, length=1.0, feed=150.0):
    """The probe measures a bore of the arbor while A and C turn a little: blocks of 1 mm at 150 mm/min."""
    os.makedirs(folder, exist_ok=True)
    program, points = started(feed, 3), []
    for end in ({'Y': 49.5}, {'X': 144.5}, {'Y': 40.5}, {'X': 135.5},
                {'X': 141, 'Y': 46, 'Z': -244, 'A': -0.2, 'C': 0.4}):
        seconds = 60 * math.dist(*([p[x] for x in 'XYZ'] for p in (BORE, dict(BORE, **end)))) / feed
        points += [(BORE, seconds), (dict(BORE, **end), seconds)]
    points.append((BORE, seconds))
    points = cut(points, length)
    approach(program, points[0][0])
    shuttle(program, points, blocks)
    return finish(folder, program, job_setup(folder), length=length, blocks=blocks)


def motion(folder, start, end=None, feed=1000.0):
    """One motion alone, or only the move to its start."""
    os.makedirs(folder, exist_ok=True)
    program = started(float(feed), 3)
    approach(program, start)
    if end:
        program.feed(**end)
    return finish(folder, program, job_setup(folder), seconds=program.time)


def examples(out):
    """The jobs that ship with the project."""
    for machine in ('ac-trunnion', 'b-head-c-table', 'cb-head'):
        job = os.path.join(ROOT, 'examples', machine)
        for program in ('clear', 'collision'):
            name = '%s-%s' % (machine, program)
            yield Scene(name, os.path.join(out, name), os.path.join(ROOT, 'machines', machine, 'machine.xml'),
                        os.path.join(job, 'setup.xml'), os.path.join(job, program + '.nc'),
                        known='clear' if program == 'clear' else None, slack=0.03)
