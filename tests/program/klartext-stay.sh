# PLANE ... STAY of Klartext with the rotary axes already in position, to three decimals: the next block is tilted.
need python3
cat >check.py <<'PYTHON'
import re

import five_axes
from five_axes import FAMILIES, X, Y, Z, add, ends, machine, place, subtract, tip, tool_direction, turned_by

HEAD = 'BEGIN PGM P MM\nTOOL CALL 1 Z S100\nCYCL DEF 247 Q339=+1\nL Z+300 R0 FMAX\nCYCL DEF 7.0\nCYCL DEF 7.1 X+5\n'
PLANE = 'PLANE SPATIAL SPA+17 SPB-23 SPC+41 STAY SEQ+\n'
five_axes.SETUP = five_axes.SETUP.replace('"G54"', '"G54.1 P1"')  # preset 1
TURNS = [(Z, 41), (Y, -23), (X, 17)]


def run(rotary, blocks):
    controller = '<controller dialect="klartext" path_tolerance="0.01">'
    rows, errors = ends(re.sub('<controller[^>]*>', controller, machine(rotary)), HEAD + blocks + 'END PGM P MM\n')
    return list(rows.values()), re.sub('^[^ ]* ', '', errors.split('\n')[0])


for name, rotary in FAMILIES.items():
    letters = sorted(letter for letter, _, _, _ in rotary)
    turn = 'L ' + ' '.join('%s+Q%d' % (letter, 120 + 'ABC'.index(letter)) for letter in letters) + ' R0 FMAX\n'
    rows, errors = run(rotary, PLANE + turn)
    angles = [rows[-1][letter] for letter in letters]

    def stand(angles):
        return 'L ' + ' '.join('%s%+.3f' % pair for pair in zip(letters, angles)) + ' R0 FMAX\n' + PLANE

    rows, errors = run(rotary, stand(angles) + 'L X+20 Y-30 Z+10 R0 FMAX\n')
    if errors:
        print(name, errors)
        continue
    off = subtract(tool_direction(rows[-1], rotary), turned_by(Z, TURNS))
    beside = subtract(tip(rows[-1], rotary), place(add(turned_by((20, -30, 10), TURNS), (5, 0, 0))))
    print(name, 'direction', max(map(abs, off)) < 3e-5, 'tip', max(map(abs, beside)) < 0.02)
    rows, errors = run(rotary, stand([angles[0], angles[1] + 0.002]) + 'L X+20 R0 FMAX\n')
    print(re.sub(r'at [^:]*:', 'at ...:', errors))
PYTHON
PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$(dirname "$LIB") FIVECHECK=$FIVECHECK python3 check.py
