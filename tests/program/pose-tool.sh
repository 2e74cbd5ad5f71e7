# Only the tool in the spindle is drawn.
small_machine
for number in 1 2 3; do
	box tool$number -5 -5 -$((10 * number)) 5 5 0
done
setup s.xml <<'XML'
  <tool number="1" name="a" length="10"><cutter mesh="tool1.stl"/></tool>
  <tool number="2" name="b" length="20"><cutter mesh="tool2.stl"/></tool>
  <tool number="3" name="c" length="30"><cutter mesh="tool3.stl"/></tool>
XML
program a.nc <<'NC'
T1 M6
T2 M6
G0 X150
G0 Z-120
G0 X0
T3 M6
NC
fivecheck -q --pose pose.stl -s s.xml m.xml a.nc | grep error
wc -c <pose.stl
