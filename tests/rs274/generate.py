"""generate.py - random programs that LinuxCNC accepts.

Moves, arcs, offsets, units, expressions, control flow, canned cycles, cutter compensation.
"""
import math

AXES = 'XYZABC'
# LinuxCNC reads lines of at most 253 bytes; a longer line is replaced by a shorter one.
LINE_MAX = 250


class Generator:
    def __init__(self, random):
        self.r = random
        self.label = 0
        self.depth = 0
        self.calls = []
        # The simulated machine of rs274 does not convert the length compensation with G20 and G21.
        self.tools = random.random() < .5

    def number(self, size=50):
        """A decimal, sometimes in an unusual form."""
        text = f'{self.r.uniform(-size, size):.{self.r.randint(0, 4)}f}'
        return text.replace('.', ' .') if self.r.random() < .05 else text

    def value(self, size=50):
        """A number, or an expression with a value of about that size."""
        if self.r.random() < .7:
            return self.number(size)
        return f'[[{self.expression(3)}] MOD {size}]'

    def term(self, depth):
        r = self.r
        choice = r.randint(0, 9)
        if depth <= 0 or choice < 3:
            return f'{r.uniform(0, 20):.3f}'
        if choice < 5:
            return f'#{r.randint(1, 12)}'
        if choice == 5:
            return f'[{self.expression(depth - 1)}]'
        inner = self.expression(depth - 1)
        if choice == 6:
            return f'SQRT[ABS[{inner}]]'
        if choice == 7:
            return f'ATAN[{inner}]/[{self.number(9)} + 20]'
        if choice == 8:
            # Not the arcsine of the sine itself: its result would be the argument except for the last digit, in which C
            # libraries differ, and a comparison with the argument would depend on this digit.
            return f'{r.choice(["ASIN", "ACOS"])}[SIN[{inner}] * 0.87]'
        return f'{r.choice(["ABS", "COS", "SIN", "FIX", "FUP", "ROUND", "-"])}[{inner}]'

    def expression(self, depth):
        text = self.long_expression(depth)
        while len(text) > LINE_MAX // 5:
            text = self.long_expression(depth - 1)
        return text

    def long_expression(self, depth):
        r = self.r
        text = self.term(depth)
        for _ in range(r.randint(0, 3)):
            operation = r.choice(['+', '-', '*', '+', '-', '/', 'MOD', 'EQ', 'NE', 'LT', 'LE', 'GT', 'GE', 'AND', 'OR',
                                  'XOR', '**'])
            if operation in ('/', 'MOD'):
                text += f' {operation} {r.uniform(1, 9):.2f}'
            elif operation == '**':
                text += f' * {r.uniform(1, 3):.2f} ** {r.randint(0, 2)}'
            else:
                text += f' {operation} {self.term(depth - 1)}'
        return text if r.random() < .5 else text.lower()

    def words(self, count, size=50):
        axes = self.r.sample(AXES, self.r.randint(1, count))
        return ' '.join(a + self.value(size) for a in axes)

    def arc(self):
        r = self.r
        code = r.choice(['G2', 'G3'])
        plane, first, second = r.choice([('G17', 'XI', 'YJ'), ('G18', 'XI', 'ZK'), ('G19', 'YJ', 'ZK')])
        if r.random() < .5:
            turns = f' P{r.randint(1, 3)}' if r.random() < .3 else ''
            rise = f' A{self.number(30)}' if r.random() < .3 else ''
            return (f'G91.1 {plane} {code} {first[1]}{r.uniform(1, 20):.3f} {second[1]}{self.number(20)} '
                    f'F200{turns}{rise}')
        x, y = r.uniform(-9, 9), r.uniform(1, 9)
        radius = r.choice(['', '-']) + f'{r.uniform(10, 30):.3f}'
        return f'G91 {plane} {code} {first[0]}{x:.3f} {second[0]}{y:.3f} R{radius} F200'

    def offset(self):
        r = self.r
        return r.choice([lambda: f'{r.choice(["G92", "G52"])} {self.words(2)}',
                         lambda: f'{r.choice(["G10 L2", "G10 L20"])} P{r.randint(0, 9)} {self.words(3)}',
                         lambda: r.choice(['G54', 'G55', 'G56', 'G57', 'G58', 'G59', 'G59.1', 'G59.2', 'G59.3']),
                         lambda: r.choice(['G92.1', 'G92.2', 'G92.3']),
                         lambda: r.choice(['G43', 'G43 H1', 'G43 H2', 'G43 H3', 'G49', 'T2']) if self.tools else 'G54',
                         lambda: self.tool_entry() if self.tools else 'G54',
                         lambda: r.choice(['G28.1', 'G30.1', 'G28', 'G30', f'G28 {self.words(2)}'])])()

    def tool_entry(self):
        """The simulated machine of rs274 uses the entry of tool 1 for an empty spindle, so this entry is not changed.
        """
        r = self.r
        radius = f' R{r.uniform(-3, 3):.3f}' if r.random() < .3 else ''
        return f'G10 L{r.choice([1, 10, 11])} P{r.randint(2, 3)} Z{self.value()}{radius}'

    def mode(self):
        units = [] if self.tools else ['G20', 'G21', 'G21']
        return self.r.choice(units + ['G90', 'G91', 'G17', 'G18', 'G19', 'G61', 'G64 P0.01', 'G80',
                              'M3 S100', 'M5', '(a comment)', '; another', 'G94', 'F300'])

    def assignment(self):
        r = self.r
        target = lambda: r.choice([f'#{r.randint(1, 12)}', '#<local>', '#<_global>'])
        text = f'{target()} = [[{self.expression(3)}] MOD 100]'
        if r.random() < .3:
            text += f' {target()}={self.number()}'
        if r.random() < .2:
            text += f' G0 X#{r.randint(1, 12)}'
        return text

    def straight(self):
        r = self.r
        if r.random() < .1:
            return f'G90 G53 G0 {self.words(2)}'
        if r.random() < .1:
            return f'G90 G0 X[#5420+{r.randint(1, 9)}] Y[#<_y> - 1]'
        return f'{r.choice(["G0", "G1", "g01 ", "G00"])} {self.words(4)} F{r.randint(10, 900)}'

    def cycle(self):
        """A canned cycle, its repetitions, and G80."""
        r = self.r
        code, words, before = r.choice([('G81', '', []), ('G82', ' P0.5', []), ('G83', f' Q{r.uniform(1, 9):.2f}', []),
                                        ('G73', f' Q{r.uniform(1, 9):.2f}', []), ('G84', '', ['M3 S100']),
                                        ('G85', '', []), ('G89', ' P0.5', []), ('G86', ' P0.5', ['M3 S100'])])
        level = r.uniform(-5, 20)
        # LinuxCNC confuses the axes of G84 in other planes.
        plane = r.choice(['G17', 'G17', 'G18', 'G19']) if code != 'G84' else 'G17'
        lines = before + [f'{plane} G94 F150', 'G90']
        first, second, depth = {'G17': 'XYZ', 'G18': 'XZY', 'G19': 'YZX'}[plane]
        place = lambda: f'{first}{self.number(30)} {second}{self.number(30)}'
        bottom = level - r.uniform(1, 20)
        if r.random() < .3:
            lines += ['G91', f'{code} {place()} {depth}{-r.uniform(1, 20):.3f} R{r.uniform(0, 5):.3f}{words} '
                      f'L{r.randint(1, 3)}']
        else:
            lines.append(f'{r.choice(["G98", "G99"])} {code} {place()} {depth}{bottom:.3f} R{level:.3f}{words}')
        for _ in range(r.randint(0, 2)):
            lines.append(place() if r.random() < .7 else f'{place()} R{level + r.uniform(0, 5):.3f}')
        return lines + ['G80 G90', f'G0 X{self.number(9)}']

    def compensated(self):
        """Once around a polygon, with an arc instead of some sides, to the left or to the right of it."""
        r = self.r
        corners = sorted(r.uniform(0, 2 * math.pi) for _ in range(r.randint(3, 6)))
        if r.random() < .5:
            corners.reverse()
        points = [(r.uniform(30, 60) * math.cos(a), r.uniform(30, 60) * math.sin(a)) for a in corners]
        lines = ['G17 G40 G90', f'G0 X{-90 + r.uniform(-5, 5):.3f} Y{self.number(9)}',
                 f'{r.choice(["G41.1", "G42.1"])} D{r.uniform(.2, 3):.3f}', 'F300']
        for i, (x, y) in enumerate(points):
            height = f' Z{self.number(5)}' if r.random() < .2 else ''
            if i > 0 and r.random() < .25:
                chord = math.hypot(x - points[i - 1][0], y - points[i - 1][1])
                lines.append(f'{r.choice(["G2", "G3"])} X{x:.3f} Y{y:.3f} R{chord + 5:.3f}{height}')
            else:
                lines.append(f'{r.choice(["G0", "G1", "G1", "G1"])} X{x:.3f} Y{y:.3f}{height}')
        return lines + ['G40', 'G0 X0 Y90']

    def name(self):
        self.label += 1
        return self.r.choice([f'o{self.label}', f'O<loop {self.label}>', f'o[{self.label}]'])

    def control(self):
        r = self.r
        name, counter = self.name(), f'#{100 + self.label}'
        body = lambda: self.blocks(r.randint(1, 4))
        kind = r.randint(0, 4)
        if kind == 0:
            lines = [f'{name} if [{self.expression(2)}]'] + body()
            for _ in range(r.randint(0, 2)):
                lines += [f'{name} elseif [{self.expression(2)}]'] + body()
            if r.random() < .6:
                lines += [f'{name} else'] + body()
            return lines + [f'{name} endif']
        if kind == 1:
            return [f'{name} repeat [{r.randint(0, 3)}]'] + body() + [f'{name} endrepeat']
        count = [f'{counter} = [{counter} + 1]']
        if kind == 2:
            leave = self.name()
            out = [f'{leave} if [{counter} EQ {r.randint(1, 4)}]', f'{name} continue', f'{leave} endif']
            return ([f'{counter}=0', f'{name} while [{counter} LT {r.randint(0, 3)}]'] + count + body() + out + body() +
                    [f'{name} endwhile'])
        if kind == 3 and self.calls:
            called = r.choice(self.calls)
            return [f'{called} call [{self.value()}] [{self.value(9)}]', 'G0 X#<_value>']
        return [f'{counter}=0', f'{name} do'] + count + body() + [f'{name} while [{counter} LT {r.randint(1, 3)}]']

    def blocks(self, count):
        r = self.r
        lines = []
        self.depth += 1
        for _ in range(count):
            choice = r.random()
            if choice < .35:
                lines.append(self.straight())
            elif choice < .45:
                lines.append(self.arc())
            elif choice < .57:
                lines.append(self.offset())
            elif choice < .67:
                lines.append(self.mode())
            elif choice < .70:
                lines += self.cycle()
            elif choice < .71:
                lines += self.compensated()
            elif choice < .87 or self.depth > 3:
                lines.append(self.assignment())
            else:
                lines += self.control()
        self.depth -= 1
        return lines

    def subprogram(self):
        name = f'o<part {len(self.calls)}>'
        self.depth += 2
        lines = [f'{name} sub', '#<local>=#1'] + self.blocks(self.r.randint(2, 6))
        self.depth -= 2
        self.calls.append(name)
        if self.r.random() < .3:
            lines += ['o9 if [#1 GT 0]', f'{name} return [#2]', 'o9 endif']
        # endsub has no value: a subprogram that ends there returns none.
        return lines + [f'{name} endsub']


def program(random):
    """The lines of one program; the last one is M2."""
    g = Generator(random)
    lines = [random.choice(['G21', 'G21', 'G20']), '#<local>=1 #<_global>=2', 'F100']
    # After this place a tool change would make the simulated machine of rs274 forget the length compensation.
    lines += random.choice([[], ['T1 M6'], ['T3 M6']])
    for _ in range(random.randint(0, 3)):
        lines += g.subprogram()
    lines += g.blocks(random.randint(10, 60))
    return lines + ['M2']
