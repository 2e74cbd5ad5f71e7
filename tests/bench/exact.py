"""exact.py - scenes whose first contact a formula gives: a ram through a thin wall, an arm that turns into a post."""
import math
import os
import random

import meshes
from nc import Axis, Program
from scene import Scene

WALL = '''<machine version="1" units="mm">
  <base>
    <body name="wall" mesh="wall.stl"/>
    <axis name="X" type="linear" direction="1 0 0" limit_min="-500" limit_max="500" rate_max="60000" home="-200">
      <axis name="Z" type="linear" direction="0 0 1" limit_min="-500" limit_max="500" rate_max="60000">
        <body name="ram" mesh="ram.stl"/>
      </axis>
    </axis>
  </base>
  <pairs><pair a="wall" b="ram" check="always"/></pairs>
</machine>
'''

ARM = '''<machine version="1" units="mm">
  <base>
    <body name="post" mesh="post.stl"/>
    <axis name="C" type="rotary" direction="0 0 1" location="0 0 0" rate_max="36000">
      <body name="arm" mesh="arm.stl"/>
    </axis>
  </base>
  <pairs><pair a="post" b="arm" check="always"/></pairs>
</machine>
'''


def write_machine(folder, text, **bodies):
    os.makedirs(folder, exist_ok=True)
    for name, triangles in bodies.items():
        meshes.write(os.path.join(folder, name + '.stl'), triangles)
    machine = os.path.join(folder, 'machine.xml')
    with open(machine, 'w') as out:
        out.write(text)
    return machine


def wall(folder, seed):
    """A ram of 1 mm passes a wall of 1/8 to 2 mm at 12 to 60 m/min, or above it."""
    rng = random.Random(seed)
    thick, misses = rng.choice([0.125, 0.25, 0.5, 1, 2]), rng.random() < 0.3
    machine = write_machine(folder, WALL, wall=meshes.box((0, -50, -50), (thick, 50, 50), rng.choice([12, 2000])),
                            ram=meshes.box((-0.5, -5, -5), (0.5, 5, 5), rng.choice([12, 500])))
    program = Program([Axis('X', False, 60000, -200), Axis('Z', False, 60000)], rng.choice([12000, 30000, 60000]),
                      os.path.join(folder, 'path.tsv'))
    # The ram's lower side is just above the wall's upper edge.
    height = 55 + rng.choice([0.004, 0.02, 0.5]) if misses else rng.uniform(-20, 20)
    program.feed(X=-200 + rng.uniform(0, 20), Z=height)
    start, x0 = program.time, program.at['X']
    program.feed(X=rng.uniform(100, 200))
    share = (-0.5 - x0) / (program.at['X'] - x0)
    known = 'clear' if misses else (start + share * (program.time - start),) * 2
    program.write(os.path.join(folder, 'part.nc'))
    return Scene(os.path.basename(folder), folder, machine, None, os.path.join(folder, 'part.nc'), program.path, known,
                 gap=height - 55 if misses else 0)


def arm(folder, seed):
    """The arm lies along x, 4 mm to each side; (px, py) is the post's edge nearest to C."""
    rng = random.Random(seed)
    px, py, thick = rng.uniform(80, 240), rng.uniform(20, 200), rng.choice([0.25, 1, 8])
    reach = math.hypot(px, py)
    long = reach + rng.uniform(1, 40) if rng.random() < 0.7 else reach - rng.choice([0.005, 0.1, 3]) - 0.1
    machine = write_machine(folder, ARM, post=meshes.box((px, py, -30), (px + thick, py + thick, 30)),
                            arm=meshes.box((-20, -4, -5), (long, 4, 5), rng.choice([12, 1200])))
    program = Program([Axis('C', True, 36000)], rng.choice([3000, 12000, 36000]), os.path.join(folder, 'path.tsv'))
    to = math.degrees(math.atan2(py, px))
    program.feed(C=to - rng.uniform(30, 60))
    start, c0 = program.time, program.at['C']
    program.feed(C=to + 90)
    # A corner lies on the arm's side when it is 4 mm from its middle line; the line meets a corner of the post first.
    corners = [(x, y) for x in (px, px + thick) for y in (py, py + thick)]
    touch = min(math.degrees(math.atan2(y, x) - math.asin(4 / math.hypot(x, y))) for x, y in corners)
    known = None
    if math.hypot(px + thick, py + thick) < long:
        known = (start + (touch - c0) / (program.at['C'] - c0) * (program.time - start),) * 2
    elif math.hypot(long, 4) < reach:
        known = 'clear'
    program.write(os.path.join(folder, 'part.nc'))
    return Scene(os.path.basename(folder), folder, machine, None, os.path.join(folder, 'part.nc'), program.path, known,
                 gap=reach - math.hypot(long, 4))
