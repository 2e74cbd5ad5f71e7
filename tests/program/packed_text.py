"""packed_text.py - reads what a report's scripts carry, as src/report/format/seven_bit.h, range_coder.h and report_data.h describe it."""
import bisect

RESERVED = (0, 13, 14, 15, 26, 27, 60, 127)


def seven_bit(text):
    bits = []
    for character in text:
        code = ord(character)
        if code < 128:
            assert code not in RESERVED
            bits.append(f"{code:07b}")
        elif code < 0x500:
            bits.append(f"{RESERVED[(code - 256) >> 7]:07b}{code & 127:07b}")
        else:
            bits.append(f"{RESERVED[code - 0x500]:07b}")
    bits = "".join(bits)
    return int("0" + bits[:len(bits) // 8 * 8], 2).to_bytes(len(bits) // 8, "big")


class Bits:
    """A range decoder; models are made when they are first asked for."""

    def __init__(self, data):
        self.data, self.at, self.range, self.models = data, 5, 2**32 - 1, {}
        self.code = int.from_bytes(data[:5], "big") % 2**32

    def bit(self, *name):
        model = self.models.setdefault(name, [32768, 0])
        bound = (self.range >> 16) * model[0]
        one = self.code < bound
        shift = min(5, (model[1] + 1).bit_length())
        if one:
            self.range = bound
            model[0] += (65536 - model[0]) >> shift
        else:
            self.code -= bound
            self.range -= bound
            model[0] -= model[0] >> shift
        model[0] = min(max(model[0], 32), 65504)
        model[1] += 1
        while self.range < 2**24:
            self.range <<= 8
            self.code = self.code << 8 | (self.data[self.at] if self.at < len(self.data) else 0)
            self.at += 1
        return int(one)

    def number(self, *name):
        length = 1
        while self.bit(name, "length", length):
            length += 1
        value = 1
        for i in range(length - 1):
            if i < 2:
                value = 2 * value + self.bit(name, length, 0 if i == 0 else 1 + (value & 1))
            else:
                self.models.pop("even", None)
                self.models[("even",)] = [32768, 0]
                value = 2 * value + self.bit("even")
        return value - 1


def signed(z):
    return -(z + 1) // 2 if z & 1 else z // 2


def int32(value):
    return (value + 2**31) % 2**32 - 2**31


class Mesh:
    """The points of the grid and the corners of a mesh."""

    def __init__(self, data, triangles):
        self.bits, self.points, self.corners = Bits(data), [], []
        self.open, self.before, self.after = set(), {}, {}
        self.history, self.memory, self.hashes = 0, {}, [0, 0]
        self.values = ([], [], [])
        while len(self.corners) < 3 * triangles:
            gates = self.take(*self.begin())
            while gates:
                a, b, opposite = gates.pop()
                if (a, b) in self.open:
                    gates += self.look_beyond(a, b, opposite)
        assert self.bits.at <= len(data) + 3

    def begin(self):
        corners = []
        for k in range(3):
            if self.bits.bit("begins new", k):
                near = [self.points[corners[k - 1] if k else -1] if self.points else (0, 0, 0)]
                corners.append(self.vertex(k, near + ([self.points[corners[0]]] if k == 2 else [])))
            else:
                corners.append(len(self.points) - 1 - self.bits.number("back at start"))
        return corners

    def look_beyond(self, a, b, opposite):
        before, after = self.before.get(a), self.after.get(b)
        has_before = before is not None and before != b and (before, a) in self.open
        has_after = after is not None and after != a and (b, after) in self.open
        beyond = 4
        for choice in (1, 2, 3, 0):
            if (choice != 2 or has_before) and (choice != 3 or has_after):
                if self.bits.bit("beyond", choice, has_before, has_after, self.history):
                    beyond = choice
                    break
        self.history = (5 * self.history + beyond) % 125
        if beyond == 0:
            self.open.discard((a, b))
            return []
        if beyond == 1:
            c = self.vertex(2, [self.points[b], self.points[a], self.points[opposite]])
        else:
            c = before if beyond == 2 else after if beyond == 3 else len(self.points) - 1 - self.bits.number("back")
        return self.take(a, b, c)

    def take(self, a, b, c):
        self.corners += [a, b, c]
        for u, v in ((a, b), (b, c), (c, a)):
            if (u, v) in self.open:
                self.open.discard((u, v))
            else:
                self.open.add((v, u))
                self.after[v], self.before[u] = u, v
        return [(b, a, c), (a, c, b), (c, b, a)]

    def vertex(self, corner, near):
        slot = ((31 * self.hashes[0] + self.hashes[1]) * 0x9e3779b1 & 0xffffffff) >> 18
        step, run = self.memory.get(slot, (None, 0))
        if self.bits.bit("again", run):
            point = tuple(n + s for n, s in zip(near[0], step))
            run = min(run + 1, 7)
        else:
            point, run = self.in_full(corner, near), 1
        step = tuple(p - n for p, n in zip(point, near[0]))
        self.memory[slot] = step, run
        self.hashes = [(step[0] * 73856093 ^ step[1] * 19349663 ^ step[2] * 83492791) & 0xffffffff, self.hashes[0]]
        self.points.append(point)
        return len(self.points) - 1

    def in_full(self, corner, near):
        point, equal = [], 0
        for k in range(3):
            value = self.neighbour(corner, k, equal, near)
            found = value is not None
            if not found:
                value = self.value(corner, k, equal, near[0][k] if len(near) < 3 else near[0][k] + near[1][k] - near[2][k])
            equal = (2 * equal + found) & 3
            point.append(value)
        return tuple(point)

    def neighbour(self, corner, k, equal, near):
        seen = []
        for i, other in enumerate(near):
            if other[k] not in seen:
                if self.bits.bit("equal", corner, k, equal, i):
                    return other[k]
                seen.append(other[k])
        return None

    def value(self, corner, k, equal, guess):
        values = self.values[k]
        if self.bits.bit("known", k, equal):
            return values[bisect.bisect_left(values, guess) + signed(self.bits.number("rank", corner))]
        value = guess + signed(self.bits.number("residual", corner))
        bisect.insort(values, value)
        return value
