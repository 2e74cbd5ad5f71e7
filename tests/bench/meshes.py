"""meshes.py - closed triangle meshes of any fineness, as binary STL files. Lengths in mm."""
import math
import struct

RECORD = struct.Struct('<12fH')


def write(path, triangles):
    """triangles: tuples of nine numbers, the corners turned outward."""
    pack, zero = RECORD.pack, (0.0, 0.0, 0.0)
    with open(path, 'wb') as out:
        out.write(b'\0' * 80 + struct.pack('<I', len(triangles)))
        for i in range(0, len(triangles), 65536):
            out.write(b''.join(pack(*zero, *t, 0) for t in triangles[i:i + 65536]))


def grid(corners, n):
    """The quadrangle of four corners, counter-clockwise seen from outside, in n x n cells."""
    a, b, c, d = corners

    def at(i, j):
        u, v = i / n, j / n
        return tuple((1 - u) * (1 - v) * a[k] + u * (1 - v) * b[k] + u * v * c[k] + (1 - u) * v * d[k]
                     for k in range(3))

    points = [[at(i, j) for j in range(n + 1)] for i in range(n + 1)]
    out = []
    for i in range(n):
        for j in range(n):
            p, q, r, s = points[i][j], points[i + 1][j], points[i + 1][j + 1], points[i][j + 1]
            out += [p + q + r, p + r + s]
    return out


def box(low, high, triangles=12):
    """About as many triangles as asked for."""
    n = max(1, round(math.sqrt(triangles / 12)))
    (x0, y0, z0), (x1, y1, z1) = low, high
    faces = [((x0, y0, z0), (x0, y1, z0), (x1, y1, z0), (x1, y0, z0)),
             ((x0, y0, z1), (x1, y0, z1), (x1, y1, z1), (x0, y1, z1)),
             ((x0, y0, z0), (x1, y0, z0), (x1, y0, z1), (x0, y0, z1)),
             ((x1, y0, z0), (x1, y1, z0), (x1, y1, z1), (x1, y0, z1)),
             ((x1, y1, z0), (x0, y1, z0), (x0, y1, z1), (x1, y1, z1)),
             ((x0, y1, z0), (x0, y0, z0), (x0, y0, z1), (x0, y1, z1))]
    return [t for face in faces for t in grid(face, n)]


def revolve(profile, n):
    """Points (radius, height) from bottom to top, turned about z in n steps; open ends are closed by discs."""
    if profile[0][0] > 0:
        profile = [(0.0, profile[0][1])] + profile
    if profile[-1][0] > 0:
        profile = profile + [(0.0, profile[-1][1])]
    turn = [(math.cos(2 * math.pi * k / n), math.sin(2 * math.pi * k / n)) for k in range(n)]
    rings = [[(r * c, r * s, z) for c, s in turn] for r, z in profile]
    out = []
    for (r0, _), (r1, _), low, high in zip(profile, profile[1:], rings, rings[1:]):
        for k in range(n):
            a, b, c, d = low[k], low[(k + 1) % n], high[(k + 1) % n], high[k]
            if r0 > 0:
                out.append(a + b + c)
            if r1 > 0:
                out.append(a + c + d)
    return out


def rings_of(triangles):
    """Rings and steps a ring of a ball with about as many triangles, twice as many steps as rings."""
    rings = max(3, round(math.sqrt(triangles / 4)))
    return rings, 2 * rings


def ball(radius, triangles, centre=(0.0, 0.0, 0.0)):
    """All corners lie on the sphere."""
    rings, n = rings_of(triangles)
    profile = [(0.0 if i in (0, rings) else radius * math.sin(math.pi * i / rings),
                -radius * math.cos(math.pi * i / rings)) for i in range(rings + 1)]
    shift = centre * 3
    return [tuple(a + b for a, b in zip(t, shift)) for t in revolve(profile, n)]


def ball_sag(radius, triangles):
    """No point of such a ball's surface is farther inside the sphere: no corner is farther from a face's middle."""
    rings, _ = rings_of(triangles)
    return radius * (1 - math.cos(math.pi / rings))
