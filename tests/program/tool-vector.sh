# G43.5, whose blocks give the direction of the tool by I, J and K, against G43.4 with the angles that make this
# direction (Fanuc 30i-A, A-79348E, "Tool Center Point Control for 5-Axis Machining", type 2): A about -X carries C about
# -Z, so that A and C stand the tool along (sin C sin A, -cos C sin A, cos A) of the workpiece. G68.4 tilts the plane of
# G68.2 on (B-64484EN, "Tilted Working Plane Indexing"): Euler's last angle, and a shift along the tilted axes.
machine base.xml <<'XML'
  <axis name="X" type="linear" direction="1 0 0" rate_max="6000">
    <axis name="Y" type="linear" direction="0 1 0" rate_max="6000">
      <axis name="Z" type="linear" direction="0 0 1" rate_max="6000">
        <spindle location="0 0 300" direction="0 0 -1"/>
      </axis></axis></axis>
  <axis name="A" type="rotary" direction="-1 0 0" location="0 0 50" limit_min="-120" limit_max="120" rate_max="3600">
    <axis name="C" type="rotary" direction="0 0 -1" location="10 0 0" rate_max="3600">
      <workholding location="10 0 50"/>
    </axis></axis>
XML
for way in axes vector; do
	sed "s|<base>|<controller dialect=\"fanuc\" power_on_units=\"mm\" power_on_distance=\"absolute\" power_on_plane=\"xy\" least_input=\"1\" orientation_interpolation=\"$way\"/><base>|" base.xml >$way.xml
done
sed 's| orientation_interpolation="axes"||' axes.xml >none.xml
setup s.xml <<'XML'
<work_offset name="G54" X="10" Y="-5" Z="-250"/>
<tool number="1" length="80"><cutter tip="flat"><section length="80" diameter="6"/></cutter></tool>
XML

# same NAME A B - the largest distance of the paths of two programs
same() {
	for program in "$2" "$3"; do fivecheck -q -s s.xml --dump-path axes.xml "$program.nc" >"$program.path" 2>"$program.err" || cat "$program.err"; done
	paste "$2.path" "$3.path" | awk -v name="$1" '
	NR > 1 { rows++; for (i = 4; i <= 8; i++) { d = $i - $(i + NF / 2); if (d < 0) d = -d; if (d > most) most = d } }
	END { print name ": " rows " rows, " (most < 1e-6 ? "the same to 1e-6" : "apart by " most) }'
}

# A job of 40 random directions that keep clear of the pole: the first along the tool, so that both start in the same
# way.
awk 'BEGIN {
	srand(7); d = atan2(0, -1) / 180; a = 30; c = 20
	print "G54 G0 X0. Y0. Z200. A30. C20.\nG43.4 H1 X0. Y0. Z50. F500." >"angles.nc"
	print "G54 G0 X0. Y0. Z200. A30. C20.\nG43.5 H1 X0. Y0. Z50. F500." >"vectors.nc"
	for (n = 0; n < 40; n++) {
		a += 20 * rand() - 10; if (a < 10) a = 10; if (a > 90) a = 90
		c += 60 * rand() - 30
		x = 40 * rand(); y = 40 * rand()
		printf "G1 X%.4f Y%.4f A%.9f C%.9f\n", x, y, a, c >"angles.nc"
		# The length of the vector has no effect.
		s = 0.5 + 3 * rand()
		printf "G1 X%.4f Y%.4f I%.12f J%.12f K%.12f\n", x, y, s * sin(c * d) * sin(a * d), -s * cos(c * d) * sin(a * d), s * cos(a * d) >"vectors.nc"
		# Without I, J and K the tool stays.
		print "X5." >"angles.nc"; print "X5." >"vectors.nc"
	}
	print "M30" >"angles.nc"; print "M30" >"vectors.nc"
}'
same "40 directions" angles vectors

program plane.nc <<'NC'
G54 G0 X0. Y0. Z200. C100.
G68.2 X20. Y30. Z40. I30. J70. K15.
G53.1
G43 H1 X1. Y2. Z3.
NC
program more.nc <<'NC'
G54 G0 X0. Y0. Z200. C100.
G68.2 X20. Y30. Z40. I30. J70.
G68.4 X0. Y0. Z7. K15.
G53.1
G43 H1 X1. Y2. Z-4.
NC
same "G68.4" plane more

for machine in none vector; do
	program p.nc <<'NC'
G54 G0 X0. Y0. Z200. A30.
G43.5 H1 X0. Y0. Z50.
G1 X5. I1. K1. F100.
NC
	fivecheck -q -s s.xml $machine.xml p.nc 2>&1 | head -n 1
done
bad() {
	printf 'G54 G0 X0. Y0. Z200. A30.\nG43.5 H1 X0. Y0. Z50.\n%s\n' "$1" >bad.nc
	fivecheck -q -s s.xml axes.xml bad.nc 2>&1 | head -n 1
}
bad 'G1 X5. A20. F100.'
bad 'G1 X5. I0. J0. K0. F100.'
bad 'G2 X5. I2.5 F100.'
bad 'G53 X5. K1.'
bad 'G1 X5. K1. Q2. F100.'
bad 'G1 X5. K-1. F100.'
bad 'G68.4 X0. Y0. Z0. I10.'
