"""Machines, jobs and truths for the tests in a browser."""
import os
import struct
import subprocess


def stl_box(path, low, high):
    """A closed box of twelve triangles, normals outward."""
    corner = [[(high if i >> k & 1 else low)[k] for k in range(3)] for i in range(8)]
    quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    triangles = [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]
    with open(path, "wb") as file:
        file.write(b"\0" * 80 + struct.pack("<I", len(triangles)))
        for triangle in triangles:
            file.write(struct.pack("<12fH", 0, 0, 0, *(v for i in triangle for v in corner[i]), 0))


def escaped(text):
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;").replace('"', "&quot;")


def boxes(work, hostile=False, subprogram=False):
    """Three linear axes, a table of 200 x 200 x 60 and a block on it that the tool runs into: machine, setup, program."""
    folder = os.path.join(work, f"boxes-{int(hostile)}{int(subprogram)}")
    os.makedirs(folder, exist_ok=True)
    name = '<img src=x onerror="window.pwned=1">' if hostile else "block"
    comment = "</script><script>window.pwned=1</script>" if hostile else "ROUGHING"
    stl_box(os.path.join(folder, "table.stl"), (-100, -100, 0), (100, 100, 60))
    stl_box(os.path.join(folder, "head.stl"), (-40, -40, 400), (40, 40, 500))
    stl_box(os.path.join(folder, "block.stl"), (-20, -20, 0), (20, 20, 40))
    machine = os.path.join(folder, "machine.xml")
    with open(machine, "w", encoding="utf-8") as file:
        file.write(f"""<?xml version="1.0"?>
<machine version="1" name="{escaped(name)}" units="mm">
  <controller dialect="linuxcnc" rapid="linear"/>
  <base>
    <body name="table" mesh="table.stl"/>
    <workholding location="0 0 60"/>
    <axis name="X" type="linear" direction="1 0 0" limit_min="-300" limit_max="300" rate_max="30000">
      <axis name="Y" type="linear" direction="0 1 0" limit_min="-300" limit_max="300" rate_max="30000">
        <axis name="Z" type="linear" direction="0 0 1" limit_min="-400" limit_max="0" rate_max="30000">
          <body name="head" mesh="head.stl"/>
          <spindle location="0 0 400" direction="0 0 -1"/>
        </axis>
      </axis>
    </axis>
  </base>
</machine>
""")
    setup = os.path.join(folder, "setup.xml")
    with open(setup, "w", encoding="utf-8") as file:
        file.write(f"""<?xml version="1.0"?>
<setup version="1" units="mm">
  <work_offset name="G54" X="0" Y="0" Z="-340"/>
  <fixture name="{escaped(name)}" mesh="block.stl"/>
  <tool number="1" name="{escaped(name)}" length="100">
    <holder><section length="50" diameter="50"/></holder>
    <cutter tip="flat"><section length="50" diameter="10"/></cutter>
  </tool>
</setup>
""")
    program = os.path.join(folder, "part.nc")
    moves = "G0 X-100\nG0 Z10\nG0 X100\n"
    with open(program, "w", encoding="utf-8") as file:
        if subprogram:
            file.write("G21 G90 G17 G40 G94\nT1 M6\nG54 G43 H1\nG0 Z200\no<approach> call\nG53 G0 Z0\nM2\n")
        else:
            file.write(f"G21 G90 G17 G40 G94\n({comment})\nT1 M6\nG54 G43 H1\nG0 Z200\n{moves}G53 G0 Z0\nM2\n")
    if subprogram:
        with open(os.path.join(folder, "approach.ngc"), "w", encoding="utf-8") as file:
            file.write(f"o<approach> sub\n{moves}o<approach> endsub\nM2\n")
    return machine, setup, program


def million(work):
    """A program of 1,000,000 blocks that winds above the block and never comes near it: machine, setup, program."""
    machine, setup, _ = boxes(work)
    program = os.path.join(work, "million.nc")
    with open(program, "w", encoding="utf-8") as file:
        file.write("G21 G90 G17 G40 G94\nT1 M6\nG54 G43 H1\nG0 Z150\nG1 F5000\n")
        state = 1
        for i in range(1_000_000):
            state = (state * 1103515245 + 12345) % 2**31
            file.write(f"X{(i * 7 % 2000) / 10 - 100 + state % 97 / 1000:.3f} Y{(i // 2000) % 200 - 100 + state % 89 / 1000:.3f}\n")
        file.write("M2\n")
    return machine, setup, program


def run(*command):
    return subprocess.run(command, capture_output=True, text=True, check=False)


def dump_path(fivecheck, machine, setup, program):
    """The rows of --dump-path as dictionaries of numbers."""
    lines = run(fivecheck, machine, f"--setup={setup}", program, "--dump-path").stdout.splitlines()
    names = lines[0].split("\t")
    return [dict(zip(names, map(float, line.split("\t")))) for line in lines[1:]]


def pose_boxes(fivecheck, work, machine, setup, program):
    """The triangles and vertices of --pose at the first finding."""
    path = os.path.join(work, "pose.stl")
    run(fivecheck, machine, f"--setup={setup}", program, f"--pose={path}")
    with open(path, "rb") as file:
        data = file.read()
    triangles = [struct.unpack_from("<9f", data, 84 + 50 * i + 12) for i in range(struct.unpack_from("<I", data, 80)[0])]
    points = {t[k:k + 3] for t in triangles for k in (0, 3, 6)}
    return {"triangles": triangles, "points": list(points)}


def farthest(points, among, limit):
    """The number of points without another point within the limit, found with a grid."""
    size = 4 * limit
    cells = {}
    for p in among:
        cells.setdefault(tuple(int(v // size) for v in p), []).append(p)
    missed = 0
    for p in points:
        cell = [int(v // size) for v in p]
        near = (q for dx in (-1, 0, 1) for dy in (-1, 0, 1) for dz in (-1, 0, 1)
                for q in cells.get((cell[0] + dx, cell[1] + dy, cell[2] + dz), ()))
        missed += not any(sum((a - b) ** 2 for a, b in zip(p, q)) <= limit * limit for q in near)
    return missed
