"""Closed triangle meshes made from a few primitives, and the STL files for them.

Lengths are in mm, angles in degrees. An outline is a list of (x, y), counter-clockwise. A solid is a set of triangles.
Solids can be added; the parts of a sum may touch or overlap, because each of them is closed by itself.
"""
import math
import os
import struct

# Coordinates are rounded to this grid (steps per mm): exact in the 24 bits of an STL float up to 16 m, and so coarse
# that the last bit of another computer's sine does not change a file.
GRID = 1024


def on_grid(x):
    return round(round(x, 7) * GRID)


def cosine(degrees):
    quarter = {0: 1.0, 90: 0.0, 180: -1.0, 270: 0.0}
    return quarter.get(degrees % 360, math.cos(math.radians(degrees)))


def sine(degrees):
    return cosine(degrees - 90)


# Outlines

def circle(radius, n=48, centre=(0, 0), phase=0.0):
    return [(centre[0] + radius * cosine(phase + 360 * i / n), centre[1] + radius * sine(phase + 360 * i / n))
            for i in range(n)]


def arc(centre, radius, start, stop, n):
    """n + 1 points of an arc, including both ends."""
    return [(centre[0] + radius * cosine(start + (stop - start) * i / n),
             centre[1] + radius * sine(start + (stop - start) * i / n)) for i in range(n + 1)]


def rectangle(x0, x1, y0, y1, radius=0, n=2):
    corners = [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
    return rounded(corners, radius, n) if radius else corners


def rounded(corners, radius, n=3):
    """The polygon with rounded corners; radius is one number, or one number per corner (0 leaves the corner sharp)."""
    out = []
    for i, p in enumerate(corners):
        r = radius[i] if isinstance(radius, (list, tuple)) else radius
        if not r:
            out.append(p)
            continue
        a, b = unit(p, corners[i - 1]), unit(p, corners[(i + 1) % len(corners)])
        half = math.acos(max(-1.0, min(1.0, a[0] * b[0] + a[1] * b[1]))) / 2
        reach = r / math.tan(half)
        start = (p[0] + a[0] * reach, p[1] + a[1] * reach)
        bisector = unit((0, 0), (a[0] + b[0], a[1] + b[1]))
        centre = (p[0] + bisector[0] * r / math.sin(half), p[1] + bisector[1] * r / math.sin(half))
        first = math.degrees(math.atan2(start[1] - centre[1], start[0] - centre[0]))
        sweep = 180 - 2 * math.degrees(half)
        left_turn = a[0] * b[1] - a[1] * b[0] < 0
        out += arc(centre, r, first, first + (sweep if left_turn else -sweep), n)
    return out


def slot(x0, x1, y, radius, n=6):
    """A slot with round ends from (x0, y) to (x1, y)."""
    return arc((x1, y), radius, -90, 90, n) + arc((x0, y), radius, 90, 270, n)


def unit(a, b):
    d = math.hypot(b[0] - a[0], b[1] - a[1])
    return ((b[0] - a[0]) / d, (b[1] - a[1]) / d)


def offset(outline, distance):
    """The outline moved outward (inward if the distance is negative), with mitred corners."""
    out = []
    for i, p in enumerate(outline):
        a, b = unit(outline[i - 1], p), unit(p, outline[(i + 1) % len(outline)])
        m, n = (a[1], -a[0]), (b[1], -b[0])
        s = distance / (1 + m[0] * n[0] + m[1] * n[1])
        out.append((p[0] + s * (m[0] + n[0]), p[1] + s * (m[1] + n[1])))
    return out


def shift(outline, dx, dy):
    return [(x + dx, y + dy) for x, y in outline]


# Triangulation of an outline with holes, in exact integers

def turn_of(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def crosses(a, b, c, d):
    """Do the segments ab and cd meet elsewhere than in a common end? Collinear segments count as meeting."""
    if a in (c, d) or b in (c, d):
        return False
    return turn_of(a, b, c) * turn_of(a, b, d) <= 0 and turn_of(c, d, a) * turn_of(c, d, b) <= 0


def in_cone(points, before, at, after, p):
    """Does the diagonal from the corner `at` to p start inside?"""
    a, b, c = points[before], points[at], points[after]
    if turn_of(a, b, c) > 0:
        return turn_of(b, p, a) > 0 and turn_of(b, c, p) > 0
    return not (turn_of(b, p, c) >= 0 and turn_of(b, a, p) >= 0)


def bridge(points, ring, hole, rings):
    """Joins a hole to the ring by two edges in the same place."""
    start = max(range(len(hole)), key=lambda i: points[hole[i]])
    p = points[hole[start]]
    edges = [(points[r[i - 1]], points[r[i]]) for r in rings for i in range(len(r))]

    def distance(i):
        q = points[ring[i]]
        return (q[0] - p[0]) ** 2 + (q[1] - p[1]) ** 2
    for i in sorted(range(len(ring)), key=distance):
        q = points[ring[i]]
        if in_cone(points, ring[i - 1], ring[i], ring[(i + 1) % len(ring)], p) \
                and not any(crosses(p, q, a, b) for a, b in edges):
            return ring[:i + 1] + hole[start:] + hole[:start + 1] + ring[i:]
    raise ValueError('a hole that cannot be reached')


def is_ear(points, ring, i, reflex):
    a, b, c = ring[i - 1], ring[i], ring[(i + 1) % len(ring)]
    pa, pb, pc = points[a], points[b], points[c]
    if turn_of(pa, pb, pc) <= 0:
        return False
    for k in reflex:
        p = points[k]
        if p != pa and p != pb and p != pc and turn_of(pa, pb, p) >= 0 and turn_of(pb, pc, p) >= 0 \
                and turn_of(pc, pa, p) >= 0:
            return False
    return True


def triangulate(outline, holes=()):
    """Index triples into outline + holes (all counter-clockwise), by ear clipping."""
    points, rings = [], []
    for loop in [outline] + list(holes):
        rings.append(list(range(len(points), len(points) + len(loop))))
        points += [(on_grid(x), on_grid(y)) for x, y in loop]
    ring = rings[0]
    todo = [list(reversed(r)) for r in rings[1:]]
    done = [ring]
    for hole in sorted(todo, key=lambda r: max(points[k] for k in r), reverse=True):
        ring = bridge(points, ring, hole, [ring] + todo)
        done.append(hole)
    out, i, misses = [], 0, 0
    while len(ring) > 3:
        n = len(ring)
        i %= n
        reflex = {ring[k] for k in range(n)
                  if turn_of(points[ring[k - 1]], points[ring[k]], points[ring[(k + 1) % n]]) <= 0}
        while not is_ear(points, ring, i, reflex):
            i, misses = (i + 1) % n, misses + 1
            if misses > n:
                raise ValueError('an outline that crosses itself')
        out.append((ring[i - 1], ring[i], ring[(i + 1) % n]))
        del ring[i]
        i, misses = i + 1, 0
    return out + [tuple(ring)]


# Solids

class Solid:
    def __init__(self, triangles=()):
        self.triangles = list(triangles)

    def __add__(self, other):
        return Solid(self.triangles + other.triangles)

    def map(self, function, mirrored=False):
        moved = [tuple(function(p) for p in t) for t in self.triangles]
        return Solid((a, c, b) for a, b, c in moved) if mirrored else Solid(moved)

    def move(self, dx=0.0, dy=0.0, dz=0.0):
        return self.map(lambda p: (p[0] + dx, p[1] + dy, p[2] + dz))

    def turn(self, axis, degrees):
        """Turns right-handed about a coordinate axis."""
        c, s = cosine(degrees), sine(degrees)
        i = 'xyz'.index(axis)
        j, k = (i + 1) % 3, (i + 2) % 3

        def function(p):
            q = [0.0, 0.0, 0.0]
            q[i], q[j], q[k] = p[i], c * p[j] - s * p[k], s * p[j] + c * p[k]
            return tuple(q)
        return self.map(function)

    def face(self, direction):
        """Puts local +z along a coordinate direction; local y becomes +z (the outline is the view with z up)."""
        return self.map({'+z': lambda p: p, '-z': lambda p: (p[0], -p[1], -p[2]),
                         '+x': lambda p: (p[2], p[0], p[1]), '-x': lambda p: (-p[2], -p[0], p[1]),
                         '+y': lambda p: (-p[0], p[2], p[1]), '-y': lambda p: (p[0], -p[2], p[1])}[direction])

    def mirror(self, axis):
        i = 'xyz'.index(axis)
        return self.map(lambda p: tuple(-v if k == i else v for k, v in enumerate(p)), True)

    def both(self, axis):
        """The solid and its mirror image."""
        return self + self.mirror(axis)


def union(solids):
    return Solid(t for s in solids for t in s.triangles)


def skin(lower, upper):
    """The triangles between two rings with equal numbers of points. They face outward if `upper` is above, for
    counter-clockwise rings."""
    out = []
    for i in range(len(lower)):
        a, b, c, d = lower[i - 1], lower[i], upper[i], upper[i - 1]
        if a != b:
            out.append((a, b, c))
        if c != d:
            out.append((a, c, d))
    return out


def lift(outline, z):
    return [(x, y, z) for x, y in outline]


def cap(outline, z, up, holes=()):
    points = lift([p for loop in [outline] + list(holes) for p in loop], z)
    if len(set(points[:len(outline)])) == 1:
        return []
    faces = [(points[a], points[b], points[c]) for a, b, c in triangulate(outline, holes)]
    return faces if up else [(a, c, b) for a, b, c in faces]


def stack(layers, holes=()):
    """Outlines with equal numbers of points at rising heights, joined and capped: [(outline, z), ...].

    A hole is such a list that goes down from the top face; it goes through if it ends at the bottom face.
    """
    triangles = []
    for (a, za), (b, zb) in zip(layers, layers[1:]):
        triangles += skin(lift(a, za), lift(b, zb))
    through = [h[-1][0] for h in holes if h[-1][1] == layers[0][1]]
    triangles += cap(layers[0][0], layers[0][1], False, through)
    triangles += cap(layers[-1][0], layers[-1][1], True, [h[0][0] for h in holes])
    for h in holes:
        for (a, za), (b, zb) in zip(h, h[1:]):
            triangles += skin(lift(a, za), lift(b, zb))
        if h[-1][1] != layers[0][1]:
            triangles += cap(h[-1][0], h[-1][1], True)
    return Solid(triangles)


def prism(outline, z0, z1, bevel=0.0, sunk=(), rim=1.0):
    """An extruded outline with bevelled edges; `sunk` are openings in its top face.

    They are [(outline, depth)]; a depth of None goes through. `rim` is the bevel of their edges.
    """
    holes = []
    for opening, depth in sunk:
        bottom = z0 if depth is None else z1 - depth
        holes.append([(offset(opening, rim), z1), (opening, z1 - rim), (opening, bottom)] if rim
                     else [(opening, z1), (opening, bottom)])
    if not bevel:
        return stack([(outline, z0), (outline, z1)], holes)
    inner = offset(outline, -bevel)
    return stack([(inner, z0), (outline, z0 + bevel), (outline, z1 - bevel), (inner, z1)], holes)


def prism_x(outline, x0, x1, bevel=0.0, sunk=(), rim=1.0):
    """The outline is (y, z); openings are sunk from the face at x1."""
    return prism(outline, x0, x1, bevel, sunk, rim).face('+x')


def prism_y(outline, y0, y1, bevel=0.0, sunk=(), rim=1.0):
    """The outline is (x, z), seen from the front; openings are sunk from the front face, at y0."""
    return prism(outline, -y1, -y0, bevel, sunk, rim).face('-y')


def box(x0, x1, y0, y1, z0, z1, bevel=0.0, radius=0.0):
    return prism(rectangle(x0, x1, y0, y1, radius), z0, z1, bevel)


def revolve(profile, n=48):
    """A profile (r, z) turned about z, from the bottom up along the outside. Ends that are not on the axis are capped.
    """
    return stack([(circle(r, n), z) for r, z in profile])


def ring(profile, n=48):
    """A closed profile (r, z) turned about z, counter-clockwise with r to the right: a ring or a tube."""
    loops = [lift(circle(r, n), z) for r, z in profile]
    return Solid(t for i, loop in enumerate(loops) for t in skin(loops[i - 1], loop))


def tube(inner, outer, z0, z1, bevel=0.0, n=48):
    b = bevel
    if not b:
        return ring([(inner, z0), (outer, z0), (outer, z1), (inner, z1)], n)
    return ring([(inner, z0 + b), (inner + b, z0), (outer - b, z0), (outer, z0 + b), (outer, z1 - b), (outer - b, z1),
                 (inner + b, z1), (inner, z1 - b)], n)


def around(solid, n, phase=0.0):
    """n copies, at equal angles about z."""
    return union(solid.turn('z', phase + 360 * i / n) for i in range(n))


def loft(sections):
    """Rings in space with equal numbers of points, joined in order; the ends are closed by fans around their middles.
    """
    triangles = []
    for a, b in zip(sections, sections[1:]):
        triangles += skin(a, b)
    for section, up in ((sections[0], False), (sections[-1], True)):
        middle = tuple(sum(p[k] for p in section) / len(section) for k in range(3))
        for i, q in enumerate(section):
            triangles.append((section[i - 1], q, middle) if up else (q, section[i - 1], middle))
    return Solid(triangles)


# Files

def snapped(solid):
    return [tuple(tuple(on_grid(v) for v in p) for p in t) for t in solid.triangles]


def volume6(t):
    (a, b, c), (d, e, f), (g, h, i) = t
    return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)


def check(triangles, name):
    """The triangles, verified: closed, none without area, and every connected component faces outward."""
    edges, parent = {}, {}

    def root(p):
        while parent.setdefault(p, p) != p:
            parent[p] = p = parent[parent[p]]
        return p
    for t in triangles:
        for i in range(3):
            edges[t[i - 1], t[i]] = edges.get((t[i - 1], t[i]), 0) + 1
            parent[root(t[i - 1])] = root(t[i])
        assert any(normal(t)), '%s: a triangle without area at %s' % (name, [v / GRID for v in t[0]])
    for (a, b), count in edges.items():
        assert edges.get((b, a), 0) == count, '%s: open at %s' % (name, [v / GRID for v in a])
    volumes = {}
    for t in triangles:
        volumes[root(t[0])] = volumes.get(root(t[0]), 0) + volume6(t)
    assert min(volumes.values()) > 0, '%s: inside out' % name


def normal(t):
    u, v = [[t[k][i] - t[0][i] for i in range(3)] for k in (1, 2)]
    return (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])


def write_stl(folder, name, solid):
    """Checks the solid and writes it to folder/name.stl, binary. The value is the number of triangles."""
    triangles = snapped(solid)
    check(triangles, name)
    out = [('fivecheck model: %s' % name).encode('ascii').ljust(80), struct.pack('<I', len(triangles))]
    for t in triangles:
        n = normal(t)
        length = math.sqrt(sum(v * v for v in n))
        out.append(struct.pack('<12fH', *(v / length for v in n), *(v / GRID for p in t for v in p), 0))
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, name + '.stl'), 'wb') as f:
        f.write(b''.join(out))
    return len(triangles)
