#!/usr/bin/env python3
"""mistakes.py FIVECHECK [--markdown] [NAME...] - plants mistakes in the shipped machines and setups.

Each mistake is one change of one file of a copy: of the text of machine or setup, or of the coordinates of a mesh.
It is caught if the check of the shipped program that is clear ends with an error, with a finding, or with a caution
beside the verdict that the unchanged files do not have. A row of the table for each; exit status 1 if a mistake that
is expected to be caught is not, or the other way round.
"""
import json
import math
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import tempfile

TOP = pathlib.Path(__file__).resolve().parents[2]
AC, BC, CB = "ac-trunnion", "b-head-c-table", "cb-head"


def text(file, old, new):
    """A change of text in one of machine.xml and setup.xml; the old text must be there."""
    def change(folder):
        path = folder / file
        before = path.read_text()
        after, count = re.subn(old, new, before, count=1, flags=re.S)
        assert count == 1, f"{file}: {old} is not there"
        path.write_text(after)
    return change


def machine(old, new):
    return text("machine.xml", old, new)


def setup(old, new):
    return text("setup.xml", old, new)


def direction(axis, vector):
    return machine(rf'(<axis name="{axis}"[^>]* direction=)"[^"]*"', rf'\1"{vector}"')


def scale(pattern, factor):
    """The meshes of a pattern, as if they had been saved in other units."""
    def change(folder):
        paths = sorted(folder.glob(pattern))
        assert paths, pattern
        for path in paths:
            data = bytearray(path.read_bytes())
            for triangle in range(struct.unpack_from("<I", data, 80)[0]):
                at = 84 + 50 * triangle + 12
                values = struct.unpack_from("<9f", data, at)
                struct.pack_into("<9f", data, at, *(factor * v for v in values))
            path.write_bytes(data)
    return change


def mirror(name):
    """Mirrors the mesh in X and keeps its triangles outward."""
    def change(folder):
        path = folder / name
        data = bytearray(path.read_bytes())
        for triangle in range(struct.unpack_from("<I", data, 80)[0]):
            at = 84 + 50 * triangle + 12
            v = [(-c if k % 3 == 0 else c) for k, c in enumerate(struct.unpack_from("<9f", data, at))]
            struct.pack_into("<9f", data, at, *v[0:3], *v[6:9], *v[3:6])
        path.write_bytes(data)
    return change


def turn_a(name, angle):
    """The mesh at an angle of A of ac-trunnion other than 0."""
    sine, cosine = math.sin(math.radians(-angle)), math.cos(math.radians(-angle))

    def change(folder):
        path = folder / name
        data = bytearray(path.read_bytes())
        for corner in range(3 * struct.unpack_from("<I", data, 80)[0]):
            at = 84 + 50 * (corner // 3) + 12 * (1 + corner % 3)
            x, y, z = struct.unpack_from("<3f", data, at)
            struct.pack_into("<3f", data, at, x, cosine * y - sine * (z - 120), 120 + sine * y + cosine * (z - 120))
        path.write_bytes(data)
    return change


def no_holders(folder):
    """Each holder becomes a part of the shank."""
    path = folder / "setup.xml"
    text = path.read_text()
    after = re.sub(r"<holder>.*?</holder>\s*<shank>", lambda m: '<shank><section length="%g" diameter="12"/>' % sum(
        float(length) for length in re.findall(r' length="([^"]*)"', m.group(0))), text, flags=re.S)
    assert after != text
    path.write_text(after)


def halve_diameters(folder):
    path = folder / "setup.xml"
    path.write_text(re.sub(r'(diameter(?:_end)?)="([^"]*)"', lambda m: f'{m.group(1)}="{float(m.group(2)) / 2:g}"',
                           path.read_text()))


def every(*changes):
    def change(folder):
        for one in changes:
            one(folder)
    return change


def scale_tool(number, factor):
    """All lengths and diameters of a tool."""
    def change(folder):
        path = folder / "setup.xml"
        before = path.read_text()
        tool = re.search(rf'<tool number="{number}".*?</tool>', before, re.S).group(0)
        other = re.sub(r'(length|diameter|diameter_end)="([^"]*)"',
                       lambda m: f'{m.group(1)}="{float(m.group(2)) * factor:.9g}"', tool)
        path.write_text(before.replace(tool, other))
    return change


# name, machine, change, is it expected to be caught
MISTAKES = [
    # signs
    ("X moves the other way", AC, direction("X", "-1 0 0"), True),
    ("Y moves the other way", AC, direction("Y", "0 -1 0"), True),
    ("Z moves the other way", AC, direction("Z", "0 0 -1"), True),
    ("X and Y move the other way", AC, every(direction("X", "-1 0 0"), direction("Y", "0 -1 0")), True),
    ("A of the table as if it turned the tool", AC, direction("A", "1 0 0"), True),
    ("C of the table as if it turned the tool", AC, direction("C", "0 0 1"), True),
    ("Y of the table as if it moved the tool", BC, direction("Y", "0 1 0"), True),
    ("C of the table as if it turned the tool, B head", BC, direction("C", "0 0 1"), True),
    ("B of the head turns the other way", BC, direction("B", "0 -1 0"), True),
    ("C of the head turns the other way", CB, direction("C", "0 0 -1"), True),
    ("B of the head turns the other way, portal", CB, direction("B", "0 -1 0"), True),
    ("spindle from the tip to the gauge point", AC, machine(r'direction="0 0 -1"/>(\s*</axis>)', r'direction="0 0 1"/>\1'),
     True),
    ("spindle along X", AC, machine(r'direction="0 0 -1"/>(\s*</axis>)', r'direction="1 0 0"/>\1'), True),
    # letters
    ("X and Y exchanged", AC, every(direction("X", "0 1 0"), direction("Y", "1 0 0")), True),
    ("Y along X", AC, direction("Y", "1 0 0"), True),
    ("Z along Y", AC, direction("Z", "0 1 0"), True),
    ("A about Y", AC, direction("A", "0 -1 0"), True),
    ("C about X", AC, direction("C", "-1 0 0"), True),
    # units
    ("machine in inches, setup in mm", AC, machine('units="mm"', 'units="inch"'), True),
    ("setup in inches", AC, setup('units="mm"', 'units="inch"'), True),
    ("all meshes of the machine saved in inches", AC, scale("stl/*.stl", 1 / 25.4), True),
    ("all meshes of the machine saved in metres", AC, scale("stl/*.stl", 1e-3), True),
    ("all meshes of the machine saved in centimetres", AC, scale("stl/*.stl", 0.1), True),
    ("all meshes of the machine 25.4 times too large", AC, scale("stl/*.stl", 25.4), True),
    ("the head's mesh saved in inches", AC, scale("stl/head.stl", 1 / 25.4), True),
    ("the table's mesh saved in inches", AC, scale("stl/table.stl", 1 / 25.4), True),
    ("the part's mesh saved in inches", AC, scale("impeller.stl", 1 / 25.4), True),
    ("the part's mesh saved in metres", AC, scale("impeller.stl", 1e-3), True),
    ("the part's mesh saved in centimetres", BC, scale("blade.stl", 0.1), True),
    ("the part's mesh 10 times too large", AC, scale("impeller.stl", 10), True),
    ("the part's mesh 25.4 times too large", AC, scale("impeller.stl", 25.4), True),
    ("the fixture's mesh saved in inches", BC, scale("vise.stl", 1 / 25.4), True),
    ("a tool in inches", AC, scale_tool(1, 1 / 25.4), True),
    ("a tool 10 times too long and thick", AC, scale_tool(1, 10), True),
    # places
    ("the part 100 mm too high", AC, setup('location="0 0 55"', 'location="0 0 155"'), True),
    ("the part 20 mm too low", AC, setup('location="0 0 55"', 'location="0 0 35"'), True),
    ("the part 5 mm too low in the vise", BC, setup('location="0 0 130"', 'location="0 0 125"'), True),
    ("the part without its location", AC, setup(' location="0 0 55"', ''), True),
    ("the part 900 mm beside the table", AC, setup('location="0 0 55"', 'location="900 0 55"'), True),
    ("the part upside down", AC, setup('location="0 0 55"', 'location="0 0 55" rotation="180 0 0"'), True),
    ("the vise turned by 90 degrees", BC, setup('mesh="vise.stl"', 'mesh="vise.stl" rotation="90 0 0"'), True),
    ("workholding without the table's height", AC, machine('<workholding location="0 0 80"/>', '<workholding/>'), True),
    ("workholding 100 mm too high", AC, machine('<workholding location="0 0 80"', '<workholding location="0 0 180"'), True),
    ("workholding in inches", AC, machine('<workholding location="0 0 80"', '<workholding location="0 0 3.15"'), True),
    ("gauge point 100 mm below the head", AC, machine('<spindle location="0 0 520"', '<spindle location="0 0 420"'), True),
    ("gauge point 100 mm inside the head", AC, machine('<spindle location="0 0 520"', '<spindle location="0 0 620"'), True),
    ("gauge point at the origin", AC, machine('<spindle location="0 0 520"', '<spindle location="0 0 0"'), True),
    ("A turns about the drawing's origin", AC, machine('(direction="-1 0 0" location=)"0 0 120"', r'\1"0 0 0"'), True),
    ("A's location in inches", AC, machine('(direction="-1 0 0" location=)"0 0 120"', r'\1"0 0 4.724"'), True),
    ("C turns about a point 50 mm beside the table", AC, machine('(direction="0 0 -1" location=)"0 0 120"', r'\1"50 0 120"'),
     True),
    # offsets and lengths
    ("G54 Z with the wrong sign", AC, setup('Z="-385"', 'Z="385"'), True),
    ("G54 Z without its last digit", AC, setup('Z="-385"', 'Z="-38"'), True),
    ("G54 in inches", AC, setup('Z="-385"', 'Z="-15.157"'), True),
    ("G54 X outside the travel", AC, setup('X="0" Y', 'X="385" Y'), True),
    ("G54 X 200 mm off the part", AC, setup('X="0" Y', 'X="200" Y'), True),
    ("G54 X 10 mm off", AC, setup('X="0" Y', 'X="10" Y'), True),
    ("G54 Z 5 mm too low", AC, setup('Z="-385"', 'Z="-390"'), True),
    ("G54 Z 50 mm too high", AC, setup('Z="-385"', 'Z="-335"'), True),
    ("G54 Y 300 mm off, portal", CB, setup('Y="0"', 'Y="-300"'), True),
    ("G54 all zero", AC, setup('Z="-385"', 'Z="0"'), True),
    ("G54 A outside the travel", AC, setup('A="0"', 'A="90"'), True),
    ("G54 missing", AC, setup('<work_offset[^>]*/>', ''), True),
    ("a length offset with exchanged digits", AC, setup('length="130"', 'length="130" length_offset="103"'), True),
    ("sections that do not add up to the length", AC, setup('length="130"', 'length="150"'), True),
    # missing and exchanged things
    ("a tool is missing", AC, setup('<tool number="2"', '<tool number="12"'), True),
    ("the fixture is missing", AC, setup('<fixture[^>]*/>', ''), True),
    ("the workholding is missing", AC, machine('<workholding[^>]*/>', ''), True),
    ("the spindle is missing", AC, machine('<spindle[^>]*/>', ''), True),
    ("limits of A exchanged", AC, machine('limit_min="-120" limit_max="30"', 'limit_min="-30" limit_max="120"'), True),
    ("limits of Z of the other sign", AC, machine('limit_min="-400" limit_max="0"', 'limit_min="0" limit_max="400"'), True),
    ("a limit without its last digit", AC, machine('limit_min="-400"', 'limit_min="-40"'), True),
    # pivots, drawings and things that are not there
    ("A's location with exchanged digits", AC, machine('(direction="-1 0 0" location=)"0 0 120"', r'\1"0 0 210"'), True),
    ("C turns about a point 5 mm beside the table", BC, machine('(direction="0 0 -1" location=)"0 0 0"', r'\1"5 0 0"'), True),
    ("B of the head turns about a point 18 mm too low", BC, machine('(direction="0 1 0" location=)"0 0 720"', r'\1"0 0 702"'),
     True),
    ("B of the fork turns about the gauge point", CB, machine('(name="B"[^>]*location=)"0 0 1050"', r'\1"0 0 800"'), True),
    ("the head's body is missing", AC, machine(r'\n *<body name="head"[^>]*/>', ''), True),
    ("the table's body is missing", AC, machine(r'\n *<body name="table"[^>]*/>', ''), True),
    ("the bed's bodies are missing", AC, machine(r'(\n *<body name="(bed|bearing_left|bearing_right)"[^>]*/>)+', ''), True),
    ("the spindle on the carriage", AC, every(machine(r'\n *<spindle[^>]*/>', ''),
                                             machine('(<body name="carriage"[^>]*/>)',
                                                     r'\1<spindle location="0 0 520" direction="0 0 -1"/>')), True),
    ("the workholding on the bed", AC, every(machine(r'\n *<workholding[^>]*/>', ''),
                                            machine('(<body name="bed"[^>]*/>)', r'\1<workholding location="0 0 80"/>')), True),
    ("the meshes of table and cradle exchanged", AC, machine('stl/cradle.stl(.*)stl/table.stl', r'stl/table.stl\1stl/cradle.stl'),
     True),
    ("no travel of Z", AC, machine(' limit_min="-400" limit_max="0"', ''), True),
    ("a travel of X that is ten times too long", AC, machine('limit_min="-300" limit_max="300"',
                                                            'limit_min="-3000" limit_max="3000"'), True),
    ("the travel of A in radians", AC, machine('limit_min="-120" limit_max="30"', 'limit_min="-2.094" limit_max="0.524"'), True),
    ("tools without holders", AC, no_holders, True),
    ("the radii of the tools as diameters", AC, halve_diameters, True),
    ("the part mirrored", BC, mirror("blade.stl"), False),
    # joints, nesting, tools and numbers
    ("the fork's body is missing", CB, machine(r'\n *<body name="fork"[^>]*/>', ''), True),
    ("the saddle's body is missing", BC, machine(r'\n *<body name="saddle"[^>]*/>', ''), True),
    ("neighbours within 500 mm are excused", AC, machine('</machine>', '<pairs adjacent_within="500"/></machine>'), True),
    ("the gauge point 30 mm beside the head's middle", AC, machine('<spindle location="0 0 520"',
                                                                  '<spindle location="30 0 520"'), True),
    ("C of the table does not ride on A", AC, machine(r'( *<axis name="C".*?</axis>\n) *</axis>\n', r'</axis>\n\1'), True),
    ("C and B of the head exchanged", CB, every(machine('<axis name="C"', '<axis name="?"'), machine('<axis name="B"', '<axis name="C"'),
                                               machine('<axis name="[?]"', '<axis name="B"'), machine('direction="0 0 1" location',
                                                                                                     'direction="?" location'),
                                               machine('direction="0 1 0" location', 'direction="0 0 1" location'),
                                               machine('direction="[?]"', 'direction="0 1 0"')), True),
    ("sections of a holder from the tip to the gauge line", AC,
     setup(r'(<section length="26" diameter="63"/>)\s*(<section length="44" diameter="40" diameter_end="27"/>)',
           r'<section length="44" diameter="27" diameter_end="40"/>\1'), True),
    ("a mesh of a tool that ends before the tip", BC, every(lambda folder: shutil.copy(folder / "blade.stl", folder / "tool.stl"),
                                                      setup(r'<cutter tip="cone".*?</cutter>', '<cutter mesh="tool.stl"/>')), True),
    ("a diameter for the radius of D", AC, setup('</setup>', '<offset number="1" radius="10"/></setup>'), True),
    ("a blank that is smaller than the part", BC, setup('</setup>', '<stock box="60 30 100" location="0 0 130"/></setup>'), True),
    ("a bearing turns with A", AC, every(machine(r'\n *<body name="bearing_left"[^>]*/>', ''),
                                         machine('(<axis name="A"[^>]*>)',
                                                 r'\1<body name="bearing_left" mesh="stl/bearing_left.stl"/>')), True),
    ("one bearing's mesh for both", AC, machine('stl/bearing_right.stl', 'stl/bearing_left.stl'), True),
    ("the vise turned by a quarter in radians", BC, setup('mesh="vise.stl"', 'mesh="vise.stl" rotation="0 0 1.5708"'), True),
    ("the workholding turned by a quarter in radians", AC, machine('<workholding location="0 0 80"/>',
                                                                  '<workholding location="0 0 80" rotation="0 0 1.571"/>'), True),
    ("A's direction with a slip", AC, machine('direction="-1 0 0" location', 'direction="-1 0.02 0" location'), True),
    ("the spindle's direction with a slip", CB, machine('(<spindle [^>]*direction=)"0 0 -1"', r'\1"0.01 0 -1"'), True),
    ("A turns about a point 1 mm beside", AC, machine('(direction="-1 0 0" location=)"0 0 120"', r'\1"0 1 120"'), True),
    ("the cradle drawn with A at 10 degrees", AC, turn_a("stl/cradle.stl", 10), False),
    ("rates in metres a minute", AC, every(*3 * [machine(r'rate_max="(30|24)000"', r'rate_max="\1"')]), True),
    ("rates in mm a second", AC, machine('rate_max="30000"', 'rate_max="500"'), False),
]


def place(folder, name):
    shutil.copytree(TOP / "machines" / name / "stl", folder / "stl")
    shutil.copy(TOP / "machines" / name / "machine.xml", folder)
    for path in (TOP / "examples" / name).iterdir():
        shutil.copy(path, folder)


def ask(fivecheck, folder):
    """The exit status, the first error or finding, and the cautions."""
    run = subprocess.run([fivecheck, "-f", "ndjson", "-s", "setup.xml", "machine.xml", "clear.nc"], cwd=folder,
                         capture_output=True, text=True, check=False)
    records = [json.loads(line) for line in run.stdout.splitlines()]
    cautions = [c for r in records if r["kind"] == "program" for c in r.get("cautions", [])]
    findings = [r for r in records if r["kind"] not in ("header", "program", "summary", "error")]
    first = ""
    if run.returncode == 1:
        f = findings[0]
        first = f"{f['kind']} in line {f['line']}" + (f" of {f['axis']}" if f["kind"] == "limit" else f": {f['a']} and {f['b']}")
    elif run.returncode:
        first = next((line.split("error: ", 1)[1] for line in run.stderr.splitlines() if "error: " in line), "error")
    return run.returncode, first, cautions


def judge(fivecheck, name, change, usual):
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        place(folder, name)
        change(folder)
        status, first, cautions = ask(fivecheck, folder)
    return status, first, [c for c in cautions if c not in usual]


def main():
    fivecheck = str(pathlib.Path(sys.argv[1]).resolve())
    markdown = "--markdown" in sys.argv
    wanted = [a for a in sys.argv[2:] if a != "--markdown"]
    usual, caught, wrong = {}, 0, 0
    rows = [m for m in MISTAKES if not wanted or m[0] in wanted]
    for name in sorted({m[1] for m in rows}):
        status, first, usual[name] = judge(fivecheck, name, lambda folder: None, [])
        if status or any("checked=" in c for c in usual[name]):
            print(f"{name} as shipped: {first} {usual[name]}")
            wrong += 1
    for title, name, change, expected in rows:
        status, first, cautions = judge(fivecheck, name, change, usual[name])
        doubts = [c for c in cautions if "checked=" in c or "adjacent_within" in c]
        said = doubts + ([first] if first else []) if status != 2 else [first]
        caught += bool(said)
        wrong += bool(said) != expected
        word = {0: "clear", 1: "found", 2: "error"}.get(status, str(status))
        if doubts and status != 2:
            word += ", caution"
        if markdown:
            more = f" (and {len(said) - 1} more)" if len(said) > 1 else ""
            print(f"| {title} | {name} | {word} | {(said[0] if said else 'nothing').replace('|', '/')}{more} |")
        else:
            print(f"{'' if bool(said) == expected else 'UNEXPECTED '}{title}: {word}")
            for line in said if wanted else []:
                print("   ", line)
    print(f"\n{caught} of {len(rows)} mistakes are caught before or beside the verdict")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
