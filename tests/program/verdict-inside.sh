# With --all, a block that starts with one body wholly inside the other is reported, though no surfaces meet.
box wall 50 -50 -50 150 50 50
box probe -5 -5 -5 5 5 5
machine m.xml <<'XML'
  <body name="wall" mesh="wall.stl"/>
  <axis name="X" type="linear" direction="1 0 0" rate_max="6000">
    <axis name="Y" type="linear" direction="0 1 0" rate_max="6000">
      <body name="probe" mesh="probe.stl"/>
    </axis>
  </axis>
XML
program a.nc <<'NC'
G0 X100
G0 Y10
G0 X90
G0 X0
G0 X10
NC
findings -a m.xml a.nc
# The distance is 0 there, too, if the surfaces are nearer to each other than the clearance or the path tolerance.
findings -a --clearance 40 m.xml a.nc
printf 'G64 P50\nG1 X100 F6000\nG1 Y10\n' >round.nc
findings -a m.xml round.nc
