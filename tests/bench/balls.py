"""balls.py - scenes whose clearance is known: a ball on the spindle goes around a ball where the axes A and C cross.

However the table turns, the centres' distance is that of the linear axes' position from the crossing: the gap is
known up to the flatness of the balls' triangles. The program climbs a spiral on a sphere about it, at a constant gap,
and may end in a nick: straight in until the balls overlap, and out again.
"""
import math
import os
import random

import meshes
from nc import Axis, Program
from scene import Scene

WORK, TOOL = 60.0, 12.0     # radii, mm
AXES = [Axis('Y', False, 30000), Axis('X', False, 30000), Axis('Z', False, 30000, 400), Axis('A', True, 7200),
        Axis('C', True, 14400)]
MACHINE = '''<machine version="1" units="mm">
  <base>
    <body name="bed" mesh="bed.stl"/>
    <axis name="Y" type="linear" direction="0 1 0" limit_min="-500" limit_max="500" rate_max="30000">
      <axis name="X" type="linear" direction="1 0 0" limit_min="-500" limit_max="500" rate_max="30000">
        <axis name="Z" type="linear" direction="0 0 1" limit_min="-20" limit_max="500" rate_max="30000" home="400">
          <body name="tool" mesh="tool.stl"/>
        </axis>
      </axis>
    </axis>
    <axis name="A" type="rotary" direction="-1 0 0" location="0 0 0" limit_min="-120" limit_max="30" rate_max="7200">
      <body name="cradle" mesh="cradle.stl"/>
      <axis name="C" type="rotary" direction="0 0 -1" location="0 0 0" rate_max="14400">
        <body name="work" mesh="work.stl"/>
      </axis>
    </axis>
  </base>
</machine>
'''


def write_machine(folder, triangles):
    os.makedirs(folder, exist_ok=True)
    half = max(64, (triangles - 24) // 2)
    meshes.write(os.path.join(folder, 'bed.stl'), meshes.box((-400, -400, -420), (400, 400, -400)))
    meshes.write(os.path.join(folder, 'cradle.stl'), meshes.box((-80, -80, -120), (80, 80, -100)))
    meshes.write(os.path.join(folder, 'work.stl'), meshes.ball(WORK, half))
    meshes.write(os.path.join(folder, 'tool.stl'), meshes.ball(TOOL, half))
    machine = os.path.join(folder, 'machine.xml')
    with open(machine, 'w') as out:
        out.write(MACHINE)
    return machine, meshes.ball_sag(WORK, half) + meshes.ball_sag(TOOL, half)


def spiral(program, blocks, distance, length, share, rng):
    """The blocks of the spiral, and its end as a unit vector."""
    turn, height = rng.uniform(0, 2 * math.pi), rng.uniform(0.3, 0.6)
    a = c = 0.0
    whole = 0
    for i in range(blocks):
        slope = height + 0.2 * math.sin(i * length / 300)
        turn += length / (distance * math.sin(math.pi / 2 - slope))
        u = (math.cos(slope) * math.cos(turn), math.cos(slope) * math.sin(turn), math.sin(slope))
        words = {'X': distance * u[0], 'Y': distance * u[1], 'Z': distance * u[2]}
        if math.floor((i + 1) * share) > whole:
            whole += 1
            a, c = -15 + 14 * math.cos(whole * length / 100), c + math.degrees(length / WORK)
            words.update(A=a, C=c)
        if i:
            program.feed(**words)
        else:
            program.rapid(Z=distance + 50)
            program.rapid(X=words['X'], Y=words['Y'])
            program.rapid(Z=words['Z'])
    return u


def nick(program, u, gap, depth, feed_depth):
    """Moves in and out along u. Returns when the spheres first touch, and when spheres smaller by `feed_depth` do."""
    start, full = program.time, gap + depth
    distance = WORK + TOOL + gap

    def words(r):
        return {x: r * v for x, v in zip('XYZ', u)}

    program.feed(**words(distance - full))
    end = program.time
    program.feed(**words(distance))
    return start + (end - start) * gap / full, start + (end - start) * min(1, (gap + feed_depth) / full)


def make(folder, seed, triangles=2000, gap=1.0, length=0.1, share=1.0, blocks=2000, depth=0.0, feed=3000.0, cache=None):
    """depth > 0: the program ends with a contact of this depth, mm. cache: machines by number of triangles."""
    rng = random.Random(seed)
    name = os.path.basename(folder)
    cache = {} if cache is None else cache
    if triangles not in cache:
        cache[triangles] = write_machine(os.path.join(os.path.dirname(folder), 'balls-%d' % triangles), triangles)
    machine, sag = cache[triangles]
    os.makedirs(folder, exist_ok=True)
    program = Program(AXES, feed, os.path.join(folder, 'path.tsv'))
    u = spiral(program, blocks, WORK + TOOL + gap, length, share, rng)
    known = 'clear'
    if depth:
        # The triangles may lie this far inside the sphere, so the result is not known.
        known = nick(program, u, gap, depth, sag) if depth > sag else None
    program.write(os.path.join(folder, 'part.nc'))
    return Scene(name, folder, machine, None, os.path.join(folder, 'part.nc'), program.path, known,
                 triangles=triangles, gap=gap, length=length, share=share, blocks=blocks, depth=depth)
