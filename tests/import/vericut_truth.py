#!/usr/bin/env python3
"""vericut_truth.py FILE.mch FOLDER - compares an imported machine with the VERICUT file that it was made from.

Both files are read anew, with nothing of fivecheck: the poses of the .mch are products of frames, each component in that
of its parent; those of machine.xml are products of motions in machine coordinates. Twenty random points of each body must
have the same place under fifty random axis positions, to 1e-6 mm; travels, rates and the collision list must be equal.
"""

import math
import random
import sys
import xml.etree.ElementTree as ET

LETTERS = "XYZABCUVW"
UNITS = {"millimeter": 1.0, "inch": 25.4}


def identity():
    return [[1.0 if i == j else 0.0 for j in range(4)] for i in range(4)]


def times(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(4)) for j in range(4)] for i in range(4)]


def apply(m, p):
    return [sum(m[i][k] * p[k] for k in range(3)) + m[i][3] for i in range(3)]


def shift(v):
    m = identity()
    for i in range(3):
        m[i][3] = v[i]
    return m


def turn(axis, degrees):
    """A right-handed turn about a line through 0: Rodrigues' formula."""
    length = math.sqrt(sum(x * x for x in axis))
    x, y, z = (a / length for a in axis)
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    k = 1 - c
    return [[c + k * x * x, k * x * y - s * z, k * x * z + s * y, 0],
            [k * x * y + s * z, c + k * y * y, k * y * z - s * x, 0],
            [k * x * z - s * y, k * y * z + s * x, c + k * z * z, 0],
            [0, 0, 0, 1]]


def numbers(text):
    return [float(word) for word in text.split()]


class Vericut:
    """The component tree of a .mch file."""

    def __init__(self, path):
        self.root = ET.parse(path).getroot()
        self.unit = UNITS[self.root.get("Unit").lower()]
        self.components = {c.get("Name"): c for c in self.root.findall("Component")}
        self.parent = {n: (c.findtext("Attach") or "").strip() for n, c in self.components.items()}
        self.work = set()
        for name, c in self.components.items():
            if c.get("Type").lower() in ("attach", "stock", "fixture", "design"):
                while name:
                    self.work.add(name)
                    name = self.parent[name]

    def frame(self, element):
        position, rotation = element.find("Position"), element.find("Rotation")
        m = shift([self.unit * float(position.get(k)) for k in "XYZ"])
        for axis, k in (((0, 0, 1), "K"), ((0, 1, 0), "J"), ((1, 0, 0), "I")):
            m = times(m, turn(axis, float(rotation.get(k))))
        return m

    def letter(self, name):
        c = self.components[name]
        link = c.find("Link")
        register = (link.get("Register") or "").upper() if link is not None else ""
        moves = c.get("Type").lower() in ("linear", "rotary")
        return register if moves and len(register) == 1 and register in LETTERS else None

    def motion(self, name, values):
        letter = self.letter(name)
        if not letter:
            return identity()
        link = self.components[name].find("Link")
        word = link.get("Axis")
        axis = [float("XYZ".index(word[-1].upper()) == i) for i in range(3)]
        sense = -1 if word.startswith("-") else 1
        if name in self.work and (link.get("DisableAuto") or "off").lower() != "on":
            sense = -sense
        if letter in "ABC":
            return turn(axis, sense * values[letter])
        return shift([sense * values[letter] * a for a in axis])

    def pose(self, name, values):
        m = self.pose(self.parent[name], values) if self.parent[name] else identity()
        return times(times(m, self.frame(self.components[name])), self.motion(name, values))

    def models(self):
        for name, c in self.components.items():
            for model in c:
                if model.get("Mirror") is not None:
                    yield name, model

    def names(self, name):
        c = self.components[name]
        if self.letter(name):
            return [self.letter(name)]
        if not self.parent[name]:
            return ["base"]
        kind = c.get("Type").lower()
        if kind == "tool":
            return ["holder", "shank", "cutter"]
        if kind == "attach":
            return ["fixture", "part"]
        return ["@" + name] if any(m.get("Mirror") is not None for m in c) else []

    def below(self, name, with_all):
        if not with_all:
            return [name]
        return [n for n in self.components if self.is_below(n, name)]

    def is_below(self, name, other):
        while name:
            if name == other:
                return True
            name = self.parent[name]
        return False

    def pairs(self):
        pairs = {}
        for between in self.root.iter("Between"):
            sides = [c.text.strip() for c in between.findall("Component")]
            some = [n for s in self.below(sides[0], between.get("Sub1") == "on") for n in self.names(s)]
            others = [n for s in self.below(sides[1], between.get("Sub2") == "on") for n in self.names(s)]
            for pair in {frozenset((a, b)) for a in some for b in others if a != b}:
                pairs[pair] = max(pairs.get(pair, 0), self.unit * float(between.get("Tol")))
        return pairs


class Machine:
    """The chain of a machine.xml file."""

    def __init__(self, path):
        self.root = ET.parse(path).getroot()
        assert self.root.get("units") == "mm"
        self.bodies, self.axes = [], {}
        self.walk(self.root.find("base"), [])

    def walk(self, element, chain):
        for child in element:
            if child.tag == "axis":
                self.axes[child.get("name")] = child
                self.walk(child, chain + [child])
            elif child.tag == "body":
                self.bodies.append((child, chain))

    def pose(self, body, chain, values):
        m = identity()
        for axis in chain:
            direction, value = numbers(axis.get("direction")), values[axis.get("name")]
            if axis.get("type") == "linear":
                m = times(m, shift([value * d for d in direction]))
                continue
            through = numbers(axis.get("location", "0 0 0"))
            m = times(times(times(m, shift(through)), turn(direction, value)), shift([-t for t in through]))
        m = times(m, shift(numbers(body.get("location", "0 0 0"))))
        angles = numbers(body.get("rotation", "0 0 0"))
        for axis, angle in (((0, 0, 1), angles[2]), ((0, 1, 0), angles[1]), ((1, 0, 0), angles[0])):
            m = times(m, turn(axis, angle))
        return m


def compare_poses(truth, machine, skipped, rng):
    models = [m for m in truth.models()]
    if len(models) - skipped != len(machine.bodies):
        sys.exit(f"{len(models)} models, but {len(machine.bodies)} bodies")
    if skipped:
        return 0.0
    worst = 0.0
    left = list(machine.bodies)
    for _ in range(50):
        values = {k: rng.uniform(-180, 180) if k in "ABC" else rng.uniform(-1000, 1000) for k in LETTERS}
        points = [[rng.uniform(-500, 500) for _ in range(3)] for _ in range(20)]
        want = [[apply(times(truth.pose(n, values), truth.frame(m)), p) for p in points] for n, m in models]
        have = [[apply(machine.pose(b, c, values), p) for p in points] for b, c in left]
        # Bodies and models have different orders: each body must be at the place of exactly one model.
        free = list(range(len(have)))
        for row in want:
            best = min(free, key=lambda i: max(abs(a - b) for p, q in zip(row[:2], have[i]) for a, b in zip(p, q)))
            worst = max(worst, max(abs(a - b) for p, q in zip(row, have[best]) for a, b in zip(p, q)))
            free.remove(best)
    return worst


def compare_axes(truth, machine):
    for name in truth.components:
        letter = truth.letter(name)
        if not letter:
            continue
        axis, link = machine.axes[letter], truth.components[name].find("Link")
        scale = 1 if letter in "ABC" else truth.unit
        record = link.find("TlRecord")
        if record is not None and record.get("TlIgnore") != "on":
            for ours, theirs in (("limit_min", "TlMin"), ("limit_max", "TlMax")):
                if abs(float(axis.get(ours)) - scale * float(record.get(theirs))) > 1e-6:
                    sys.exit(f"{letter}: {ours} is {axis.get(ours)}, but {theirs} {record.get(theirs)}")
        if link.get("RapidRate") and abs(float(axis.get("rate_max")) - scale * float(link.get("RapidRate"))) > 1e-6:
            sys.exit(f"{letter}: rate_max is {axis.get('rate_max')}, but RapidRate {link.get('RapidRate')}")


def compare_pairs(truth, machine):
    want = truth.pairs()
    have = {frozenset((p.get("a"), p.get("b"))): float(p.get("clearance", 0)) for p in machine.root.iter("pair")}
    # A component that is neither an axis nor the base is found in machine.xml by the names of its bodies.
    plain = {pair: c for pair, c in want.items() if not any(n.startswith("@") for n in pair)}
    for pair, clearance in plain.items():
        if abs(have.get(pair, -1) - clearance) > 1e-9:
            sys.exit(f"the pair {sorted(pair)} has {have.get(pair)}, not {clearance}")
    if len(plain) == len(want) and len(have) != len(want):
        sys.exit(f"{len(want)} pairs, but {len(have)} in machine.xml")
    return len(have)


def main():
    truth, machine = Vericut(sys.argv[1]), Machine(sys.argv[2] + "/machine.xml")
    skipped = int(sys.argv[3]) if len(sys.argv) > 3 else 0
    worst = compare_poses(truth, machine, skipped, random.Random(1))
    compare_axes(truth, machine)
    pairs = compare_pairs(truth, machine)
    print(f"{len(machine.bodies)} bodies, {len(machine.axes)} axes, {pairs} pairs, largest difference {worst:.1e} mm"
          if worst > 1e-9 else f"{len(machine.bodies)} bodies, {len(machine.axes)} axes, {pairs} pairs, all the same")
    return worst > 1e-6


if __name__ == "__main__":
    sys.exit(main())
