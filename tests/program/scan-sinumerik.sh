# Of Sinumerik's words scan counts cycles by their names, and no short word as the start of a longer one (PO of POCKET3).
program part.mpf <<'NC'
G54 G17 G90 F100
TRANS X1
POCKET3(50,0,1,-10,40,30,5,50,50,0)
MCALL CYCLE83(10,0,1,-5)
CP X1
CYCLE63("KONTUR",50,0,1,-5)
M30
NC
fivecheck scan part.mpf 2>/dev/null | sed -n '/^code/,/^$/p'
# An answer of scan's own may make a loop endless: it gives up, and lists what it has found.
program loop.mpf <<'NC'
LOOP
R1=_GUD
ENDLOOP
NC
status fivecheck scan --dialect=sinumerik --max-blocks=50 loop.mpf 2>&1 | sed -n '/error\|variable\|status/p'
