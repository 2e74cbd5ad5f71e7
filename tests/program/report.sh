# A report against the other outputs of the same check, read by an independent decoder (report_data.py).
need python3
check() {
	python3 "$(dirname "$LIB")/report_data.py" "$@"
}
small_machine
sphere knob 15 12
sed -i 's|<body name="head" mesh="head.stl"/>|<body name="head" mesh="head.stl"/><body name="knob" mesh="knob.stl" location="30 5 110"/>|' m.xml
program a.nc <<'NC'
(a comment)
G0 X10 C45
G1 X-12.345 Z-30 F600
G4 P2
G1 X5 Z-92 C90
G2 X15 Z-92 I5 K0 G18
G1 Z-120 F600
G0 Z0
NC
fivecheck -q m.xml a.nc >plain.txt
fivecheck -q --report=a.html m.xml a.nc >with.txt
cmp plain.txt with.txt
cmp plain.txt - <<TEXT
$(fivecheck -q --report=j.html -j 3 m.xml a.nc)
TEXT
cmp a.html j.html
test "$(fivecheck -q -a m.xml a.nc)" = "$(fivecheck -q -a --report=all.html m.xml a.nc)"
# The picture rings the contact, and again in the inset that enlarges it.
fivecheck -q --picture=a.svg m.xml a.nc >/dev/null
test "$(grep -o '<circle' a.svg | wc -l)" = 4
# Bodies that move with an axis past its limit are red.
printf 'G1 F600 X9000\n' | program limit.nc
fivecheck -q --picture=limit.svg m.xml limit.nc | grep -q 'X leaves its travel'
grep -q 'fill="#8e0d14"' limit.svg
fivecheck -q -f ndjson=a.ndjson --pose=a.stl m.xml a.nc
fivecheck --clearance-report=a.csv --report=sharp.html -q m.xml a.nc >/dev/null
check sharp.html sharp=a.csv
check a.html policy findings=a.ndjson pose=a.stl contact clearance=a.csv code=a.nc planes \
	"text=knob (Z) meets table (C)"

# A long program comes as near as 2 mm, later goes far away and back again.
awk 'BEGIN { for (i = 1; i <= 3000; i++) printf "G1 F6000 X%.3f Z%.3f C%d\n", i % 20, -90 + 3 * cos(i / 10) + (i > 1500 ? i / 1000 : 0), i % 7 }' >long.nc
fivecheck -q --report=long.html -o /dev/null m.xml long.nc
fivecheck -q --clearance-report=long.csv -o /dev/null m.xml long.nc
check long.html long-clearance=long.csv

# A program that starts too close: nothing is proved for its first block, whose clearance is measured.
box post -40 -20 90 -24 20 210
sed 's|<axis name="X"|<body name="post" mesh="post.stl"/>&|' m.xml >near.xml
printf 'G1 F6000 X40 C45\nC90\nX90\n' >near.nc
status fivecheck -q -a -o /dev/null --clearance=5 --report=near.html near.xml near.nc
status fivecheck -q -a -o /dev/null --clearance=5 --clearance-report=near.csv near.xml near.nc
check near.html clearance=near.csv

# Cutter and part are not kept apart: in the block where the cutter is too deep the curve still falls to 0.
box block -30 -30 0 30 30 20
setup deep.xml <<'XML'
  <work_offset name="G54" Z="-100"/>
  <part name="block" mesh="block.stl" gouge="0.2"/>
  <tool number="1" length="60"><cutter><section length="60" diameter="10"/></cutter></tool>
XML
printf 'T1 M6\nM3 S1000\nG0 X-60\nG43 H1 Z60\nZ20\nG1 X60 F1000\nZ30\nX0\nZ10\nZ40\nG0 X-60\nZ10\nX60\n' >deep.nc
status fivecheck -q -a -o /dev/null --report=deep.html -s deep.xml m.xml deep.nc
check deep.html curve
# The label of a bound in a long program, where not every block is measured, and in a short one.
caption() {
	grep -o 'clear; smallest[^<]*' "$1" | sed 's/line [0-9]*/line N/; s/[0-9.]* mm/D mm/g; q'
}
caption long.html
sed -n 1,9p long.nc >short.nc
fivecheck -q --report=short.html -o /dev/null m.xml short.nc
caption short.html
grep -c '^short.nc: clear; smallest.*</figcaption>' short.html
fivecheck -q --report=nearest.html --clearance-report=nearest.csv -o /dev/null m.xml short.nc
check nearest.html smallest=nearest.csv
# The same in a subprogram.
{ echo 'o<down> sub'; sed -n 4,5p short.nc; echo 'o<down> endsub'; echo 'M2'; } >down.ngc
printf 'G0 Z0\no<down> call\nG0 Z0\nM2\n' >calls.nc
fivecheck -q --report=calls.html --clearance-report=calls.csv -o /dev/null m.xml calls.nc
check calls.html smallest=calls.csv
caption calls.html

# Straight moves have one row each in --dump-path and here, whatever the tolerance.
program b.nc <<'NC'
G0 X10 C45
G1 X-12.345 Z-30 F600
G4 P2
G1 X5 Z-92 C90
M2
NC
status fivecheck -q --report=b.html m.xml b.nc
fivecheck --dump-path m.xml b.nc >b.tsv
check b.html policy path=b.tsv code=b.nc text=clear

# Without the program's text.
fivecheck -q --report=none.html --report-code=none m.xml b.nc >/dev/null
check none.html code=b.nc
grep -c 'G1 X-12.345' none.html

# Several programs: an index and one report each; equal names, and names that are not valid as file names.
mkdir p 'p/q & <b>'
cp a.nc p/a.nc
cp b.nc 'p/q & <b>/b b.nc'
status fivecheck -q -j 2 --report=all.html m.xml a.nc p/a.nc 'p/q & <b>/b b.nc' | grep status
ls all*.html
grep -o 'href="[^"]*"' all.html
grep -c '<b>/b' all.html
check all-a-2.html policy "text=p/a.nc"
check all-b_b.html policy "text=p/q & <b>/b b.nc"


# A report with a name derived from a program must not overwrite an input or another output.
cp a.nc o-b.html
status fivecheck -q --report=o.html m.xml b.nc o-b.html 2>&1
cmp a.nc o-b.html
status fivecheck -q --report=o.html -f ndjson=o-a.html m.xml a.nc b.nc 2>&1
status fivecheck -q --report='i "<x>&.html' m.xml a.nc b.nc >/dev/null 2>&1
grep -o 'href="[^"]*"' 'i "<x>&.html'
