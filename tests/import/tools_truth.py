#!/usr/bin/env python3
"""tools_truth.py LIBRARY.tls SETUP.xml - compares imported tools with the VERICUT library that they were made from.

Both files are read anew. At random heights the outermost radius of the setup's sections must be one that the library's
outlines have within 0.01 mm of that height, to 0.01 mm. Heights at a step, where sections may be thinner than a setup
can have, are left out.
"""

import bisect
import math
import random
import sys
import xml.etree.ElementTree as ET

NEAR = 0.0101


def number(node, path, default=0.0):
    text = node.findtext(path)
    return float(text) if text else default


def arc_radius(points, center, left, z):
    """The largest radius of an arc at a height; None: the arc does not reach this height."""
    (r0, z0), (r1, z1) = points
    radius = math.hypot(r0 - center[0], z0 - center[1])
    if abs(z - center[1]) > radius:
        return None
    half = math.sqrt(radius * radius - (z - center[1]) ** 2)
    start = math.atan2(z0 - center[1], r0 - center[0])
    sign = 1 if left else -1
    turn = (sign * (math.atan2(z1 - center[1], r1 - center[0]) - start)) % (2 * math.pi) or 2 * math.pi
    best = None
    for r in (center[0] + half, center[0] - half):
        at = (sign * (math.atan2(z - center[1], r - center[0]) - start)) % (2 * math.pi)
        if at <= turn + 1e-9 or at >= 2 * math.pi - 1e-9:
            best = r if best is None else max(best, r)
    return best


class Outline:
    """Radii of a tool of the library by height."""

    def __init__(self, tool):
        self.parts = []
        self.steps = []
        self.unit = 25.4 if tool.get("Units", "").lower() == "inch" else 1.0
        for group in tool.findall("Cutter") + tool.findall("Holder"):
            base = number(group, "Origin/Z")
            for sor in group.findall("SOR"):
                self.add_sor(sor, base + number(sor, "Origin/Z"))
            for apt in group.findall("Apt"):
                self.add_apt(apt, base)

    def add_line(self, r0, z0, r1, z1):
        if z0 != z1:
            self.parts.append(lambda z: r0 + (r1 - r0) * (z - z0) / (z1 - z0)
                              if min(z0, z1) <= z <= max(z0, z1) else None)
        self.steps += [z0, z1]

    def add_sor(self, sor, base):
        last, arc = None, None
        for node in sor:
            if node.tag == "Arc":
                arc = node
            if node.tag != "Pt":
                continue
            point = (number(node, "X"), base + number(node, "Z"))
            if last and arc is not None:
                center, left = (number(arc, "X"), base + number(arc, "Z")), arc.findtext("Direction") != "CW"
                ends = (last, point)
                self.parts.append(lambda z, e=ends, c=center, l=left: arc_radius(e, c, l, z))
                self.steps += [last[1], point[1]]
            elif last:
                self.add_line(*last, *point)
            last, arc = point, None

    def add_apt(self, apt, base):
        d, r, height, flutes = (number(apt, k) for k in ("D", "R", "H", "FluteLength"))
        shank, angle, kind = number(apt, "ShankDiameter"), number(apt, "A"), apt.get("Type")
        tip = 0.0
        if kind == "BALL END":
            r = d / 2
        if kind in ("BALL END", "BULL NOSE") and r > 0:
            tip = r
            self.parts.append(lambda z: d / 2 - r + math.sqrt(max(0, r * r - (r - z + base) ** 2))
                              if base <= z <= base + r else None)
        elif kind == "DRILL":
            tip = d / 2 * math.tan(math.radians(angle))
            self.add_line(0, base, d / 2, base + tip)
        self.steps += [base, base + tip]
        cut = flutes if 0 < flutes < height and shank > 0 else height
        self.add_line(d / 2, base + tip, d / 2, base + cut)
        if cut < height:
            self.add_line(shank / 2, base + cut, shank / 2, base + height)

    def radius(self, z):
        """mm, at a height in mm."""
        found = [r for r in (part(z / self.unit) for part in self.parts) if r is not None]
        return self.unit * max(found) if found else None

    def is_step(self, z):
        return any(abs(z - self.unit * step) < NEAR for step in self.steps)


class Setup:
    """Radii of a tool of the setup by height; the tip is cut from the last section."""

    def __init__(self, tool):
        self.length = float(tool.get("length"))
        self.rows, z = [], self.length
        for piece in ("holder", "shank", "cutter"):
            for s in tool.findall(piece + "/section"):
                d = float(s.get("diameter"))
                self.rows.append((z - float(s.get("length")), z, float(s.get("diameter_end", d)) / 2, d / 2))
                z -= float(s.get("length"))
        assert abs(z) < 1e-6, z
        self.rows.reverse()
        self.lows = [row[0] for row in self.rows]
        cutter = tool.find("cutter")
        self.tip = cutter.get("tip", "flat") if cutter is not None else "flat"
        self.corner = float(cutter.get("corner", 0)) if cutter is not None else 0
        self.angle = float(cutter.get("angle", 180)) if cutter is not None else 180

    def radius(self, z):
        low, high, r_low, r_high = self.rows[max(0, bisect.bisect_right(self.lows, z) - 1)]
        r = r_low + (r_high - r_low) * (z - low) / (high - low)
        last = self.rows[0][3]
        corner = last if self.tip == "ball" else self.corner if self.tip == "bull" else 0
        if z < corner:
            r = min(r, last - corner + math.sqrt(max(0, corner ** 2 - (corner - z) ** 2)))
        if self.tip == "cone":
            r = min(r, z * math.tan(math.radians(self.angle / 2)))
        return r


def main():
    library, setup = ET.parse(sys.argv[1]).getroot(), ET.parse(sys.argv[2]).getroot()
    rng, compared, worst = random.Random(1), 0, 0.0
    named = {}
    for tool in library.iter("Tool"):
        name = (tool.findtext("Description") or tool.get("ID")).strip()
        named.setdefault(name, []).append(tool)
    for tool in setup.findall("tool"):
        mine = Setup(tool)
        candidates = [t for t in library.iter("Tool") if t.get("ID") == tool.get("number")]
        outlines = [Outline(t) for t in candidates or named.get(tool.get("name"), [])]
        differences = []
        for outline in outlines:
            difference = 0.0
            for _ in range(60):
                z = rng.uniform(0, mine.length)
                near = [outline.radius(z + NEAR * k / 4) for k in range(-4, 5)]
                if None in near or outline.is_step(z):
                    continue
                difference = max(difference, mine.radius(z) - max(near), min(near) - mine.radius(z))
            differences.append(difference)
        # Several tools of a library may have the same name: one of them must be this tool.
        if differences:
            compared += 1
            worst = max(worst, min(differences))
            if min(differences) > 0.01:
                print(f"tool {tool.get('number')} ({tool.get('name')}): {min(differences):.4f} mm")
    print(f"{compared} tools compared, largest difference {worst:.4f} mm")
    return worst > 0.01 or not compared


if __name__ == "__main__":
    sys.exit(main())
