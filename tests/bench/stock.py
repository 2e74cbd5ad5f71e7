"""stock.py - programs with a blank: blocks a second and memory, against the usual grid (grid.c) in the same run."""
import math
import os
import re

import meshes
import trunnion
from measure import median, rounds, say
from scene import Scene

COLUMNS = ['job', 'blocks', 'blocks_per_second', 'target', 'met', 'grid_seconds', 'times', 'megabytes', 'verdict']

CELL = 0.1
RAPID = 60000   # mm/min
MILL = '''<machine version="1" units="mm">
  <controller dialect="linuxcnc" rapid="linear"/>
  <base>
    <axis name="X" type="linear" direction="1 0 0" rate_max="%(rate)d">
      <axis name="Y" type="linear" direction="0 1 0" rate_max="%(rate)d">
        <axis name="Z" type="linear" direction="0 0 1" home="100" rate_max="%(rate)d">
          <spindle location="0 0 100" direction="0 0 -1"/>
        </axis>
      </axis>
    </axis>
    <workholding location="0 0 0"/>
  </base>
</machine>
''' % {'rate': RAPID}


class Tool:
    """A ball cutter 100 mm long: what is in a holder, above the cutter's flutes a shank. Lengths in mm."""

    def __init__(self, diameter, flutes, shank, holder, holder_end):
        self.diameter, self.flutes, self.shank = diameter, flutes, shank
        self.holder, self.holder_end = holder, holder_end

    def xml(self):
        return """  <tool number="1" length="100" length_offset="0">
    <holder><section length="%g" diameter="%g"/></holder>
    <shank><section length="%g" diameter="%g"/></shank>
    <cutter tip="ball"><section length="%g" diameter="%g"/></cutter>
  </tool>
""" % (100 - self.holder_end, self.holder, self.holder_end - self.flutes, self.shank, self.flutes, self.diameter)


class Job:
    """The mill with the box of the blank; the height of the program's zero."""

    def __init__(self, name, program, tool, low, high, zero):
        self.name, self.program, self.tool, self.low, self.high, self.zero = name, program, tool, low, high, zero

    def scene(self, folder):
        os.makedirs(folder, exist_ok=True)
        machine, setup = (os.path.join(folder, self.name + x) for x in ('-machine.xml', '-setup.xml'))
        size = [b - a for a, b in zip(self.low, self.high)]
        with open(machine, 'w') as out:
            out.write(MILL)
        with open(setup, 'w') as out:
            out.write('<setup version="1" units="mm" initial_tool="1">\n  <work_offset name="G54" Z="%g"/>\n'
                      '  <stock box="%g %g %g" location="%g %g %g"/>\n%s</setup>\n' %
                      (self.zero, *size, self.low[0] + size[0] / 2, self.low[1] + size[1] / 2, self.low[2],
                       self.tool.xml()))
        return Scene(self.name, folder, machine, setup, self.program)


def relief(path, blocks):
    """A wavy face, milled line by line in steps of 1 mm, each lap below the last one."""
    with open(path, 'w') as out:
        out.write('G21 G90 G17 G94 G61 F3000\nM3 S1000\nG0 X-5 Y-5 Z25\nG0 Z22\n')
        for i in range(blocks):
            lap, place = divmod(i, 10000)
            row, along = divmod(place, 100)
            x, y = (along, 99 - along)[row % 2], 0.6 * row
            if not place:
                out.write('G1 Z22\nG1 X0 Y0\n')
            out.write('G1 X%.3f Y%.3f Z%.3f\n' % (x, y, 19 - 0.02 * lap + 0.5 * math.sin(x / 7) * math.cos(y / 9)))
        out.write('G0 Z25\nM2\n')
    return path


def slot(path, laps):
    """A round slot as wide as its cutter, 1 mm deeper with each lap of 200 blocks."""
    with open(path, 'w') as out:
        out.write('G21 G90 G17 G94 G61 F3000\nM3 S1000\nG0 X20 Y0 Z5\n')
        for i in range(200 * laps + 1):
            turn = math.pi * i / 100
            out.write('G1 X%.4f Y%.4f Z%.4f\n' % (20 * math.cos(turn), 20 * math.sin(turn), -i / 200))
        out.write('G0 Z5\nM2\n')
    return path


def copy(source, target, changes):
    """A program with some lines changed: (pattern, replacement)."""
    with open(source, errors='replace') as text:
        program = text.read()
    for pattern, replacement in changes:
        program = re.sub(pattern, replacement, program, count=1, flags=re.MULTILINE)
    with open(target, 'w') as out:
        out.write(program)
    return target


def mill_jobs(tools, folder):
    """(job, its target in blocks a second)"""
    yield Job('relief', relief(os.path.join(folder, 'relief.ngc'), 100000), Tool(6, 20, 6, 30, 60),
              (0, 0, 0), (100, 60, 20), 0), 50000
    # 0.1 mm beside both walls, as deep as the slot.
    yield Job('slot', slot(os.path.join(folder, 'slot.ngc'), 30), Tool(6, 8, 5.8, 30, 50),
              (-30, -30, -40), (30, 30, 0), 0), 1000
    real = os.path.join(tools.real or folder, 'nc')
    if os.path.exists(os.path.join(real, 'stellabee1.ngc')):
        program = copy(os.path.join(real, 'stellabee1.ngc'), os.path.join(folder, 'stellabee1.ngc'), [])
        # Where the cutter is deepest, its flutes end 0.5 mm above the blank.
        tool = Tool(3.175, 6.7, 3.1, 30, 15)
        yield Job('stellabee1', program, tool, (-12.5, -13.5, 0), (97.5, 136.5, 20), 20), 50000
    if os.path.exists(os.path.join(real, 'trochoidal.ngc')):
        program = copy(os.path.join(real, 'trochoidal.ngc'), os.path.join(folder, 'trochoidal.ngc'),
                       [('^F300', 'M3 S1000\nF300')])
        yield Job('trochoidal', program, Tool(6, 8, 6, 12, 40), (-47.5, -16, 0), (72.5, 124, 20), 20), 50000


def impeller(tools, folder):
    """The public five-axis program on the A/C machine, with its blank: a truncated cone. None: it is not there."""
    program = os.path.join(tools.real or folder, 'nc', 'impeller-7bl-xyzac.ngc')
    if not os.path.exists(program):
        return None
    machine, setup = (os.path.join(folder, 'impeller-' + x) for x in ('machine.xml', 'setup.xml'))
    meshes.write(os.path.join(folder, 'cone.stl'), meshes.revolve([(26.0, 0.0), (11.0, 26.0)], 96))
    copy(trunnion.MACHINE, machine, [('<controller[^>]*/>',
                                      '<controller dialect="linuxcnc" rapid="linear">'
                                      '<mcode number="428" action="tcp-on"/>'
                                      '<mcode number="429" action="tcp-off"/></controller>')])
    with open(machine) as text:
        description = text.read().replace('mesh="', 'mesh="%s/' % os.path.dirname(trunnion.MACHINE))
    with open(machine, 'w') as out:
        out.write(description)
    with open(setup, 'w') as out:
        out.write('<setup version="1" units="mm" initial_tool="1">\n  <work_offset name="G54" Z="-385"/>\n'
                  '  <stock mesh="cone.stl" location="0 0 55"/>\n%s</setup>\n' %
                  Tool(6, 60, 5.6, 24, 75).xml().replace('length_offset="0"', ''))
    copied = copy(program, os.path.join(folder, 'impeller.ngc'), [('^S600 M3', 'S600 M3\nG43 H1')])
    return Scene('impeller', folder, machine, setup, copied)


def blocks_of(spent):
    return spent.phases()[3]


def grid_seconds(tools, job, scene):
    """The time of the grid, without reading the path, and whether it found anything."""
    path = os.path.join(scene.folder, job.name + '.path')
    tools.check(scene, ['--dump-path', '-q', '-o', path])
    tool = job.tool
    numbers = [CELL, tool.holder_end, tool.flutes, tool.diameter, tool.shank, tool.holder, *job.low, *job.high,
               0.9 * RAPID / 60]
    with open(path) as text:
        spent = tools.run([os.path.join(tools.out, 'grid')] + ['%g' % x for x in numbers], stdin=text)
    seconds, found = spent.out.split()
    return float(seconds), int(found)


def row_of(tools, scene, target, job=None):
    say('stock: ' + scene.name)
    runs, grids = rounds(tools.runs, lambda: tools.check(scene, ['-j', '1']),
                         lambda: grid_seconds(tools, job, scene) if job else (0, 0))
    seconds, blocks = median([s.cpu for s in runs]), blocks_of(runs[0])
    rate, grid = blocks / seconds, median([g[0] for g in grids])
    verdict = ('clear', 'found')[runs[0].status]
    if job:
        verdict += ', grid: ' + ('found' if grids[0][1] else 'nothing found')
    return dict(zip(COLUMNS, (scene.name, blocks, round(rate), target, 'yes' if rate >= target else 'no',
                              '%.2f' % grid if job else '', '%.1f' % (grid / seconds) if job else '',
                              '%.1f' % (max(s.peak for s in runs) / 1e6), verdict)))


def memory_rows(tools, folder, blocks):
    """Programs of a tenth and of all blocks: the memory is that of the log of cuts, and most of that is in a file."""
    blocks = max(blocks, 1000000)   # The first 250,000 cuts stay in memory.
    peaks = []
    for count in (blocks // 10, blocks):
        program = relief(os.path.join(folder, 'long.ngc'), count)
        scene = Job('long', program, Tool(6, 20, 6, 30, 60), (0, 0, 0), (100, 60, 20), 0).scene(folder)
        spent = tools.check(scene, ['-j', '1'])
        peaks.append(spent.peak)
        os.remove(program)
    more = (peaks[1] - peaks[0]) / (blocks - blocks // 10)
    return [dict(zip(COLUMNS, ('relief, bytes a block more', blocks, '', '<= 48', 'yes' if more <= 48 else 'no', '', '',
                               '%.1f' % (peaks[1] / 1e6), '%.1f bytes; a tenth of the blocks: %.1f MB' %
                               (more, peaks[0] / 1e6))))]


def rows(tools, out, blocks):
    folder = os.path.join(out, 'stock')
    os.makedirs(folder, exist_ok=True)
    result = [row_of(tools, job.scene(folder), target, job) for job, target in mill_jobs(tools, folder)]
    five = impeller(tools, folder)
    if five:
        result.append(row_of(tools, five, 20000))
    return result + memory_rows(tools, folder, blocks)
