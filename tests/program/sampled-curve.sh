# The sampled methods look at the path itself: a cube moves round a post, which is 4 um beside its path.
box head -5 -5 0 5 5 100
box post -0.5 -20 0 0.5 94.845 100
machine m.xml <<'XML'
  <body name="post" mesh="post.stl"/>
  <axis name="X" type="linear" direction="1 0 0" home="-100" rate_max="60000">
    <axis name="Y" type="linear" direction="0 1 0" rate_max="60000">
      <body name="head" mesh="head.stl"/>
    </axis>
  </axis>
XML
echo 'G2 X100 Y0 I100 F6000' >beside.nc
status fivecheck -q m.xml beside.nc | grep -e '^[bs]'
for method in conventional interpolated; do
	status fivecheck -q --step=0.001 --method=$method m.xml beside.nc | grep -e '^[bs]'
done
