# The position where a probe stops is not known: motion from there is proved for every position on its path. A ledge
# that the tool hits only if the probe stops between 5 and 15 mm above the end of its path is found. For a rotary axis
# only the end is followed, with a warning beside the verdict.
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
