# A cutter that is wholly inside the finished part does not touch its surface. Its checked steps follow steps that are
# not checked, so at the start of each the check must test whether one body is inside the other.
box head -20 -20 100 20 20 200
machine m.xml <<'XML'
  <axis name="X" type="linear" direction="1 0 0" limit_min="-200" limit_max="200" rate_max="6000">
    <axis name="Y" type="linear" direction="0 1 0" limit_min="-200" limit_max="200" rate_max="6000">
      <axis name="Z" type="linear" direction="0 0 1" limit_min="-150" limit_max="50" home="50" rate_max="6000">
        <body name="head" mesh="head.stl"/>
        <spindle location="0 0 100" direction="0 0 -1"/>
      </axis>
    </axis>
  </axis>
  <workholding location="0 0 0"/>
--
<pairs><pair a="shank" b="part" check="never" reason="this is about the cutters"/></pairs>
XML

# job PART_ATTRIBUTES - s.xml
job() {
	tool='<shank><section length="70" diameter="2"/></shank><cutter tip="ball"><section length="10" diameter="8"/></cutter>'
	setup s.xml <<XML
  <work_offset name="G54" X="0" Y="0" Z="-100"/>
  <part name="thing" $1/>
  <tool number="1" length="80">$tool</tool>
  <tool number="2" length="80">$tool</tool>
XML
}

echo '== a gouge by a tool that comes into the spindle inside the part'
box block -100 -100 -100 100 100 30
job 'mesh="block.stl" gouge="0.05"'
program p.nc <<'NC'
T1 M6
M3 S1000
G0 G43 H1 Z31
G1 Z0 F1000
T2 M6
M3 S1000
G43 H2
G1 X5
X6
NC
findings -a -s s.xml m.xml p.nc

# Rapids 0.05 mm above the surface of the ball need so much work that the rest is divided among several threads; in each
# of these programs, the one rapid inside the ball is at the start of such a part.
echo '== a rapid inside the part, after much work'
sphere ball 30 24
# The sine of pi is not exactly 0, so it is not used: the mesh must be closed.
sed -i 's/[0-9.-]*e-[0-9]*/0/g' ball.stl
job 'mesh="ball.stl"'
for count in 1206 1207 1208 1209; do
	awk -v count=$count 'BEGIN {
		print "G21 G90 G94 T1 M6\nG0 G43 H1 Z31\nM3 S1000\nG0 Z31\nG0 Z31"
		for (i = 0; i < count; i++) {
			t = 0.2 + 0.02 * (i % 7)
			f = i * 0.2
			printf "G0 X%.4f Y%.4f Z%.4f\n", 34 * sin(t) * cos(f), 34 * sin(t) * sin(f), 34 * cos(t) - 4
		}
		print "G0 Z31\nG0 X0 Y0 Z31\nG1 Z0 F1000\nG0 Z1\nG1 Z31"
		for (i = 0; i < 1500; i++)
			print "G0 X" i % 2
		print "M2"
	}' >p.nc
	for threads in 1 2; do
		findings -j $threads -s s.xml m.xml p.nc
	done
done
