"""A random five-axis job: a list of operations, which controls.py writes for each control."""

import math

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


# Elements that a control lacks.
LACKS = {
    "linuxcnc": {"rotate", "mirror", "scale", "plane", "compensated"},
    "fanuc": {"in_plane"},
    "haas": {"plane"},
    "sinumerik": set(),
    "klartext": set(),
}


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
