# If the control may leave the path, the proof includes that distance: a gap of 0.03 mm.
box cube -5 -5 -5 5 5 5
box wall -50 5.03 -50 150 10 50
machine m.xml <<'XML'
  <body name="wall" mesh="wall.stl"/>
  <axis name="X" type="linear" direction="1 0 0" limit_min="-10" limit_max="300" rate_max="6000">
    <axis name="Y" type="linear" direction="0 1 0" limit_min="-10" limit_max="300" rate_max="6000">
      <body name="cube" mesh="cube.stl"/>
    </axis>
  </axis>
XML
for tolerance in 0.02 0.04; do
	printf 'G64 P%s\nG1 X100 F600\n' $tolerance >a.nc
	findings m.xml a.nc
	status fivecheck -q m.xml a.nc | tail -n 1
done
printf 'G64\nG1 X100 F600\n' >b.nc
fivecheck m.xml b.nc | grep -i G64
