"""compare.py - the differential test: runs the programs of this folder, then random ones, in fivecheck and in rs274.

A program that must be refused has in its first line the error of fivecheck:
    (error: division by zero)
    (error, rs274 accepts: ...)     if rs274 goes on; the reason is given further on
"""
import argparse
import glob
import os
import random
import re
import sys

import generate
import reference


def expected_error(path):
    """The expected message, and whether rs274 must refuse the program, too; or None, True."""
    with open(path, errors='replace') as program:
        found = re.match(r'\(error(, rs274 accepts)?: (.*)\)$', program.readline().strip())
    return (found.group(2), not found.group(1)) if found else (None, True)


def check_program(programs, path):
    message, both = expected_error(path)
    if not message:
        wrong = reference.compare(programs, path)
        if not wrong and not programs.run_ours(path)[0]:
            wrong = 'both refuse it, and its first line does not say so: ' + programs.run_ours(path)[2]
        return wrong
    accepted, _, said = programs.run_ours(path)
    if accepted:
        return f'fivecheck accepts it, but "{message}" was expected'
    # An error quotes the line of the program, which may contain the message.
    if not any(message in line for line in said.splitlines() if ': error: ' in line):
        return f'fivecheck says something else: {said.strip()}'
    if programs.run_reference(path)[0] == both:
        return 'rs274 ' + ('accepts it' if both else 'refuses it, too')
    return None


def corpus(programs):
    paths = sorted(glob.glob(os.path.join(reference.HERE, '*.ngc')))
    paths = [path for path in paths if not os.path.basename(path).startswith('sub-')]
    failed = 0
    for path in paths:
        wrong = check_program(programs, path)
        if wrong:
            print(f'{os.path.basename(path)}: {wrong}')
            failed += 1
    print(f'check-rs274: {len(paths)} programs, {failed} differ')
    return failed == 0


def write(path, lines):
    with open(path, 'w') as program:
        program.write('\n'.join(lines) + '\n')


def shrink(programs, path, lines):
    """Removes lines as long as the two programs still differ, but neither the first, the unit of length, in which they
    start differently without it, nor the last, M2."""
    size = max(1, len(lines) // 2)
    while size:
        at = 1
        while at + size < len(lines):
            fewer = lines[:at] + lines[at + size:]
            write(path, fewer)
            try:
                differ = reference.compare(programs, path)
            except reference.Endless:
                differ = None
            if differ:
                lines = fewer
            else:
                at += size
        size //= 2
    write(path, lines)
    return lines


def is_worth(count, less, what):
    """False if more than one in twenty was not compared as a whole; a few are always allowed."""
    if less * 20 <= count + 40:
        return True
    print(f'check-rs274: too many were {what}')
    return False


def random_programs(programs, seed, blocks):
    path = os.path.join(programs.folder, 'random.ngc')
    done = refused = stopped = count = 0
    print(f'check-rs274: random programs from seed {seed}')
    while done < blocks:
        lines = generate.program(random.Random(f'{seed}/{count}'))
        write(path, lines)
        wrong = reference.compare(programs, path)
        if wrong:
            print(f'seed {seed}, program {count}, of {len(lines)} lines: {wrong}')
            lines = shrink(programs, path, lines)
            print(f'shrunk to {len(lines)} lines: {reference.compare(programs, path)}')
            print('\n'.join(lines))
            return False
        accepted = programs.run_ours(path)[0]
        stopped += not accepted and reference.stops_where_versions_disagree(programs, path)
        refused += not accepted
        done += len(lines)
        count += 1
    refused -= stopped
    print(f'check-rs274: {count} random programs of {done} blocks agree; {refused} refused by both, {stopped} compared '
          'up to a place where versions of LinuxCNC disagree')
    return is_worth(count, refused, 'refused by both') and is_worth(count, stopped, 'compared in part only')


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--fivecheck', required=True)
    parser.add_argument('--rs274', required=True)
    parser.add_argument('--seed', type=int, default=random.SystemRandom().randrange(1000000))
    parser.add_argument('--blocks', type=int, default=10000)
    parser.add_argument('programs', nargs='*', help='compare just these')
    options = parser.parse_args()
    programs = reference.Programs(options.fivecheck, options.rs274)
    try:
        if options.programs:
            wrong = [(p, check_program(programs, os.path.abspath(p))) for p in options.programs]
            for path, text in wrong:
                print(f'{path}: {text or "the same"}')
            good = not any(text for _, text in wrong)
        else:
            good = corpus(programs) and random_programs(programs, options.seed, options.blocks)
    finally:
        programs.close()
    return 0 if good else 1


if __name__ == '__main__':
    sys.exit(main())
