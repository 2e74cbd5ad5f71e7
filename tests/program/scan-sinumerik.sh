# scan counts Sinumerik's cycles by name, and no word as the start of another (PO of POCKET3, SETM of SETMS).
program part.mpf <<'NC'
G54 G17 G90 F100
TRANS X1
SETMS(1)
POCKET3(50,0,1,-10,40,30,5,50,50,0)
MCALL CYCLE83(10,0,1,-5)
CP X1
G1 X1 B4.5 C3 B3=0.5 C3=1 F9
R2=CPA X=R2
CYCLE63("KONTUR",50,0,1,-5)
M30
NC
fivecheck scan part.mpf 2>/dev/null | sed -n '/^code/,/^$/p'
# An assumed answer of scan may make a loop endless: scan gives up, and lists its results so far.
program loop.mpf <<'NC'
LOOP
R1=_GUD
ENDLOOP
NC
status fivecheck scan --dialect=sinumerik --max-blocks=50 loop.mpf 2>&1 | sed -n '/error\|variable\|status/p'
# Names, edges and radii of tools do not stop scan; it asks for the data of swivelling and turning.
program five.mpf <<'NC'
N10 G17 G54 G90 G71 G94
N20 T="MILL 10"
N30 M6
N40 D2
N50 CYCLE800(1,"",0,57,0,0,0,30,0,0,0,0,0,-1)
N60 G1 G41 X10 Y10 F500
N70 X20
N80 G40 Y20
N90 CYCLE800()
N100 TRAORI
N110 G0 X0 Y0 Z10 A10 C=DC(350)
N120 TRAFOOF
N130 M77
N140 M30
NC
status fivecheck scan five.mpf 2>&1 | sed -n '/error/p; /^needed in the machine/,$p'
# The list of elements for the setup comes last: tools by name and by number, and work offsets.
program job.mpf <<'NC'
G17 G90 G71 G94 G505
T="MILL 10" D1
M6
G0 X1
T7
M6
D1 X3
G54 X4
G505 X5
T0 M6
M30
NC
status fivecheck scan --dialect=sinumerik job.mpf 2>&1 | sed -n '/^G505/p; /^needed/,$p'
# An axis of the machine that follows another one: the machine file must say that it moves nothing else.
program coupled.mpf <<'NC'
G17 G90 G71 G94 G500
TRAILON(A1,A)
G0 X1 A=DC(30)
TRAILOF(A1,A)
M30
NC
status fivecheck scan --dialect=sinumerik coupled.mpf 2>&1 | sed -n '/^TRAIL/p; /^needed in the machine/,$p'
root=$(dirname "$LIB")/../..
cp -r "$root/machines/ac-trunnion/stl" stl
for answer in '' '<macro program="TRAILON" action="none"/>'; do
	sed "s|<controller dialect=\"[a-z]*\" rapid=\"linear\"/>|<controller dialect=\"sinumerik\" rapid=\"linear\">$answer</controller>|; s|name=\"A\" title=\"First axis\"|& wrap=\"shortest\"|" \
		"$root/machines/ac-trunnion/machine.xml" >machine.xml
	status fivecheck -q machine.xml coupled.mpf 2>&1 | grep '^coupled\|^status'
done
