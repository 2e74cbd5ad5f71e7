# A post is beside the straight path of a rapid from (0,0) to (100,20), but in the path of a dogleg, which moves
# diagonally to (20,20) and then along X; it is also hit if the path is not known.
box pin -1 -1 -1 1 1 1
box post 20 12 -5 24 30 5
for rapid in linear dogleg any; do
	machine $rapid.xml <<'XML'
  <body name="post" mesh="post.stl"/>
  <axis name="X" type="linear" direction="1 0 0" limit_min="-200" limit_max="200" rate_max="6000">
    <axis name="Y" type="linear" direction="0 1 0" limit_min="-200" limit_max="200" rate_max="6000">
      <body name="pin" mesh="pin.stl"/>
    </axis>
  </axis>
XML
	sed -i "s|<base>|<controller rapid=\"$rapid\"/><base>|" $rapid.xml
done
echo 'G0 X100 Y20' >rapid.nc
status fivecheck -q linear.xml rapid.nc
findings dogleg.xml rapid.nc
findings any.xml rapid.nc | cut -d ' ' -f 1-3
# A feed is straight whatever the rapids are; so is a rapid of one axis.
echo 'G1 X100 Y20 F1000' >feed.nc
status fivecheck -q any.xml feed.nc
status fivecheck -q any.xml - <<'NC'
G0 X100
NC
# Five axes move at once, and the bodies come within the clearance only at the rapid's end: head and table are then
# sqrt(1 + 1 + 10 * 10) = 10.0995 mm apart. To find this the box of all positions is halved some 90 times.
box head 0 0 100 20 20 140
box table -60 -60 -20 0 0 0
machine five.xml <<'XML'
  <axis name="X" type="linear" direction="1 0 0" rate_max="6000">
    <axis name="Y" type="linear" direction="0 1 0" rate_max="6000">
      <axis name="Z" type="linear" direction="0 0 1" rate_max="6000">
        <body name="head" mesh="head.stl"/>
      </axis>
    </axis>
  </axis>
  <axis name="A" type="rotary" direction="1 0 0" location="0 0 0" rate_max="3600">
    <axis name="C" type="rotary" direction="0 0 1" location="0 0 0" rate_max="3600">
      <body name="table" mesh="table.stl"/>
    </axis>
  </axis>
XML
sed -i 's|<base>|<controller rapid="any"/><base>|' five.xml
printf 'G61\nG0 X60 Y60 A30 C30\nG0 X1 Y1 Z-90 A0 C0\n' >five.nc
findings --clearance 10.0996 five.xml five.nc
status fivecheck -q --clearance 5 five.xml five.nc
