# 100,000 short blocks along a sine between two walls; one of them, the 70,001st, reaches 0.2 mm into a wall.
box cube -1 -1 -1 1 1 1
box wall -2000 5 -5 2000 6 5
box other -2000 -6 -5 2000 -5 5
machine m.xml <<'XML'
  <body name="wall" mesh="wall.stl"/>
  <body name="other" mesh="other.stl"/>
  <axis name="X" type="linear" direction="1 0 0" limit_min="-2000" limit_max="2000" rate_max="6000">
    <axis name="Y" type="linear" direction="0 1 0" limit_min="-20" limit_max="20" rate_max="6000">
      <body name="cube" mesh="cube.stl"/>
    </axis>
  </axis>
XML
awk 'BEGIN {
	print "F1000"
	for (i = 1; i <= 100000; i++)
		printf "G1 X%.4f Y%.4f\n", i / 100, i == 70001 ? 4.2 : 2 * sin(i / 50)
}' >sine.nc
findings m.xml sine.nc | cut -d ' ' -f 1-3
sed 70002d sine.nc >clear.nc
status fivecheck -q m.xml clear.nc
findings m.xml - <sine.nc | cut -d ' ' -f 1-3
findings -j 2 m.xml sine.nc | cut -d ' ' -f 1-3
