# Under TCP (G43.4) a rapid keeps the tip on a line only if rapids are linear. Otherwise each axis moves independently
# to the same end, and the tool hits a post beside the line.
box pin -1 -1 -1 1 1 1
box table -5 -5 -60 5 5 -50
box post 26 26 -5 34 34 5
for rapid in linear dogleg any; do
	machine $rapid.xml <<'XML'
  <body name="post" mesh="post.stl"/>
  <axis name="X" type="linear" direction="1 0 0" limit_min="-200" limit_max="200" rate_max="6000">
    <axis name="Y" type="linear" direction="0 1 0" limit_min="-200" limit_max="200" rate_max="6000">
      <axis name="Z" type="linear" direction="0 0 1" limit_min="-200" limit_max="200" rate_max="6000">
        <body name="pin" mesh="pin.stl"/>
        <spindle location="0 0 0" direction="0 0 -1"/>
      </axis>
    </axis>
  </axis>
  <axis name="C" type="rotary" direction="0 0 1" location="0 0 0" rate_max="36000">
    <body name="table" mesh="table.stl"/>
    <workholding location="0 0 0"/>
  </axis>
XML
	sed -i "s|<base>|<controller rapid=\"$rapid\"/><base>|" $rapid.xml
done
# The tip keeps its position on the table, which turns by 90 degrees: X and Y follow the circle from (60,0) to (0,60),
# or the straight line.
printf 'G21 G90\nG43.4 H0\nG0 X60\nG0 C90\nM2\n' >turn.nc
for rapid in linear dogleg any; do
	echo "rapid=$rapid"
	findings $rapid.xml turn.nc | cut -d ' ' -f 1-3
done
