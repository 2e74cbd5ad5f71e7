# A tool that overlaps at home is found even if another takes its place before anything moves.
small_machine
box post -10 -10 0 10 10 90
setup s.xml <<'XML'
  <fixture name="post" mesh="post.stl"/>
  <tool number="1" length="50"><cutter><section length="50" diameter="4"/></cutter></tool>
  <tool number="2" length="5"><cutter><section length="5" diameter="4"/></cutter></tool>
XML
sed 's/version="1"/& initial_tool="1"/' s.xml >in.xml
printf 'T1 M6\nT2 M6\nG0 X30\n' >a.nc
findings -s s.xml m.xml a.nc
printf 'T0 M6\nT2 M6\n' >b.nc
findings -s in.xml m.xml b.nc
printf 'T2 M6\nG0 X30\nT0 M6\nT2 M6\n' >c.nc
findings -s s.xml m.xml c.nc
