# Bodies that overlap at the start, one inside the other, in a cavity, and after a tool change.
box big -50 -50 0 50 50 100
box small -5 -5 40 5 5 50
machine inside.xml <<'XML'
  <body name="big" mesh="big.stl"/>
  <axis name="X" type="linear" direction="1 0 0" limit_min="-10" limit_max="10" rate_max="6000">
    <axis name="Y" type="linear" direction="0 1 0" limit_min="-10" limit_max="10" rate_max="6000">
      <body name="small" mesh="small.stl"/>
    </axis>
  </axis>
XML
program move.nc <<'NC'
(nothing moves here)
G4 P1
G1 X5 F100
G1 X-5
NC
findings inside.xml move.nc
fivecheck -q inside.xml move.nc | grep '<pair'
# The start of a program without motion is checked.
echo 'G4 P1' >still.nc
status fivecheck inside.xml still.nc 2>&1 | grep -E 'warning|error|status'
# The tool appears in the table's post.
small_machine
rectangle post 10 10 40 0 0 40
setup s.xml <<'XML'
  <fixture name="post" mesh="post.stl"/>
  <tool number="1" name="long" length="60"><cutter tip="flat"><section length="60" diameter="10"/></cutter></tool>
XML
program change.nc <<'NC'
G0 X1
T1 M6
G0 X2
NC
findings -s s.xml m.xml change.nc
printf 'G0 X50\nT1 M6\nG0 X100\n' >beside.nc
status fivecheck -q -s s.xml m.xml beside.nc
