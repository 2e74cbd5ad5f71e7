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
