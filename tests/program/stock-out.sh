# The remaining stock of a program is the blank of the next setup.
stock_mill
setup first.xml <<'XML'
  <work_offset name="G54" X="0" Y="0" Z="-100"/>
  <stock box="40 30 10"/>
  <tool number="1" length="100"><shank><section length="80" diameter="6"/></shank><cutter><section length="20" diameter="10"/></cutter></tool>
XML
sed 's|box="40 30 10"|mesh="rest.stl" excess="1"|' first.xml >second.xml

head='G21 G90 G94 G61 T1 M6
M3 S1000
G0 G43 H1 Z100'
printf '%s\n' "$head" 'G0 X-30 Z5' 'G1 X30 F600' 'G0 Z20' >slot.nc
"$FIVECHECK" -q --stock-out=rest.stl -s first.xml m.xml slot.nc
echo "exit status $?"

echo '== in the next setup the cutter goes through the slot at rapid, and not beside it'
# The cubes of the mesh are 0.4 mm.
printf '%s\n' "$head" 'G0 X-30 Z5.5' 'G0 X30' >again.nc
sed 's/diameter="10"/diameter="9"/' second.xml >smaller.xml
findings -s smaller.xml m.xml again.nc
printf '%s\n' "$head" 'G0 X-30 Y3 Z5.5' 'G0 X30' >beside.nc
"$FIVECHECK" -q -s smaller.xml m.xml beside.nc | grep -E 'rapid-contact|stock  '

echo '== turned to its side: the slot is open to -Y, where a cutter on a thin neck goes through it at rapid; not higher or turned on'
cat >side.xml <<'XML'
<setup version="1" units="mm">
  <work_offset name="G54" X="0" Y="0" Z="-100"/>
  <stock mesh="rest.stl" excess="1" location="0 5 20" rotation="90 0 0"/>
  <tool number="1" length="100"><shank><section length="94" diameter="3"/></shank><cutter><section length="6" diameter="9"/></cutter></tool>
</setup>
XML
printf '%s\n' "$head" 'G0 X-30 Y-6.7' 'G0 Z17' 'G0 X30' >side.nc
findings -s side.xml m.xml side.nc
sed 's/Z17/Z20/' side.nc >higher.nc
"$FIVECHECK" -q -s side.xml m.xml higher.nc | grep -E 'rapid-contact|stock  '
sed 's|location="0 5 20" rotation="90 0 0"|location="0 -5 20" rotation="90 0 180"|' side.xml >on.xml
"$FIVECHECK" -q -s on.xml m.xml side.nc | grep -E 'rapid-contact|stock  '

echo '== what the note says is right in a setup in mm and in one in inches, and the doubts about both blanks add up'
sed 's|box="40 30 10"|& uncertainty="0.5" excess="3"|' first.xml >doubted.xml
for setup in first doubted; do
	"$FIVECHECK" --stock-out=noted.stl -s $setup.xml m.xml slot.nc 2>&1 | grep -o 'material deeper.*'
done
cat >inches.xml <<'XML'
<setup version="1" units="inch">
  <work_offset name="G54" X="0" Y="0" Z="-3.937007874"/>
  <stock mesh="rest.stl" units="mm" excess="0.039"/>
  <tool number="1" length="3.937007874"><cutter><section length="3.937007874" diameter="0.354330709"/></cutter></tool>
</setup>
XML
findings -s inches.xml m.xml again.nc
"$FIVECHECK" -q -s inches.xml m.xml beside.nc | grep -E 'rapid-contact|stock  '

echo '== in a job file, the stock of another job is not taken from before the run'
cat >jobs.xml <<'XML'
<jobs version="1">
  <job name="op10" machine="m.xml" setup="first.xml"><program file="slot.nc"/></job>
  <job name="op20" machine="m.xml" setup="rest10.xml"><program file="again.nc"/></job>
</jobs>
XML
sed 's/rest.stl/rest-op10.stl/' smaller.xml >rest10.xml
"$FIVECHECK" -q --stock-out='rest-%.stl' jobs.xml
echo "exit status $?"
printf '%s\n' "$head" 'G1 X0 F600' 'G123' >stops.nc
sed 's/slot.nc/stops.nc/' jobs.xml >stops.xml
"$FIVECHECK" -q --stock-out='rest-%.stl' stops.xml
echo "exit status $?"
{ sed -n '1p; 3p' jobs.xml; sed -n '2p; 4p' jobs.xml; } >order.xml
"$FIVECHECK" -q --stock-out='rest-%.stl' order.xml
echo "exit status $?"

echo '== nothing to write'
printf '%s\n' "$head" 'G0 X-30 Z5' 'G0 X30' >rapid.nc
"$FIVECHECK" --stock-out=none.stl -s first.xml m.xml rapid.nc 2>&1 | grep note
# The cutter takes all of a blank that it encloses.
sed 's/box="40 30 10"/box="4 4 4" location="0 0 6" checked="small"/' first.xml >crumb.xml
"$FIVECHECK" -q --stock-out=none.stl -s crumb.xml m.xml slot.nc
echo "exit status $?"
sed '/<stock/d' first.xml >bare.xml
"$FIVECHECK" -q --stock-out=none.stl -s bare.xml m.xml slot.nc
echo "exit status $?"
"$FIVECHECK" --method=interpolated --stock-out=none.stl -s first.xml m.xml slot.nc 2>&1 | grep note
"$FIVECHECK" -q --stock-out=none.stl -s first.xml m.xml slot.nc rapid.nc
echo "exit status $?"
"$FIVECHECK" -q --stock-out=slot.nc -s first.xml m.xml slot.nc
echo "exit status $?"
cat >jobs.xml <<'XML'
<jobs version="1">
  <job name="one" machine="m.xml" setup="first.xml"><program file="slot.nc"/><program file="rapid.nc"/></job>
</jobs>
XML
"$FIVECHECK" -q --stock-out=none.stl jobs.xml
echo "exit status $?"
ls none.stl 2>&1 | grep -c '^none'
"$FIVECHECK" -q --stock-out=missing/rest.stl -s first.xml m.xml slot.nc
echo "exit status $?"

echo '== --sensitivity tries other cuts, but they are not those of the program'
"$FIVECHECK" -q --stock-out=again.stl --sensitivity 0,0,1,0 -s first.xml m.xml slot.nc | head -n 1
cmp rest.stl again.stl

echo '== the disk is full for the cuts of a long program: an error, and nothing is left behind'
awk 'BEGIN { for (i = 0; i < 300000; i++) printf "G1 X%.3f Y%.3f Z%.3f\n", 15 * sin(i), 10 * cos(i), 9 + sin(i * i) }' >cuts
(printf '%s\n' "$head" 'G0 X0 Y0 Z12'; echo 'G1 F600 Z10'; cat cuts; echo 'G0 Z20'; echo 'G0 X1') >long.nc
mkdir tmp
(trap '' XFSZ; ulimit -f 100; TMPDIR=$PWD/tmp "$FIVECHECK" -q -s first.xml m.xml long.nc)
echo "exit status $?"
ls tmp
