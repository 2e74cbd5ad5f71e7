#!/usr/bin/env python3
"""The same program has the same verdict and the same first finding, however it is asked.

Draws machines and programs of some thousand small blocks, moves each program to the place where its verdict just turns,
and runs it there plainly and in all the ways that only tell more or only save time. Any difference is a fault; the case
is kept. Only Python's standard library is needed.

    one_verdict.py --fivecheck build/fivecheck --cases 4 --seed 1 --keep FOLDER [--only CASE] [--blocks MOST]
"""

import argparse
import json
import math
import os
import random
import shutil
import struct
import subprocess
import sys
import tempfile

# Halvings of the range in which the verdict turns, and the places next to the turn that are looked at, in mm.
HALVINGS = 16
BESIDE = (0.0, 0.0004, -0.0004)


class Fault(Exception):
    pass


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
    """About Z, with one corner for each radius."""
    n = len(radii)
    ring = [(r * math.cos(2 * math.pi * i / n), r * math.sin(2 * math.pi * i / n)) for i, r in enumerate(radii)]
    out = []
    for i, p in enumerate(ring):
        q = ring[(i + 1) % n]
        out += [((*p, bottom), (*q, bottom), (*q, top)), ((*p, bottom), (*q, top), (*p, top))]
        out += [((0, 0, top), (*p, top), (*q, top)), ((0, 0, bottom), (*q, bottom), (*p, bottom))]
    return out


def axis_xml(name, kind, direction, inside, location=None, extra=""):
    place = f' location="{location}"' if location else ""
    rate = 7200 if kind == "rotary" else 30000
    return (f'<axis name="{name}" type="{kind}" direction="{direction}"{place} rate_max="{rate}" {extra}>{inside}</axis>')


class Case:
    """A machine, its setup, and a program whose approach along one axis is `place` mm."""

    def __init__(self, seed, number, folder, most=5000):
        self.random = random.Random(f"{seed} {number}")
        self.folder = folder
        r = self.random
        self.tolerance_on_path = r.choice([0, 0.005, 0.02, 0.05, 0.2])
        self.by_program = bool(self.tolerance_on_path) and r.random() < 0.4
        self.rapid = r.choice(["linear", "linear", "dogleg", "any"])
        self.wrap = r.choice(["none", "shortest", "sign"])
        self.clearance = r.choice([0, 0, 0, 0.5])
        self.e = r.choice([0.001, 0.001, 0.01, 0.1])
        r.choice([self.head_over_table, self.trunnion, self.tilting_head])()
        self.blocks = self.walk(min(most, r.randrange(3000, 5001) if r.random() < 0.8 else r.randrange(5, 200)))

    def controller(self):
        own = "" if self.by_program or not self.tolerance_on_path else f' path_tolerance="{self.tolerance_on_path}"'
        return f'<controller rapid="{self.rapid}"{own}/>'

    def save(self, tree, pairs="", setup=None):
        with open(os.path.join(self.folder, "machine.xml"), "w") as f:
            f.write(f'<machine version="1" name="case">{self.controller()}<base>{tree}</base>{pairs}</machine>\n')
        self.setup = setup
        if setup:
            with open(os.path.join(self.folder, "setup.xml"), "w") as f:
                f.write(setup)

    def mesh(self, name, triangles):
        write_stl(os.path.join(self.folder, name + ".stl"), triangles)
        return f'<body name="{name}" mesh="{name}.stl"/>'

    def gear(self, radius, bottom, top):
        n = self.random.choice([4, 6, 7, 24, 60])
        return prism([radius * self.random.uniform(0.97, 1) for _ in range(n)], bottom, top)

    def head_over_table(self):
        """A long head comes from the side to a turning table; its neighbour, the slide, touches it and is excused."""
        r = self.random
        head = self.mesh("head", box((60, -r.uniform(2, 20), -20), (80, r.uniform(2, 20), r.choice([40, 580]))))
        slide = self.mesh("slide", box((80, -20, 0), (100, 20, 400)))
        z = axis_xml("Z", "linear", "0 0 1", head)
        tree = axis_xml("X", "linear", "1 0 0", slide + z, extra='home="60"')
        tree += axis_xml("C", "rotary", r.choice(["0 0 1", "0 0 -1"]), self.mesh("table", self.gear(60, -40, 0)),
                         "0 0 0", f'wrap="{self.wrap}"')
        self.save(tree)
        self.approach, self.range = "X", (0.5, 40.0)
        self.wander = {"C": 2.0, "Z": 3.0}
        self.prologue = ""

    def trunnion(self):
        """A tool, or the bare spindle nose, above a table that tilts and turns."""
        r = self.random
        tool = r.random() < 0.7
        spindle = '<spindle location="0 0 300" direction="0 0 -1"/>' if tool else ""
        head = self.mesh("nose", box((-30, -30, 300), (30, 30, 400))) + spindle
        tree = axis_xml("X", "linear", "1 0 0", axis_xml("Y", "linear", "0 1 0", axis_xml("Z", "linear", "0 0 1", head)))
        table = self.mesh("table", self.gear(120, 0, 20)) + '<workholding location="0 0 20"/>'
        cradle = self.mesh("cradle", box((-150, -40, -60), (150, 40, -10)))
        c = axis_xml("C", "rotary", "0 0 -1", table, "0 0 0", f'wrap="{self.wrap}"')
        tree += axis_xml("A", "rotary", "-1 0 0", cradle + c, "0 0 -50", 'limit_min="-100" limit_max="100"')
        setup = None
        self.prologue = ""
        reach = 0
        if tool:
            reach = r.choice([60, 110])
            setup = ('<setup version="1"><tool number="1" length="%d"><holder><section length="%d" diameter="40"/></holder>'
                     '<cutter tip="flat"><section length="30" diameter="12"/></cutter></tool></setup>\n' % (reach, reach - 30))
            self.prologue = "T1 M6\n"
        self.save(tree, setup=setup)
        self.approach, self.range = "Z", (-280.0 + reach - 140, -279.0 + reach + 160)
        self.wander = {"A": 1.0, "C": 2.0, "X": 3.0, "Y": 3.0}

    def tilting_head(self):
        """A head that tilts by B and turns by C over blocks on the base."""
        r = self.random
        nose = self.mesh("nose", prism([25 * r.uniform(0.9, 1) for _ in range(12)], 120, 300))
        b = axis_xml("B", "rotary", "0 1 0", nose, "0 0 350", 'limit_min="-90" limit_max="90"')
        c = axis_xml("C", "rotary", "0 0 1", b, "0 0 0", f'wrap="{self.wrap}"')
        tree = self.mesh("block", box((-60, -60, -50), (60, 60, 0))) + self.mesh("post", self.gear(20, -50, 40))
        tree += axis_xml("X", "linear", "1 0 0", axis_xml("Y", "linear", "0 1 0", axis_xml("Z", "linear", "0 0 1", c)))
        self.save(tree)
        self.approach, self.range = "Z", (-150.0, 60.0)
        self.wander = {"B": 1.5, "C": 4.0, "X": 4.0, "Y": 4.0}
        self.prologue = ""

    def walk(self, count):
        """Lists what each block does to the wandering axes, and its retreat from the approach."""
        r = self.random
        at = {axis: 0.0 for axis in self.wander}
        step = r.choice([0.002, 0.02, 0.2, 1.0])
        retreats = r.random() < 0.5
        slides = r.random() < 0.5
        blocks = []
        for _ in range(count):
            for axis, amount in self.wander.items():
                if r.random() < 0.8:
                    at[axis] += step * amount * r.uniform(-1, 1) - 0.02 * at[axis]
            retreat = r.choice([0, 0, r.uniform(0, 0.01 if slides else 2)]) if retreats else 0
            kind = "G0" if r.random() < 0.05 else "G1"
            blocks.append((kind, retreat, dict(at), r.random() < 0.1))
        return blocks

    def program(self, place, name):
        far = place + 30 if self.approach == "X" else place + 400
        lines = [self.prologue + f"G90 G21 G94 F5000 G0 {self.approach}{far:.4f}"]
        if self.by_program:
            lines.append(f"G64 P{self.tolerance_on_path}")
        for kind, retreat, at, winds in self.blocks:
            words = "".join(f" {axis}{value + (360 if winds and axis == 'C' and self.wrap == 'shortest' else 0):.5f}"
                            for axis, value in at.items())
            lines.append(f"{kind} {self.approach}{place + retreat:.6f}{words}")
        with open(os.path.join(self.folder, name), "w") as f:
            f.write("\n".join(lines) + "\nM2\n")


class Asker:
    def __init__(self, fivecheck, case):
        self.fivecheck, self.case = fivecheck, case
        self.runs = 0

    def run(self, program, *options, simd=None, statuses=(0, 1)):
        out = os.path.join(self.case.folder, "out.ndjson")
        command = [self.fivecheck, f"--tolerance={self.case.e}", f"--format=ndjson={out}", "--format=text", *options]
        if self.case.clearance:
            command.append(f"--clearance={self.case.clearance}")
        if self.case.setup:
            command += ["-s", "setup.xml"]
        environment = dict(os.environ)
        environment.pop("FIVECHECK_SIMD", None)
        if simd:
            environment["FIVECHECK_SIMD"] = simd
        done = subprocess.run(command + ["machine.xml", program], cwd=self.case.folder, env=environment,
                              capture_output=True, text=True)
        self.runs += 1
        if done.returncode not in statuses:
            raise Fault(f"{' '.join(options)} {program}: status {done.returncode}: {done.stderr.strip()}")
        with open(out) as f:
            lines = f.read().splitlines()
        findings = [line for line in lines if json.loads(line).get("kind") not in ("header", "program", "summary")]
        return done.returncode, findings[0] if findings else None, done.stderr


def first_of(findings):
    found = [f for f in findings if f]
    return min(found, key=lambda f: (json.loads(f)["time"], json.loads(f)["line"])) if found else None


# Ways to ask that only tell more or only save time.
def ways(levels):
    yield "-a", ["-a"], None
    yield "-v", ["-v"], None
    yield "-v -a", ["-v", "-a"], None
    yield "--timing", ["--timing=timing.csv"], None
    yield "--clearance-report", ["--clearance-report=near.csv"], None
    yield "--waivers", ["--waivers=none.xml"], None
    for jobs in range(2, 6):
        yield f"-j{jobs}", [f"-j{jobs}"], None
    for level in levels:
        yield level, [], level


def compare(asker, program, levels):
    status, first, _ = asker.run(program)
    for name, options, simd in ways(levels):
        other_status, other, _ = asker.run(program, *options, simd=simd)
        if (other_status, other) != (status, first):
            raise Fault(f"{program}: plain: {status} {first}\n  {name}: {other_status} {other}")
    for shards in (2, 3):
        found = [asker.run(program, f"--shard={k}/{shards}") for k in range(1, shards + 1)]
        joint = max(f[0] for f in found), first_of([f[1] for f in found])
        if joint != (status, first):
            raise Fault(f"{program}: plain: {status} {first}\n  {shards} shards: {joint[0]} {joint[1]}")
    return status


def check(fivecheck, seed, number, folder, levels, most):
    """Returns how many programs were clear and how many were not, and the number of runs."""
    case = Case(seed, number, folder, most)
    asker = Asker(fivecheck, case)
    near, far = case.range
    counts = [0, 0]

    case.program(far, "clear.nc")
    with open(os.path.join(folder, "none.xml"), "w") as f:
        f.write('<waivers version="1"/>\n')
    status, _, said = asker.run("clear.nc")
    if status:
        raise Fault(f"clear.nc is not clear: {said}")
    for _ in range(HALVINGS):
        middle = 0.5 * (near + far)
        case.program(middle, "turn.nc")
        if asker.run("turn.nc")[0]:
            near = middle
        else:
            far = middle
    for i, beside in enumerate(BESIDE):
        case.program(far + beside * case.e / 0.001, f"p{i}.nc")
        counts[compare(asker, f"p{i}.nc", levels)] += 1
    return counts, asker.runs


def levels_of(fivecheck, folder):
    case = Case(0, 0, folder)
    case.program(case.range[1], "clear.nc")
    levels = []
    for level in ("scalar", "sse2", "avx2"):
        if Asker(fivecheck, case).run("clear.nc", simd=level, statuses=(0, 1, 2))[0] != 2:
            levels.append(level)
    return levels


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--fivecheck", default="build/fivecheck")
    parser.add_argument("--cases", type=int, default=4)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", type=int, help="the number of one case")
    parser.add_argument("--blocks", type=int, default=5000, help="the most blocks to a program")
    parser.add_argument("--keep", default="build/verdicts", help="where cases that disagree are kept")
    arguments = parser.parse_args()
    fivecheck = os.path.abspath(arguments.fivecheck)
    numbers = [arguments.only] if arguments.only is not None else range(arguments.cases)
    clear = found = runs = faults = 0

    with tempfile.TemporaryDirectory() as folder:
        levels = levels_of(fivecheck, folder)
    for number in numbers:
        with tempfile.TemporaryDirectory() as folder:
            try:
                counts, done = check(fivecheck, arguments.seed, number, folder, levels, arguments.blocks)
                clear, found, runs = clear + counts[0], found + counts[1], runs + done
            except Fault as fault:
                kept = os.path.join(arguments.keep, f"{arguments.seed}-{number}")
                shutil.rmtree(kept, ignore_errors=True)
                shutil.copytree(folder, kept)
                print(f"case {number} of seed {arguments.seed}, kept in {kept}:\n  {fault}")
                faults += 1
    print(f"one_verdict: {clear + found} programs near the turn of their verdict, {clear} clear, {found} not, "
          f"levels {' '.join(levels)}, {runs} runs, {faults} disagreements")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
