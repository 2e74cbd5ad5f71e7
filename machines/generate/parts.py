"""Standard parts of machine tools: screws, guideways, motors, tables with T-slots, spindle noses.

Unless stated otherwise a part stands on z = 0 at the origin and rises along +z; Solid.face places it elsewhere.
"""
import functools
import math

from solids import (arc, around, box, circle, offset, prism, prism_x, rectangle, revolve, ring, shift, stack, union)


@functools.cache
def screw(d):
    """The head of a hexagon socket cap screw (ISO 4762) of thread d."""
    rim = circle(0.75 * d, 8)
    return stack([(rim, 0), (rim, d)], [[(circle(0.5 * d, 6), d), (circle(0, 6), 0.4 * d)]])


def button(d):
    """The head of a small screw."""
    return revolve([(0.75 * d, -0.2 * d), (0.6 * d, 0.5 * d)], 8)


def buttons_at(points, d, z=0.0):
    return union(button(d).move(x, y, z) for x, y in points)


def screw_circle(radius, n, d, z=0.0, phase=0.0):
    return around(screw(d).move(radius, 0, z), n, phase)


def bolts(points, d, direction):
    """Screw heads at points in space, all with the same direction."""
    return union(screw(d).face(direction).move(*p) for p in points)


def cover(x0, x1, y0, y1, thick, nx, ny, d=6):
    """A sheet cover with rounded corners, and nx and ny screws along its sides."""
    m = 2.2 * d
    xs = [x0 + m + (x1 - x0 - 2 * m) * i / (nx - 1) for i in range(nx)]
    ys = [y0 + m + (y1 - y0 - 2 * m) * i / (ny - 1) for i in range(ny)]
    rim = [(x, y) for y in (ys[0], ys[-1]) for x in xs] + [(x, y) for x in (xs[0], xs[-1]) for y in ys[1:-1]]
    return prism(rectangle(x0, x1, y0, y1, 10, 2), 0, thick, min(2, thick / 3)) + buttons_at(rim, d, thick)


# Linear guides: the rail is `size` wide and 0.85 size high; the carriage is 2.1 size wide and ends 1.4 size above the
# seat.

def rail(length, size, pitch):
    """A rail along x, centred, with countersunk holes."""
    half, w, top = length / 2, size / 2, 0.85 * size
    foot = prism_x([(-w, 0), (w, 0), (w, 0.25 * size), (0.7 * w, 0.42 * size), (0.7 * w, 0.55 * size),
                    (-0.7 * w, 0.55 * size), (-0.7 * w, 0.42 * size), (-w, 0.25 * size)], -half, half)
    n = int(length / pitch)
    holes = [(circle(0.28 * size, 8, ((i - (n - 1) / 2) * pitch, 0)), 0.25 * size) for i in range(n)]
    return foot + prism(rectangle(-half, half, -w, w), 0.55 * size, top, 0.03 * size, holes, 0.04 * size)


def truck(size):
    """The carriage of a guide, centred, with 1 mm of air around the rail."""
    w, groove, low, high = 1.05 * size, 0.5 * size + 1, 0.22 * size, 1.4 * size
    ceiling = 0.85 * size + 1
    section = [(groove, low), (0.8 * w, low), (w, 0.6 * size), (w, high), (-w, high), (-w, 0.6 * size),
               (-0.8 * w, low), (-groove, low), (-groove, ceiling), (groove, ceiling)]
    body = prism_x(section, -1.3 * size, 1.3 * size)
    scraper = prism_x(offset(section, -0.02 * size), 1.3 * size, 1.65 * size)
    nipple = revolve([(0.12 * size, 0), (0.12 * size, 0.15 * size), (0.06 * size, 0.3 * size)], 8).face('+x')
    return body + scraper.both('x') + nipple.move(1.65 * size, 0.8 * size, 1.1 * size)


# Directions for a part that runs along x and rises along z.

def lay_y_up(solid):
    """Along y, rising upward."""
    return solid.turn('z', 90)


def lay_x_front(solid):
    """Along x, rising to the front."""
    return solid.face('-y')


def lay_z_back(solid):
    """Along z, rising to the back."""
    return solid.turn('z', 90).face('+y')


def lay_z_front(solid):
    """Along z, rising to the front."""
    return solid.turn('z', 90).face('-y')


def guide_pair(length, size, pitch, gap):
    """Two rails along x, `gap` apart in y."""
    return rail(length, size, pitch).move(0, gap / 2, 0).both('y')


def trucks(xs, size, gap):
    return union(truck(size).move(x, gap / 2, 0).both('y') for x in xs)


def ball_screw(length, d):
    """A ball screw along x, centred on it: the shaft and two bearing blocks, 3 d high."""
    shaft = revolve([(0.4 * d, 0), (0.4 * d, 2 * d), (0.5 * d, 2.1 * d), (0.5 * d, length - 2.1 * d),
                     (0.4 * d, length - 2 * d), (0.4 * d, length)], 20)
    block = prism(rectangle(-1.4 * d, 1.4 * d, -1.4 * d, 1.4 * d, 0.3 * d), 0, 1.6 * d, 0.1 * d) \
        + screw_circle(1.5 * d, 2, 0.3 * d, 1.6 * d, 45)
    return (shaft + block).move(0, 0, -length / 2).face('+x') + block.move(0, 0, -length / 2).face('-x')


def motor(size, length):
    """A servo motor that stands on its flange. size: across the flange; length: its height."""
    half = size / 2
    square = rectangle(-half, half, -half, half, 0.12 * size, 2)
    body = rectangle(-0.46 * size, 0.46 * size, -0.46 * size, 0.46 * size, 0.16 * size, 2)
    groove = offset(body, -0.04 * size)
    layers, n, low, high = [], 5, 0.14 * length, 0.7 * length
    step = (high - low) / n
    for i in range(n):
        z = low + i * step
        layers += [(body, z), (body, z + 0.7 * step), (groove, z + 0.85 * step)]
    layers += [(body, high), (body, high + 0.05 * length)]
    small = offset(body, -0.06 * size)
    lid = stack([(small, high), (small, 0.96 * length), (offset(small, -0.04 * size), length)])
    plug = box(-0.12 * size, 0.12 * size, 0.3 * size, 0.62 * size, 0, 0.22 * size, 0.03 * size)
    return prism(square, 0, 0.1 * length, 0.02 * size) \
        + stack([(groove, 0.1 * length)] + [(groove, low)] + layers) + lid \
        + around(button(0.08 * size).move(0.42 * size, 0.42 * size, 0.1 * length), 4) \
        + plug.move(0, 0, 0.16 * length) + plug.move(0, 0, 0.74 * length)


def finned_drum(radius, z0, z1, n, steps=36):
    """A motor housing with n cooling fins around."""
    pitch, deep = (z1 - z0) / n, 0.06 * radius
    profile = [(radius - deep, z0)]
    for i in range(n):
        z = z0 + i * pitch
        profile += [(radius, z + 0.3 * pitch), (radius, z + 0.7 * pitch), (radius - deep, z + pitch)]
    return revolve(profile, steps)


def foot(height):
    """A levelling foot, below z = 0."""
    return revolve([(80, -height), (80, 20 - height), (35, 32 - height), (35, -16)], 12) \
        + prism(circle(54, 6), -24, 0, 2)


def spindle_nose(radius, length, taper, n=48):
    """A spindle nose with its gauge line at z = 0 and the housing above it (up to z = length): face, drive keys, taper
    bore, screws.

    radius is that of the nose, taper the diameter of the bore at the face.
    """
    r, b = radius, taper / 2
    profile = [(0.72 * r, 0), (0.74 * r, 2), (0.74 * r, 12), (0.97 * r, 14), (r, 17), (r, 0.3 * length),
               (1.06 * r, 0.33 * length), (1.06 * r, 0.42 * length), (1.12 * r, 0.45 * length), (1.3 * r, 0.7 * length),
               (1.34 * r, 0.74 * length), (1.34 * r, 0.97 * length), (1.3 * r, length)]
    inside = [(0.7 * b, length), (0.7 * b, 0.6 * length), (b, 2), (b + 1.5, 0)]
    housing = ring(profile + inside, n)
    key = box(b + 2, 0.7 * r, -7, 7, -5, 6, 1)
    nozzle = revolve([(2, -7), (4, -2), (6, 0), (6, 6)], 8)
    return housing + around(key, 2) + around(nozzle.move(0.86 * r, 0, 13), 4, 45) \
        + around(screw(6).face('-z').move(0.87 * r, 0, 14), 8)


# Tables. The working surface is at z = 0, the table is below it.

SLOT_14 = (7.0, 12.0, 11.5, 10.0)  # T-slot DIN 650-14: half width and depth of the neck, half width and height below
SLOT_18 = (9.0, 15.0, 15.0, 13.0)


def strips(radius, lines, half, z0, z1, hole, bevel, n):
    """A disc minus slots along x at the y values `lines`, 2 half wide; the middle strip has a central hole."""
    def angle(y):
        return math.degrees(math.asin(y / radius))
    solids = []
    for low, high in zip([None] + lines, lines + [None]):
        a = angle(low + half) if low is not None else -90
        b = angle(high - half) if high is not None else 90
        if low is None:
            outline = arc((0, 0), radius, 180 - b, 360 + b, 2 * n)
        elif high is None:
            outline = arc((0, 0), radius, a, 180 - a, 2 * n)
        else:
            outline = arc((0, 0), radius, a, b, n // 2) + arc((0, 0), radius, 180 - b, 180 - a, n // 2)
        central = low is not None and high is not None and low < 0 < high
        solids.append(prism(outline, z0, z1, bevel, [(circle(hole, 32), None)] if central else (), bevel))
    return union(solids)


def round_table_parallel(radius, lines, slot, hole, n=24):
    """The slotted layers of a round table. The value also has the depth at which the solid disc begins."""
    half, neck, wide, high = slot
    top = strips(radius, lines, half, -neck, 0, hole, 0.8, n)
    below = strips(radius, lines, wide, -neck - high, -neck, hole, 0, n)
    return top + below, neck + high


def round_table_radial(radius, count, slot, hole, n=20):
    """The same, with slots like the spokes of a wheel."""
    half, neck, wide, high = slot

    def sectors(s, z0, z1, bevel):
        def angle(r):
            return math.degrees(math.asin(s / r))
        pitch = 360 / count
        outline = arc((0, 0), radius, angle(radius), pitch - angle(radius), n) \
            + arc((0, 0), hole, pitch - angle(hole), angle(hole), max(4, n // 4))
        return around(prism(outline, z0, z1, bevel), count)
    return sectors(half, -neck, 0, 0.8) + sectors(wide, -neck - high, -neck, 0), neck + high


def long_table(length, width, thick, lines, slot):
    """A rectangular table along x, with its slots from end to end: one extruded profile."""
    half, neck, wide, high = slot
    top = []
    for y in sorted(lines, reverse=True):
        top += [(y + half + 1, 0), (y + half, -1), (y + half, -neck), (y + wide, -neck), (y + wide, -neck - high),
                (y - wide, -neck - high), (y - wide, -neck), (y - half, -neck), (y - half, -1), (y - half - 1, 0)]
    w, t = width / 2, thick
    outline = [(-w, -3), (-w, -0.45 * t), (30 - w, -0.6 * t), (30 - w, -t), (w - 30, -t), (w - 30, -0.6 * t),
               (w, -0.45 * t), (w, -3), (w - 3, 0)] + top + [(3 - w, 0)]
    return prism_x(outline, -length / 2, length / 2)


def grid_pockets(x0, x1, y0, y1, nx, ny, wall, radius=20):
    """Rounded rectangles with walls between them."""
    w, h = (x1 - x0 - (nx + 1) * wall) / nx, (y1 - y0 - (ny + 1) * wall) / ny
    return [shift(rectangle(0, w, 0, h, radius), x0 + wall + i * (w + wall), y0 + wall + j * (h + wall))
            for i in range(nx) for j in range(ny)]
