"""five_axes.py - five-axis machines of all families, and chains of the test's own: where the tip stands on the
workpiece and how the tool points, from the positions of the axes. Lengths in mm, angles in degrees."""
import math
import os
import subprocess

LENGTH = 120            # of the tool, from the gauge point
GAUGE = (0, 0, 500)     # the gauge point while every axis is at 0
OFFSET = (11, -7, 380)  # of G54
HALF = math.sqrt(0.5)
X, Y, Z = (1, 0, 0), (0, 1, 0), (0, 0, 1)

# Rotary axes, those of a chain from the base outward: letter, direction, a point on the axis, 'table' or 'head'.
FAMILIES = {
    'AC table': [('A', (-1, 0, 0), (0, 3, 5), 'table'), ('C', (0, 0, -1), (1, 2, 0), 'table')],
    'BC table': [('B', (0, -1, 0), (4, 0, 7), 'table'), ('C', (0, 0, -1), (0, 0, 0), 'table')],
    'nutating BC table': [('B', (0, HALF, -HALF), (0, 10, -20), 'table'), ('C', (0, 0, -1), (0, 0, 0), 'table')],
    'CB head': [('C', (0, 0, 1), (0, 0, 900), 'head'), ('B', (0, 1, 0), (0, 5, 700), 'head')],
    'nutating head B, table C': [('B', (0, HALF, HALF), (0, 0, 600), 'head'), ('C', (0, 0, -1), (3, 0, 0), 'table')],
}

SETUP = ('<setup version="1" units="mm"><work_offset name="G54" X="%g" Y="%g" Z="%g"/><tool number="1" name="t" '
         'length="%g"><cutter tip="flat"><section length="%g" diameter="5"/></cutter></tool></setup>'
         % (*OFFSET, LENGTH, LENGTH))


def add(a, b):
    return [x + y for x, y in zip(a, b)]


def subtract(a, b):
    return [x - y for x, y in zip(a, b)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def turned(v, axis, angle):
    """Rodrigues' formula: v turned about a unit vector."""
    c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    along = (1 - c) * dot(axis, v)
    across = cross(axis, v)
    return [c * v[i] + s * across[i] + along * axis[i] for i in range(3)]


def turned_by(v, turns):
    """v turned by the last (axis, angle) first, as by a product of matrices."""
    for axis, angle in reversed(turns):
        v = turned(v, axis, angle)
    return v


def tilting_axis(rotary):
    return next(letter for letter, _, _, _ in rotary if letter != 'C')


def turns(rotary):
    """(letter, axis, point, sign) in the order in which they turn the tool as the workpiece sees it."""
    heads = [(letter, axis, point, 1) for letter, axis, point, on in reversed(rotary) if on == 'head']
    return heads + [(letter, axis, point, -1) for letter, axis, point, on in rotary if on == 'table']


def tool_direction(position, rotary):
    direction = Z
    for letter, axis, _, sign in turns(rotary):
        direction = turned(direction, axis, sign * position[letter])
    return direction


def tip(position, rotary):
    def carry(point, sign):
        for letter, axis, middle, of in turns(rotary):
            if of == sign:
                point = add(turned(subtract(point, middle), axis, sign * position[letter]), middle)
        return point

    under_head = carry(subtract(GAUGE, (0, 0, LENGTH)), 1)
    return carry(add(under_head, [position[letter] for letter in 'XYZ']), -1)


def place(coordinates):
    """Where the tip is on the workpiece, for coordinates of the program in G54."""
    return add(add(coordinates, OFFSET), GAUGE)


def machine(rotary):
    def axis(letter, kind, direction, point, rate):
        return ('<axis name="%s" type="%s" direction="%.17g %.17g %.17g"%s limit_min="-9999" limit_max="9999" '
                'rate_max="%d">' % (letter, kind, *direction, point and ' location="%g %g %g"' % point, rate))

    chains = {on: [axis(r[0], 'rotary', r[1], r[2], 3600) for r in rotary if r[3] == on] for on in ('table', 'head')}
    linear = [axis(letter, 'linear', direction, '', 6000) for letter, direction in zip('XYZ', (X, Y, Z))]
    return ('<machine version="1" name="t" units="mm"><controller dialect="sinumerik" rapid="linear" '
            'path_tolerance="0.01" frames_outlive_traori="yes" swivel_axis="%s"><tool_change/></controller><base>' % tilting_axis(rotary) +
            ''.join(linear + chains['head']) + '<spindle location="%g %g %g" direction="0 0 -1"/>' % GAUGE +
            '</axis>' * (3 + len(chains['head'])) +
            ''.join(chains['table']) + '<workholding location="0 0 0"/>' + '</axis>' * len(chains['table']) +
            '</base></machine>')


def path(xml, program):
    """The rows of --dump-path as dictionaries, and what stands on standard error."""
    for name, text in ('ts.xml', SETUP), ('tm.xml', xml), ('tp.mpf', program):
        with open(name, 'w') as file:
            file.write(text)
    ran = subprocess.run([os.environ['FIVECHECK'], '-s', 'ts.xml', '--dump-path', 'tm.xml', 'tp.mpf'],
                         capture_output=True, text=True)
    rows = [line.split('\t') for line in ran.stdout.split('\n') if line]
    return [dict(zip(rows[0], map(float, row))) for row in rows[1:]], ran.stderr


def ends(xml, program):
    """The last row of each line, and what stands on standard error."""
    rows, errors = path(xml, program)
    return {int(row['line']): row for row in rows}, errors
