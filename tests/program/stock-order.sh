# A holder that reaches over a wall: this is clear after the wall was cut. The same blocks in the other order are a
# finding.
stock_mill
setup s.xml <<'XML'
  <work_offset name="G54" X="0" Y="0" Z="-100"/>
  <stock box="40 20 20"/>
  <tool number="1" length="100">
    <holder><section length="88" diameter="16"/></holder>
    <cutter><section length="12" diameter="10"/></cutter>
  </tool>
XML

head='G21 G90 G94 G61 F600 T1 M6
M3 S1000
G0 G43 H1 Z100
G0 X-30 Z30'
# Three passes of 10 mm cut the upper half; then a slot along the middle, in which the holder moves down to 17 mm.
top='G1 Y-6 Z10
G1 X30
G1 Y0
G1 X-30
G1 Y6
G1 X30
G0 Z30
G0 X-30'
slot='G0 Y0
G1 Z5
G1 X0
G0 Z30
G0 X-30'

echo '== the wall first'
printf '%s\n' "$head" "$top" "$slot" >p.nc
findings -s s.xml m.xml p.nc
echo '== the wall last: the holder, 12 mm over the tip, is 3 mm deep in it'
printf '%s\n' "$head" "$slot" "$top" >p.nc
findings -s s.xml m.xml p.nc
echo '== the slot only as deep as the holder just clears it'
printf '%s\n' "$head" "$slot" "$top" | sed 's/G1 Z5/G1 Z8.1/' >p.nc
findings -s s.xml m.xml p.nc
echo '== and a little deeper'
printf '%s\n' "$head" "$slot" "$top" | sed 's/G1 Z5/G1 Z7.9/' >p.nc
findings -s s.xml m.xml p.nc
echo '== retracts alone leave the blank as it is'
printf '%s\n' "$head" 'G0 X0' 'G0 Z25' 'G0 Z30' 'G0 Z15' >p.nc
findings -s s.xml m.xml p.nc
echo '== a waiver, and a rule that even a feed must keep off'
printf '%s\n' "$head" "$slot" >p.nc
sed 's|</machine>|<pairs><pair a="holder" b="stock" check="never" reason="it yields"/></pairs>&|' m.xml >never.xml
findings -s s.xml never.xml p.nc
sed 's|</machine>|<pairs><pair a="cutter" b="stock" check="always"/></pairs>&|' m.xml >always.xml
findings -s s.xml always.xml p.nc

echo '== the blank as a mesh, and a mesh with a hole'
box blank -20 -10 0 20 10 20
sed 's|<stock box="40 20 20"/>|<stock name="blank" mesh="blank.stl"/>|' s.xml >mesh.xml
findings -s mesh.xml m.xml p.nc
awk '/facet normal/ && !cut { cut = 1; skip = 7 } skip-- > 0 { next } { print }' blank.stl >open.stl
sed 's|blank.stl|open.stl|' mesh.xml >open.xml
findings -s open.xml m.xml p.nc

echo '== faults of the setup'
for stock in '<stock/>' '<stock box="1 2"/>' '<stock box="1 2 -3"/>' '<stock box="1 2 3" cylinder="1 2"/>' \
	'<stock cylinder="10"/>' '<stock box="1 2 3" units="mm"/>' '<stock box="1 2 3"/><stock box="1 2 3"/>' \
	'<stock box="1 2 3" uncertainty="-1"/>' '<stock box="1 2 3" name="X"/>'; do
	sed "s|<stock box=\"40 20 20\"/>|$stock|" s.xml >bad.xml
	"$FIVECHECK" -q -s bad.xml m.xml p.nc
	echo "exit status $?"
done

echo '== a report is written, too'
findings -s s.xml m.xml --report=r.html p.nc
grep -c 'rapid-contact\|collision' r.html | awk '{ print ($1 > 0) }'
