# The tool table of a Heidenhain control (TOOL.T): values for tools of other libraries, and tools as far as it describes
# them.
stock_mill
sed -i 's|<base>|<controller dialect="klartext" path_tolerance="0.01"><tool_change/></controller><base>|' m.xml

# table FILE - the lines of standard input, columns separated by bars, as a table with columns of fixed widths
table() {
	awk -F '|' 'BEGIN { split("8 18 12 12 12 10 10 10 9 12 8 8", width, " ") }
	NF < 2 { print; next }
	{
		line = ""
		for (i = 1; i <= NF; i++)
			line = line sprintf("%-" width[i] "s", $i)
		sub(/ *$/, "", line)
		print line
	}' >"$1"
}
tool_table() { # FILE
	table "$1" <<'TABLE'
BEGIN TOOL .T MM
; written by the control
T|NAME|L|R|R2|DL|DR|DR2|TYP|LCUTS|T-ANGLE|DOC
0|NULL|+0|+0|+0|+0|+0|+0|0|+0|+0|
3|||||||||||
5|BOHRER D8,5|+120.25|+4.25|+0|+0|-0.01|+0|DRILL|60|118|fuer Kuehlung
5.1|STUFE|+100|+6|+0|+0|+0|+0|0|+0|+0|
7|KUGEL D8|+95.5|+4|+4|-0.02|-0.015|+0|22|12|+0|
8|TORUS D16 R1|+99.5|+8|+1|+0.1|+0.05|-0.1|0|20|+0|
9|TASTER|+150|+2|+2|+0|+0|+0|21|+0|+0|
10|FR D8, ohne R|+99.5|+0|+0|+0|-0.05|+0|0|30|+0|
11|MESSER|-12|+4|+0|+0|+0|+0|0|+0|+0|
12|WENDEPLATTE|+88|+20|+0|+0|+0|+0|0|+0|+0|
[END]
TABLE
}
tool_table TOOL.T
echo "tools of a table:"
fivecheck import -o new TOOL.T
sed 1,3d new/setup.xml
"$FIVECHECK" --list-pairs -s new/setup.xml m.xml >/dev/null && echo "a check accepts them"
mkdir sub
same() { # TEXT SED-SCRIPT - the changed table is imported as the same tools
	sed "$2" TOOL.T >sub/TOOL.T
	fivecheck import -o sub/new sub/TOOL.T >said 2>&1
	cmp sub/new/setup.xml new/setup.xml && echo "$1"
	rm -r sub/new
}
same "with the line ends of Windows" 's/$/\r/'
same "with decimal commas" '/^[5-9]/s/\.\([0-9]* \)/,\1/g'
same "with a version" "s/ MM/ MM Version: 'Update:150.21' U/"
same "without a unit" 's/ MM//'
grep 'unit' said
same "with another letter in Latin-1" 's/fuer K/fuer \xfc/'
# A name with a letter that has one byte in Latin-1 and two in UTF-8: the columns count letters.
sed 's/KUGEL D8  /K\xc3\xbcGEL D8  /' TOOL.T >utf.t
sed 's/KUGEL D8  /K\xfcGEL D8  /' TOOL.T >latin.t
for name in utf latin; do
	fivecheck import -o $name $name.t 2>/dev/null
	grep -o 'name="K.*' $name/setup.xml
done
table inch.t <<'TABLE'
BEGIN WERKZEUG.T INCH
T|NAME|L|R
1|E_INCH|+4|+.25
[END]
TABLE
fivecheck import -o inch inch.t 2>/dev/null
sed -n '/<tool/,/<.tool>/p' inch/setup.xml

echo "values for tools that the setup describes:"
cat >tools.json <<'JSON'
{"version": 2, "data": [
 {"type": "drill", "unit": "millimeters", "geometry": {"DC": 8.5, "LB": 80, "LCF": 60, "SFDM": 8.5, "SIG": 118},
  "post-process": {"number": 5}, "holder": {"unit": "millimeters", "gaugeLength": 40.25, "segments": [
   {"height": 40.25, "lower-diameter": 40, "upper-diameter": 50}]}},
 {"type": "ball end mill", "unit": "millimeters", "description": "8 mm", "geometry": {"DC": 8, "LB": 40, "LCF": 12, "SFDM": 8},
  "post-process": {"number": 7}, "holder": {"unit": "millimeters", "gaugeLength": 55.5, "segments": [
   {"height": 55.5, "lower-diameter": 40, "upper-diameter": 50}]}},
 {"type": "flat end mill", "unit": "millimeters", "geometry": {"DC": 12, "LB": 40, "LCF": 12, "SFDM": 12},
  "post-process": {"number": 10}, "holder": {"unit": "millimeters", "gaugeLength": 56, "segments": [
   {"height": 56, "lower-diameter": 40, "upper-diameter": 50}]}}
]}
JSON
setup s.xml <<'XML'
<work_offset name="G54.1 P1" Z="-200"/>
<tools href="tools.json"/>
<tool number="500" name="5.1" length="120.25"><cutter><section length="120.25" diameter="12"/></cutter></tool>
<tools href="TOOL.T" numbers="1-9"/>
XML
program p.h <<'NC'
0 BEGIN PGM P MM
1 CYCL DEF 247 DATUM SETTING Q339=+1 ;DATUM NUMBER
2 TOOL CALL "BOHRER D8,5" Z S1000
3 L X+0 Y+0 Z+10 R0 FMAX
4 TOOL CALL 5.1 Z S1000
5 L Z+10 R0 FMAX
6 TOOL CALL "KUGEL D8" Z S1000 DL+0.5
7 L Z+10 R0 FMAX
8 L X+20 Y+0 RL F500
9 L X+50
10 L X+60 Y+0 R0
11 M30
12 END PGM P MM
NC
"$FIVECHECK" --dump-path -s s.xml m.xml p.h | cut -f 1,3-6
echo "the same with the values written out:"
"$FIVECHECK" --dump-path -s s.xml m.xml p.h >a
fivecheck import -o tools tools.json 2>/dev/null
sed 's|<tool number="5" |&name="BOHRER D8,5" radius_offset="4.24" |; s|<tool number="7" name="8 mm"|<tool number="7" name="KUGEL D8" length_offset="95.48" radius_offset="3.985"|
	s|<!-- TODO.*|<work_offset name="G54.1 P1" Z="-200"/><tool number="500" name="5.1" length="120.25" length_offset="100"><cutter><section length="120.25" diameter="12"/></cutter></tool>|' \
	tools/setup.xml >w.xml
"$FIVECHECK" --dump-path -s w.xml m.xml p.h | cmp - a && echo "the same path"
echo "all rows: a radius that is not that of the shape"
sed 's/ numbers="1-9"//' s.xml >all.xml
"$FIVECHECK" -q --dump-path -s all.xml m.xml p.h | cmp - a
sed 's/+4          +4  /+3          +3  /' TOOL.T >thin.t
sed 's/TOOL.T/thin.t/' s.xml >thin.xml
"$FIVECHECK" --parse-only -s thin.xml m.xml p.h 2>&1 | grep "has the radius"
echo "radius compensation with a radius of 0 or less:"
sed 's/"KUGEL D8"/10/' p.h >zero.h
"$FIVECHECK" -q --parse-only -s all.xml m.xml zero.h 2>&1 | grep error:
echo "a tool without a shape:"
sed 's/"KUGEL D8"/"TASTER"/' p.h >bare.h
"$FIVECHECK" -q --parse-only -s s.xml m.xml bare.h 2>&1 | grep error:
echo "the setup has another length than the table:"
sed 's/length="120.25"/& length_offset="99"/' s.xml >other.xml
"$FIVECHECK" -q --parse-only -s other.xml m.xml p.h 2>&1 | grep error:

echo "faults:"
fault() { # SED-SCRIPT
	sed "$1" TOOL.T >bad.t
	fivecheck import -o bad bad.t 2>&1 | grep error:
	[ ! -e bad ] || { echo "a folder was written"; rm -r bad; }
}
fault 's/^7 /5 /'
fault 's/^5.1/5.12/'
fault 's/^7 /x7/'
fault 's/^7    /33000/'
fault 's/+95.5 /+9.5.5/'
fault 's/+95.5    /+1234567/'
fault 's/+95.5/inf  /'
fault 's/+95.5/     /'
fault 's/^0       NULL              +0/0       NULL              +5/'
fault 's/^7       /7   /'
fault 's/KUGEL D8          +95.5/KUGEL D8      95.5/'
fault 's/^7       KUGEL/7	KUGEL/'
fault 's/NAME  /NAME	/'
fault 's/DR2 /DR  /'
fault 's/^T   /X   /'
fault '/END/d'
fault 's/END/&]\n9/'
head -c 400 TOOL.T >bad.t
fivecheck import -o bad bad.t 2>&1 | grep error:
printf 'BEGIN PRESET.PR MM\nNO X Y Z\n0 1 2 3\n[END]\n' >bad.t
fivecheck import -o bad bad.t
table other.t <<'TABLE'
BEGIN TOOL.T MM
T|NAME|L|R|R2|DL|DR|DR2|TYP
5.1|STUFE|+100|+6|+0|+0|+0|+0|0
5|BOHRER|+120.25|+4.25|+0|+0|+0|+0|1
6|DREHEN|+40|+3|+0|+0|+0|+0|29
[END]
TABLE
echo "a turning tool:"
sed '/^5.1/d' other.t >turn.t
fivecheck import -o turn turn.t 2>&1 | grep left
grep -c '<tool' turn/setup.xml
cat >turn.xml <<'XML'
<setup version="1" units="mm"><work_offset name="G54.1 P1" Z="-200"/>
<tool number="6" length="90"><cutter><section length="90" diameter="6"/></cutter></tool><tools href="turn.t"/></setup>
XML
printf '0 BEGIN PGM P MM\n1 TOOL CALL 6 Z S1000\n2 L Z+300 R0 FMAX M91\n3 END PGM P MM\n' >turn.h
"$FIVECHECK" -q --parse-only -s turn.xml m.xml turn.h
echo "L and R without DL and DR, where they are 0 and where not:"
for tool in '"BOHRER D8,5"' '"KUGEL D8"'; do
	printf '%s\n' '0 BEGIN PGM P MM' "1 TOOL CALL $tool Z S1000" '2 FN 18: SYSREAD Q1 = ID50 NR2' \
		'3 FN 18: SYSREAD Q2 = ID50 NR1' '4 L X+Q1 R0 FMAX' '5 L X+Q2 R0 FMAX' '6 END PGM P MM' >read.h
	sed 's/-0.01     /+0        /' TOOL.T >zero.t
	sed 's/TOOL.T/zero.t/' s.xml >read.xml
	"$FIVECHECK" -q --parse-only -s read.xml m.xml read.h 2>&1 | cut -c 1-110
done
echo "a row with an index before its tool:"
fivecheck import -o bad other.t
