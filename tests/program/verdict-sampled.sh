# Cases in which the paper's methods fail and the proof does not.
tetrahedron blade -40 -57 32 -17 -32 -2 -30 0 -17 42 -25 -3
tetrahedron post 13 -33 21 -50 16 53 3 54 49 -25 -20 7
machine m.xml <<'XML'
  <body name="post" mesh="post.stl"/>
  <axis name="C" type="rotary" direction="0 0 1" location="0 0 0" limit_min="-360" limit_max="360" rate_max="3600">
    <body name="blade" mesh="blade.stl"/>
  </axis>
--
  <pairs><pair a="post" b="blade" check="always"/></pairs>
XML
echo 'G1 C180 F1000' >turn.nc
# The axes of both ends, interpolated over half a turn, do not separate the bodies in between: a false alarm.
echo 'false alarm:'
status fivecheck -q m.xml turn.nc | tail -n 1
status fivecheck -q --method conventional m.xml turn.nc | tail -n 1
status fivecheck -q --method interpolated m.xml turn.nc | tail -n 1
# A pin 40 mm from the axis, 0.2 mm wide, which a blade of 50 mm hits on its path: samples every 3 s step over it.
echo 'miss:'
box blade -50 -2 -2 50 2 2
box post -0.1 40 -3 0.1 60 3
findings m.xml turn.nc
status fivecheck -q --method conventional --step 3 m.xml turn.nc | tail -n 1
fivecheck --method conventional --step 3 m.xml turn.nc | head -n 1
# Finer samples find it, but too late.
findings --method conventional --step 0.05 m.xml turn.nc | cut -d ' ' -f 1-3
