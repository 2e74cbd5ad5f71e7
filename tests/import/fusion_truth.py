#!/usr/bin/env python3
"""fusion_truth.py LIBRARY.json SETUP.xml - compares imported tools with the library of Fusion 360 that they were made from.

Both files are read anew. At 2,000 heights of each tool the outermost radius of the setup's sections and tip must be that of
the library's sizes within 0.01 mm of that height, to 0.01 mm.
"""

import json
import math
import sys
import xml.etree.ElementTree as ET

NEAR = 0.0101
STANDING = ("flat end mill", "ball end mill", "bull nose end mill", "drill", "spot drill", "chamfer mill", "face mill",
            "counter sink", "tapered mill", "dovetail mill", "lollipop mill")


def tapered_radius(r, half, corner, h):
    """A cone of the radius r at the tip, and the largest ball of the corner's radius on the plane of the tip within it."""
    angle = math.radians(half)
    cone = r + h * math.tan(angle)
    centre = r + corner * math.tan(angle) - corner / math.cos(angle)
    if h >= corner * (1 - math.sin(angle)):
        return cone
    return centre + math.sqrt(max(0, corner ** 2 - (corner - h) ** 2))


def library_radius(tool, h):
    """The outermost radius of the library's tool at a height above its tip."""
    unit = 25.4 if tool["unit"] == "inches" else 1.0
    g = {k: v * unit if k not in ("SIG", "TA") else v for k, v in tool["geometry"].items()
         if isinstance(v, (int, float)) and not isinstance(v, bool)}
    r, best, kind = g["DC"] / 2, 0.0, tool["type"]
    flutes = g.get("LCF", 0)
    shoulder = g.get("shoulder-length", flutes)
    below = g["LB"]
    if h <= min(flutes, below):
        best = r
        corner = g.get("RE", 0)
        if kind == "ball end mill":
            corner = r
        if kind in ("ball end mill", "bull nose end mill", "face mill") and h < corner:
            best = r - corner + math.sqrt(max(0, corner ** 2 - (corner - h) ** 2))
        if kind in ("drill", "spot drill") and g.get("SIG"):
            best = min(r, h * math.tan(math.radians(g["SIG"] / 2)))
        if kind == "counter sink":
            best = min(r, g.get("tip-diameter", 0) / 2 + h * math.tan(math.radians(g["SIG"] / 2)))
        if kind == "dovetail mill":
            best = r - h * math.tan(math.radians(g["TA"]))
        if kind == "lollipop mill":
            best = math.sqrt(max(0, r * r - (h - r) ** 2))
        if kind == "tapered mill" or kind == "face mill" and g.get("DCX", 0) > g["DC"]:
            best = tapered_radius(r, g["TA"], corner, h)
        if kind == "chamfer mill":
            best = min(r, g.get("tip-diameter", 0) / 2 + h * math.tan(math.radians(g["TA"])))
    if kind == "lollipop mill" and r <= h <= below:
        best = max(best, g.get("shoulder-diameter", g["SFDM"]) / 2, math.sqrt(max(0, r * r - (h - r) ** 2)))
    elif flutes <= h <= min(shoulder, below):
        best = max(best, g.get("shoulder-diameter", g["DC"]) / 2)
    if max(flutes, shoulder, r if kind == "lollipop mill" else 0) <= h <= below:
        best = max(best, g.get("SFDM", g["DC"]) / 2)
    holder, base = tool.get("holder") or {}, below
    scale = 25.4 if holder.get("unit") == "inches" else 1.0
    for s in holder.get("segments", []):
        height, low, high = scale * s["height"], scale * s["lower-diameter"] / 2, scale * s["upper-diameter"] / 2
        if base <= h <= base + height and height > 0:
            best = max(best, low + (high - low) * (h - base) / height)
        base += height
    return best


def known_to(tool):
    """The height up to which the library describes the tool."""
    holder = tool.get("holder") or {}
    scale = 25.4 if holder.get("unit") == "inches" else 1.0
    below = tool["geometry"]["LB"] * (25.4 if tool["unit"] == "inches" else 1.0)
    return below + scale * sum(s["height"] for s in holder.get("segments", []))


class SetupTool:
    def __init__(self, node):
        self.length = float(node.get("length"))
        self.sections, top = [], self.length
        for piece in ("holder", "shank", "cutter"):
            for s in node.findall(piece + "/section"):
                height, d = float(s.get("length")), float(s.get("diameter"))
                self.sections.append((top - height, top, float(s.get("diameter_end", d)) / 2, d / 2))
                top -= height
        assert abs(top) < 1e-6, top
        cutter = node.find("cutter")
        self.tip = cutter.get("tip", "flat")
        self.corner, self.angle = float(cutter.get("corner", 0)), float(cutter.get("angle", 0))
        self.r = self.sections[-1][2]

    def radius(self, h):
        best = max(lr + (hr - lr) * (h - low) / (high - low) for low, high, lr, hr in self.sections if low <= h <= high)
        corner = self.r if self.tip == "ball" else self.corner
        if self.tip in ("ball", "bull") and h < corner:
            return self.r - corner + math.sqrt(max(0, corner ** 2 - (corner - h) ** 2))
        if self.tip == "cone":
            return min(best, h * math.tan(math.radians(self.angle / 2)))
        return best


def differs(tool, made, h):
    have = made.radius(h)
    around = [library_radius(tool, x) for x in [h + d for d in (-NEAR, -NEAR / 2, 0, NEAR / 2, NEAR)] if 0 <= x <= made.length]
    return max(min(around) - have, have - max(around), 0)


def main():
    tools = json.load(open(sys.argv[1]))["data"]
    made = {int(t.get("number")): SetupTool(t) for t in ET.parse(sys.argv[2]).getroot().findall("tool")}
    compared, worst = 0, 0.0
    for tool in tools:
        number = tool.get("post-process", {}).get("number")
        if number not in made or tool["type"] not in STANDING or (tool.get("shaft") or {}).get("segments"):
            continue
        compared += 1
        known = min(made[number].length, known_to(tool))
        for i in range(1, 2000):
            gap = differs(tool, made[number], known * i / 2000)
            if gap > 0.01:
                print(f"tool {number} ({tool['type']}): {gap:.4f} mm at {known * i / 2000:.3f} mm above the tip")
                return 1
            worst = max(worst, gap)
    print(f"{compared} tools compared, to 0.01 mm")
    return compared == 0


sys.exit(main())
