# Closed forms with a rotary table: a plane cut at B30, and a flank cut at B90, touch a cutter at B0 at the right
# height.
machine m.xml <<'XML'
  <axis name="X" type="linear" direction="1 0 0" limit_min="-300" limit_max="300" rate_max="6000">
    <axis name="Y" type="linear" direction="0 1 0" limit_min="-300" limit_max="300" rate_max="6000">
      <axis name="Z" type="linear" direction="0 0 1" limit_min="-300" limit_max="300" home="100" rate_max="6000">
        <spindle location="0 0 100" direction="0 0 -1"/>
      </axis>
    </axis>
  </axis>
  <axis name="B" type="rotary" direction="0 1 0" location="0 0 0" limit_min="-180" limit_max="180" rate_max="3600">
    <workholding location="0 0 0"/>
  </axis>
XML
setup s.xml <<'XML'
  <work_offset name="G54" X="0" Y="0" Z="-100"/>
  <stock box="40 30 20"/>
  <tool number="1" length="100">
    <shank><section length="55" diameter="6"/></shank>
    <cutter><section length="45" diameter="10"/></cutter>
  </tool>
XML
head='G21 G90 G94 G61 T1 M6
M3 S1000
G0 G43 H1 Z100'

# check TITLE CUTS END - the cuts, and then a rapid of the cutter straight down to Z at X0 B0
check() {
	echo "== $1"
	printf '%s\n' "$head" "$2" 'G0 Z100' 'G0 X0 Y0 B0' "G0 Z$3" >p.nc
	findings -s s.xml m.xml p.nc
}

# At B30 a point (x, z) of the stock has the height z cos 30 - x sin 30. Material above 12 mm is cut.
plane='G0 X-60 B30
G0 Y-12 Z12
G1 X60 F600
G0 Y-4
G1 X-60
G0 Y4
G1 X60
G0 Y12
G1 X-60'
# Under the core of the cutter (its radius and its end less 0.25 mm) the plane is highest at x = 4.75.
contact=$(awk 'BEGIN { b = atan2(0, -1) / 6; printf "%.4f", (12 + 4.75 * sin(b)) / cos(b) - 0.25 }')
check 'a tilted plane: down to 0.15 mm before the core touches it' "$plane" "$(awk "BEGIN { print $contact + 0.15 }")"
check 'and 0.02 mm too far' "$plane" "$(awk "BEGIN { print $contact - 0.02 }")"

# At B90 the cutter is parallel to the stock's X, and the machine's X is the height above the table: with its axis at 18
# mm its side cuts a level face at 13 mm.
flank='G0 X25 Y-30 B90
G0 Z-20.5
G1 X18 F600
G1 Y30
G0 X60'
check 'the flank, level: down to 0.15 mm before the core touches it' "$flank" 12.90
check 'and too far' "$flank" 12.73
