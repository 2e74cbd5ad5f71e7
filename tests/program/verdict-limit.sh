# Pairs out of reach are checked again past a limit, and a limit itself is a finding at the instant it is passed.
box head -5 -5 -5 5 5 5
box wall 100 -50 -50 110 50 50
machine m.xml <<'XML'
  <body name="wall" mesh="wall.stl"/>
  <axis name="X" type="linear" direction="1 0 0" limit_min="-50" limit_max="50" rate_max="6000">
    <axis name="Y" type="linear" direction="0 1 0" limit_min="-50" limit_max="50" rate_max="6000">
      <body name="head" mesh="head.stl"/>
    </axis>
  </axis>
XML
fivecheck --list-pairs m.xml | cut -f 1-3
echo 'G1 X200 F600' >past.nc
findings m.xml past.nc
findings -a m.xml past.nc
# A move to the limit, or past it by less than rounding, is inside.
status fivecheck -q m.xml - <<'NC'
G1 X50 F600
G1 X50.0000009
NC
# An arc that bulges past the limit although its ends are inside: from (40,0) about (40,20) to (40,40), X up to 60.
findings m.xml - <<'NC'
G1 X40 F600
G3 Y40 J20
NC
# A tool loaded past a limit is checked there, although nothing moves any more and the limit is accepted: wholly
# inside the wall, through its surface, above it.
box wall 100 -50 -50 200 50 50
box head -5 -5 -5 5 5 5
box probe -2 -2 -60 2 2 -50
machine m.xml <<'XML'
  <body name="wall" mesh="wall.stl"/>
  <axis name="X" type="linear" direction="1 0 0" limit_min="-50" limit_max="50" rate_max="6000">
    <axis name="Z" type="linear" direction="0 0 1" limit_min="-50" limit_max="100" rate_max="6000">
      <body name="head" mesh="head.stl"/>
      <spindle location="0 0 -5" direction="0 0 -1"/>
    </axis>
  </axis>
XML
setup s.xml <<'XML'
  <tool number="1" length="60"><holder mesh="probe.stl"/></tool>
XML
fivecheck --list-pairs -s s.xml m.xml | cut -f 1-3
for z in 62 110 120; do
	printf '%s\n' "G1 Z$z F600" X150 'T1 M6' >put.nc
	findings -a -s s.xml m.xml put.nc
	status fivecheck -q --fail-on collision,start-overlap -s s.xml m.xml put.nc | tail -n 1
done
# A path tolerance of 0.001 mm at a position that is 0.0000009 mm past the limit, where it still counts as inside: the two
# together reach the wall, or leave 0.0000001 mm.
box head -10 -5 -5 0 5 5
for gap in 0.0010004 0.001001; do
	box wall $gap -5 -5 20 5 5
	machine m.xml <<'XML'
  <axis name="X" type="linear" direction="1 0 0" limit_min="-50" limit_max="0" rate_max="6000" home="-20">
    <body name="head" mesh="head.stl"/>
  </axis>
  <body name="wall" mesh="wall.stl"/>
--
<pairs adjacent_within="0"/>
<controller path_tolerance="0.001"/>
XML
	echo 'G64 G1 X0.0000009 F600' >near.nc
	findings m.xml near.nc
done
