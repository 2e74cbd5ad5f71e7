# ORIVECT on tables, heads and nutating axes: the tip moves on a line, the tool turns in the plane of its two
# directions, and between two rows the rotary axes follow the great circle within the chord error of a piece.
need python3
cat >check.py <<'PYTHON'
import math
import random

from five_axes import (FAMILIES, Z, add, cross, dot, machine, path, place, subtract, tilting_axis, tip, tool_direction,
                       turned, turns)

random.seed(7)


def some(reach, about=0):
    return round(about + random.uniform(-reach, reach), 3)


def words(values):
    return ' '.join('%s%.3f' % item for item in values.items())


def on_circle(start, end, share):
    """The direction on the great circle from start to end."""
    normal = cross(start, end)
    norm = math.sqrt(dot(normal, normal))
    return turned(start, [x / norm for x in normal], math.degrees(share * math.atan2(norm, dot(start, end))))


def solve(position, rotary, direction):
    """The angles near a position that point the tool so: Newton's method.

    The second axis turns what the first one has turned."""
    (first, first_axis, _, first_sign), (second, second_axis, _, second_sign) = turns(rotary)
    a, b = position[first], position[second]
    for _ in range(30):
        once = turned(Z, first_axis, first_sign * a)
        now = turned(once, second_axis, second_sign * b)
        missing = subtract(now, direction)
        by_a = [first_sign * x for x in turned(cross(first_axis, once), second_axis, second_sign * b)]
        by_b = [second_sign * x for x in cross(second_axis, now)]
        # The normal equations of the two columns.
        aa, ab, bb, ra, rb = (dot(*pair) for pair in ((by_a, by_a), (by_a, by_b), (by_b, by_b), (by_a, missing),
                                                      (by_b, missing)))
        step = [math.degrees(x / (aa * bb - ab * ab)) for x in (bb * ra - ab * rb, aa * rb - ab * ra)]
        a, b = a - step[0], b - step[1]
        if max(map(abs, step)) < 1e-10:
            return {first: a, second: b}
    raise ArithmeticError('Newton')


class Checked:
    """How far the paths of one machine are off, at most: the tip in mm, directions, and angles in degrees."""

    def __init__(self, rotary):
        self.rotary, self.tilt = rotary, tilting_axis(rotary)
        self.tip = self.plane = self.beside = 0
        self.refused = []

    def check(self, by_vector):
        start, end = ([some(50) for _ in 'XYZ'] for _ in range(2))
        from_angles = {self.tilt: some(20, 40), 'C': some(60)}
        to_angles = {self.tilt: some(12, from_angles[self.tilt]), 'C': some(25, from_angles['C'])}
        d0, d1 = (tool_direction(angles, self.rotary) for angles in (from_angles, to_angles))
        rows, errors = path(machine(self.rotary), 'T1 D1 M6\nG54 G17 G71 G90\nTRAORI\nORIWKS ORIAXES\nF1000\n'
                            'G1 %s %s\nORIVECT\n%s %s\nM30\n' % (
                                words(dict(zip('XYZ', start))), words(from_angles), words(dict(zip('XYZ', end))),
                                'A3=%.12f B3=%.12f C3=%.12f' % tuple(d1) if by_vector else words(to_angles)))
        before = [row for row in rows if row['line'] == 6]
        rows = [row for row in rows if row['line'] == 8]
        if rows:
            self.check_rows(before[-1:] + rows, place(start), place(end), d0, d1)
        else:
            self.refused.append(errors)

    def check_rows(self, rows, start, end, d0, d1):
        previous = None
        for row in rows:
            point = tip(row, self.rotary)
            share = math.dist(start, point) / math.dist(start, end)
            wanted = add(start, [share * x for x in subtract(end, start)])
            self.tip = max(self.tip, math.dist(point, wanted))
            self.plane = max(self.plane, math.dist(tool_direction(row, self.rotary), on_circle(d0, d1, share)))
            if previous:
                middle = {letter: (row[letter] + previous[0][letter]) / 2 for letter in (self.tilt, 'C')}
                there = solve(middle, self.rotary, on_circle(d0, d1, (share + previous[1]) / 2))
                self.beside = max(self.beside, *(abs(there[letter] - middle[letter]) for letter in middle))
            previous = row, share
        self.tip = max(self.tip, math.dist(tip(rows[-1], self.rotary), end))


for name, rotary in FAMILIES.items():
    checked = Checked(rotary)
    for case in range(12):
        checked.check(case % 2)
    # Rows inside a piece are on its chord, which may be beside the circle.
    good = checked.tip < 1e-6 and checked.plane < 5e-5 and checked.beside < 0.0012 and not checked.refused
    print(name + (': as computed' if good else ': tip %g mm, direction %g, angle %g degrees, refused %s'
                  % (checked.tip, checked.plane, checked.beside, checked.refused)))

# From a pole, where the tool is parallel to the C axis: a parameter decides what the control does.
for answer in '', ' orientation_pole="axes"':
    _, errors = path(machine(FAMILIES['AC table']).replace(' swivel_axis', answer + ' swivel_axis'),
                     'T1 D1 M6\nG54 G17 G71 G90\nTRAORI\nORIWKS ORIVECT\nF1000\nG1 X1 A3=0.1 B3=0.2 C3=1\nM30\n')
    print(next((line for line in errors.split('\n') if 'error' in line), 'read'))
PYTHON
PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$(dirname "$LIB") FIVECHECK=$FIVECHECK python3 check.py
