# The reported clearance is the distance of the nearest points, not of the first ones found too near.
box left -30 -10 -1 -10 10 40
box middle -9 -10 -2 9 10 40
box right 10 -10 -3 30 10 40
box plate -100 -100 -10 100 100 0
{
	sed '$d' left.stl
	sed '1d;$d' middle.stl
	sed 1d right.stl
} >head.stl
machine m.xml <<'XML'
  <body name="plate" mesh="plate.stl"/>
  <axis name="Z" type="linear" direction="0 0 1" rate_max="6000" home="20">
    <axis name="X" type="linear" direction="1 0 0" rate_max="6000">
      <body name="head" mesh="head.stl"/>
    </axis>
  </axis>
XML
printf 'G0 Z4\nG0 X5\n' >a.nc
findings -a --clearance=5 m.xml a.nc
