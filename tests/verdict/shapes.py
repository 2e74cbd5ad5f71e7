"""shapes.py - surfaces of random bodies as they are drawn in practice, and STL files of them."""
import math
import struct


def write_stl(path, triangles):
    with open(path, "wb") as f:
        f.write(b"\0" * 80 + struct.pack("<I", len(triangles)))
        for t in triangles:
            f.write(struct.pack("<12fH", 0, 0, 0, *t[0], *t[1], *t[2], 0))


def box(low, high):
    c = [(x, y, z) for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2])]
    quads = ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))
    return [t for a, b, d, e in quads for t in ((c[a], c[b], c[d]), (c[a], c[d], c[e]))]


def prism(radii, bottom, top):
    """A prism about Z, with one corner for each radius."""
    n = len(radii)
    ring = [(r * math.cos(2 * math.pi * i / n), r * math.sin(2 * math.pi * i / n)) for i, r in enumerate(radii)]
    out = []
    for i, p in enumerate(ring):
        q = ring[(i + 1) % n]
        out += [((*p, bottom), (*q, bottom), (*q, top)), ((*p, bottom), (*q, top), (*p, top))]
        out += [((0, 0, top), (*p, top), (*q, top)), ((0, 0, bottom), (*q, bottom), (*p, bottom))]
    return out


def flipped(triangles):
    return [(a, c, b) for a, b, c in triangles]


def shrunk(triangles):
    """The surface at half size, about its middle."""
    corners = [p for t in triangles for p in t]
    middle = [0.5 * (min(p[k] for p in corners) + max(p[k] for p in corners)) for k in range(3)]
    return [tuple(tuple(middle[k] + 0.5 * (p[k] - middle[k]) for k in range(3)) for p in t) for t in triangles]


def drawn(r, triangles):
    """The surface as it is drawn in practice: mostly once, facing outward."""
    how = r.choice(["plain"] * 5 + ["doubled", "inverted", "nested", "hollow", "open"])
    if how == "doubled":
        return triangles + flipped(triangles)
    if how == "inverted":
        return flipped(triangles)
    if how == "nested":
        return triangles + shrunk(triangles)
    if how == "hollow":
        return triangles + flipped(shrunk(triangles))
    return triangles[:-1] if how == "open" else triangles
