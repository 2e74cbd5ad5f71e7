# <tools href=""/>: a setup takes tools and offsets straight from the files of other programs. A check with such a setup
# is the same as one with the tools written out.
small_machine
cat >library.json <<'JSON'
{"version": 2, "data": [
 {"type": "flat end mill", "unit": "millimeters", "description": "D10", "geometry": {"DC": 10, "LB": 30, "LCF": 20, "SFDM": 10},
  "post-process": {"number": 1}, "holder": {"unit": "millimeters", "gaugeLength": 40, "segments": [
   {"height": 40, "lower-diameter": 40, "upper-diameter": 50}]}},
 {"type": "ball end mill", "unit": "inches", "geometry": {"DC": 0.25, "LB": 1, "LCF": 0.5, "SFDM": 0.25},
  "post-process": {"number": 12}, "holder": {"unit": "inches", "gaugeLength": 2, "segments": [
   {"height": 2, "lower-diameter": 1.5, "upper-diameter": 1.5}]}},
 {"type": "turning general", "unit": "millimeters", "geometry": {}, "post-process": {"number": 30}}
]}
JSON
program cut.nc <<'NC'
G21 G90 G54
T1 M6
G43 G0 Z20.
X10.
Z-45.
M2
NC
mkdir sub
mv library.json sub/
setup s.xml <<'XML'
<work_offset name="G54" Z="-60"/>
<tools href="sub/library.json"/>
XML
fivecheck import -o written sub/library.json 2>/dev/null
echo "the same pairs and findings as with the tools written out:"
sed 's/<!-- TODO.*/<work_offset name="G54" Z="-60"\/>/' written/setup.xml >w.xml
"$FIVECHECK" --list-pairs -s s.xml m.xml >a
"$FIVECHECK" --list-pairs -s w.xml m.xml >b
cmp a b && grep -c '^[^	]*	T' a
findings -s s.xml m.xml cut.nc | tee a
findings -s w.xml m.xml cut.nc | cmp - a
echo "the file is named with its digest, in make's rule, and as a dependency of the input root:"
"$FIVECHECK" -q -f ndjson -o result --depfile rule -s s.xml m.xml cut.nc
grep -o '{"kind":"tools"[^}]*"' result | sed 's/[0-9a-f]\{64\}/DIGEST/'
grep -c 'sub/library.json' rule
mkdir root
cp -R cut.nc m.xml s.xml head.stl table.stl root
sed 's/sub/..\/sub/' s.xml >root/s.xml
"$FIVECHECK" -q --input-root root -s root/s.xml root/m.xml root/cut.nc
"$FIVECHECK" -q -o sub/library.json -s s.xml m.xml cut.nc 2>&1 | sed "s|$PWD|.|"
echo "chosen numbers:"
chosen() { # NUMBERS
	sed "s|json\"|json\" numbers=\"$1\"|" s.xml >n.xml
	"$FIVECHECK" --list-pairs -s n.xml m.xml 2>&1 | sed -n 's/^[^	]*	\(T[0-9]*\) cutter.*/\1/p; /error:/p' | sort -u
}
chosen 12
chosen '1 10-20'
chosen '1 30'
chosen '5-3'
chosen '0'
chosen 'one'
echo "a number that the setup has already:"
sed 's|<tools|<tool number="1" length="50"><cutter><section length="50" diameter="6"/></cutter></tool><tools|' s.xml >n.xml
"$FIVECHECK" --list-pairs -s n.xml m.xml 2>&1 | grep error:
echo "a tool that the library has, but a setup cannot:"
sed 's/T1 /T30 /' cut.nc >turn.nc
"$FIVECHECK" -q -s s.xml m.xml turn.nc 2>&1 | grep error:

echo "a table of tools, CSV:"
table() { # UNITS
	setup t.xml <<-XML
	<work_offset name="G54" Z="-60"/>
	<tools href="t.csv" $1/>
	XML
	"$FIVECHECK" --list-pairs -s t.xml m.xml 2>&1 >pairs | grep -v '^ '
	cut -f 2 pairs | grep '^T' | sort -u | tr '\n' ' '
	echo
}
cat >t.csv <<'CSV'
Number,Name,Type,Length,Diameter,Flute length,Shank diameter,Stickout,Holder diameter,Corner radius,Point angle,Tip diameter,Price
1,"mill, ""flat""",flat,70,10,20,10,30,40,,,,12.50
2,ball,ball,70,6,15,6,30,40
3,,bull,70,10,,,30,40,2
4,,drill,100,8.5,60,10,70,40,,118
5,,chamfer,60,10,6,10,30,40,,90,1
6,,probe,150,6,,4,50,30
CSV
table
sed 's/,/;/g; s/12.50/12,50/; s/8.5/8,5/; s/mill;/mill,/' t.csv >t2.csv
cp pairs first
mv t2.csv t.csv
table >/dev/null
cmp pairs first
fivecheck import -o csv t.csv
sed -n '/number="4"/,/<.tool>/p; /number="5"/,/<.tool>/p' csv/setup.xml
printf 'number\tlength\tdiameter\tunits\n1\t2\t0.5\tinch\n' >t.csv
table 'units="inch"'
fivecheck import -o inch t.csv 2>/dev/null
grep '<tool \|<section' inch/setup.xml
bad() { # TEXT
	printf "$1" >t.csv
	table
}
bad 'number,length,diameter\n1,70\n'
bad 'number,length,diameter\n1.5,70,10\n'
bad 'number,length,diameter\n1,70,10\n1,80,10\n'
bad 'number,length,diameter\n1,70,nan\n'
bad 'number,length,diameter\n1,1e300,10\n'
bad 'number,length,diameter,number\n1,70,10,1\n'
bad 'number,length,diameter,units\n1,70,10,ell\n'
bad 'number,length,diameter,type\n1,70,10,dovetail\n'
bad 'number,length,diameter,type\n1,70,10,drill\n'
bad 'number,name,diameter,length\n1,"open,10,70\n'
# Data that would make a different tool, or one that cuts more.
bad 'number,length,diameter,stickout,shank_diameter\n1,70,6,40,12\n'
bad 'number,type,length,diameter\n1,bull,70,10\n'
bad 'number,type,length,diameter,corner_radius\n1,flat,70,10,2\n'
bad 'number,type,length,diameter,corner_radius\n1,ball,70,10,2\n'
bad 'number,type,length,diameter,flute_length,point_angle\n1,flat,70,10,20,118\n'
bad 'number,length,diameter,Holder diameter (mm)\n1,70,10,50\n'
# A decimal comma between commas shifts the cells: the length would be 120 and the diameter 5.
bad 'number,type,length,diameter\n1,flat,120,5,10\n'
bad 'number,length,diameter,stickout,holder_diameter\n1,70,10,80,40\n'
bad 'number,length,diameter\r1,70,10\r2,70,ten\r'
bad 'number;length;diameter\n1;70;10;7\n'
echo "a table of Excel, with the separator in its first line:"
printf 'sep=;\r\nnumber;length;diameter;name\r\n1;70,5;10;"a, b"\r\n' >t.csv
fivecheck import -o excel t.csv
grep '<tool ' excel/setup.xml
echo "tables with other column names:"
printf 'Nummer;L\303\244nge;Durchmesser\n1;70;10\n' >german.csv
fivecheck import -o german german.csv
sed 's/t.csv/german.csv/' t.xml >german.xml
"$FIVECHECK" --parse-only -s german.xml m.xml cut.nc
printf 'number,length,diameter,Unit,\n1,2,0.5,inch,,\n' >t.csv
fivecheck import -o unit t.csv 2>/dev/null
grep '<tool ' unit/setup.xml

echo "the tool table of a control: lengths for the tools that the setup describes"
cat >tool.tbl <<'TBL'
;pocket and comment
T1 P1 Z+68.5 D10 ;end mill
T12 P2 D6.35 Z+75.946 X0 Q0

T99 P9 Z1
TBL
setup tbl.xml <<'XML'
<work_offset name="G54" Z="-60"/>
<tools href="sub/library.json"/>
<tools href="tool.tbl"/>
XML
"$FIVECHECK" --dump-path -s tbl.xml m.xml cut.nc | cut -f 3-5
sed -i 's/T12 P2 D6.35/T12 P2 D6/' tool.tbl
"$FIVECHECK" --parse-only -s tbl.xml m.xml cut.nc 2>&1 | grep warning:
sed -i 's/X0 Q0/X0.1/' tool.tbl
"$FIVECHECK" -q --parse-only -s tbl.xml m.xml cut.nc
# A line of a tool that the setup does not take, and T0, the empty spindle.
sed 's/tool.tbl"/tool.tbl" numbers="1 99"/' tbl.xml >some.xml
printf 'T0 P0 Z0 D0 ; no tool\n' >>tool.tbl
"$FIVECHECK" -q --parse-only -s some.xml m.xml cut.nc && echo "T0 and T12 do not matter"
printf 'T0 P0 Z5 ; no tool\n' >tool.tbl
"$FIVECHECK" -q --parse-only -s tbl.xml m.xml cut.nc
printf 'P1 Z1\nT1 P2 Z2\n' >tool.tbl
"$FIVECHECK" -q --parse-only -s tbl.xml m.xml cut.nc
printf 'T1 P1 Z1\nT1 P2 Z2\n' >tool.tbl
"$FIVECHECK" -q --parse-only -s tbl.xml m.xml cut.nc
printf 'T1 P1 Z1 D\n' >tool.tbl
"$FIVECHECK" -q --parse-only -s tbl.xml m.xml cut.nc
printf 'T1 P1 Z10 D10\n' >tool.tbl
fivecheck import --units inch -o tbl tool.tbl
grep TODO tbl/setup.xml

echo "a listing of offsets:"
cat >offsets.nc <<'NC'
%
O9999 (OFFSETS)
G90 G21
N1 G10 L2 P0 X0. Y0. Z0.
G10 L2 P1 X-1. Y0. Z-2.5 C30.
G10 L20 P3 X5.
G10 L10 P1 R70.
G10 L11 P1 R-.5
G10 L12 P1 R10.
G10 L13 P1 R0
M30
%
NC
setup off.xml <<'XML'
<tools href="sub/library.json"/>
<tools href="offsets.nc"/>
XML
sed 's/G43/G43 H1/' cut.nc >cut-h.nc
"$FIVECHECK" --dump-path -s off.xml m.xml cut-h.nc
sed 's/<base>/<controller dialect="fanuc" cutter_comp_d="diameter"><tool_change\/><\/controller><base>/' m.xml >mf.xml
"$FIVECHECK" --dump-path -s off.xml mf.xml cut-h.nc | cut -f 3-6
fivecheck import -o off offsets.nc
sed 1,3d off/setup.xml
listing() { # LINE
	printf 'G10 L10 P2 R1.\n%s\n' "$1" >offsets.nc
	"$FIVECHECK" -q --parse-only -s off.xml mf.xml cut-h.nc 2>&1 | grep -m 1 error:
}
listing 'G10 L10 P1 R70'
listing 'G10 L2 P0 X1.'
listing 'G10 L2 P7 X1.'
listing 'G10 L10 P2 R2.'
listing 'G91 G10 L10 P1 R1.'
listing 'G0 X5.'
listing 'X5.'
listing 'G10 L3'
listing 'M98 P100'
listing 'G10 L2 P1 X1. X2.'
listing 'G10 L2 P1 X1. R30.'
listing 'G10 L1 P1 R5. Z70.'
echo "files that are not there, are none, or are no files:"
href() { # HREF
	setup h.xml <<-XML
	<tools href="$1"/>
	XML
	"$FIVECHECK" -q --parse-only -s h.xml m.xml cut.nc 2>&1 | sed "s|$PWD|.|"
}
href gone.json
href .
href cut.nc
href head.stl
href https://example.org/library.json
href ''
ln -s loop loop
href loop
mkfifo pipe
href pipe
printf '[[[[' >deep.json
href deep.json
awk 'BEGIN { for (i = 0; i < 100000; i++) printf "["; for (i = 0; i < 100000; i++) printf "]" }' >deep.json
href deep.json 2>&1 | cut -c 1-90
printf '{"data": [{"type": "flat end mill", "unit": "millimeters", "geometry": {"DC": 1e999}}]}' >deep.json
href deep.json
