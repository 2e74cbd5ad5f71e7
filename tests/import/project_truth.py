#!/usr/bin/env python3
"""project_truth.py FILE.VcProject FILE.mch FOLDER - compares an imported project with the VERICUT files.

Both sides are read anew. Twenty points of each fixture, part and stock must have the same place under fifty random axis
positions, to 1e-6 mm. Where the axes stand at a work offset, and all others at 0, the gauge point must be at the place
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
            self.work.add(c.get("Name"))

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


def compare_bodies(project, machine, setup, rng):
    models = [(c, m) for c in project.own for m in c if m.find("Position") is not None]
    bodies = [b for b in setup if b.tag in ("fixture", "part", "stock")]
    assert len(models) == len(bodies), (len(models), len(bodies))
    kinds = {"fixture": "fixture", "design": "part", "stock": "stock"}
    assert sorted(kinds[c.get("Type")] for c, _ in models) == sorted(b.tag for b in bodies)
    mount, chain = workholding(machine.root.find("base"), [])
    worst = 0
    for _ in range(50):
        values = {k: rng.uniform(-180, 180) if k in "ABC" else rng.uniform(-1000, 1000) for k in LETTERS}
        points = [[rng.uniform(-500, 500) for _ in range(3)] for _ in range(20)]
        have = [(b.tag, times(machine.pose(mount, chain, values), frame(b))) for b in bodies]
        for c, model in models:
            want = times(project.pose(c.get("Name"), values), project.frame(model))
            rows = [max(math.dist(apply(want, p), apply(m, p)) for p in points) for tag, m in have
                    if tag == kinds[c.get("Type")]]
            worst = max(worst, min(rows))
    return len(bodies), worst


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
