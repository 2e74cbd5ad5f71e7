# Tool data that a Sinumerik control archives (TO area): values for tools of other libraries, and tools as far as the
# data describe them.
stock_mill
sed -i 's|<base>|<controller dialect="sinumerik" path_tolerance="0.01" edge_after_tool_change="first"><tool_change/></controller><base>|' m.xml
cat >TO_TOA.INI <<'TOA'
%_N_TO_TMA
;$PATH=/_N_TOA_DIR
;TOOL MAGAZIN ZEROPOINT "IS_METRIC"=1
METRIC
CHANDATA(1)
$TC_TP1[1]=1
$TC_TP2[1]="MILL_D16; R1"
$TC_TP8[1]='H2'
$TC_DP1[1,1]=121
$TC_DP3[1,1]=99.5
$TC_DP6[1,1]=8
$TC_DP7[1,1]=1
$TC_DP12[1,1]=0.1	;wear
$TC_DP15[1,1]=.05
$TC_DP21[1,1]=10
$TC_DP1[1,2]=121
$TC_DP3[1,2]=89.5
$TC_DP6[1,2]=7.5
$TC_SCP13[1,1]=0
$TC_TP2[2]="90"
$TC_DP1[2,1]=200 $TC_DP3[2,1]=120 $TC_DP6[2,1]=4.25
N10 $TC_TP2[7]="BALL"
N20 $TC_DP1[7,1]=110
N30 $TC_DP3[7,1] = 95.5
N40 $TC_DP6[7,1]=4
N50 $TC_DP12[7,1]=-2.0E-2
N60 $TC_DP15[7,1]=-0.015
$TC_DP1[8,1]=710
$TC_DP3[8,1]=150
$TC_DP6[8,1]=2
$TC_TP2[9]="TURN"
$TC_DP1[9,1]=500
$TC_DP3[9,1]=50
$TC_DP4[9,1]=30
$TC_DP6[9,1]=0.8
$TC_TP2[10]="NO_RADIUS"
$TC_DP1[10,1]=120
$TC_DP3[10,1]=80
$TC_TP2[11]="TAPER"
$TC_DP1[11,1]=155
$TC_DP3[11,1]=80
$TC_DP6[11,1]=5
$TC_MPP6[1,1]=7
M17
TOA
echo "tools of an archive:"
fivecheck import -o new TO_TOA.INI
sed 1,3d new/setup.xml
"$FIVECHECK" --list-pairs -s new/setup.xml m.xml >/dev/null && echo "a check accepts them"
same() { # TEXT SED-SCRIPT - the changed file is imported as the same tools
	mkdir -p sub
	sed "$2" TO_TOA.INI >sub/TO_TOA.INI
	fivecheck import -o sub/new sub/TO_TOA.INI >said 2>&1
	cmp sub/new/setup.xml new/setup.xml && echo "$1"
	rm -r sub/new
}
same "with the line ends of Windows" 's/$/\r/'
same "without a unit" '/^METRIC/d'
grep unit said
sed 's/^METRIC/INCH/' TO_TOA.INI >inch.ini
fivecheck import -o inch inch.ini 2>/dev/null
grep '<tool' inch/setup.xml

echo "values for tools that the setup describes:"
setup s.xml <<'XML'
<work_offset name="G54" Z="-200"/>
<tool number="5" name="mill_d16; r1" length="109.5"><cutter tip="bull" corner="1"><section length="109.5" diameter="16"/></cutter></tool>
<tool number="6" name="BALL" length="95.5"><cutter tip="ball"><section length="95.5" diameter="8"/></cutter></tool>
<tool number="90" name="drill" length="120"><cutter><section length="120" diameter="8.5"/></cutter></tool>
<tools href="TO_TOA.INI"/>
XML
program p.mpf <<'NC'
G17 G90 G94 G71 G40 G54
T="MILL_D16; R1" M6
G0 X0 Y0 Z10 D1
Z10 D2
T90 M6
G0 Z10 D1
T="BALL" M6
G0 Z10 D1
S1000 M3
G1 G41 X20 Y0 F500
X50
G40 X60
M30
NC
"$FIVECHECK" --dump-path -s s.xml m.xml p.mpf | cut -f 1,3-6
echo "the same with the values written out:"
"$FIVECHECK" --dump-path -s s.xml m.xml p.mpf 2>/dev/null >a
sed '/<tools/d; s|name="mill_d16; r1"|& length_offset="109.6" radius_offset="8.05"|; s|name="BALL"|& length_offset="95.48" radius_offset="3.985"|
	s|</cutter></tool>|</cutter><edge number="2" length="89.5" diameter="15"/></tool>|' s.xml >w.xml
"$FIVECHECK" --dump-path -s w.xml m.xml p.mpf | cmp - a && echo "the same path"
echo "an internal number is not that of a tool with a name:"
sed 's/name="BALL" //; s/number="6"/number="7"/' s.xml >seven.xml
"$FIVECHECK" -q --parse-only -s seven.xml m.xml p.mpf 2>&1 | grep error:
echo "the second edge is outside of the shape:"
cp TO_TOA.INI kept.ini
for value in DP3:110.1 DP3:109.5 DP6:8.3 DP6:8.2; do
	sed "s/^.TC_${value%:*}\[1,2\]=.*/\$TC_${value%:*}[1,2]=${value#*:}/" kept.ini >TO_TOA.INI
	echo "$value"
	"$FIVECHECK" --parse-only -s s.xml m.xml p.mpf 2>&1 | grep ' D2 '
done
mv kept.ini TO_TOA.INI

echo "faults:"
fault() { # SED-SCRIPT
	sed "$1" TO_TOA.INI >bad.ini
	fivecheck import -o bad bad.ini 2>&1 | grep error:
	[ ! -e bad ] || { echo "a folder was written"; rm -r bad; }
}
fault 's/DP6.7,1./DP3[7,1]/'
fault 's/TP2.7./TP2[2]/'
fault 's/="90"/="7"/; s/TP2.7.="BALL"/TP2[7]="7"/'
fault 's/= 95.5/=95,5/'
fault 's/= 95.5/=95.5x/'
fault 's/= 95.5/=90 + 5.5/'
fault 's/= 95.5/=/'
fault 's/= 95.5/=1E999/'
fault 's/= 95.5/=5000000/'
fault 's/DP3.7,1./DP3[7]/'
fault 's/DP3.7,1./DP3[TOOL,EDGE]/'
fault 's/DP3.7,1./DP3[7.5,1]/'
fault 's/DP3.7,1./DP3[7,1/'
fault 's/="BALL"/="BALL/'
fault 's/="BALL"/=5/'
fault 's/SCP13.1,1.=0/SCP13[1,1]=0.1/'
fault 's/^METRIC/&\nINCH/'
fault 's/DP4.9,1./DP4[7,1]/'
echo "two tools of one name:"
sed 's/"BALL"/"MILL_D16; R1"/' TO_TOA.INI >twins.ini
sed 's/TO_TOA.INI/twins.ini/' s.xml >twins.xml
"$FIVECHECK" -q --parse-only -s twins.xml m.xml p.mpf 2>&1 | grep error:
sed 's/twins.ini"/& numbers="1 90"/' twins.xml >one.xml
"$FIVECHECK" -q --parse-only -s one.xml m.xml p.mpf

echo "edges below D1, and thicker ones above it:"
archive() { # FILE - standard input, with the unit and the end of an archive
	{ echo METRIC; cat; echo M17; } >"$1"
}
archive edges.toa <<'TOA'
$TC_DP1[1,1]=120 $TC_DP3[1,1]=80 $TC_DP6[1,1]=5
$TC_DP1[1,2]=120 $TC_DP3[1,2]=100 $TC_DP6[1,2]=3
$TC_DP1[1,3]=120 $TC_DP3[1,3]=70 $TC_DP6[1,3]=8 $TC_DP12[1,3]=1 $TC_DP15[1,3]=0.5
$TC_DP1[2,1]=110 $TC_DP3[2,1]=90 $TC_DP6[2,1]=4
$TC_DP1[2,2]=120 $TC_DP3[2,2]=88 $TC_DP6[2,2]=6
$TC_DP1[3,1]=110 $TC_DP3[3,1]=90 $TC_DP6[3,1]=4
$TC_DP1[3,2]=120 $TC_DP3[3,2]=80 $TC_DP6[3,2]=6
$TC_DP1[4,1]=714 $TC_DP3[4,1]=90 $TC_DP6[4,1]=4
$TC_DP1[5,2]=120 $TC_DP3[5,2]=90 $TC_DP6[5,2]=4
$TC_DP1[6,1]=120 $TC_DP3[6,1]=90 $TC_DP6[6,1]=4
$TC_DP1[6,2]=120 $TC_DP3[6,2]=85 $TC_DP6[6,2]=0
TOA
fivecheck import -o edges edges.toa
sed -n '/<tool/,$p' edges/setup.xml
setup edge.xml <<'XML'
<work_offset name="G54" Z="-200"/>
<tool number="6" length="90"><cutter><section length="90" diameter="8"/></cutter></tool>
<tools href="edges.toa" numbers="6"/>
XML
program d2.mpf <<'NC'
G17 G90 G94 G71 G40 G54
T6 M6
G0 X0 Y0 Z10 D2
S1000 M3
G1 G41 X20 Y0 F500
M30
NC
echo "the control has no radius for D2, or another one:"
"$FIVECHECK" -q --parse-only -s edge.xml m.xml d2.mpf 2>&1 | grep error:
sed 's|</cutter></tool>|</cutter><edge number="2" length="85" diameter="4"/></tool>|' edge.xml >two.xml
"$FIVECHECK" -q --parse-only -s two.xml m.xml d2.mpf 2>&1 | grep error:
echo "cut off, and the length of an adapter:"
head -c 52 edges.toa >cut.toa
fivecheck import -o bad cut.toa
echo '$TC_ADPT1[1]=25' | cat edges.toa - >adapter.toa
fivecheck import -o bad adapter.toa 2>&1 | grep error:
