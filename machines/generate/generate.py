#!/usr/bin/env python3
"""generate.py FOLDER: writes the meshes of the machines to FOLDER/machines/NAME/stl and, to FOLDER/examples/NAME,
the meshes and the programs of their jobs; prints the triangle counts."""
import os
import sys

sys.dont_write_bytecode = True  # importing the modules must not write files into the tree

import ac_trunnion
import b_head_c_table
import blade
import cb_head
import impeller
import solids
import tub

MACHINES = [ac_trunnion, cb_head, b_head_c_table]
JOBS = [impeller, tub, blade]


def write_meshes(title, folder, bodies):
    counts = [(make.__name__, solids.write_stl(folder, make.__name__, make())) for make in bodies]
    print(title, sum(n for _, n in counts), ' '.join('%s=%d' % c for c in counts))


def main(root):
    for machine in MACHINES:
        write_meshes(machine.NAME, os.path.join(root, 'machines', machine.NAME, 'stl'), machine.BODIES)
    for job in JOBS:
        folder = os.path.join(root, 'examples', job.NAME)
        write_meshes(job.NAME + ' job', folder, job.BODIES)
        for name, make in job.PROGRAMS.items():
            with open(os.path.join(folder, name), 'w', encoding='ascii', newline='\n') as f:
                f.write(make())


if __name__ == '__main__':
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
