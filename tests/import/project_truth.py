#!/usr/bin/env python3
"""project_truth.py FILE.VcProject FILE.mch FOLDER - compares an imported project with the VERICUT files.

Both sides are read anew. Twenty points of each body of the machine and of each fixture, part and stock must have the same
place under fifty random axis positions, to 1e-6 mm. Where the axes stand at a work offset, and all others at 0, the gauge point must be at the place
that the row of the project names with To.
"""

import math
import random
import sys
import xml.etree.ElementTree as ET

from vericut_truth import LETTERS, Machine, Vericut, apply, numbers, shift, times, turn


class Project(Vericut):
    """The components of the machine with those of one setup."""

    def __init__(self, machine, setup):
        super().__init__(machine)
        self.setup = setup
        self.own = setup.findall("Build/Component")
        for c in self.own:
            self.components[c.get("Name")] = c
            self.parent[c.get("Name")] = (c.findtext("Attach") or "").strip()
        for name in [c.get("Name") for c in self.own if c.get("Type").lower() in ("stock", "fixture", "design")]:
            while name:
                self.work.add(name)
                name = self.parent[name]

    def places(self, values):
        for row in self.setup.iter("Row"):
            to = row.find("To")
            if to.get("CSystem") == "on":
                system = next(s for s in self.setup.iter("CSystem") if s.get("Name") == to.text.strip())
                m = times(self.pose(system.findtext("Attach").strip(), values), self.frame(system))
            else:
                m = self.pose(to.text.strip(), values)
            yield apply(m, [self.unit * float(to.get(k) or 0) for k in "XYZ"])

    def gauge(self, values):
        name = next(n for n, c in self.components.items() if c.get("Type").lower() == "tool")
        return apply(self.pose(name, values), [0, 0, 0])


def workholding(element, chain):
    for child in element:
        if child.tag == "workholding":
            return child, chain
        found = workholding(child, chain + [child]) if child.tag == "axis" else None
        if found:
            return found
    return None


def frame(element):
    m = shift(numbers(element.get("location", "0 0 0")))
    angles = numbers(element.get("rotation", "0 0 0"))
    for axis, angle in (((0, 0, 1), angles[2]), ((0, 1, 0), angles[1]), ((1, 0, 0), angles[0])):
        m = times(m, turn(axis, angle))
    return m


def choose(models, tags, want, have, points):
    """The body of each model: the nearest body that the model can have become; each body is used once."""
    kinds = {"fixture": ("fixture", "machine"), "design": ("part",), "stock": ("stock",)}
    free = {i: [apply(m, p) for p in points] for i, m in enumerate(have)}
    chosen = []
    for (_, kind, _), pose in zip(models, want):
        at = [apply(pose, p) for p in points]
        chosen.append(min((i for i in free if tags[i] in kinds.get(kind, ("machine",))),
                          key=lambda i: max(map(math.dist, at, free[i]))))
        del free[chosen[-1]]
    return chosen


def compare_bodies(project, machine, setup, rng):
    """Each model of the machine and of the setup is one body, of machine.xml or of the setup, at the same place."""
    models = [(n, c.get("Type").lower(), m) for n, c in project.components.items() for m in c
              if m.get("Mirror") is not None or m.find("Position") is not None]
    work = [b for b in setup if b.tag in ("fixture", "part", "stock")]
    tags = ["machine"] * len(machine.bodies) + [b.tag for b in work]
    assert len(models) == len(tags), (len(models), len(tags))
    mount, chain = workholding(machine.root.find("base"), [])
    worst, body_of = 0, []
    for _ in range(50):
        values = {k: rng.uniform(-180, 180) if k in "ABC" else rng.uniform(-1000, 1000) for k in LETTERS}
        points = [[rng.uniform(-500, 500) for _ in range(3)] for _ in range(20)]
        have = [machine.pose(b, c, values) for b, c in machine.bodies]
        have += [times(machine.pose(mount, chain, values), frame(b)) for b in work]
        want = [times(project.pose(name, values), project.frame(model)) for name, _, model in models]
        if not body_of:
            body_of = choose(models, tags, want, have, points[:2])
        for model, body in zip(want, body_of):
            worst = max(worst, max(math.dist(apply(model, p), apply(have[body], p)) for p in points))
    return len(tags), worst


def compare_offsets(project, setup):
    worst, places = 0, list(project.places({k: 0 for k in LETTERS}))
    offsets = setup.findall("work_offset")
    for offset in offsets:
        values = {k: float(offset.get(k, 0)) for k in LETTERS}
        worst = max(worst, min(math.dist(project.gauge(values), p) for p in project.places(values)))
    return len(offsets), len(places), worst


def main():
    project = Project(sys.argv[2], ET.parse(sys.argv[1]).getroot().find("Setup"))
    machine = Machine(sys.argv[3] + "/machine.xml")
    setup = ET.parse(sys.argv[3] + "/setup.xml").getroot()
    bodies, difference = compare_bodies(project, machine, setup, random.Random(1))
    offsets, rows, far = compare_offsets(project, setup)
    assert difference < 1e-6 and far < 1e-6, (difference, far)
    print(f"{bodies} bodies and {offsets} work offsets of {rows} rows, all the same")


if __name__ == "__main__":
    main()
