# A pocket is a region: it is clear where the cutter is long enough for its depth and the way out has room, also in a
# tilted plane; so is a face far wider than its set-up clearance; found where the holder meets the block, and where the next cycle or move goes too low for the way there.
root=$(dirname "$LIB")/../..
# The one preset of the setup holds from the first word of an axis on: the tool does not go to its Z by itself.
cp -r "$root/machines/ac-trunnion/stl" stl
sed 's|<controller dialect="[a-z]*" rapid="linear"/>|<controller dialect="klartext" rapid="linear"><tool_change/></controller>|' \
	"$root/machines/ac-trunnion/machine.xml" >machine.xml
sed 's|name="G54"|name="G54.1 P1"|' "$root/examples/stock/setup.xml" >setup.xml
pocket()
{
	cat >part.h <<EOF
0 BEGIN PGM PART MM
1 TOOL CALL 1 Z S8000
2 L X-60 Y0 A0 C0 R0 FMAX M3
3 L Z20 R0 FMAX
$3
5 CYCL DEF 251 RECTANGULAR POCKET Q215=1 Q218=40 Q219=30 Q220=6 Q367=0 Q207=500 Q201=$1 Q202=4 Q206=150 Q200=2 Q203=${4:-0} Q204=20
6 L X0 Y0 R0 FMAX M99
$2
99 END PGM PART MM
EOF
	fivecheck -q -s setup.xml machine.xml part.h 2>&1 | grep -v '^ ' | sed 's/^\([^[]*\) \[.*/\1/'
}
pocket -8 '7 L Z50 FMAX'
pocket -26 '7 L Z50 FMAX'
pocket -8 '7 L Z-5 FMAX'
# From where the pocket has left the tool, straight to a place beside it: too low.
pocket -8 '7 L X60 Z-5 FMAX'
pocket -8 '7 L Z50 FMAX' '4 PLANE SPATIAL SPA+20 SPB+0 SPC+0 MOVE DIST50 F2000' 12
# A face wider than the block: the way over it and away is clear, and the rapid into the block behind it is found.
sed -i 's|^5 CYCL.*|5 CYCL DEF 233 FACE MILLING Q225=-60 Q226=-50 Q227=0 Q386=-1 Q218=120 Q219=100 Q207=500 Q200=2 Q357=2 Q204=2|
s|^4 PLANE.*||; s|^7 L.*|7 L X60 Y40 FMAX\n8 L X0 Y0 Z-4 FMAX|' part.h
fivecheck -q -s setup.xml machine.xml part.h 2>&1 | grep -v '^ ' | sed 's/^\([^[]*\) \[.*/\1/'
