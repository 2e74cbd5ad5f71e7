# Where a probe stops is not known: what moves from there is proved for every place of its way. A ledge that the tool
# hits only if the probe stops between 5 and 15 mm over the end of its way is found. Of a rotary axis only the end of its
# way is followed, and that is said beside the verdict.
small_machine
box ledge 40 -20 80 60 20 90
sed 's|<workholding|<body name="ledge" mesh="ledge.stl"/><workholding|' m.xml >ledge.xml
program beside.nc <<'NC'
G21 G90 G94 F100
G0 X10 Z40
G38.2 Z-60
X50
G0 Z40
M2
NC
program over.nc <<'NC'
G21 G90 G94 F100
G0 X10 Z40
G38.2 Z10
X50
G0 Z40
M2
NC
program turned.nc <<'NC'
G21 G90 G94 F100
G0 Z40
G38.2 C20
X50
M2
NC
program skip.nc <<'NC'
%
O1
G21 G90 G94 F100.
G0 X10. Z40.
G31 Z10.
X20.
M30
%
NC
for name in beside over turned; do
	status fivecheck -q ledge.xml $name.nc 2>&1 | sed '/^      */d'
done
sed 's|<base|<controller dialect="haas" rapid="linear"/><base|' m.xml >haas.xml
status fivecheck -q haas.xml skip.nc 2>&1
