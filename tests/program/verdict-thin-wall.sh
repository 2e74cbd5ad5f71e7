# A wall of 0.01 mm, crossed by one rapid of 300 mm. The cube's front, at x=5, meets the wall's face, at
# x=100.3, after 95.3 of the 300 mm. Samples of 0.01 s are 1 mm apart: they find the cube in the wall, but later.
box cube -5 -5 -5 5 5 5
box wall 100.3 -50 -50 100.31 50 50
box pin -0.001 -0.001 -0.001 0.001 0.001 0.001
for body in cube pin; do
	machine $body.xml <<XML
  <body name="wall" mesh="wall.stl"/>
  <axis name="X" type="linear" direction="1 0 0" limit_min="0" limit_max="300" rate_max="6000">
    <body name="$body" mesh="$body.stl"/>
  </axis>
--
  <pairs><pair a="wall" b="$body" check="always"/></pairs>
XML
done
program across.nc <<'NC'
G0 X300
NC
findings cube.xml across.nc
findings --method conventional cube.xml across.nc
# A pin of 0.002 mm is in the wall for 0.12 ms: the samples step over it, the proof does not.
findings pin.xml across.nc
status fivecheck -q --method conventional pin.xml across.nc
status fivecheck -q --method interpolated pin.xml across.nc
