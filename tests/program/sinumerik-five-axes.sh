# TRAORI and CYCLE800 on tables, heads and nutating axes: position of the tip and direction of the tool on the
# workpiece, computed from the axis positions by independent chains (five_axes.py).
need python3
cat >check.py <<'PYTHON'
import math
import random

from five_axes import (FAMILIES, X, Y, Z, add, dot, ends, machine, place, subtract, tilting_axis, tip, tool_direction,
                       turned_by)

random.seed(5)
ORDERS = {57: (X, Y, Z), 27: (Z, Y, X), 39: (Z, X, Y), 30: (Y, Z, X), 45: (X, Z, Y), 54: (Y, X, Z)}


def some(count, reach):
    return [round(random.uniform(-reach, reach), 3) for _ in range(count)]


def words(values):
    return ' '.join('%s%.3f' % item for item in values.items())


def off(a, b):
    return max(abs(x) for x in subtract(a, b))


class Checked:
    """How far the paths of one machine are off, at most, and what was refused."""

    def __init__(self, rotary):
        self.rotary, self.xml = rotary, machine(rotary)
        self.refused = []
        self.traori = self.cycle = self.direction = 0

    def run(self, program, last):
        """
        The last row of each line; None: the program did not come to this line. That is noted, unless it is not known
        which of two solutions is the nearer one.
        """
        rows, errors = ends(self.xml, program)
        if last in rows:
            return rows
        if 'turns less, to the other' not in errors:
            self.refused.append(errors)
        return None

    def random_angles(self):
        return {r[0]: round(random.uniform(-80, 80), 3) for r in self.rotary}

    def check_traori(self):
        program, wanted = 'T1 D1 M6\nG54 G17 G71 G90\nTRAORI\nORIAXES\nF1000\n', {}
        for line in range(6, 46):
            coordinates = dict(zip('XYZ', some(3, 50)))
            program += 'G1 ' + words({**coordinates, **self.random_angles()}) + '\n'
            wanted[line] = place(coordinates.values())
        rows = self.run(program + 'M30\n', 45)
        for line in wanted if rows else ():
            self.traori = max(self.traori, off(tip(rows[line], self.rotary), wanted[line]))

    def check_swivelled(self):
        """CYCLE800: a random plane, with both DIR."""
        angles, origin, point = some(3, 40), some(3, 20), some(3, 30)
        mode, side = random.choice(list(ORDERS)), random.choice((1, -1))
        rows = self.run('T1 D1 M6\nG54 G17 G71 G90\nG0 X0 Y0 Z0\n'
                        'CYCLE800(0,"",0,%d,%g,%g,%g,%g,%g,%g,0,0,0,%d)\n' % (mode, *origin, *angles, side) +
                        'G0 X%g Y%g Z%g\nM30\n' % tuple(point), 5)
        if rows:
            plane = list(zip(ORDERS[mode], angles))
            self.cycle = max(self.cycle, off(tip(rows[5], self.rotary), place(add(turned_by(point, plane), origin))))
            self.direction = max(self.direction, off(tool_direction(rows[5], self.rotary), turned_by(Z, plane)))
            assert rows[5][tilting_axis(self.rotary)] * side >= -1e-6

    def check_torot(self):
        """Z leads along the tool, by an increment and to a coordinate from the workpiece's zero."""
        coordinates = some(3, 50)
        move = 'X%g Y%g Z%g' % tuple(coordinates)
        rows = self.run('T1 D1 M6\nG54 G17 G71 G90\nTRAORI ORIAXES\nG0 %s %s\nTOROT\n'
                        'G91 Z25\nG90 Z300\nTOROTOF\n%s\nM30\n' % (move, words(self.random_angles()), move), 9)
        if rows:
            start, by_increment, to_coordinate, back = (tip(rows[line], self.rotary) for line in (4, 6, 7, 9))
            tool = tool_direction(rows[4], self.rotary)
            way = 300 - dot(subtract(start, place((0, 0, 0))), tool)
            self.traori = max(self.traori, off(by_increment, add(start, [25 * x for x in tool])),
                              off(to_coordinate, add(start, [way * x for x in tool])), off(back, start))

    def check_frames(self):
        """Programmable frames under TRAORI carry the tip; A3= B3= C3= are turned with them, and words of axes are not."""
        axis, letter = random.choice(((X, 'X'), (Y, 'Y'), (Z, 'Z')))
        shift, angle, scale = some(3, 20), random.uniform(-70, 70), random.uniform(0.5, 2)
        before, behind, direction = some(3, 40), some(3, 40), (random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), 1)

        def carried(v):
            return turned_by([v[0] * scale, -v[1] * scale, v[2] * scale], [(axis, angle)])

        rows = self.run('T1 D1 M6\nG54 G17 G71 G90\nTRAORI ORIAXES\nTRANS X%g Y%g Z%g\n' % tuple(shift) +
                        'AROT %s%.17g\nAMIRROR Y0\nASCALE X%.17g Y%.17g Z%.17g\n' % (letter, angle, scale, scale, scale) +
                        'G0 X%g Y%g Z%g ' % tuple(before) + words(self.random_angles()) +
                        '\nX%g Y%g Z%g A3=%.17g B3=%.17g C3=%.17g\nM30\n' % (*behind, *direction), 9)
        if rows:
            along = carried(direction)
            length = math.sqrt(dot(along, along))
            self.traori = max(self.traori, *(off(tip(rows[line], self.rotary), place(add(shift, carried(point))))
                                             for line, point in ((8, before), (9, behind))))
            self.direction = max(self.direction,
                                 off(tool_direction(rows[9], self.rotary), [x / length for x in along]))

    def check_angles(self, word, order):
        """A2= B2= C2= of the tool's direction."""
        angles = dict(zip('ABC', some(3, 40)))
        rows = self.run('T1 D1 M6\nG54 G17 G71 G90\nTRAORI ORIAXES %s\nG0 X1 Y2 Z3 %s1 C1\nG0 %s\nM30\n'
                        % (word, tilting_axis(self.rotary), ' '.join('%s2=%g' % item for item in angles.items())), 5)
        if rows:
            wanted = turned_by(Z, [(axis, angles[letter]) for axis, letter in order])
            self.direction = max(self.direction, off(tool_direction(rows[5], self.rotary), wanted))


for name, rotary in FAMILIES.items():
    checked = Checked(rotary)
    checked.check_traori()
    for _ in range(12):
        checked.check_swivelled()
    for _ in range(4):
        checked.check_torot()
        checked.check_frames()
    for word, order in (('ORIEULER', ((Z, 'A'), (X, 'B'), (Z, 'C'))), ('ORIRPY', ((Z, 'C'), (Y, 'B'), (X, 'A'))),
                        ('ORIRPY2', ((X, 'A'), (Y, 'B'), (Z, 'C')))):
        for _ in range(2):
            checked.check_angles(word, order)
    good = checked.traori < 1e-6 and checked.cycle < 1e-6 and checked.direction < 1e-9 and not checked.refused
    print(name + (': as computed' if good else ': TRAORI %g mm, CYCLE800 %g mm, direction %g, refused %s'
                  % (checked.traori, checked.cycle, checked.direction, checked.refused)))

# SUPA while a plane is swivelled: with a table the tool length acts along Z as before; a head needs D0.
for name, rotary in FAMILIES.items():
    for edge in '', ' D0':
        rows, errors = ends(machine(rotary), 'T1 D1 M6\nG54 G17 G71 G90\nG0 X0 Y0 Z0\n'
                            'CYCLE800(0,"",0,57,0,0,0,25,10,0,0,0,0,1)\nG0 X9\nG0 SUPA X5 Z50%s\nM30\n' % edge)
        print(name, edge, 'X %g Z %g' % (rows[6]['X'], rows[6]['Z']) if 6 in rows else errors.split('\n')[0])

# If limits leave one solution, it is taken whatever DIR says, and without a question to the machine file; then no
# solution is left.
for low in -60, -20:
    xml = machine(FAMILIES['AC table']).replace(' swivel_axis="A"', '').replace(
        'limit_min="-9999" limit_max="9999" rate_max="3600"', 'limit_min="%d" limit_max="10" rate_max="3600"' % low, 1)
    for side in 1, -1:
        rows, errors = ends(xml, 'T1 D1 M6\nG54 G17 G71 G90\nG0 C-150\n'
                            'CYCLE800(0,"",0,57,0,0,0,25,0,0,0,0,0,%d)\nG0 X0\nM30\n' % side)
        print('A %g C %g' % (rows[5]['A'], rows[5]['C']) if 5 in rows else errors.split('\n')[0])

# From A30 C0 to the direction of A35 C100 or A-35 C-80: C turns less to the second, and both together as much to each;
# to that of A30 C60, both ways count less. A limit of A leaves one solution; that it excludes the nearer one is said.
for low, a, c in (-9999, 35, 100), (0, 35, 100), (-9999, 30, 60):
    rotary = FAMILIES['AC table']
    xml = machine(rotary).replace('limit_min="-9999" limit_max="9999" rate_max="3600"',
                                  'limit_min="%d" limit_max="9999" rate_max="3600"' % low, 1)
    rows, errors = ends(xml, 'T1 D1 M6\nG54 G17 G71 G90\nTRAORI ORIAXES\nG0 X0 Y0 Z0 A30 C0\n'
                        'A3=%.17g B3=%.17g C3=%.17g\nM30\n'
                        % tuple(tool_direction({'A': a, 'C': c, 'X': 0, 'Y': 0, 'Z': 0}, rotary)))
    print('A %g C %g' % (rows[5]['A'], rows[5]['C']) if 5 in rows
          else [line for line in errors.split('\n') if 'error' in line][0])
    print(*[line for line in errors.split('\n') if 'MD21180' in line and 'warning' in line])
PYTHON
PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$(dirname "$LIB") FIVECHECK=$FIVECHECK python3 check.py
