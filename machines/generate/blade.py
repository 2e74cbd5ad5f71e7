"""The job of the B head and C table machine: a turbine blade held at its root, milled in a spiral.

Part coordinates: z along the blade, 0 under the root. The vise stands on the table.
"""
import math

from parts import bolts
from program import Program, add, azimuth, near, unit3
from solids import around, box, prism, prism_y, rectangle, revolve, rounded, stack, tube

NAME = 'b-head-c-table'
HEIGHT = 130  # of the part's zero above the table
FOOT, TIP = 48, 228  # of the airfoil
TILT = 25.0  # of the tool above the horizontal
STEPS = 48


def section(t, z):
    """A point of the airfoil at t, in turns from the leading edge."""
    h = (z - FOOT) / (TIP - FOOT)
    c, s = math.cos(2 * math.pi * t), math.sin(2 * math.pi * t)
    x, y = (42 - 10 * h) * c, (8 - 3.5 * h) * s * (1 + 0.25 * c) + 9 * s * s
    twist = math.radians(8 + 34 * h)
    return (x * math.cos(twist) - y * math.sin(twist), x * math.sin(twist) + y * math.cos(twist), z)


def normal(t, z):
    a, b = section(t - 0.002, z), section(t + 0.002, z)
    return unit3((b[1] - a[1], a[0] - b[0], 0))


def blade():
    root = prism_y(rounded([(-50, 0), (50, 0), (50, 8), (42, 14), (42, 20), (50, 26), (50, 41), (-50, 41), (-50, 26),
                            (-42, 20), (-42, 14), (-50, 8)], 2), -25, 25, 1)
    platform = prism(rectangle(-60, 60, -35, 35, 6), 40, FOOT, 1)
    heights = [FOOT - 1 + (TIP - FOOT + 1) * k / 16 for k in range(17)]
    airfoil = stack([([section(i / 40, z)[:2] for i in range(40)], z) for z in heights])
    stub = revolve([(8, TIP - 1), (8, TIP + 12), (6, TIP + 14)], 24)
    return root + platform + airfoil + stub


def vise():
    foot = tube(20, 140, 0, 50, 2, 64) + around(bolts([(118, 0, 50)], 14, '+z'), 4, 22.5)
    body = prism(rectangle(-70, 70, -62, 62, 8), 48, HEIGHT - 12, 3) \
        + box(-60, 60, -60, 60, HEIGHT - 13, HEIGHT - 0.1, 1)
    profile = rounded([(-55, -2), (55, -2), (55, 14), (47, 25), (-47, 25), (-55, 14)], 2)
    jaw = prism_y(profile, 25.1, 58, 1.5).move(0, 0, HEIGHT)
    jaws = jaw.both('y') + bolts([(x, -58, HEIGHT + 6) for x in (-35, 35)], 10, '-y').both('y')
    stop = box(78, 96, -13, 13, 49, HEIGHT + 40, 1.5) + box(64, 104, -16, 16, 49, 70, 2) \
        + revolve([(6, 0), (6, 26)], 16).face('-x').move(78.5, 0, HEIGHT + 33)
    return foot + body + jaws + stop


BODIES = [vise, blade]


def spiral(program):
    program.comment('OPERATION 1: AIRFOIL, SPIRAL, 5 AXES')
    # At home, the tool change would put the tool into the blade.
    program.add('G53 X-400.')
    program.tool(1, 'ball 12', 12000)
    turns, last = 8, 0.0
    sin, cos = math.sin(math.radians(TILT)), math.cos(math.radians(TILT))
    for k in range(turns * STEPS + 1):
        t, z = k / STEPS, TIP - 6 - (TIP - FOOT - 16) * k / (turns * STEPS)
        n = normal(t, z)
        axis = add((0, 0, sin), cos, n)
        tip = add(add(section(t, z), 6, n), -6, axis)
        c = near(azimuth(n), last)
        last = c
        if k == 0:
            away = add(tip, 70, axis)
            program.rapid(B=90 - TILT, C=c)
            program.tcp(1)
            program.rapid(X=away[0], Y=away[1], Z=away[2] + 150)
            program.rapid(Z=away[2])
            program.add('M8')
        program.feed(900 if k == 0 else 3000, X=tip[0], Y=tip[1], Z=tip[2], B=90 - TILT, C=c)
    away = add(tip, 70, axis)
    program.rapid(X=away[0], Y=away[1], Z=away[2])
    program.add('M9')
    program.add('G49')
    program.retract()


def holes(program, safe):
    """Two holes in each flank of the root, with the tool horizontal.

    The part is drawn without the holes, so the drill leaves them at feed.
    """
    program.comment('OPERATION 2: ROOT HOLES, B90')
    program.tool(2, 'drill 8', 3400)
    for side in (1, -1):
        program.rapid(**({'B': 90, 'C': 90} if side > 0 else {'C': -90}))
        program.tcp(2)
        if side > 0:
            program.rapid(X=28, Y=110, Z=200)
        for x in (28, -28):
            program.rapid(X=x, Y=side * (110 if x > 0 and (side > 0 or safe) else 35), Z=33)
            program.rapid(Y=side * 27)
            for depth in (6, 12):
                program.feed(200, Y=side * (25 - depth))
                program.feed(3000, Y=side * 27)
            program.rapid(Y=side * 35)
        if side < 0 or safe:
            program.rapid(Y=side * 110)
        program.add('G49')
        program.forget()
    program.retract()


def program(safe):
    out = Program('TURBINE BLADE, B HEAD AND C TABLE', 'ZERO: STACKING AXIS, UNDER THE ROOT', 'T1 BALL 12  T2 DRILL 8')
    out.start()
    spiral(out)
    holes(out, safe)
    out.rapid(B=0, C=0)
    out.end()
    return out.text()


PROGRAMS = {'clear.nc': lambda: program(True), 'collision.nc': lambda: program(False)}
