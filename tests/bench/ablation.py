"""ablation.py - measures the gain of each part of the proof with programs that leave it out (src/base/ablation.h)."""
import os
import re
import subprocess

import judge
from measure import rounds, say

# The part that is left out, and its macro.
ABLATIONS = [
    ('budget', 'BUDGET'),
    ('kept budgets', 'KEPT_BUDGETS'),
    ('travelling planes', 'PLANES'),
    ('profiles of revolution', 'PROFILES'),
    ('chunks', 'CHUNKS'),
    ('merged steps', 'MERGED_STEPS'),
    ('cached axes', 'CACHED_AXES'),
    ('supports', 'SUPPORTS'),
    ('interpolated axes', 'INTERPOLATED_AXES'),
    ('second order', 'SECOND_ORDER'),
    ('SIMD', 'SIMD'),
]
COLUMNS = ['without', 'scene', 'us_per_block', 'times', 'verdict']
LIBRARIES = '-lxml2 -ljansson -lnettle -lz -lm'


def sources_that_ask(source, macro):
    """The files that use the macro's constant."""
    constant = re.compile(r'\bWITH_%s\b' % macro)
    for folder, _, names in os.walk(os.path.join(source, 'src')):
        for name in names:
            path = os.path.join(folder, name)
            if name.endswith('.c'):
                with open(path) as text:
                    if constant.search(text.read()):
                        yield os.path.relpath(path, source)


def build_without(tools, source, macro):
    """Compiles only the files that use the macro; the linker takes all others from the library, which comes last."""
    folder = os.path.join(tools.out, 'without-' + macro.lower())
    program, objects = os.path.join(folder, 'fivecheck'), [os.path.join(tools.build, 'src', 'main.o')]
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(tools.build, 'flags')) as text:
        compiler = text.read().strip()
    commands = []
    for path in sources_that_ask(source, macro):
        objects.append(os.path.join(folder, path.replace('/', '-') + '.o'))
        commands.append('%s -DFIVECHECK_WITHOUT_%s -c -o %s %s' % (compiler, macro, objects[-1], path))
    commands.append('%s -o %s %s %s %s' % (compiler, program, ' '.join(objects),
                                           os.path.join(tools.build, 'libfivecheck.a'), LIBRARIES))
    for command in commands:
        subprocess.run(command, shell=True, check=True, cwd=source)
    return program


def seconds(tools, scene, program):
    return judge.check_seconds(tools, scene, [], 1, program)


def rows(tools, source, scenes):
    """Leaves out each part in turn, on each scene; all results must be the same. The quicker of two runs counts."""
    programs = {'nothing': tools.fivecheck}
    for name, macro in ABLATIONS:
        say('ablation: building without ' + name)
        programs[name] = build_without(tools, source, macro)
    result = []
    for scene in scenes:
        say('ablation: ' + scene.name)
        whole = tools.check(scene, ['-f', 'ndjson', '-q'], expect=(0, 1, 2))
        times = rounds(2, *[lambda p=p: seconds(tools, scene, p) for p in programs.values()])
        for (name, program), spent in zip(programs.items(), times):
            status = tools.check(scene, ['-f', 'ndjson', '-q'], expect=(0, 1, 2), fivecheck=program).status
            if status != whole.status:
                raise SystemExit('bench: %s: another verdict without %s' % (scene.name, name))
            result.append(dict(zip(COLUMNS, (
                name, scene.name, '%.4g' % (1e6 * min(spent) / judge.blocks_until(scene, None)),
                '%.3g' % (min(spent) / max(min(times[0]), 1e-9)), ('clear', 'contact', 'incomplete')[status]))))
    return result
