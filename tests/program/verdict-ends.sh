# Contact only at the end of a block, a gap of 2e that stays, an overlap of 2e that is found (e is 0.001 mm);
# and a start in contact that departs.
box cube -5 -5 -5 5 5 5
box wall 100 -50 -50 110 50 50
machine m.xml <<'XML'
  <body name="wall" mesh="wall.stl"/>
  <axis name="X" type="linear" direction="1 0 0" limit_min="-10" limit_max="300" rate_max="6000">
    <body name="cube" mesh="cube.stl"/>
  </axis>
--
  <pairs><pair a="wall" b="cube" check="always"/></pairs>
XML
echo 'G1 X95 F600' >touch.nc
echo 'G1 X94.998 F600' >gap.nc
echo 'G1 X95.002 F600' >overlap.nc
printf 'G1 X94.998 F600\nG1 X0\nG1 X94.998\n' >to_and_fro.nc
findings m.xml touch.nc
status fivecheck -q m.xml gap.nc
findings m.xml overlap.nc
status fivecheck -q m.xml to_and_fro.nc
sed 's/limit_min/home="95.5" limit_min/' m.xml >started.xml
findings started.xml touch.nc
echo 'G1 X0 F600' >depart.nc
findings started.xml depart.nc
findings -a started.xml depart.nc
# A clearance: what must remain is measured from face to face.
findings --clearance 10 m.xml touch.nc
status fivecheck -q --clearance 10 m.xml - <<'NC'
G1 X84.998 F600
NC
