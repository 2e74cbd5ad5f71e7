"""The job of the A/C trunnion machine: an impeller on an arbor; its shroud and its blades are finished.

Part coordinates: z along the impeller's axis, 0 at its back face. The plate of the arbor is on the table.
"""
import math

from parts import bolts
from program import Program, add, azimuth, cross, near, polar, unit3
from solids import around, loft, prism, rectangle, revolve, tube, union

NAME = 'ac-trunnion'
BLADES = 9
PLATE = 40  # the arbor's plate
PIVOT_HEIGHT = 40  # of the A axis above the table
HEIGHT = 55  # of the arbor: the height of the part's zero above the table
BORES = [(-140, 45), (-140, -45), (140, -45), (140, 45)]
BORE_TOP = PLATE + 10 - HEIGHT


def point(u, w, blade=0):
    """The camber surface of a blade: u from inlet to exit, w from hub to shroud."""
    c, s = math.cos(u * math.pi / 2), math.sin(u * math.pi / 2)
    r = (22 + 58 * (1 - c)) * (1 - w) + (52 + 28 * (1 - c)) * w
    z = (6 + 56 * (1 - s)) * (1 - w) + (18 + 48 * (1 - s)) * w
    turn = math.radians(360 * blade / BLADES - 38 * u * u)
    return (r * math.cos(turn), r * math.sin(turn), z)


def ruling(u, blade=0):
    return unit3(add(point(u, 1, blade), -1, point(u, 0, blade)))


def side(u, blade=0):
    """The normal of the camber surface at mid height."""
    along = add(point(u + 0.001, 0.5, blade), -1, point(u - 0.001, 0.5, blade))
    return unit3(cross(ruling(u, blade), along))


def impeller():
    hub = [(22 + 58 * (1 - math.cos(i * math.pi / 16)), 6 + 56 * (1 - math.sin(i * math.pi / 16)))
           for i in range(8, -1, -1)]
    body = revolve([(78, 0), (80, 2)] + hub + [(20, 64), (9, 64), (9, 58)], 48)
    sections = []
    for i in range(17):
        u = i / 16
        n = side(u)
        half = 0.7 if i in (0, 16) else 1.3
        sections.append([add(point(u, w), d * half, n) for w, d in ((-0.06, 1), (0.5, 0.9), (0.97, 0.7), (1, 0),
                                                                   (0.97, -0.7), (0.5, -0.9), (-0.06, -1))])
    return body + around(loft(sections), BLADES)


def arbor():
    plate = prism(rectangle(-168, 168, -70, 70, 16), 0, PLATE, 2)
    column = revolve([(62, PLATE - 1), (58, PLATE + 5), (56, PLATE + 7), (56, HEIGHT - 0.1)], 40)
    pads = union(tube(10, 18, PLATE - 1, PLATE + 10, 1, 24).move(x, y) for x, y in BORES)
    return plate + column + pads + bolts([(x, y, PLATE) for x in (-110, 110) for y in (-31.5, 31.5)], 12, '+z')


BODIES = [arbor, impeller]


def tilt(v, last):
    """The A and C that turn the workpiece direction v upward, toward the spindle."""
    return {'A': -polar(v), 'C': near(azimuth(v) - 90, last)}


def measure_bore(program, x, y):
    program.rapid(X=x, Y=y)
    program.rapid(Z=BORE_TOP + 10)
    program.feed(600, Z=BORE_TOP - 6)
    for dx, dy in ((5, 0), (-5, 0), (0, 5), (0, -5)):
        program.feed(150, X=x + dx, Y=y + dy)
        program.feed(600, X=x, Y=y)
    program.rapid(Z=BORE_TOP + 10)


def measuring(program, safe):
    """The arbor's bores from above; then the rim of the impeller with the table upright."""
    program.comment('OPERATION 1: MEASURE THE BORES OF THE ARBOR, A0')
    program.tool(3, 'probe 6', 50)
    program.rapid(A=0, C=0)
    program.rapid(X=BORES[0][0], Y=BORES[0][1])
    program.add('G43 H3')
    for i, (x, y) in enumerate(BORES):
        if i == 2:
            program.rapid(Z=110)
        measure_bore(program, x, y)
    program.comment('OPERATION 2: MEASURE THE RIM, A-90')
    # The table's surface is 40 mm below the A axis. Upright, it is 40 mm behind the axis, and the rim 80 mm above it.
    top, y = PIVOT_HEIGHT - HEIGHT + 80, PIVOT_HEIGHT - HEIGHT - 3
    program.add('G49')
    program.retract()
    program.rapid(A=-90, C=0)
    program.add('G43 H3')
    program.rapid(X=0, Y=y)
    for c in (0, 180):
        if c and safe:
            program.rapid(Z=top + 120)
        program.rapid(C=c)
        program.rapid(Z=top + 6)
        program.feed(150, Z=top + 0.5)
        program.rapid(Z=top + 6)
    program.add('G49')
    program.retract()


def shroud(program):
    """A spiral down the envelope of the blades, with the centre of the ball 5 mm outside."""
    program.comment('OPERATION 3: SHROUD FINISHING, 5 AXES')
    program.tool(1, 'ball 10', 15000)
    turns, steps, last = 7, 30, -90.0
    for i in range(turns * steps + 1):
        u = i / (turns * steps)
        phase = math.radians(360 * i / steps)
        c, s = math.cos(u * math.pi / 2), math.sin(u * math.pi / 2)
        p, n = (52 + 28 * (1 - c), 18 + 48 * (1 - s)), unit3((c / 28, s / 48, 0))
        lean = math.radians(12 + 62 * (1 - u))
        axis = (math.sin(lean) * math.cos(phase), math.sin(lean) * math.sin(phase), math.cos(lean))
        centre = ((p[0] + 5 * n[0]) * math.cos(phase), (p[0] + 5 * n[0]) * math.sin(phase), p[1] + 5 * n[1])
        tip = add(centre, -5, axis)
        angles = tilt(axis, last)
        last = angles['C']
        if i == 0:
            away = add(tip, 60, axis)
            program.rapid(**angles)
            program.tcp(1)
            program.rapid(X=away[0], Y=away[1], Z=away[2], **angles)
            program.add('M8')
        program.feed(800 if i == 0 else 3200, X=tip[0], Y=tip[1], Z=tip[2], **angles)
    away = add(tip, 60, axis)
    program.rapid(X=away[0], Y=away[1], Z=away[2])
    program.add('M9')
    program.add('G49')
    program.retract()


def flanks(program):
    """The pressure side of each blade in one pass, with the tool along the rulings."""
    program.comment('OPERATION 4: BLADE FLANKS, 5 AXES')
    program.tool(2, 'ball 6', 18000)
    last, steps = -90.0, 24
    for blade in range(BLADES):
        program.comment('BLADE %d' % (blade + 1))
        for i in range(steps + 1):
            u = i / steps
            axis = ruling(u, blade)
            centre = add(add(point(u, 0, blade), 3.3, axis), 1.3 + 3, side(u, blade))
            tip = add(centre, -3, axis)
            angles = tilt(axis, last)
            last = angles['C']
            if i == 0:
                away = add(tip, 70, axis)
                if blade == 0:
                    program.rapid(**angles)
                    program.tcp(2)
                program.rapid(X=away[0], Y=away[1], Z=away[2], **angles)
            program.feed(1000 if i == 0 else 2400, X=tip[0], Y=tip[1], Z=tip[2], **angles)
        away = add(tip, 90, axis)
        program.rapid(X=away[0], Y=away[1], Z=away[2])
    program.add('G49')
    program.retract()


def program(safe):
    out = Program('IMPELLER 9 BLADES, A/C TRUNNION', 'ZERO: AXIS OF THE ARBOR, BACK FACE OF THE IMPELLER',
                  'T1 BALL 10  T2 BALL 6  T3 PROBE 6')
    out.start()
    measuring(out, safe)
    shroud(out)
    flanks(out)
    out.rapid(A=0, C=0)
    out.end()
    return out.text()


PROGRAMS = {'clear.nc': lambda: program(True), 'collision.nc': lambda: program(False)}
