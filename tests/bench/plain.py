"""plain.py - a machine and its setup, read independently of fivecheck, as the plain scene of plain_scene.h.

Only what the scenes of the benchmark use: millimetres, tool sections or meshes, fixtures and parts.
"""
import math
import os
import xml.etree.ElementTree as tree

import meshes

LETTERS = 'XYZABCUVW'
STEPS = 96      # round a tool


def numbers(text, count=3):
    values = [float(x) for x in (text or ' '.join(['0'] * count)).split()]
    assert len(values) == count, text
    return values


def unit(v):
    length = math.sqrt(sum(x * x for x in v))
    return [x / length for x in v]


def product(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]


def turned(degrees):
    """About the fixed axes X, then Y, then Z."""
    x, y, z = (math.radians(d) for d in degrees)
    about_x = [[1, 0, 0], [0, math.cos(x), -math.sin(x)], [0, math.sin(x), math.cos(x)]]
    about_y = [[math.cos(y), 0, math.sin(y)], [0, 1, 0], [-math.sin(y), 0, math.cos(y)]]
    about_z = [[math.cos(z), -math.sin(z), 0], [math.sin(z), math.cos(z), 0], [0, 0, 1]]
    return product(about_z, product(about_y, about_x))


def place_of(element):
    return turned(numbers(element.get('rotation'))), numbers(element.get('location'))


def combined(outer, inner):
    r, t = outer
    s, u = inner
    return product(r, s), [sum(r[i][k] * u[k] for k in range(3)) + t[i] for i in range(3)]


def tool_frame(spindle):
    """Gauge point at the origin, tip toward -Z."""
    z = [-x for x in unit(numbers(spindle.get('direction')))]
    x = unit([0, z[2], -z[1]] if abs(z[0]) < 0.8 else [z[2], 0, -z[0]])
    y = [z[1] * x[2] - z[2] * x[1], z[2] * x[0] - z[0] * x[2], z[0] * x[1] - z[1] * x[0]]
    return [[x[i], y[i], z[i]] for i in range(3)], numbers(spindle.get('location'))


def tip_of(cutter, radius, steps=24):
    """The profile (radius, height over the tip) below the straight part."""
    kind = cutter.get('tip', 'flat')
    quarter = [math.pi / 2 * i / steps for i in range(steps + 1)]
    if kind == 'ball':
        return [(radius * math.sin(a), radius - radius * math.cos(a)) for a in quarter]
    if kind == 'bull':
        corner = float(cutter.get('corner'))
        return [(radius - corner + corner * math.sin(a), corner - corner * math.cos(a)) for a in quarter]
    if kind == 'cone':
        return [(0.0, 0.0), (radius, radius / math.tan(math.radians(float(cutter.get('angle')) / 2)))]
    return [(radius, 0.0)]


def tool_profile(element, top):
    """From bottom to top, heights in the tool's frame. Returns where the next element begins."""
    profile, height = [], top
    for section in element.findall('section'):
        radius = float(section.get('diameter')) / 2
        end = float(section.get('diameter_end', section.get('diameter'))) / 2
        profile += [(radius, height), (end, height - float(section.get('length')))]
        height -= float(section.get('length'))
    if element.tag == 'cutter' and element.get('tip', 'flat') != 'flat':
        profile.pop()
        profile += [(r, height + h) for r, h in reversed(tip_of(element, radius))]
    profile.reverse()
    return [p for i, p in enumerate(profile) if i == 0 or p != profile[i - 1]], height


class Reader:
    def __init__(self, folder):
        self.folder, self.lines, self.links, self.spindle, self.work = folder, [], 0, None, None

    def body(self, element, base, link, tool, frame=None):
        place = combined(frame, place_of(element)) if frame else place_of(element)
        self.solid(os.path.join(base, element.get('mesh')), place, link, tool, element.get('name'))

    def solid(self, mesh, place, link, tool, name):
        r, t = place
        figures = ' '.join('%.17g' % x for x in r[0] + r[1] + r[2] + t)
        self.lines.append('body %d %d %s 1 %s' % (link, tool, figures, os.path.abspath(mesh)))
        self.lines.append('name ' + name)

    def link(self, element, base, link):
        for child in element:
            if child.tag == 'body':
                self.body(child, base, link, 0)
            elif child.tag == 'spindle':
                self.spindle = link, tool_frame(child)
            elif child.tag == 'workholding':
                self.work = link, place_of(child)
            elif child.tag == 'axis':
                self.links += 1
                figures = unit(numbers(child.get('direction'))) + numbers(child.get('location'))
                self.lines.append('axis %s %s %d %s %s' % (
                    child.get('name'), child.get('type'), link, ' '.join('%.17g' % x for x in figures),
                    child.get('home', '0')))
                self.link(child, base, self.links)

    def tool(self, element, base):
        number, link, frame = int(element.get('number')), self.spindle[0], self.spindle[1]
        top = 0.0
        for part in (element.find(x) for x in ('holder', 'shank', 'cutter')):
            if part is None:
                continue
            mesh, name = part.get('mesh'), 'T%d %s' % (number, part.tag)
            if mesh:
                mesh = os.path.join(base, mesh)
            else:
                profile, top = tool_profile(part, top)
                mesh = os.path.join(self.folder, 'tool-%d-%s.stl' % (number, part.tag))
                meshes.write(mesh, meshes.revolve(profile, STEPS))
            self.solid(mesh, frame, link, number, name)

    def setup(self, root, base):
        for child in root:
            if child.tag in ('fixture', 'part'):
                self.body(child, base, self.work[0], 0, self.work[1])
            elif child.tag == 'tool':
                self.tool(child, base)


def write(machine, setup, pairs, folder):
    """Writes folder/scene.txt; pairs is what fivecheck --list-pairs printed. Returns its path."""
    reader = Reader(folder)
    root = tree.parse(machine).getroot()
    assert root.get('units', 'mm') == 'mm'
    reader.link(root.find('base'), os.path.dirname(machine), 0)
    if setup:
        reader.setup(tree.parse(setup).getroot(), os.path.dirname(setup))
    names = [line[5:] for line in reader.lines if line.startswith('name ')]
    for row in pairs.splitlines()[1:]:
        a, b, status, clearance, _ = row.split('\t')
        # The truth also looks at pairs that were proved out of reach.
        if status in ('checked', 'out of reach'):
            reader.lines.append('pair %d %d %s %d' % (names.index(a), names.index(b), clearance, status == 'checked'))
    path = os.path.join(folder, 'scene.txt')
    with open(path, 'w') as out:
        out.write('\n'.join(reader.lines) + '\n')
    return path
