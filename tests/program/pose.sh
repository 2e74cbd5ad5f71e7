# All bodies in their positions at the first finding: head down, table turned by 45 degrees; 24 triangles.
small_machine
program a.nc <<'NC'
G0 C45
G1 Z-120 F600
NC
program clear.nc <<'NC'
G0 C45
NC
fivecheck -q --pose pose.stl m.xml clear.nc a.nc >/dev/null
echo "status $?"
wc -c <pose.stl
# bounds FILE FIRST LAST - of these triangles. Skip the header, then 50 bytes a triangle: 12 floats and two bytes.
bounds() {
	for i in $(seq "$2" "$3"); do
		od -An -v -tf4 -w12 -j $((84 + 50 * i + 12)) -N 36 "$1"
	done | awk '
		{ for (k = 1; k <= 3; k++) { if (NR == 1 || $k < lo[k]) lo[k] = $k; if (NR == 1 || $k > hi[k]) hi[k] = $k } }
		END { printf "X %.2f %.2f Y %.2f %.2f Z %.2f %.2f\n", lo[1], hi[1], lo[2], hi[2], lo[3], hi[3] }'
}
od -An -v -tu1 -w1 -j 80 -N 4 pose.stl | tr -d ' \n'
echo
bounds pose.stl 0 23
# The blank is one more solid, drawn complete on the rotated table, although the cutter has removed its top.
setup s.xml <<'XML'
  <work_offset name="G54" Z="-100"/>
  <stock box="20 20 30" location="30 0 0"/>
  <tool number="1" length="20"><cutter><section length="20" diameter="40"/></cutter></tool>
XML
program cut.nc <<'NC'
T1 M6
G43 H1
M3 S1000
G0 X70
G0 Z25
G1 X30 F600
G0 X70
G0 C45
G0 Z10
G0 X25
NC
fivecheck -q --pose cut.stl -s s.xml m.xml cut.nc | sed -n 's/ *\[.*//; 1p'
bounds cut.stl 24 35
status fivecheck --pose none.stl -f ndjson m.xml clear.nc 2>&1 | grep none.stl
ls none.stl 2>/dev/null
status fivecheck -q --pose nowhere/pose.stl m.xml a.nc | tail -n 1
# A file that cannot be written is reported before the check, also if there will be no finding.
status fivecheck -q --pose nowhere/pose.stl m.xml clear.nc
