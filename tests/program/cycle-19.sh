# CYCL DEF 19 of Klartext: which of two solutions Q120 to Q122 contain, and their values after the angles are 0 again.
need python3
cat >check.py <<'PYTHON'
import re

import five_axes
from five_axes import FAMILIES, X, Z, ends, machine, subtract, tool_direction, turned_by

HEAD = 'BEGIN PGM P MM\nTOOL CALL 1 Z S100\nCYCL DEF 247 Q339=+1\nL Z+300 R0 FMAX\n'
AC = FAMILIES['AC table']
five_axes.SETUP = five_axes.SETUP.replace('"G54"', '"G54.1 P1"')  # preset 1


def run(pole, blocks):
    controller = '<controller dialect="klartext" path_tolerance="0.01" cycle_19_angles="spatial"%s>' % pole
    rows, errors = ends(re.sub('<controller[^>]*>', controller, machine(AC)), HEAD + blocks + 'END PGM P MM\n')
    return list(rows.values()), errors.split('\n')[0]


ZERO, STAYS = ' swivel_pole="zero"', ' swivel_pole="stays"'
TILT = 'CYCL DEF 19.0\nCYCL DEF 19.1 A+30 B+0 C+10\nL A+Q120 C+Q122 R0 FMAX\n'
LEVEL = 'CYCL DEF 19.0\nCYCL DEF 19.1 A+0 B+0 C+0\nL A+Q120 C+Q122 R0 FMAX\n'
# The manual measures the shorter path from axis position 0. From the present position, A-30 C190 is nearer.
for start in '', 'L A-30 C+170 R0 FMAX\n':
    rows, errors = run(ZERO, start + TILT)
    off = subtract(tool_direction(rows[-1], AC), turned_by(Z, [(Z, 10), (X, 30)]))
    assert max(map(abs, off)) < 1e-9
    print('A %g C %g' % (rows[-1]['A'], rows[-1]['C']))
for name, pole in ('zero', ZERO), ('stays', STAYS), ('not known', ''):
    rows, errors = run(pole, TILT + LEVEL)
    print(name, 'A %g C %g' % (rows[-1]['A'], rows[-1]['C']), errors.replace('tp.mpf:', ''))
rows, errors = run(ZERO, TILT + 'PLANE RESET STAY\nL A+Q120 R0 FMAX\n')
print('PLANE RESET', errors.replace('tp.mpf:', ''))
PYTHON
PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$(dirname "$LIB") FIVECHECK=$FIVECHECK python3 check.py
