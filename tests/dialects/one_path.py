#!/usr/bin/env python3
"""One random five-axis job, written for five controls, makes one path of the axes.

Draws machines and jobs (lines, arcs, helices, datum shifts, rotations, mirror images, tilted planes, tool centre point
control, drilling cycles, radius compensation, subprograms, loops), writes each job as LinuxCNC, Fanuc, Haas, Sinumerik
and Klartext program, and compares what --dump-path tells of them, to 1e-6 mm and degrees. A control that lacks an
element of a job leaves that job out, and the end of the run says how many jobs each control had. Only Python's standard
library is needed.

    one_path.py --fivecheck build/fivecheck --cases 40 --seed 1 --keep FOLDER [--only CASE] [--progress]
"""

import argparse
import math
import os
import random
import shutil
import subprocess
import sys
import tempfile

DIALECTS = ("linuxcnc", "fanuc", "haas", "sinumerik", "klartext")

# mm and degrees: how far two controls may be apart.
SAME = 1e-6

# Elements that a control lacks.
LACKS = {
    "linuxcnc": {"rotate", "mirror", "scale", "plane", "compensated"},
    "fanuc": {"scale", "in_plane"},
    "haas": {"scale", "plane"},
    "sinumerik": set(),
    "klartext": set(),
}

# Directions with exact decimals: arcs start and end on them.
EXACT = [(1, 0), (0, 1), (-1, 0), (0, -1)] + [
    (sx * a, sy * b) for a, b in ((0.6, 0.8), (0.8, 0.6), (0.28, 0.96), (0.96, 0.28)) for sx in (1, -1) for sy in (1, -1)
]

SLANT = math.sqrt(0.5)

# Rotary axes from the base on: letter, direction as on a head, location, limits, on the table or the head.
MACHINES = {
    "AC table": [("A", (1, 0, 0), (0, 3, -50), (-100, 3), "t"), ("C", (0, 0, 1), (10, 20, 0), None, "t")],
    "BC table": [("B", (0, 1, 0), (5, 0, -30), (-100, 3), "t"), ("C", (0, 0, 1), (0, 0, 0), None, "t")],
    "CA head": [("C", (0, 0, 1), (0, 0, 0), None, "h"), ("A", (1, 0, 0), (0, 0, 200), (-100, 3), "h")],
    "B head, C table": [("C", (0, 0, 1), (3, 4, 0), None, "t"), ("B", (0, 1, 0), (0, 0, 150), (-3, 100), "h")],
    "nutating head": [("C", (0, 0, 1), (3, 4, 0), None, "t"), ("B", (0, SLANT, SLANT), (0, -30, 120), (-3, 178), "h")],
}


def number(value):
    text = f"{value:.4f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text


def pointed(value):
    """With a decimal point, as Fanuc and Haas need it."""
    text = number(value)
    return text if "." in text else text + "."


def signed(value):
    text = number(value)
    return text if text.startswith("-") else "+" + text


# ------------------------------------------------------------------ the job


class Job:
    """Operations, as tuples: what they do stands in Control below, in a method of the same name."""

    def __init__(self, rng, only):
        self.rng = rng
        self.machine = rng.choice(sorted(MACHINES))
        self.letters = [axis[0] for axis in MACHINES[self.machine]]
        self.inch = rng.random() < 0.2
        self.lengths = [round(rng.uniform(30, 150), 3) for _ in range(2)]
        self.offsets = [[round(rng.uniform(-50, 50), 3) for _ in range(3)] for _ in range(2)]
        self.elements = set(rng.sample(only, rng.randint(1, min(4, len(only)))))
        self.operations = []
        self.at = [0.0, 0.0, 0.0]
        self.bodies = 0
        self.start()
        for _ in range(rng.randint(6, 14)):
            self.element()
        self.add("end")

    def add(self, *operation):
        self.operations.append(operation)

    def coordinate(self, least=-60, most=60):
        return round(self.rng.uniform(least, most), 3)

    def start(self):
        self.tool = self.rng.randint(1, 2)
        self.add("head")
        self.add("tool", self.tool)
        self.add("system", self.rng.randint(1, 2))
        self.go()

    # Absolute, all three, so that nothing depends on what was before.
    def go(self, rapid=True):
        self.at = [self.coordinate(), self.coordinate(), self.coordinate(20, 60)]
        self.add("line", rapid, dict(zip("XYZ", self.at)))

    def element(self):
        kinds = ["lines", "increments", "arc", "arc", "arc", "tool_change"] + 3 * sorted(self.elements)
        getattr(self, "make_" + self.rng.choice(kinds))()

    def make_lines(self):
        for _ in range(self.rng.randint(1, 4)):
            axes = self.rng.sample("XYZ", self.rng.randint(1, 3))
            words = {axis: self.coordinate() for axis in sorted(axes)}
            for axis, value in words.items():
                self.at["XYZ".index(axis)] = value
            self.add("line", self.rng.random() < 0.3, words)

    def make_increments(self):
        words = {axis: self.coordinate(-9, 9) for axis in sorted(self.rng.sample("XYZ", self.rng.randint(1, 3)))}
        for axis, value in words.items():
            self.at["XYZ".index(axis)] += value
        self.at = [round(value, 3) for value in self.at]
        self.add("increment", words)

    def make_arc(self, planes=(2, 2, 2, 1, 0)):
        across = self.rng.choice(planes)
        a, b = (across + 1) % 3, (across + 2) % 3
        radius = 5 * self.rng.randint(1, 8)
        centre = [round(c, 1) for c in (self.coordinate(), self.coordinate())]
        first, last = self.rng.choice(EXACT), self.rng.choice(EXACT)
        clockwise = self.rng.random() < 0.5
        start, end = list(self.at), list(self.at)
        for point, way in ((start, first), (end, last)):
            point[a] = round(centre[0] + radius * way[0], 4)
            point[b] = round(centre[1] + radius * way[1], 4)
        # A full circle where both are the same.
        if across == 2 and self.rng.random() < 0.3:
            end[2] = self.coordinate(-20, 20)
        by_radius = first != last and across == 2 and end[2] == start[2] and self.rng.random() < 0.3
        self.add("line", False, dict(zip("XYZ", start)))
        turned = math.atan2(last[1], last[0]) - math.atan2(first[1], first[0])
        turned = (-turned if clockwise else turned) % (2 * math.pi)
        by_radius = by_radius and abs(turned - math.pi) > 0.01
        self.add("arc", across, start, end, centre, clockwise, (-radius if turned > math.pi else radius) if by_radius else None)
        self.at = list(end)

    def make_tool_change(self):
        self.tool = self.rng.randint(1, 2)
        self.add("tool", self.tool)
        if self.rng.random() < 0.5:
            self.add("system", self.rng.randint(1, 2))
        self.go()

    def inside(self):
        """What may stand in changed coordinates."""
        self.go()
        for _ in range(self.rng.randint(1, 3)):
            self.rng.choice((self.make_lines, self.make_arc, self.make_increments))()

    def make_shift(self):
        self.add("shift", [self.coordinate(-30, 30) for _ in range(3)])
        self.inside()
        self.add("unshift")
        self.go()

    def make_rotate(self):
        self.add("rotate", self.coordinate(-170, 170))
        self.go()
        for _ in range(self.rng.randint(1, 3)):
            self.rng.choice((self.make_lines, lambda: self.make_arc((2,))))()
        self.add("unrotate")
        self.go()

    def make_mirror(self):
        self.add("mirror", self.rng.choice("XY"))
        self.go()
        for _ in range(self.rng.randint(1, 3)):
            self.rng.choice((self.make_lines, lambda: self.make_arc((2,))))()
        self.add("unmirror")
        self.go()

    def make_scale(self):
        self.add("scale", round(self.rng.uniform(0.5, 1.5), 3))
        self.go()
        for _ in range(self.rng.randint(1, 3)):
            self.rng.choice((self.make_lines, lambda: self.make_arc((2,))))()
        self.add("unscale")
        self.go()

    def make_plane(self):
        first, last = self.coordinate(-80, 80), self.coordinate(-80, 80)
        first, last = self.rng.choice(((0, last), (first, 0)))
        # Without a turn about Z first, a positive one needs half a turn of C on these machines: either way is as short.
        side = -1 if not first and "A" in self.letters else self.rng.choice((-1, 1))
        nod = round(side * self.rng.uniform(5, 70), 3)
        self.add("plane", (first, nod, last), [self.coordinate(-20, 20) for _ in range(3)])
        self.inside()
        if self.rng.random() < 0.5:
            self.make_drill()
        if "comp" in self.elements and self.rng.random() < 0.5:
            self.add("in_plane")
            self.make_comp()
        self.add("unplane")
        self.go()

    def make_tcp(self):
        self.add("tcp")
        primary = MACHINES[self.machine]
        for _ in range(self.rng.randint(2, 5)):
            words = dict(zip("XYZ", (self.coordinate(), self.coordinate(), self.coordinate(20, 60))))
            for letter, _, _, limits, _ in primary:
                low, high = limits or (-170, 170)
                words[letter] = round(self.rng.uniform(max(low, -60), min(high, 60)), 3)
            self.add("line", False, words)
        self.add("line", False, {letter: 0 for letter in self.letters})
        self.add("untcp")
        self.go()

    def make_rotary(self):
        words = {}
        for letter, _, _, limits, _ in MACHINES[self.machine]:
            low, high = limits or (-170, 170)
            words[letter] = round(self.rng.uniform(low, high), 3)
        self.add("line", True, words)
        self.go()
        self.make_lines()
        self.add("line", True, {letter: 0 for letter in words})

    def make_drill(self):
        kind = self.rng.choice(("drill", "dwell", "ream"))
        surface = self.coordinate(-20, 0)
        clearance = round(self.rng.uniform(0.5, 5), 3)
        depth = round(self.rng.uniform(2, 30), 3)
        level = round(surface + clearance + self.rng.uniform(1, 20), 3)
        points = [(self.coordinate(), self.coordinate()) for _ in range(self.rng.randint(1, 4))]
        self.add("line", True, {"Z": level})
        self.add("drill", kind, surface, clearance, depth, level, points)
        self.at = [*points[-1], level]
        self.go()

    def make_comp(self):
        """Round a polygon with arcs for corners here and there; the tool's radius is 4 and 2.5 mm."""
        left = self.rng.random() < 0.5
        corners = self.rng.randint(3, 6)
        outline = []
        for i in range(corners):
            angle = 2 * math.pi * (i + self.rng.uniform(-0.2, 0.2)) / corners
            size = self.rng.uniform(40, 80)
            outline.append((round(size * math.cos(angle), 3), round(size * math.sin(angle), 3)))
        if self.rng.random() < 0.5:
            outline.reverse()
        before = self.beside(outline[1], outline[0])
        behind = self.beside(outline[-2], outline[-1])
        self.add("line", True, {"X": before[0], "Y": before[1], "Z": 10.0})
        self.add("compensated", self.tool, left, outline, behind)
        self.at = [*behind, 10.0]
        self.go()

    def beside(self, start, end):
        """A point 30 mm behind the end of a line, up to 60 degrees beside its direction."""
        angle = math.atan2(end[1] - start[1], end[0] - start[0]) + math.radians(self.rng.uniform(-60, 60))
        return (round(end[0] + 30 * math.cos(angle), 3), round(end[1] + 30 * math.sin(angle), 3))

    def body(self):
        steps = [{axis: self.coordinate(-5, 5) for axis in sorted(self.rng.sample("XYZ", self.rng.randint(1, 3)))}
                 for _ in range(self.rng.randint(1, 4))]
        self.bodies += 1
        return self.bodies, steps

    def make_call(self):
        self.add("call", *self.body(), self.rng.randint(1, 3))
        self.go()

    def make_loop(self):
        self.add("loop", *self.body(), self.rng.randint(1, 4))
        self.go()

    def compare_on(self, dialect):
        used = {operation[0] for operation in self.operations}
        return not used & LACKS[dialect]


# ------------------------------------------------------------------ the controls


class Control:
    """Writes a job. Lengths come in mm."""

    number = staticmethod(pointed)

    def __init__(self, job):
        self.job = job
        self.unit = 25.4 if job.inch else 1
        self.lines = []
        self.subs = []
        for operation in job.operations:
            getattr(self, operation[0])(*operation[1:])

    def put(self, *lines):
        self.lines.extend(lines)

    # Jobs in inches have the same numbers, counted in inches: a tenth of them, so that they stay on the machine.
    def length(self, value):
        return value / 10 if self.job.inch else value

    def word(self, axis, value):
        return axis + self.number(value if axis in "ABC" else self.length(value))

    def words(self, words):
        return " ".join(self.word(axis, value) for axis, value in words.items())

    def text(self):
        return "\n".join(self.lines + self.subs) + "\n"


    def in_plane(self):
        """The next element, radius compensation, is in a tilted plane."""


class Iso(Control):
    """What LinuxCNC, Fanuc, Haas and Sinumerik write alike."""

    def system(self, which):
        self.put(f"G{53 + which}")

    def line(self, rapid, words):
        self.put(("G0 " if rapid else "G1 ") + self.words(words) + ("" if rapid else " F" + self.number(self.length(900))))

    def increment(self, words):
        self.put("G91", "G1 " + self.words(words) + " F" + self.number(self.length(500)), "G90")

    def arc(self, across, start, end, centre, clockwise, radius):
        a, b = (across + 1) % 3, (across + 2) % 3
        text = "G2" if clockwise else "G3"
        if across == 2:
            words = {"X": end[0], "Y": end[1]}
            if end[2] != start[2]:
                words["Z"] = end[2]
        else:
            words = {"XYZ"[i]: end[i] for i in sorted((a, b))}
        text += " " + self.words(words)
        if radius is not None:
            text += " " + self.radius(radius)
        else:
            ways = {a: centre[0] - start[a], b: centre[1] - start[b]}
            text += "".join(" " + "IJK"[i] + self.number(self.length(ways[i])) for i in sorted(ways))
        if across != 2:
            self.put("G18" if across == 1 else "G19")
        self.put(text)
        if across != 2:
            self.put("G17")

    def radius(self, radius):
        return "R" + self.number(self.length(radius))

    def drill(self, kind, surface, clearance, depth, level, points):
        code = {"drill": "G81", "dwell": "G82", "ream": "G85"}[kind]
        more = f" P{self.dwell}" if kind == "dwell" else ""
        for i, (x, y) in enumerate(points):
            words = {"X": x, "Y": y}
            if i == 0:
                words.update({"Z": surface - depth, "R": surface + clearance})
            tail = more + " F" + self.number(self.length(300)) if i == 0 else ""
            self.put((f"G98 {code} " if i == 0 else "") + self.words(words) + tail)
        self.put("G80")

    dwell = "500"

    def shift(self, by):
        self.put("G52 " + self.words(dict(zip("XYZ", by))))

    def unshift(self):
        self.put("G52 " + self.words(dict(zip("XYZ", (0, 0, 0)))))

    def compensated(self, tool, left, outline, behind):
        code = "G41" if left else "G42"
        for i, (x, y) in enumerate(outline):
            words = self.words({"X": x, "Y": y})
            self.put((f"{code} {self.offset(tool)}G1 " if i == 0 else "G1 ") + words + " F" + self.number(self.length(800)))
        self.put("G40 G1 " + self.words(dict(zip("XY", behind))))

    def offset(self, tool):
        return f"D{tool} "

    def steps(self, steps):
        return ["G91"] + ["G1 " + self.words(step) + " F" + self.number(self.length(700)) for step in steps] + ["G90"]

    def end(self):
        self.put("M30")


class Linuxcnc(Iso):
    number = staticmethod(number)
    dwell = "0.5"

    def head(self):
        self.put("G17 G90 G94 G64 " + ("G20" if self.job.inch else "G21"))

    def tool(self, which):
        self.put(f"T{which} M6", f"G43 H{which}", "S1000 M3")

    def tcp(self):
        self.put("M428")

    def untcp(self):
        self.put("M429")

    def call(self, body, steps, times):
        self.put(f"o{body} sub", *self.steps(steps), f"o{body} endsub")
        self.put(*[f"o{body} call"] * times)

    def loop(self, body, steps, times):
        self.put(f"#1={times}", f"o{body} while [#1 GT 0]", *self.steps(steps), "#1=[#1-1]", f"o{body} endwhile")


class Fanuc(Iso):
    def head(self):
        self.put("%", "O1", "G17 G90 G94 G40 G49 G80 G69 " + ("G20" if self.job.inch else "G21"))

    def tool(self, which):
        self.put(f"T{which} M6", f"G43 H{which}", "S1000 M3")

    def rotate(self, angle):
        self.put("G68 X0. Y0. R" + pointed(angle))

    def unrotate(self):
        self.put("G69")

    def mirror(self, axis):
        self.put(f"G51.1 {axis}0.")

    def unmirror(self):
        self.put("G50.1 X0. Y0.")

    def scale(self, factor):
        self.put("G51 X0. Y0. Z0. P" + pointed(factor))

    def unscale(self):
        self.put("G50")

    def plane(self, angles, origin):
        words = self.words(dict(zip("XYZ", origin)))
        self.put("G68.2 " + words + "".join(" " + letter + pointed(a) for letter, a in zip("IJK", angles)), "G53.1")

    def unplane(self):
        self.put("G69", "G0 " + self.words({letter: 0 for letter in self.job.letters}))

    def tcp(self):
        self.put(f"G43.4 H{self.job_tool()}")

    def untcp(self):
        self.put("G49", f"G43 H{self.job_tool()}")

    def job_tool(self):
        return [line for line in self.lines if " M6" in line][-1].split()[0][1:]

    def call(self, body, steps, times):
        self.put(f"M98 P{8000 + body} L{times}")
        self.subs += [f"O{8000 + body}", *self.steps(steps), "M99"]

    def loop(self, body, steps, times):
        self.put(f"#1={times}", "WHILE [#1 GT 0] DO1", *self.steps(steps), "#1=#1-1", "END1")

    def text(self):
        return super().text() + "%\n"


class Haas(Fanuc):
    def plane(self, angles, origin):
        words = self.words(dict(zip("XYZ", origin)))
        self.put("G268 " + words + "".join(" " + letter + pointed(a) for letter, a in zip("IJK", angles)) + " Q313",
                 "G253")

    def unplane(self):
        self.put("G269", "G0 " + self.words({letter: 0 for letter in self.job.letters}))

    def tcp(self):
        self.put(f"G234 H{self.job_tool()}")

    def mirror(self, axis):
        self.put(f"G101 {axis}0.")

    def unmirror(self):
        self.put("G100 X0. Y0.")


class Sinumerik(Iso):
    number = staticmethod(number)

    def head(self):
        self.put("G17 G90 G94 G64 NORM G450 " + ("G700" if self.job.inch else "G710"))

    def tool(self, which):
        self.put(f"T{which} D1", "M6", "S1000 M3")

    def radius(self, radius):
        return "CR=" + number(self.length(radius))

    def shift(self, by):
        self.put("TRANS " + self.words(dict(zip("XYZ", by))))

    def unshift(self):
        self.put("TRANS")

    def rotate(self, angle):
        self.put("ROT RPL=" + number(angle))

    def unrotate(self):
        self.put("ROT")

    def mirror(self, axis):
        self.put(f"MIRROR {axis}0")

    def unmirror(self):
        self.put("MIRROR")

    def scale(self, factor):
        self.put("SCALE " + " ".join(axis + number(factor) for axis in "XYZ"))

    def unscale(self):
        self.put("SCALE")

    def plane(self, angles, origin):
        first, nod, last = angles
        # Z, X, Y for a turn about Z first; X, Y, Z for one about Z last: each about the new axes.
        mode, turns = (39, (first, nod, 0)) if first else (57, (nod, 0, last))
        place = ",".join(number(self.length(c)) for c in origin)
        # DIR: the sign of the axis that is no C; its limits leave no other.
        side = [1 if axis[3][1] > 50 else -1 for axis in MACHINES[self.job.machine] if axis[0] != "C"][0]
        self.put(f'CYCLE800(0,"",0,{mode},{place},' + ",".join(map(number, turns)) + f",0,0,0,{side})")

    def unplane(self):
        self.put('CYCLE800()', "G0 " + self.words({letter: 0 for letter in self.job.letters}))

    def tcp(self):
        self.put("TRAORI", "ORIAXES")

    def untcp(self):
        self.put("TRAFOOF")

    def drill(self, kind, surface, clearance, depth, level, points):
        values = [level, surface, clearance, surface - depth]
        values = ",".join(number(self.length(v)) for v in values)
        feed = number(self.length(300))
        self.put("F" + feed)
        call = {"drill": f"CYCLE81({values})", "dwell": f"CYCLE82({values},,0.5)",
                "ream": f"CYCLE85({values},,0,{feed},{feed})"}[kind]
        self.put("G0", "MCALL " + call)
        for x, y in points:
            self.put(self.words({"X": x, "Y": y}))
        self.put("MCALL")

    def in_plane(self):
        self.put("CUT2DF")

    def offset(self, tool):
        return ""

    def call(self, body, steps, times):
        self.put(f"GOTOF BEHIND{body}", f"FIRST{body}:", *self.steps(steps), f"LAST{body}:", f"BEHIND{body}:")
        self.put(f"REPEAT FIRST{body} LAST{body}" + (f" P={times}" if times > 1 else ""))

    def loop(self, body, steps, times):
        self.put(f"R1={times}", "WHILE R1>0", *self.steps(steps), "R1=R1-1", "ENDWHILE")


class Klartext(Control):
    number = staticmethod(signed)

    def head(self):
        self.put("BEGIN PGM JOB " + ("INCH" if self.job.inch else "MM"))

    def tool(self, which):
        self.put(f"TOOL CALL {which} Z S1000", "L M3")

    def system(self, which):
        self.put(f"CYCL DEF 247 DATUM SETTING ~", f"    Q339=+{which} ;DATUM NUMBER")

    def line(self, rapid, words):
        self.put("L " + self.words(words) + (" R0 FMAX" if rapid else " R0 F900"))

    def increment(self, words):
        self.put("L " + " ".join("I" + self.word(axis, value) for axis, value in words.items()) + " F500")

    def arc(self, across, start, end, centre, clockwise, radius):
        a, b = (across + 1) % 3, (across + 2) % 3
        direction = " DR-" if clockwise else " DR+"
        ends = " ".join(self.word("XYZ"[i], end[i]) for i in sorted((a, b)))
        if radius is not None:
            self.put("CR " + ends + " R" + signed(self.length(radius)) + direction)
            return
        self.put("CC " + " ".join(self.word("XYZ"[i], c) for i, c in sorted(((a, centre[0]), (b, centre[1])))))
        if across == 2 and end[2] != start[2]:
            turn = math.degrees(math.atan2(end[b] - centre[1], end[a] - centre[0]))
            begin = math.degrees(math.atan2(start[b] - centre[1], start[a] - centre[0]))
            turn = (begin - turn if clockwise else turn - begin) % 360
            turn = 360 if turn < 1e-6 or turn > 360 - 1e-6 else turn
            self.put(f"CP IPA{'-' if clockwise else '+'}{turn:.12g} " + self.word("Z", end[2]) + direction)
            return
        self.put("C " + ends + direction)

    def drill(self, kind, surface, clearance, depth, level, points):
        cycle = {"drill": 200, "dwell": 200, "ream": 201}[kind]
        words = {200: clearance, 201: -depth, 203: surface, 204: level - surface}
        text = " ".join(f"Q{q}={signed(self.length(v))}" for q, v in words.items())
        if cycle == 200:
            text += f" Q202={signed(self.length(depth))} Q210=0"
        text += f" Q206=300 Q208=300 Q211={'0.5' if kind == 'dwell' else '0'}"
        self.put(f"CYCL DEF {cycle} {text}")
        for x, y in points:
            self.put("L " + self.words({"X": x, "Y": y}) + " FMAX M99")

    def shift(self, by):
        self.put("CYCL DEF 7.0 DATUM SHIFT")
        self.put(*[f"CYCL DEF 7.{i + 1} " + self.word(axis, c) for i, (axis, c) in enumerate(zip("XYZ", by))])

    def unshift(self):
        self.shift((0, 0, 0))

    def rotate(self, angle):
        self.put("CYCL DEF 10.0 ROTATION", "CYCL DEF 10.1 ROT" + signed(angle))

    def unrotate(self):
        self.rotate(0)

    def mirror(self, axis):
        self.put("CYCL DEF 8.0 MIRROR IMAGE", f"CYCL DEF 8.1 {axis}")

    def unmirror(self):
        self.put("CYCL DEF 8.0 MIRROR IMAGE", "CYCL DEF 8.1")

    def scale(self, factor):
        self.put("CYCL DEF 26.0 AXIS-SPEC. SCALING",
                 "CYCL DEF 26.1 " + " ".join(axis + number(factor) for axis in "XYZ"))

    def unscale(self):
        self.scale(1)

    def plane(self, angles, origin):
        first, nod, last = angles
        self.shift(origin)
        if last == 0 and self.job.bodies % 2:
            words = f"SPATIAL SPA{signed(nod)} SPB+0 SPC{signed(first)}"
        else:
            words = f"EULER EULPR{signed(first)} EULNU{signed(nod)} EULROT{signed(last)}"
        self.put(f"PLANE {words} TURN FMAX")

    def unplane(self):
        self.put("PLANE RESET STAY")
        self.unshift()
        self.put("L " + self.words({letter: 0 for letter in self.job.letters}) + " FMAX")

    def tcp(self):
        self.put("L M128")

    def untcp(self):
        self.put("L M129")

    def compensated(self, tool, left, outline, behind):
        for i, (x, y) in enumerate(outline):
            self.put("L " + self.words({"X": x, "Y": y}) + (" RL" if left else " RR") + " F800")
        self.put("L " + self.words(dict(zip("XY", behind))) + " R0")

    def steps(self, steps):
        return ["L " + " ".join("I" + self.word(axis, value) for axis, value in step.items()) + " F700" for step in steps]

    def call(self, body, steps, times):
        self.put(*[f"CALL LBL {body}"] * times)
        self.subs += [f"LBL {body}", *self.steps(steps), "LBL 0"]

    def loop(self, body, steps, times):
        self.put(f"LBL {body}", *self.steps(steps))
        if times > 1:
            self.put(f"CALL LBL {body} REP {times - 1}")

    def end(self):
        self.put("L M30")

    def text(self):
        return super().text() + "END PGM JOB " + ("INCH" if self.job.inch else "MM") + "\n"


CONTROLS = {"linuxcnc": Linuxcnc, "fanuc": Fanuc, "haas": Haas, "sinumerik": Sinumerik, "klartext": Klartext}


# ------------------------------------------------------------------ files


def axis_element(letter, direction, location, limits):
    limits = 'limit_min="%g" limit_max="%g" ' % limits if limits else ""
    return '<axis name="%s" type="%s" direction="%.17g %.17g %.17g" location="%g %g %g" %srate_max="3600">' % (
        letter, "rotary" if letter in "ABC" else "linear", *direction, *location, limits)


def machine_file(job, dialect):
    own = {
        "linuxcnc": "",
        "fanuc": ' length_offset_moves="no" cutter_comp_start="A" cutter_comp_corner="circular"',
        "haas": ' length_offset_moves="no" cutter_comp_start="A" cutter_comp_corner="circular"',
        "sinumerik": ' frames_outlive_traori="yes" edge_after_tool_change="first" tool_length_axis="z" swivel_axis="%s"'
        % [letter for letter in job.letters if letter != "C"][0],
        "klartext": "",
    }[dialect]
    inside = '<tool_change/>'
    if dialect == "linuxcnc":
        inside += '<mcode number="428" action="tcp-on"/><mcode number="429" action="tcp-off"/>'
    text = f'<machine version="1" name="job" units="mm"><controller dialect="{dialect}" path_tolerance="0.01"{own}>'
    text += inside + "</controller><base>"
    axes = MACHINES[job.machine]
    for letter, direction, location, limits, where in axes:
        if where == "t":
            text += axis_element(letter, [-c for c in direction], location, limits)
    text += '<workholding location="0 0 0"/>' + "</axis>" * sum(axis[4] == "t" for axis in axes)
    for i, letter in enumerate("XYZ"):
        text += axis_element(letter, [float(i == k) for k in range(3)], (0, 0, 0), (-9000, 9000))
    for letter, direction, location, limits, where in axes:
        if where == "h":
            text += axis_element(letter, direction, location, limits)
    text += '<spindle location="0 0 0" direction="0 0 -1"/>' + "</axis>" * (3 + sum(axis[4] == "h" for axis in axes))
    return text + "</base></machine>\n"


def setup_file(job, dialect):
    text = '<setup version="1" units="mm">'
    for i, offset in enumerate(job.offsets):
        name = f"G54.1 P{i + 1}" if dialect == "klartext" else f"G{54 + i}"
        text += '<work_offset name="%s" X="%g" Y="%g" Z="%g"/>' % (name, *offset)
    for i, length in enumerate(job.lengths):
        text += '<tool number="%d" length="%g" diameter="%g" checked="only its length counts here"/>' % (i + 1, length, (8, 5)[i])
        if dialect in ("fanuc", "haas"):
            text += '<offset number="%d" length="%g" radius="%g"/>' % (i + 1, length, (4, 2.5)[i])
    return text + "</setup>\n"


# ------------------------------------------------------------------ comparison


class Differs(Exception):
    pass


def write(path, text):
    with open(path, "w", encoding="ascii") as file:
        file.write(text)


def dump(fivecheck, folder, job, dialect):
    ending = {"sinumerik": "mpf", "klartext": "h"}.get(dialect, "nc")
    names = [os.path.join(folder, f"{dialect}{tail}") for tail in ("-machine.xml", "-setup.xml", "." + ending)]
    for name, text in zip(names, (machine_file(job, dialect), setup_file(job, dialect), CONTROLS[dialect](job).text())):
        write(name, text)
    done = subprocess.run([fivecheck, "-q", "--dump-path", "-s", names[1], names[0], names[2]], capture_output=True,
                          text=True, check=False)
    if done.returncode > 1:
        raise Differs(f"{dialect} refuses the job: {done.stderr.strip().splitlines()[:3]}")
    rows = [line.split("\t") for line in done.stdout.splitlines()]
    first = rows[0].index("tool") + 1
    last = rows[0].index("time")
    return [(row[2], [float(value) for value in row[first:last]]) for row in rows[1:]]


def straightened(rows):
    """Points at which the path of the axes turns: rows that go straight on are one."""
    points = []
    for tool, point in rows:
        if len(points) >= 1 and points[-1][0] == tool and math.dist(points[-1][1], point) < 1e-9:
            continue
        if len(points) >= 2 and points[-2][0] == points[-1][0] == tool:
            a, b = points[-2][1], points[-1][1]
            first, second = math.dist(a, b), math.dist(b, point)
            beside = math.dist([(q - p) / first for p, q in zip(a, b)], [(q - p) / second for p, q in zip(b, point)])
            if beside < 1e-9:
                points.pop()
        points.append((tool, point))
    return points


def compare(one, other, names):
    if len(one) != len(other):
        for i, (a, b) in enumerate(zip(one, other)):
            if a[0] != b[0] or max(abs(p - q) for p, q in zip(a[1], b[1])) > SAME:
                raise Differs(f"{names[0]} and {names[1]} part at point {i}: {a} and {b}")
        raise Differs(f"{names[0]} has {len(one)} points and {names[1]} {len(other)}")
    for i, (a, b) in enumerate(zip(one, other)):
        worst = max(abs(p - q) for p, q in zip(a[1], b[1]))
        if a[0] != b[0] or worst > SAME:
            raise Differs(f"{names[0]} and {names[1]} differ by {worst:g} at point {i}: {a} and {b}")


def run_case(fivecheck, folder, job, counts):
    paths = {}
    for dialect in DIALECTS:
        if job.compare_on(dialect):
            paths[dialect] = straightened(dump(fivecheck, folder, job, dialect))
            counts[dialect] += 1
    for dialect in paths:
        compare(paths["klartext"], paths[dialect], ("klartext", dialect))
    return len(paths["klartext"])


ELEMENTS = ["shift", "rotate", "mirror", "scale", "plane", "tcp", "rotary", "drill", "comp", "call", "loop"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--fivecheck", required=True)
    parser.add_argument("--cases", type=int, default=40)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", type=int, help="the number of the only case to run")
    parser.add_argument("--keep", help="folder for the cases that differ")
    parser.add_argument("--progress", action="store_true")
    options = parser.parse_args()
    counts = {dialect: 0 for dialect in DIALECTS}
    elements = {element: 0 for element in ELEMENTS}
    differ = points = 0
    for case in range(options.cases) if options.only is None else [options.only]:
        rng = random.Random(f"{options.seed} {case}")
        # Every second job has only what all five controls have.
        common = [e for e in ELEMENTS if not any(e in lacks for lacks in LACKS.values()) and e != "comp"]
        job = Job(rng, common if case % 2 else ELEMENTS)
        folder = tempfile.mkdtemp()
        try:
            for element in job.elements:
                elements[element] += 1
            points += run_case(options.fivecheck, folder, job, counts)
        except Differs as reason:
            differ += 1
            print(f"case {case} of seed {options.seed} ({job.machine}, {', '.join(sorted(job.elements))}): {reason}")
            if options.keep:
                kept = os.path.join(options.keep, f"{options.seed}-{case}")
                shutil.rmtree(kept, ignore_errors=True)
                shutil.copytree(folder, kept)
                print(f"    kept in {kept}")
        finally:
            shutil.rmtree(folder)
        if options.progress and case % 50 == 49:
            print(f"{case + 1} jobs", file=sys.stderr)
    print("jobs: " + ", ".join(f"{dialect} {count}" for dialect, count in counts.items()))
    print("elements: " + ", ".join(f"{element} {count}" for element, count in elements.items()))
    print(f"{points} points of paths, {differ} jobs differ" if differ else "every job makes one path")
    return 1 if differ else 0


if __name__ == "__main__":
    sys.exit(main())
