# Fanuc's G68.2, G53.1 and G43.4, and Haas' G234, from the program to --dump-path: the tip, put back into the workpiece
# by the trunnion's own geometry (A about -X at Y0 Z50 carries C about -Z at X10 Y0), is where the program has it.
# B-64484EN, tilted working plane indexing, tool center point control; Haas mill operator's manual, G234.
machine base.xml <<'XML'
  <axis name="X" type="linear" direction="1 0 0" rate_max="6000">
    <axis name="Y" type="linear" direction="0 1 0" rate_max="6000">
      <axis name="Z" type="linear" direction="0 0 1" rate_max="6000">
        <spindle location="0 0 300" direction="0 0 -1"/>
      </axis></axis></axis>
  <axis name="A" type="rotary" direction="-1 0 0" location="0 0 50" limit_min="-120" limit_max="30" rate_max="3600">
    <axis name="C" type="rotary" direction="0 0 -1" location="10 0 0" rate_max="3600">
      <workholding location="10 0 50"/>
    </axis></axis>
XML
for dialect in fanuc haas; do
	sed "s|<base>|<controller dialect=\"$dialect\" power_on_units=\"mm\" power_on_distance=\"absolute\" power_on_plane=\"xy\" least_input=\"1\"/><base>|" base.xml >$dialect.xml
done
setup s.xml <<'XML'
<work_offset name="G54" X="10" Y="-5" Z="-250"/>
<tool number="1" length="80"><cutter tip="flat"><section length="80" diameter="6"/></cutter></tool>
XML

# tips LENGTH - the tip of each row of the path, and the direction of the tool, as the workpiece has them
tips() {
	awk -v length_="$1" '
	NR > 1 {
		d = atan2(0, -1) / 180
		x = $4 - 10; y = $5; z = $6 + 300 - length_ - 50
		# The table turned by A about -X and C about -Z: back about +X, then about +Z.
		ca = cos($7 * d); sa = sin($7 * d); cc = cos($8 * d); sc = sin($8 * d)
		y1 = ca * y - sa * z; z1 = sa * y + ca * z
		x2 = cc * x - sc * y1; y2 = sc * x + cc * y1
		# From the work offset; the tool along Z back in the workpiece.
		printf "line %d: %.6f %.6f %.6f tool %.9f %.9f %.9f\n", $1, x2, y2 + 5, z1,
		       sc * sa, -cc * sa, ca
	}' path
}

program plane.nc <<'NC'
G54 G0 X0. Y0. Z200. C100.
G68.2 X20. Y30. Z40. I30. J70. K15.
G53.1
G43 H1 X1. Y2. Z3.
G1 X-4. Y5. Z6. F600.
NC
fivecheck -q -s s.xml --dump-path fanuc.xml plane.nc >path
echo "G68.2: A and C $(awk 'NR == 3 { printf "%.9f %.9f", $7, $8 }' path)"
tips 80 | tail -n 2
awk 'BEGIN {
	d = atan2(0, -1) / 180
	n = split("4 1 2 3 5 -4 5 6", p, " ")
	for (i = 1; i <= n; i += 4) {
		x = cos(15 * d) * p[i + 1] - sin(15 * d) * p[i + 2]; y = sin(15 * d) * p[i + 1] + cos(15 * d) * p[i + 2]
		y1 = cos(70 * d) * y - sin(70 * d) * p[i + 3]; z1 = sin(70 * d) * y + cos(70 * d) * p[i + 3]
		printf "means %d: %.6f %.6f %.6f tool %.9f %.9f %.9f\n", p[i], cos(30 * d) * x - sin(30 * d) * y1 + 20,
		       sin(30 * d) * x + cos(30 * d) * y1 + 30, z1 + 40, sin(30 * d) * sin(70 * d),
		       -cos(30 * d) * sin(70 * d), cos(70 * d)
	}
}'

for dialect in fanuc haas; do
	on=G43.4
	[ $dialect = haas ] && on=G234
	program tcp.nc <<NC
G54 G0 X0. Y0. Z200.
$on H1 X1. Y2. Z3. A-30. C45.
G1 X11. Y22. Z33. A20. C-80. F600.
NC
	fivecheck -q -s s.xml --dump-path $dialect.xml tcp.nc >path
	echo "$on: $(($(wc -l <path) > 10)) $(tips 80 | awk '$2 == "2:"' | tail -n 1)"
	tips 80 | awk '
	# From (1 2 3) to (11 22 33) on a line.
	$2 == "3:" {
		u = ($3 - 1) / 10
		if (($4 - 2 - 20 * u) ^ 2 + ($5 - 3 - 30 * u) ^ 2 > 1e-9) print "off the line:", $0
		last = $0
	}
	END { print last }'
done
fivecheck -s s.xml --parse-only fanuc.xml plane.nc 2>&1 >/dev/null | grep G53.1
