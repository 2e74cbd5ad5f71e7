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
