#!/usr/bin/env python3
"""kinematics_truth.py urdf FILE.urdf MACHINE.xml | freecad|mtconnect FILE/TABLE/HEAD MACHINE.xml | MODULE NAME=VALUE,... MACHINE.xml
- compares an imported machine with its source.

Nothing of fivecheck is used. A URDF tree is walked frame by frame; a kinematics module of LinuxCNC (xyzac-trt-kins,
xyzbc-trt-kins, 5axiskins) is computed by its published formulas. The axes of a machine of FreeCAD or MTConnect follow each
other in the order of TABLE and HEAD, their letters from the base on. machine.xml is a product of motions in machine coordinates.
Twenty points, or the point of the tool, must have the same place under fifty random axis positions, to 1e-6 mm.
"""

import json
import math
import os
import random
import sys
import xml.etree.ElementTree as ET

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from vericut_truth import apply, identity, numbers, shift, times, turn  # noqa: E402


def inverse(m):
    r = [[m[j][i] for j in range(3)] for i in range(3)]
    p = [-sum(r[i][k] * m[k][3] for k in range(3)) for i in range(3)]
    return [r[i] + [p[i]] for i in range(3)] + [[0, 0, 0, 1]]


def frame(element):
    m = shift(numbers(element.get("location", "0 0 0")))
    rotation = numbers(element.get("rotation", "0 0 0"))
    for axis, k in (((0, 0, 1), 2), ((0, 1, 0), 1), ((1, 0, 0), 0)):
        m = times(m, turn(axis, rotation[k]))
    return m


class Machine:
    def __init__(self, path):
        root = ET.parse(path).getroot()
        unit = 25.4 if root.get("units") == "inch" else 1
        self.base = root.find("base")
        for element in self.base.iter():
            if "location" in element.attrib:
                element.set("location", " ".join(str(unit * float(v)) for v in element.get("location").split()))
        self.axes = list(self.base.iter("axis"))

    def poses(self, values, node=None, pose=None):
        """(element, pose of its link) of all elements below."""
        node, pose = (self.base, identity()) if node is None else (node, pose)
        for child in node:
            if child.tag != "axis":
                yield child, pose
                continue
            direction = numbers(child.get("direction"))
            q = values[child.get("name")]
            if child.get("type") == "linear":
                length = math.sqrt(sum(d * d for d in direction))
                motion = shift([q * d / length for d in direction])
            else:
                at = numbers(child.get("location", "0 0 0"))
                motion = times(times(shift(at), turn(direction, q)), shift([-a for a in at]))
            yield from self.poses(values, child, times(pose, motion))

    def random(self):
        values = {}
        for axis in self.axes:
            low, high = float(axis.get("limit_min", -360)), float(axis.get("limit_max", 360))
            values[axis.get("name")] = random.uniform(low, high)
        return values


class Urdf:
    def __init__(self, path):
        self.root = ET.parse(path).getroot()
        self.joint = {j.find("child").get("link"): j for j in self.root.findall("joint")}

    @staticmethod
    def origin(element):
        o = element.find("origin")
        xyz = numbers(o.get("xyz", "0 0 0")) if o is not None else [0, 0, 0]
        rpy = numbers(o.get("rpy", "0 0 0")) if o is not None else [0, 0, 0]
        m = shift([1000 * v for v in xyz])
        for axis, k in (((0, 0, 1), 2), ((0, 1, 0), 1), ((1, 0, 0), 0)):
            m = times(m, turn(axis, math.degrees(rpy[k])))
        return m

    def pose(self, link, values):
        joint = self.joint.get(link)
        if joint is None:
            return identity()
        m = times(self.pose(joint.find("parent").get("link"), values), self.origin(joint))
        if joint.get("type") == "fixed":
            return m
        letter = [w for w in joint.get("name").upper().replace("-", "_").split("_") if w in "XYZABCUVW"][0]
        a = joint.find("axis")
        axis = numbers(a.get("xyz")) if a is not None else [1, 0, 0]
        if joint.get("type") == "prismatic":
            return times(m, shift([values[letter] * x for x in axis]))
        return times(m, turn(axis, values[letter]))

    def shapes(self):
        for link in self.root.findall("link"):
            kind = "collision" if link.find("collision") is not None else "visual"
            for shape in link.findall(kind):
                yield link.get("name"), shape


def compare_urdf(path, machine):
    urdf, worst = Urdf(path), 0
    shapes = list(urdf.shapes())
    for _ in range(50):
        values = machine.random()
        bodies = [(e, p) for e, p in machine.poses(values) if e.tag == "body"]
        assert len(bodies) == len(shapes), (len(bodies), len(shapes))
        by_name = {}
        for element, pose in bodies:
            by_name.setdefault(element.get("name").replace("link_", ""), []).append(times(pose, frame(element)))
        for name, shape in shapes:
            want = times(urdf.pose(name, values), urdf.origin(shape))
            geometry = shape.find("geometry")
            if geometry.find("box") is not None:
                want = times(want, shift([-500 * s for s in numbers(geometry.find("box").get("size"))]))
            if geometry.find("cylinder") is not None:
                want = times(want, shift([0, 0, -500 * float(geometry.find("cylinder").get("length"))]))
            have = by_name[name].pop(0)
            for _ in range(20):
                p = [random.uniform(-500, 500) for _ in range(3)]
                worst = max(worst, math.dist(apply(want, p), apply(have, p)))
    return worst


def nutating_point(module, p, q):
    """The trsrn modules: the table undoes a turn about X or Y; the head is Z through one point after a tilted turn."""
    i = 1 if module == "xyzacb_trsrn" else 0
    table, secondary = ("A", "B") if i else ("B", "A")
    name = "xy"[i]
    pivot = [0, 0, p["z-pivot"]]
    pivot[i] = p[name + "-pivot"]
    primary = [p["x-offset"] + pivot[0], p["y-offset"] + pivot[1], 0]
    centre = [0, 0, p["z-rot-axis"]]
    centre[i] = p[name + "-rot-axis"]
    tilt = [0, 0, math.cos(math.radians(p["nut-angle"]))]
    tilt[i] = math.sin(math.radians(p["nut-angle"]))

    def about(point, axis, degrees):
        return times(times(shift(point), turn(axis, degrees)), shift([-v for v in point]))

    head = times(about(primary, (0, 0, 1), q["C"]), about(pivot, tilt, q[secondary]))
    tip = [a + b for a, b in zip(apply(head, [0, 0, 0]), (q["X"], q["Y"], q["Z"]))]
    return apply(about(centre, (1, 0, 0) if i else (0, 1, 0), q[table]), tip)


def module_point(module, p, q):
    """The programmed point for joint positions, by the forward formulas of the modules."""
    def sc(letter):
        return math.sin(math.radians(q[letter])), math.cos(math.radians(q[letter]))

    if module in ("xyzacb_trsrn", "xyzbca_trsrn"):
        return nutating_point(module, p, q)
    if module == "xyzab_tdr_kins":
        (sa, ca), (sb, cb) = sc("A"), sc("B")
        x, y, z = q["X"] - p["x-rot-point"], q["Y"] - p["y-rot-point"], q["Z"] - p["z-rot-point"]
        dz = p["z-offset"]
        return [cb * x + sb * z + p["x-rot-point"], sa * sb * x + ca * y - cb * sa * z + sa * dz + p["y-rot-point"],
                -ca * sb * x + sa * y + ca * cb * z - ca * dz + p["z-rot-point"] + dz]
    s, c = sc("C")
    con = 1 if p["conventional-directions"] else -1
    if module == "maxkins":
        sb, cb = sc("B")
        length = p["pivot-length"] + q.get("W", 0)
        x, y = q["X"] - con * length * sb, q["Y"] - q.get("V", 0)
        return [c * x - s * y, s * x + c * y, q["Z"] - length * cb + p["pivot-length"]]
    if module == "5axiskins":
        sb, cb = sc("B")
        length = p["pivot-length"] + q.get("W", 0)
        return [q["X"] + length * sb * c, q["Y"] + length * sb * s, q["Z"] - length * cb + p["pivot-length"]]
    rx, ry, rz = p["x-rot-point"], p["y-rot-point"], p["z-rot-point"]
    s *= -con
    if module == "xyzac-trt-kins":
        sa, ca = sc("A")
        sa *= -con
        dy, dz = p["y-offset"], p["z-offset"]
        x, y, z = q["X"] - rx, q["Y"] - dy - ry, q["Z"] - dz - rz
        return [c * x + s * ca * y + s * sa * z + s * dy + rx, -s * x + c * ca * y + c * sa * z + c * dy + ry,
                -sa * y + ca * z + dz + rz]
    sb, cb = sc("B")
    sb *= -con
    dx, dz = p["x-offset"], p["z-offset"]
    x, y, z = q["X"] - dx - rx, q["Y"] - ry, q["Z"] - dz - rz
    return [c * cb * x + s * y - c * sb * z + c * dx + rx, -s * cb * x + c * y + s * sb * z - s * dx + ry,
            sb * x + cb * z + dz + rz]


def compare_module(module, parameters, machine):
    p = {"x-rot-point": 0, "y-rot-point": 0, "z-rot-point": 0, "x-offset": 0, "y-offset": 0, "z-offset": 0, "pivot-length": 250,
         "conventional-directions": 0, "x-pivot": 0, "y-pivot": 0, "z-pivot": 0, "y-offset": 0, "nut-angle": 0,
         "x-rot-axis": 0, "y-rot-axis": 0, "z-rot-axis": 0}
    for word in parameters.split(","):
        if word:
            p[word.split("=")[0]] = float(word.split("=")[1])
    worst = 0
    for _ in range(1000):
        values = machine.random()
        poses = {e.tag: times(m, frame(e)) for e, m in machine.poses(values)}
        have = apply(inverse(poses["workholding"]), apply(poses["spindle"], [0, 0, 0]))
        worst = max(worst, math.dist(have, module_point(module, p, values)))
    return worst


def freecad_pose(axes, letters, values, sign, unit):
    """A linear axis counts the tool relative to the work; a rotary one turns what it carries about its vector."""
    pose = identity()
    for letter in letters:
        axis, q = axes[letter], values[letter]
        joint = axis["joint"]
        if isinstance(joint, dict):
            at, vector = joint["origin"], joint["axis"]
        else:
            at, vector = joint if any(joint[1]) else [[0, 0, 0], joint[0]]
        length = math.sqrt(sum(v * v for v in vector))
        at = [unit * v for v in at]
        if axis["type"] == "linear":
            pose = times(pose, shift([sign * q * v / length for v in vector]))
        else:
            pose = times(pose, times(times(shift(at), turn(vector, q)), shift([-v for v in at])))
    return pose


def compare_freecad(source, machine):
    path, table, head = source.split("/")
    with open(path, encoding="utf-8") as file:
        data = json.load(file)["machine"]
    unit = 25.4 if data.get("units") == "imperial" else 1
    axes, worst = data["axes"], 0
    for axis in machine.axes:
        name, said = axis.get("name"), axes[axis.get("name")]
        scale = unit if said["type"] == "linear" else 1
        limits = said.get("limits", said)
        for ours, theirs in (("limit_min", limits["min"]), ("limit_max", limits["max"]), ("rate_max", said["max_velocity"])):
            assert abs(float(axis.get(ours)) - scale * theirs) < 1e-9, (name, ours)
    assert len(machine.axes) == len(axes)
    for _ in range(50):
        values = machine.random()
        poses = {e.tag: times(m, frame(e)) for e, m in machine.poses(values)}
        have = times(inverse(poses["workholding"]), poses["spindle"])
        want = times(inverse(freecad_pose(axes, table, values, -1, unit)), freecad_pose(axes, head, values, 1, unit))
        for _ in range(20):
            p = [random.uniform(-500, 500) for _ in range(3)]
            worst = max(worst, math.dist(apply(want, p), apply(have, p)))
    return worst


def mtconnect_pose(root, letters, values):
    """Every Motion moves what it carries along or about its Axis; an Origin counts in the coordinate system."""
    pose = identity()
    for letter in letters:
        part = [e for e in root.iter() if e.get("nativeName", e.get("name")) == letter and e.tag in ("Linear", "Rotary")][0]
        axis = numbers(part.findtext("Configuration/Motion/Axis"))
        at = numbers(part.findtext("Configuration/Motion/Origin") or "0 0 0")
        length = math.sqrt(sum(v * v for v in axis))
        if part.tag == "Linear":
            pose = times(pose, shift([values[letter] * v / length for v in axis]))
        else:
            pose = times(pose, times(times(shift(at), turn(axis, values[letter])), shift([-v for v in at])))
    return pose


def compare_mtconnect(source, machine):
    path, table, head = source.split("/")
    with open(path, encoding="utf-8") as file:
        root = ET.fromstring(file.read().replace("xmlns=", "was="))
    worst = 0
    for _ in range(50):
        values = machine.random()
        poses = {e.tag: times(m, frame(e)) for e, m in machine.poses(values)}
        for tag, letters in (("workholding", table), ("spindle", head)):
            want = mtconnect_pose(root, letters, values)
            for _ in range(20):
                p = [random.uniform(-500, 500) for _ in range(3)]
                worst = max(worst, math.dist(apply(want, p), apply(poses[tag], p)))
    return worst


def main():
    random.seed(19)
    kind, source, machine = sys.argv[1], sys.argv[2], Machine(sys.argv[3])
    compare = {"urdf": compare_urdf, "freecad": compare_freecad, "mtconnect": compare_mtconnect}.get(kind)
    worst = compare(source, machine) if compare else compare_module(kind, source, machine)
    assert worst < 1e-6, worst
    print("the same places, to 1e-6 mm")


main()
