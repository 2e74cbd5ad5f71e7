#!/usr/bin/env python3
"""One random five-axis job, written for five controls, makes one path of the axes.

Draws machines and jobs (lines, arcs, helices, datum shifts, rotations, mirror images, tilted planes, tool centre point
control, drilling cycles, radius compensation, subprograms, loops), writes each job as LinuxCNC, Fanuc, Haas, Sinumerik
and Klartext program, and compares what --dump-path tells of them, to 1e-6 mm and degrees. A control that lacks an
element of a job leaves that job out, and the end of the run says how many jobs each control had. Only Python's standard
library is needed.

    one_path.py --fivecheck build/fivecheck --cases 40 --seed 1 --keep FOLDER [--only CASE] [--progress]
"""

import argparse
import math
import os
import random
import shutil
import subprocess
import sys
import tempfile

from controls import CONTROLS
from job import LACKS, MACHINES, Job

DIALECTS = ("linuxcnc", "fanuc", "haas", "sinumerik", "klartext")

# mm and degrees: the largest difference between two controls.
SAME = 1e-6


# ------------------------------------------------------------------ files


def axis_element(letter, direction, location, limits):
    limits = 'limit_min="%g" limit_max="%g" ' % limits if limits else ""
    return '<axis name="%s" type="%s" direction="%.17g %.17g %.17g" location="%g %g %g" %srate_max="3600">' % (
        letter, "rotary" if letter in "ABC" else "linear", *direction, *location, limits)


def machine_file(job, dialect):
    own = {
        "linuxcnc": "",
        "fanuc": ' length_offset_moves="no" cutter_comp_start="A" cutter_comp_corner="circular"',
        "haas": ' length_offset_moves="no" cutter_comp_start="A" cutter_comp_corner="circular"',
        "sinumerik": ' frames_outlive_traori="yes" edge_after_tool_change="first" tool_length_axis="z" swivel_axis="%s"'
        % [letter for letter in job.letters if letter != "C"][0],
        "klartext": "",
    }[dialect]
    inside = '<tool_change/>'
    if dialect == "linuxcnc":
        inside += '<mcode number="428" action="tcp-on"/><mcode number="429" action="tcp-off"/>'
    text = f'<machine version="1" name="job" units="mm"><controller dialect="{dialect}" path_tolerance="0.01"{own}>'
    text += inside + "</controller><base>"
    axes = MACHINES[job.machine]
    for letter, direction, location, limits, where in axes:
        if where == "t":
            text += axis_element(letter, [-c for c in direction], location, limits)
    text += '<workholding location="0 0 0"/>' + "</axis>" * sum(axis[4] == "t" for axis in axes)
    for i, letter in enumerate("XYZ"):
        text += axis_element(letter, [float(i == k) for k in range(3)], (0, 0, 0), (-9000, 9000))
    for letter, direction, location, limits, where in axes:
        if where == "h":
            text += axis_element(letter, direction, location, limits)
    text += '<spindle location="0 0 0" direction="0 0 -1"/>' + "</axis>" * (3 + sum(axis[4] == "h" for axis in axes))
    return text + "</base></machine>\n"


def setup_file(job, dialect):
    text = '<setup version="1" units="mm">'
    for i, offset in enumerate(job.offsets):
        name = f"G54.1 P{i + 1}" if dialect == "klartext" else f"G{54 + i}"
        text += '<work_offset name="%s" X="%g" Y="%g" Z="%g"/>' % (name, *offset)
    for i, length in enumerate(job.lengths):
        text += '<tool number="%d" length="%g" diameter="%g" checked="only its length counts here"/>' % (i + 1, length, (8, 5)[i])
        if dialect in ("fanuc", "haas"):
            text += '<offset number="%d" length="%g" radius="%g"/>' % (i + 1, length, (4, 2.5)[i])
    return text + "</setup>\n"


# ------------------------------------------------------------------ comparison


class Differs(Exception):
    pass


def write(path, text):
    with open(path, "w", encoding="ascii") as file:
        file.write(text)


def dump(fivecheck, folder, job, dialect):
    ending = {"sinumerik": "mpf", "klartext": "h"}.get(dialect, "nc")
    names = [os.path.join(folder, f"{dialect}{tail}") for tail in ("-machine.xml", "-setup.xml", "." + ending)]
    for name, text in zip(names, (machine_file(job, dialect), setup_file(job, dialect), CONTROLS[dialect](job).text())):
        write(name, text)
    done = subprocess.run([fivecheck, "-q", "--dump-path", "-s", names[1], names[0], names[2]], capture_output=True,
                          text=True, check=False)
    if done.returncode > 1:
        raise Differs(f"{dialect} refuses the job: {done.stderr.strip().splitlines()[:3]}")
    rows = [line.split("\t") for line in done.stdout.splitlines()]
    first = rows[0].index("tool") + 1
    last = rows[0].index("time")
    return [(row[2], [float(value) for value in row[first:last]]) for row in rows[1:]]


def straightened(rows):
    """Points at which the path of the axes turns: collinear rows are joined."""
    points = []
    for tool, point in rows:
        if len(points) >= 1 and points[-1][0] == tool and math.dist(points[-1][1], point) < 1e-9:
            continue
        if len(points) >= 2 and points[-2][0] == points[-1][0] == tool:
            a, b = points[-2][1], points[-1][1]
            first, second = math.dist(a, b), math.dist(b, point)
            beside = math.dist([(q - p) / first for p, q in zip(a, b)], [(q - p) / second for p, q in zip(b, point)])
            if beside < 1e-9:
                points.pop()
        points.append((tool, point))
    return points


def compare(one, other, names):
    if len(one) != len(other):
        for i, (a, b) in enumerate(zip(one, other)):
            if a[0] != b[0] or max(abs(p - q) for p, q in zip(a[1], b[1])) > SAME:
                raise Differs(f"{names[0]} and {names[1]} part at point {i}: {a} and {b}")
        raise Differs(f"{names[0]} has {len(one)} points and {names[1]} {len(other)}")
    for i, (a, b) in enumerate(zip(one, other)):
        worst = max(abs(p - q) for p, q in zip(a[1], b[1]))
        if a[0] != b[0] or worst > SAME:
            raise Differs(f"{names[0]} and {names[1]} differ by {worst:g} at point {i}: {a} and {b}")


def run_case(fivecheck, folder, job, counts):
    paths = {}
    for dialect in DIALECTS:
        if job.compare_on(dialect):
            paths[dialect] = straightened(dump(fivecheck, folder, job, dialect))
            counts[dialect] += 1
    for dialect in paths:
        compare(paths["klartext"], paths[dialect], ("klartext", dialect))
    return len(paths["klartext"])


ELEMENTS = ["shift", "rotate", "mirror", "scale", "plane", "tcp", "rotary", "drill", "comp", "call", "loop"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--fivecheck", required=True)
    parser.add_argument("--cases", type=int, default=40)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", type=int, help="the number of the only case to run")
    parser.add_argument("--keep", help="folder for the cases that differ")
    parser.add_argument("--progress", action="store_true")
    options = parser.parse_args()
    counts = {dialect: 0 for dialect in DIALECTS}
    elements = {element: 0 for element in ELEMENTS}
    differ = points = 0
    for case in range(options.cases) if options.only is None else [options.only]:
        rng = random.Random(f"{options.seed} {case}")
        # Every second job uses only functions that all five controls have.
        common = [e for e in ELEMENTS if not any(e in lacks for lacks in LACKS.values()) and e != "comp"]
        job = Job(rng, common if case % 2 else ELEMENTS)
        folder = tempfile.mkdtemp()
        try:
            for element in job.elements:
                elements[element] += 1
            points += run_case(options.fivecheck, folder, job, counts)
        except Differs as reason:
            differ += 1
            print(f"case {case} of seed {options.seed} ({job.machine}, {', '.join(sorted(job.elements))}): {reason}")
            if options.keep:
                kept = os.path.join(options.keep, f"{options.seed}-{case}")
                shutil.rmtree(kept, ignore_errors=True)
                shutil.copytree(folder, kept)
                print(f"    kept in {kept}")
        finally:
            shutil.rmtree(folder)
        if options.progress and case % 50 == 49:
            print(f"{case + 1} jobs", file=sys.stderr)
    print("jobs: " + ", ".join(f"{dialect} {count}" for dialect, count in counts.items()))
    print("elements: " + ", ".join(f"{element} {count}" for element, count in elements.items()))
    print(f"{points} points of paths, {differ} jobs differ" if differ else "every job makes one path")
    return 1 if differ else 0


if __name__ == "__main__":
    sys.exit(main())
