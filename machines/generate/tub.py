"""The job of the C/B head machine: an open structural part whose wall leans outward and is milled along its rulings.

Part coordinates: the origin is the middle of the base's underside. The clamping plate is on the table.
"""
import math

from parts import bolts
from program import Program, add, near, unit3
from solids import box, offset, prism, rectangle, revolve, stack, union

NAME = 'cb-head'
PLATE = 40  # of the clamping plate: the height of the part's zero above the table
BASE, FLOOR, TOP, WALL = 25, 33, 110, 7
LEAN = 9.0  # of the wall, degrees
DRAIN = 35.0  # of the drain holes
STEPS = 72


def outline(n):
    """The outer side of the wall, where it meets the base."""
    out = []
    for i in range(n):
        c, s = math.cos(2 * math.pi * i / n), math.sin(2 * math.pi * i / n)
        out.append((150 * c * (1 + 0.1 * s * s), 95 * s * (1 + 0.12 * c * c)))
    return out


def leaning(distance, z, n=STEPS):
    """The outer side moved outward by the distance, at the height z."""
    return offset(outline(n), distance + (z - BASE) * math.tan(math.radians(LEAN)))


def tub():
    base = prism(rectangle(-205, 205, -150, 150, 20), 0, BASE, 1.5)
    wall = stack([(leaning(0, BASE - 1), BASE - 1), (leaning(0, TOP), TOP)],
                 [[(leaning(-WALL, TOP), TOP), (leaning(-WALL, FLOOR), FLOOR)]])
    bosses = union(revolve([(16, FLOOR - 2), (16, 58), (14, 60)], 24).move(x, 0) for x in (-60, 60))
    return base + wall + bosses


def clamps():
    plate = prism(rectangle(-260, 260, -200, 200, 15), 0, PLATE, 2)
    block = box(207, 240, -20, 20, PLATE - 1, 64, 1.5) + box(175, 238, -16, 16, 65, 80, 1.5, 8)
    nut = revolve([(14, 79), (14, 83), (11, 84), (11, 94), (9, 96)], 16).move(215, 0)
    sides = union((block + nut).move(0, y) for y in (-90, 90))
    tie = revolve([(24, FLOOR), (24, FLOOR + 5), (11, FLOOR + 6), (11, 118), (18, 118), (18, 134), (11, 136)], 24)
    return plate + sides.both('x') + tie.move(0, 0, PLATE) \
        + bolts([(x, y, PLATE) for x in (-242, 242) for y in (-170, 0, 170)], 14, '+z')


BODIES = [clamps, tub]


def wall_pass(program, side, radius, z, turn, last):
    """Once around the wall with the flank of the cutter, outside (side 1) or inside (-1), tip at z. Returns C."""
    path = offset(outline(STEPS), side * (radius + 0.2) - (WALL if side < 0 else 0)
                  + (z - BASE) * math.tan(math.radians(LEAN)))
    first = True
    for k in range(STEPS + 1):
        i = turn * k % STEPS
        a, b = path[i - 1], path[(i + 1) % STEPS]
        n = unit3((b[1] - a[1], a[0] - b[0], 0))
        c = near(math.degrees(math.atan2(n[1], n[0])), last)
        last = c
        axis = add((0, 0, math.cos(math.radians(LEAN))), math.sin(math.radians(LEAN)), n)
        p = (path[i][0], path[i][1], z)
        if first:
            away = add(p, 140, axis)
            program.rapid(X=away[0], Y=away[1], Z=away[2], C=c, B=LEAN)
            program.feed(1500, X=p[0], Y=p[1], Z=p[2])
            first = False
        program.feed(2800, X=p[0], Y=p[1], Z=p[2], C=c, B=LEAN)
    away = add(p, 140, axis)
    program.rapid(X=away[0], Y=away[1], Z=away[2])
    return last


def walls(program):
    program.comment('OPERATION 1: WALL OUTSIDE, FLANK, 5 AXES')
    program.tool(1, 'flat 16', 9000)
    program.rapid(B=LEAN, C=0)
    program.rapid(X=150, Y=0)
    program.tcp(1)
    program.add('M8')
    c = 0.0
    for k, z in enumerate((78, 52, 27)):
        c = wall_pass(program, 1, 8, z, 1 if k % 2 == 0 else -1, c)
    program.comment('OPERATION 2: WALL INSIDE, FLANK, 5 AXES')
    for k, z in enumerate((80, 57, 35)):
        c = wall_pass(program, -1, 8, z, -1 if k % 2 == 0 else 1, c)
    program.add('M9')
    program.add('G49')
    program.retract()


def inclined_hole(program, side, back):
    """A hole through the wall, from the side that faces +X (1) or -X (-1)."""
    axis = (side * math.sin(math.radians(DRAIN)), 0, math.cos(math.radians(DRAIN)))
    foot = (side * (152 + 16 * math.tan(math.radians(LEAN))), 0, BASE + 16)
    for distance in (back, 3):
        p = add(foot, distance, axis)
        program.rapid(X=p[0], Y=p[1], Z=p[2], B=DRAIN * side, C=0)
    # The part is drawn without these holes: the drill leaves them at feed, with the spindle on.
    for depth in (6, 12, 18):
        p = add(foot, -depth, axis)
        program.feed(180, X=p[0], Y=p[1], Z=p[2])
        p = add(foot, 3, axis)
        program.feed(3000, X=p[0], Y=p[1], Z=p[2])
    p = add(foot, back, axis)
    program.rapid(X=p[0], Y=p[1], Z=p[2])


def holes(program, safe):
    program.comment('OPERATION 3: DRAIN HOLES, B35 AND B-35')
    program.tool(2, 'drill 8', 3200)
    program.rapid(B=DRAIN, C=0)
    program.rapid(X=400, Y=0)
    program.tcp(2)
    inclined_hole(program, 1, 92)
    if safe:
        program.rapid(Z=330)
        program.rapid(X=-207, B=-DRAIN)
    inclined_hole(program, -1, 92)
    program.rapid(Z=330)
    program.add('G49')
    program.retract()


def program(safe):
    out = Program('STRUCTURAL TUB, C/B HEAD', 'ZERO: MIDDLE OF THE BASE, UNDERSIDE', 'T1 FLAT 16  T2 DRILL 8')
    out.start()
    walls(out)
    holes(out, safe)
    out.rapid(B=0, C=0)
    out.end()
    return out.text()


PROGRAMS = {'clear.nc': lambda: program(True), 'collision.nc': lambda: program(False)}
