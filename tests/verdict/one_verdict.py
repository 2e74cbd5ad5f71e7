#!/usr/bin/env python3
"""A program has the same verdict and the same first finding with all options that must not change them.

Makes random machines and programs of some thousand small blocks, finds the place of each program at which its verdict
changes, and runs it there without options, and with all options that only report more or only save time. Any difference
is a fault, and its case is kept. Only Python's standard library is needed.

    one_verdict.py --fivecheck build/fivecheck --cases 4 --seed 1 --keep FOLDER [--only CASE] [--blocks MOST]
        [--programs COUNT] [--ways COUNT] [--patience SECONDS] [--progress] [--stock]
"""

import argparse
import collections
import json
import os
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

from shapes import box, drawn, prism, write_stl

# The place at which the verdict changes is searched with this many programs at once, this many times.
PLACES = 3
ROUNDS = 9

# Places around the change, toward clear: in mm, and in multiples of e. 0 is the last place with a finding, or the first
# clear one.
BESIDE_MM = (-0.5, -0.05)
BESIDE_E = (-2.0, -0.4, 0.4, 2.0)
# More places, at random: their largest distance from the change, in multiples of e or in mm.
AROUND_E = 4.0
AROUND_MM = 0.3

# The most blocks of a program that cuts a blank, and the tolerance of the remaining stock, in mm.
STOCK_BLOCKS = 40
STOCK_TOLERANCE = 2

# The blocks of a share, when shards share a program.
SHARE = 1024

# Options that take long.
COSTLY = ("--clearance", "--report", "--glb", "--picture")

# With this many programs, at least this share must have a cutter in a part; otherwise that is not tested.
MANY = 400
SHARE_OF_CUTTING = 0.05

# Seconds between two lines of progress.
PROGRESS = 10


class Fault(Exception):
    pass


class TooSlow(Exception):
    pass


class Undecided(Exception):
    """A rapid whose path is not known moves too many axes: the program cannot be a case."""


def axis_xml(name, kind, direction, inside, location=None, extra=""):
    place = f' location="{location}"' if location else ""
    rate = 7200 if kind == "rotary" else 30000
    return (f'<axis name="{name}" type="{kind}" direction="{direction}"{place} rate_max="{rate}" {extra}>{inside}'
            '</axis>')


class Case:
    """A machine, its setup, and a program whose approach along one axis is `place` mm."""

    prologue = ""
    tip = False  # the program guides the tool's tip
    stock = False  # the setup has a blank, which the program cuts
    rapids = 0.05  # the share of the blocks that are rapids
    changes_tool = False  # at the end of a share of the blocks the tool is loaded again

    def __init__(self, seed, number, folder, most=5000, with_stock=False):
        self.random = random.Random(f"{seed} {number}")
        self.folder = folder
        self.between = {}  # lines before blocks, by the number of the block
        r = self.random
        self.tolerance_on_path = r.choice([0, 0.005, 0.02, 0.05, 0.2])
        self.by_program = bool(self.tolerance_on_path) and r.random() < 0.4
        self.rapid = r.choice(["linear"] * 6 + ["dogleg"] * 3 + ["any"])
        self.wrap = r.choice(["none", "shortest", "sign"])
        self.clearance = r.choice([0, 0, 0, 0.5])
        self.e = r.choice([0.001, 0.001, 0.01, 0.1])
        r.choice([self.milling] if with_stock else
                 [self.head_over_table, self.trunnion, self.tilting_head, self.cutting, self.milling])()
        most = min(most, STOCK_BLOCKS) if self.stock else most
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
        write_stl(os.path.join(self.folder, name + ".stl"), drawn(self.random, triangles))
        return f'<body name="{name}" mesh="{name}.stl"/>'

    def gear(self, radius, bottom, top):
        n = self.random.choice([4, 6, 7, 24, 60])
        return prism([radius * self.random.uniform(0.97, 1) for _ in range(n)], bottom, top)

    def head_over_table(self):
        """A long head approaches a turning table from the side; its neighbour, the slide, touches it and is excused."""
        r = self.random
        head = self.mesh("head", box((60, -r.uniform(2, 20), -20), (80, r.uniform(2, 20), r.choice([40, 580]))))
        slide = self.mesh("slide", box((80, -20, 0), (100, 20, 400)))
        z = axis_xml("Z", "linear", "0 0 1", head)
        tree = axis_xml("X", "linear", "1 0 0", slide + z, extra='home="60"')
        tree += axis_xml("C", "rotary", r.choice(["0 0 1", "0 0 -1"]), self.mesh("table", self.gear(60, -40, 0)),
                         "0 0 0", f'wrap="{self.wrap}"')
        self.save(tree)
        self.approach, self.range = "X", (-25.0, 40.0)
        self.wander = {"C": 2.0, "Z": 3.0}

    def cutting(self):
        """A cutter that approaches a part, which it may enter a little at rapid or with a stopped spindle."""
        self.rapids = self.random.choice([0, 0.05, 0.5])
        self.trunnion(cutting=True)

    def milling(self):
        """Two tools that cut a blank, which they may enter a little at rapid or with a stopped spindle."""
        self.stock = True
        self.rapids = self.random.choice([0.02, 0.2])
        self.trunnion(cutting=True)
        for _ in range(self.random.randrange(6)):
            tool = self.random.choice((1, 2))
            guided = f"\nG43.4 H{tool}" if self.tip else ""
            self.between[self.random.randrange(STOCK_BLOCKS)] = self.random.choice(
                ["M5", "M3 S500", "/M5", f"T{tool} M6{guided}", f"T{tool} M6{guided}\nM3 S800"] +
                [f"G91\n{move}\nG90" for move in self.curves()])

    def curves(self):
        """Incremental moves that end where they begin, or whose end the next block leaves: arcs, a cycle, a probe move.
        """
        r = self.random
        if self.tip or self.rapid != "linear":
            return []
        turn = f"{r.choice(['G2', 'G3'])} I{r.uniform(-2, 2):.3f} J{r.uniform(0.3, 2):.3f} F900"
        return [turn, f"{turn} Z-{r.uniform(0.1, 2):.3f}", f"G18 G3 I{r.uniform(0.3, 2):.3f} K0.2 F900\nG17",
                f"G81 X{r.uniform(-3, 3):.3f} Y0 Z-{r.uniform(0.5, 3):.3f} R-0.2 F600\nG80",
                f"G38.3 Z-{r.uniform(0.1, 1):.3f} F300"]

    def trunnion(self, cutting=False):
        """A tool, or only the spindle nose, above a table that tilts and turns."""
        r = self.random
        tool = cutting or r.random() < 0.7
        spindle = '<spindle location="0 0 300" direction="0 0 -1"/>' if tool else ""
        head = self.mesh("nose", box((-30, -30, 300), (30, 30, 400))) + spindle
        z = axis_xml("Z", "linear", "0 0 1", head)
        tree = axis_xml("X", "linear", "1 0 0", axis_xml("Y", "linear", "0 1 0", z))
        table = self.mesh("table", self.gear(120, 0, 20)) + '<workholding location="0 0 20"/>'
        cradle = self.mesh("cradle", box((-150, -40, -60), (150, 40, -10)))
        c = axis_xml("C", "rotary", "0 0 -1", table, "0 0 0", f'wrap="{self.wrap}"')
        tree += axis_xml("A", "rotary", "-1 0 0", cradle + c, "0 0 -50", 'limit_min="-100" limit_max="100"')
        setup = None
        reach = 0
        if tool:
            reach = r.choice([60, 110])
            holder = f'<holder><section length="{reach - 30}" diameter="40"/></holder>'
            setup = (f'<setup version="1">{self.blank() if self.stock else self.part(cutting)}'
                     f'<tool number="1" length="{reach}">{holder}'
                     f'<cutter tip="{r.choice(["flat", "ball"])}"><section length="30" diameter="12"/></cutter></tool>'
                     f'{self.second_tool(reach, holder)}</setup>\n')
            self.prologue = "T1 M6\n" + ("M3 S1000\n" if self.stock else r.choice(["", "M3 S1000\n"]))
            self.changes_tool = not self.stock and r.random() < 0.5
            if r.random() < 0.4 and not self.changes_tool:
                self.prologue += "G43.4 H1\n"
                self.tip, reach = True, 0
        self.save(tree, setup=setup)
        self.approach, self.range = "Z", (-280.0 + reach - 140, -279.0 + reach + 160)
        self.wander = {"A": 1.0, "C": 2.0, "X": 3.0, "Y": 3.0}

    def part(self, always):
        """The part on the table, or nothing. A cutter may enter it while it cuts."""
        r = self.random
        if not always and r.random() < 0.4:
            return ""
        write_stl(os.path.join(self.folder, "part.stl"), drawn(r, box((-50, -45, 0), (50, 45, r.uniform(10, 60)))))
        depth = r.choice(["", ' rapid_allowance="0.02"', ' gouge="0.5"', ' gouge="0.05"'])
        return f'<part name="blank" mesh="part.stl"{depth}/>'

    def blank(self):
        r = self.random
        write_stl(os.path.join(self.folder, "blank.stl"), box((-40, -35, 0), (40, 35, r.uniform(20, 60))))
        high = r.uniform(20, 60)
        size = r.choice(['mesh="blank.stl"', f'box="70 60 {high:.3f}"', f'cylinder="70 {high:.3f}"'])
        doubt = r.choice(["", ' uncertainty="0.5"', ' excess="0.5"'])
        return f"<stock {size}{doubt}/>"

    def second_tool(self, reach, holder):
        """A tool with several sections: tapered, or wide at its end."""
        if not self.stock:
            return ""
        wide = self.random.random() < 0.5
        return (f'<tool number="2" length="{reach}">{holder}<shank><section length="10" diameter="8"/></shank><cutter>'
                f'<section length="10" diameter="{6 if wide else 16}" diameter_end="{6 if wide else 10}"/>'
                f'<section length="10" diameter="{20 if wide else 10}"/></cutter></tool>')

    def tilting_head(self):
        """A head that tilts by B and turns by C above blocks on the base."""
        r = self.random
        nose = self.mesh("nose", prism([25 * r.uniform(0.9, 1) for _ in range(12)], 120, 300))
        b = axis_xml("B", "rotary", "0 1 0", nose, "0 0 350", 'limit_min="-90" limit_max="90"')
        c = axis_xml("C", "rotary", "0 0 1", b, "0 0 0", f'wrap="{self.wrap}"')
        tree = self.mesh("block", box((-60, -60, -50), (60, 60, 0))) + self.mesh("post", self.gear(20, -50, 40))
        tree += axis_xml("X", "linear", "1 0 0", axis_xml("Y", "linear", "0 1 0", axis_xml("Z", "linear", "0 0 1", c)))
        self.save(tree)
        self.approach, self.range = "Z", (-150.0, 60.0)
        self.wander = {"B": 1.5, "C": 4.0, "X": 4.0, "Y": 4.0}

    def walk(self, count):
        """Lists for each block the positions of the wandering axes, and its retreat from the approach."""
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
            kind = "G0" if r.random() < self.rapids else "G1"
            blocks.append((kind, retreat, dict(at), r.random() < 0.1))
        return blocks

    def program(self, place, name):
        far = place + 30 if self.approach == "X" else place + 400
        lines = [self.prologue + f"G90 G21 G94 F5000 G0 {self.approach}{far:.4f}"]
        if self.by_program:
            lines.append(f"G64 P{self.tolerance_on_path}")
        for number, (kind, retreat, at, winds) in enumerate(self.blocks):
            lines.extend(filter(None, [self.between.get(number)]))
            # The tool is changed in the last block of a share; some entries of the list have several blocks.
            if self.changes_tool and len(lines) + lines[0].count("\n") == 2 * SHARE - 1:
                lines.append(self.prologue.strip())
            words = "".join(f" {axis}{value + (360 if winds and axis == 'C' and self.wrap == 'shortest' else 0):.5f}"
                            for axis, value in at.items())
            # The path of a rapid that is not straight is not known if the program guides the tip.
            kind = "G1" if self.tip and self.rapid != "linear" else kind
            lines.append(f"{kind} {self.approach}{place + retreat:.6f}{words}")
        with open(os.path.join(self.folder, name), "w") as f:
            f.write("\n".join(lines) + "\nM2\n")


def seconds_used():
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime


class Asker:
    def __init__(self, fivecheck, case, patience=None):
        self.fivecheck, self.case, self.patience = fivecheck, case, patience
        self.runs = 0
        self.settled = False  # the programs are known to be decidable
        self.began = seconds_used()

    def limit_time(self):
        if self.patience:
            resource.setrlimit(resource.RLIMIT_CPU, (self.patience, self.patience))

    def call(self, words, environment=None, statuses=(0, 1)):
        done = subprocess.run([self.fivecheck, *words], cwd=self.case.folder, env=environment, capture_output=True,
                              text=True, preexec_fn=self.limit_time)
        self.runs += 1
        if self.patience and (done.returncode in (-signal.SIGXCPU, -signal.SIGKILL) or
                              seconds_used() - self.began > self.patience):
            raise TooSlow()
        if not self.settled and done.returncode == 2 and "cannot be decided with reasonable effort" in done.stderr:
            raise Undecided()
        if done.returncode not in statuses:
            raise Fault(f"{' '.join(words)}: status {done.returncode}: {done.stderr.strip()}")
        return done

    def run(self, programs, *options, simd=None, statuses=(0, 1), out="out.ndjson"):
        """The exit status, and for each program its verdict and its findings, one line each."""
        words = [f"--tolerance={self.case.e}", f"--format=ndjson={out}", "--format=text", *options]
        if self.case.clearance:
            words.append(f"--clearance={self.case.clearance}")
        if self.case.setup:
            words += ["-s", "setup.xml"]
        if self.case.stock:
            words.append(f"--stock-tolerance={STOCK_TOLERANCE}")
        environment = dict(os.environ)
        environment.pop("FIVECHECK_SIMD", None)
        if simd:
            environment["FIVECHECK_SIMD"] = simd
        done = self.call(words + ["machine.xml", *programs], environment, statuses)
        return done.returncode, self.read(out)

    def read(self, out):
        """The verdict and the findings of each program of a run."""
        with open(os.path.join(self.case.folder, out)) as f:
            lines = f.read().splitlines()
        found = {}
        for line in lines:
            row = json.loads(line)
            if row["kind"] == "program":
                found.setdefault(row["file"], ["", []])[0] = row["verdict"]
            elif row["kind"] not in ("header", "summary"):
                found.setdefault(row["file"], ["", []])[1].append(line)
        return found

    def merge(self, names):
        """The same for joined shards."""
        status = self.call(["merge", "-o", "joined.ndjson", *names]).returncode
        return status, self.read("joined.ndjson")

    def waivers(self, run, name, most=None):
        """Writes waivers for the findings of a run, or only for the first ones of each program."""
        text = self.call(["waive", "--reason=known", "--until=9999-12-31", run]).stdout
        head, *items = text.split("<waiver ")
        end = items[-1][items[-1].index("</waivers>"):]
        kept, counts = [head], {}
        for item in items:
            program = re.search('program="([^"]*)"', item)[1]
            counts[program] = counts.get(program, 0) + 1
            if most is None or counts[program] <= most:
                kept.append(item.replace(end, ""))
        with open(os.path.join(self.case.folder, name), "w") as f:
            f.write("<waiver ".join(kept) + end)


# Options that only report more or only save time.
def ways(levels, with_glb):
    yield "-v", ["-v"], None
    yield "--timing", ["--timing=timing.csv", "--max-blocks=100000"], None
    yield "--clearance-report", ["--clearance-report=near.csv"], None
    yield "--clearance-cap", ["--clearance-report=near.csv", "--clearance-cap=0.01"], None
    yield "--waivers", ["--waivers=none.xml"], None
    yield "--report", ["--report=report.html"], None
    yield "--report-code", ["--report=report.html", "--report-code=none", "--picture=picture.svg"], None
    yield "--picture", ["--picture=picture.png", "--stats"], None
    yield "--pose", ["--pose=pose.stl", "--record=run.record"], None
    yield "--format", ["--format=sarif=run.sarif", "--format=junit=run.xml", "--format=github=run.txt"], None
    if with_glb:
        yield "--glb", ["--glb=scene.glb", "--report=report.html"], None
    for jobs in range(2, 6):
        yield f"-j{jobs}", [f"-j{jobs}"], None
    for level in levels:
        yield level, [], level


def expect(name, found, wanted):
    if found == wanted:
        return
    if isinstance(wanted, dict):
        for program in wanted:
            if found.get(program) != wanted[program]:
                raise Fault(f"{program}: plain: {wanted[program]}\n  {name}: {found.get(program)}")
    raise Fault(f"plain: {wanted}\n  {name}: {found}")


def firsts(runs):
    """The first finding of each program."""
    return {program: findings[:1] for program, (_, findings) in runs.items()}


def compare_shards(asker, programs, first, every):
    """Each shard of a program finds its share, and joined they are the whole run. The same for shards of a list."""
    count = asker.case.random.choice((2, 3, 5))
    names = [f"shard-{k}.ndjson" for k in range(1, count + 1)]
    program = asker.case.random.choice(programs)
    for options, (verdict, wanted) in (([], first[program]), (["-a"], every[program])):
        for k, name in enumerate(names, 1):
            asker.run([program], f"--shard={k}/{count}", *options, out=name)
        status, joined = asker.merge(names)
        findings = joined[program][1]
        if not options:
            # Each shard stops at its own first finding.
            findings = sorted(findings, key=lambda f: (json.loads(f)["time"], json.loads(f)["line"]))[:1]
        expect(f"{program}: merge of {count} shards {options}", (status, findings), (int(verdict == "found"), wanted))
    for k, name in enumerate(names, 1):
        asker.run(programs, f"--shard={k}/{count}", out=name)
    expect(f"merge of {count} shards of the list", asker.merge(names)[1], first)


def compare_waived(asker, programs, every):
    """If all findings are waived, the same findings are accepted; if the first is waived, the next one is the first
    that fails."""
    def bare(line):
        finding = json.loads(line)
        for key in ("accepted", "reason", "expires"):
            finding.pop(key, None)
        return finding

    asker.waivers("every.ndjson", "every.xml")
    status, runs = asker.run(programs, "--waivers=every.xml")
    expect("all waived", (status, {p: [bare(f) for f in runs[p][1]] for p in programs}),
           (0, {p: [json.loads(f) for f in every[p][1]] for p in programs}))
    asker.waivers("every.ndjson", "first.xml", 1)
    status, runs = asker.run(programs, "--waivers=first.xml")
    failing = {p: [f for f in runs[p][1] if "accepted" not in json.loads(f)] for p in programs}
    expect("the first waived", failing, {p: every[p][1][1:2] for p in programs})


def compare(asker, programs, levels, with_glb, count):
    """Compares all options, or `count` of them at random. The value counts the kinds of the programs' first findings,
    or their verdicts."""
    r = asker.case.random
    plain = asker.run(programs)
    every = asker.run(programs, "-a", out="every.ndjson")
    asker.settled = True
    expect("-a", (every[0], firsts(every[1])), (plain[0], firsts(plain[1])))
    asked = list(ways(levels, with_glb))
    for name, options, simd in asked if count is None else r.sample(asked, count):
        # Costly options are used only for the two programs next to the change.
        some = programs[:2] if name.startswith(COSTLY) else programs
        for more, (_, wanted) in ([], plain), (["-a"], every):
            status = int(any(wanted[p][0] == "found" for p in some))
            expect(f"{name} {more}", asker.run(some, *options, *more, simd=simd),
                   (status, {p: wanted[p] for p in some}))
    if r.random() < 0.1:
        expect("--sensitivity", asker.run(programs[:2], "--sensitivity=0.01,0.01,0.01,0.01")[1],
               {p: plain[1][p] for p in programs[:2]})
    for program in programs[:2] if asker.case.stock else ():
        expect("--stock-out", asker.run([program], "--stock-out=rest.stl")[1], {program: plain[1][program]})
    compare_shards(asker, programs, plain[1], every[1])
    if 0 < sum(len(findings) for _, findings in every[1].values()) < 1000:
        compare_waived(asker, programs, every[1])
    return collections.Counter(json.loads(findings[0])["kind"] if findings else verdict
                               for verdict, findings in plain[1].values())


def find_turn(case, asker):
    """The highest place with a finding, and the next one, which is clear."""
    near, far = case.range
    for _ in range(ROUNDS):
        places = [near + (far - near) * k / (PLACES + 1) for k in range(PLACES + 2)]
        names = [f"turn-{k}.nc" for k in range(1, PLACES + 1)]
        for place, name in zip(places[1:], names):
            case.program(place, name)
        runs = asker.run(names)[1]
        last = max((k for k, name in enumerate(names, 1) if runs[name][0] == "found"), default=0)
        near, far = places[last], places[last + 1]
    return near, far


def places_near(case, near, far, count):
    """The change itself, the places beside it, and more at random."""
    r = case.random
    places = [near, far] + [near + m for m in BESIDE_MM] + [(near if s < 0 else far) + s * case.e for s in BESIDE_E]
    while len(places) < count:
        around = r.choice((AROUND_E * case.e, AROUND_MM))
        places.append(near + r.uniform(-around, around))
    return places[:count]


def check(fivecheck, seed, number, folder, levels, with_glb, most, count, patience, programs_wanted, with_stock):
    """Checks a case. The value is the kinds of first findings with their numbers of programs, and the number of runs.
    """
    case = Case(seed, number, folder, most, with_stock)
    asker = Asker(fivecheck, case, patience)

    case.program(case.range[1], "clear.nc")
    with open(os.path.join(folder, "none.xml"), "w") as f:
        f.write('<waivers version="1"/>\n')
    status, runs = asker.run(["clear.nc"])
    if status:
        raise Fault(f"clear.nc is not clear: {runs}")
    places = places_near(case, *find_turn(case, asker), programs_wanted)
    programs = [f"p{i}.nc" for i in range(len(places))]
    for place, program in zip(places, programs):
        case.program(place, program)
    return compare(asker, programs, levels, with_glb, count), asker.runs


def abilities(fivecheck, folder):
    """The levels of SIMD, and whether --glb was built in."""
    case = Case(0, 0, folder)
    case.program(case.range[1], "clear.nc")
    works = lambda *options, simd=None: Asker(fivecheck, case).run(["clear.nc"], *options, simd=simd,
                                                                  statuses=(0, 1, 2))[0] != 2
    return [level for level in ("scalar", "sse2", "avx2") if works(simd=level)], works("--glb=scene.glb")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--fivecheck", default="build/fivecheck")
    parser.add_argument("--cases", type=int, default=4)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--programs", type=int, default=8, help="programs of each case")
    parser.add_argument("--only", type=int, help="the number of one case")
    parser.add_argument("--blocks", type=int, default=5000, help="the most blocks to a program")
    parser.add_argument("--ways", type=int, metavar="COUNT",
                        help="run each program with this many of the options, at random, instead of all")
    parser.add_argument("--patience", type=int, metavar="SECONDS",
                        help="leave out, and count, cases that take more processor time")
    parser.add_argument("--stock", action="store_true", help="only cases with a blank that is cut")
    parser.add_argument("--progress", action="store_true", help="print progress on standard error")
    parser.add_argument("--keep", default="build/verdicts", help="where cases that disagree are kept")
    arguments = parser.parse_args()
    fivecheck = os.path.abspath(arguments.fivecheck)
    numbers = [arguments.only] if arguments.only is not None else range(arguments.cases)
    kinds = collections.Counter()
    runs = faults = slow = undecided = 0
    told = time.monotonic()

    with tempfile.TemporaryDirectory() as folder:
        levels, with_glb = abilities(fivecheck, folder)
    for done, number in enumerate(numbers, 1):
        with tempfile.TemporaryDirectory() as folder:
            try:
                counts, some = check(fivecheck, arguments.seed, number, folder, levels, with_glb, arguments.blocks,
                                     arguments.ways, arguments.patience, arguments.programs, arguments.stock)
                kinds.update(counts)
                runs += some
            except TooSlow:
                slow += 1
            except Undecided:
                undecided += 1
            except Fault as fault:
                kept = os.path.join(arguments.keep, f"{arguments.seed}-{number}")
                shutil.rmtree(kept, ignore_errors=True)
                shutil.copytree(folder, kept)
                print(f"case {number} of seed {arguments.seed}, kept in {kept}:\n  {fault}", flush=True)
                faults += 1
        if arguments.progress and (time.monotonic() - told > PROGRESS or done == len(numbers)):
            told = time.monotonic()
            print(f"one_verdict: {done} of {len(numbers)} cases, {sum(kinds.values())} programs, {runs} runs, "
                  f"{faults} disagreements", file=sys.stderr, flush=True)
    programs, cutting = sum(kinds.values()), kinds["rapid-contact"] + kinds["gouge"]
    print(f"one_verdict: {programs} programs near the turn of their verdict, "
          f"{', '.join(f'{number} {kind}' for kind, number in sorted(kinds.items()))}, "
          f"levels {' '.join(levels)}, {runs} runs, {slow} cases left out as too slow, {undecided} as undecidable, "
          f"{faults} disagreements")
    if programs >= MANY and cutting < SHARE_OF_CUTTING * programs:
        print(f"one_verdict: a cutter enters a part in {cutting} programs only: too few to try that")
        return 1
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
