"""Writes a job as a program for each of five controls."""

import math

from job import MACHINES


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
