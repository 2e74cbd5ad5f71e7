# The remaining stock: only a cutter that feeds and turns may touch it. Each case has a counterpart with the other
# verdict.
stock_mill

# job STOCK_ATTRIBUTES - s.xml, with a flat cutter of 10 mm and a shank of 8 mm above it, 20 mm over the tip
job() {
	setup s.xml <<XML
  <work_offset name="G54" X="0" Y="0" Z="-100"/>
  <stock $1/>
  <tool number="1" length="100">
    <holder><section length="50" diameter="40"/></holder>
    <shank><section length="30" diameter="8"/></shank>
    <cutter><section length="20" diameter="10"/></cutter>
  </tool>
XML
}

# check TITLE - the program on standard input begins above the stock with the tool 1, and the spindle turns
check() {
	echo "== $1"
	(echo 'G21 G90 G94 T1 M6'; echo 'M3 S1000'; echo 'G0 G43 H1 Z100'; cat) >p.nc
	findings -s s.xml m.xml p.nc
}

box part -20 -15 0 20 15 10
job 'box="40 30 10"'
check 'a rapid above the blank' <<'NC'
G0 X-30 Z10.01
G0 X30
NC
check 'a rapid into the blank, but less deep than is allowed' <<'NC'
G0 X-30 Z9.8
G0 X30
NC
check 'a rapid deeper into the blank' <<'NC'
G0 X-30 Z9.6
G0 X30
NC
check 'a slot and a retract from it' <<'NC'
G0 X-30 Z7
G1 X10 F600
G0 Z20
NC
check 'on at rapid behind the end of the slot' <<'NC'
G0 X-30 Z7
G1 X10 F600
G0 X11
NC
check 'beside the slot' <<'NC'
G0 X-30 Z7
G1 X10 F600
G0 Z20
G0 Y0.5
G0 Z9
NC
check 'at a standstill in the slot, and out of it' <<'NC'
G0 X-30 Z7
G1 X10 F600
M5
G1 Z20
NC
check 'where a touch may have ended before, from which the cutter came back' <<'NC'
G0 X-30 Z7
G38.2 X10 F600
G1 X-30
G0 X5
NC
check 'a feed with a spindle that stands' <<'NC'
G0 X-30 Z7
M5
G1 X10 F600
NC
for hand in '' 'hand="right"' 'hand="left"'; do
	sed "s|<tool |&$hand |" s.xml >hand.xml
	for code in M3 M4; do
		echo "== a feed with $code and a cutter of which the hand is ${hand:-not given}"
		printf '%s\n' 'G21 G90 G94 G61 T1 M6' "$code S1000" 'G0 G43 H1 Z100' 'G0 X-30 Z7' 'G1 X10 F600' >p.nc
		findings -s hand.xml m.xml p.nc 2>&1
		"$FIVECHECK" -q -s hand.xml m.xml p.nc 2>&1 | grep -o 'mm deep [^[]*'
		sed 's|<stock|<part name="block" mesh="part.stl"|; s|box="40 30 10"||' hand.xml >part.xml
		"$FIVECHECK" -s part.xml m.xml p.nc 2>&1 | grep -e warning -e deep | sed 's/\[.*//'
	done
done
check 'a hole, in one block, deeper than the flutes: the shank follows in what the same block has cut' <<'NC'
G0 X0 Z12
G1 Z-15 F600
G0 Z12
NC

check 'a slot by a move that may stop anywhere: nothing is cut for certain' <<'NC'
G0 X-30 Z7
G38.3 X10 F600
G0 Z20
NC

job 'box="40 30 30" location="0 0 -20"'
check 'a holder that comes down to the top of the stock' <<'NC'
G0 X0 Z12
G1 Z-39.9 F600
NC
check 'a holder that comes down into it' <<'NC'
G0 X0 Z12
G1 Z-40.1 F600
NC

setup s.xml <<'XML'
  <work_offset name="G54" X="0" Y="0" Z="-100"/>
  <stock box="40 30 10"/>
  <tool number="1" length="100">
    <shank><section length="80" diameter="6"/></shank>
    <cutter><section length="15" diameter="6"/><section length="5" diameter="16"/></cutter>
  </tool>
XML
check 'a T-slot cutter returns in its slot, whose roof has a slit for the neck' <<'NC'
G0 X-40 Z2
G1 X40 F600
G0 X-40
NC
check 'and through the roof' <<'NC'
G0 X-40 Z2
G1 X0 F600
G0 Z4
NC

echo '== cylinders, uncertainty, allowance'
job 'cylinder="20 10" uncertainty="0.5" rapid_allowance="0.1"'
check 'above the uncertain blank' <<'NC'
G0 X-30 Z10.46
G0 X30
NC
check 'not above it' <<'NC'
G0 X-30 Z10.3
G0 X30
NC
check 'beside the cylinder' <<'NC'
G0 X-12.2 Y-12.2 Z5
G0 Y-30
NC
check 'too near to it' <<'NC'
G0 X-10 Y-13
G0 Z5
G0 Y-11.8
G0 Y-11.6
NC

echo '== what is not known yet'
status fivecheck -q -o verdict --method=conventional -s s.xml m.xml p.nc

echo '== a cutter from a mesh'
box closed -5 -5 -100 5 5 -80
head -n -8 closed.stl >open.stl
echo endsolid >>open.stl
for mesh in closed open; do
	setup s.xml <<XML
  <work_offset name="G54"/>
  <stock box="40 30 10"/>
  <tool number="1" length="100"><cutter mesh="$mesh.stl"/></tool>
XML
	check "of which the mesh is $mesh" <<'NC'
G0 Z-95
G0 X-40
NC
done

echo '== whether a finding is certain stands in every format'
job 'box="40 30 10"'
printf '%s\n' 'G21 G90 G94 G61 T1 M6' 'M3 S1000' 'G0 G43 H1 Z100' 'G0 X-30 Z7' 'G1 X10 F600' 'G0 X12' >p.nc
sed 's|<stock|& excess="6"|' s.xml >doubtful.xml
for format in text ndjson junit sarif github; do
	echo "$format: $(for setup in s doubtful; do
		"$FIVECHECK" -q -f $format -s $setup.xml m.xml p.nc
	done | grep -o -e 'certain: they' -e 'possible: all' -e '"certain":[a-z]*' | tr '\n' ' ')"
done
echo '== kinds that fail, waivers, and the work offsets of two jobs'
for kind in none collision warning rapid-contact; do
	"$FIVECHECK" -q -a --fail-on=$kind -f ndjson=found -s s.xml m.xml p.nc
	echo "$kind: exit status $?"
done
"$FIVECHECK" waive --reason='the spindle has power' --until=9999-12-31 found >waivers.xml
"$FIVECHECK" -q -a --waivers=waivers.xml -s s.xml m.xml p.nc 2>&1 | grep -e found -e waived
sed 's/X="0"/X="60"/' s.xml >aside.xml
echo '<jobs version="1"><job name="a" machine="m.xml" setup="s.xml"><program file="p.nc"/></job>
<job name="b" machine="m.xml" setup="aside.xml"><program file="p.nc"/></job></jobs>' >jobs.xml
findings jobs.xml
echo '== a program that is not followed to its end leaves no stock'
printf '%s\n' 'G21 G90 G94 G61 T1 M6' 'o1 while [1]' 'G0 X-30' 'G0 X-31' 'o1 endwhile' >p.nc
status fivecheck -q --max-blocks=99 --stock-out=rest.stl -s s.xml m.xml p.nc 2>&1 | grep -v '^ '
ls rest.stl 2>&1 | grep -c '^rest'

echo '== threads, shards, all findings: the same bytes'
job 'box="40 30 10"'
{
	echo 'G21 G90 G94 T1 M6'
	echo 'M3 S1000'
	echo 'G0 G43 H1 Z100'
	awk 'BEGIN { for (i = 0; i < 25; i++) printf "G0 Z12\nG0 X%.3f Y%.3f\nG1 Z%.2f F600\n", 25 * sin(i), 20 * cos(2 * i), 8 - i / 40 }'
	echo 'G0 X0 Y0'
	echo 'G0 Z5'
	echo 'G0 X30'
} >p.nc
"$FIVECHECK" -q --stock-tolerance 0.4 -a -f ndjson -s s.xml m.xml p.nc | grep '"kind":"[cr]' >one
"$FIVECHECK" -q --stock-tolerance 0.4 -a -j 2 -f ndjson -s s.xml m.xml p.nc | grep '"kind":"[cr]' >two
for shard in 1 2 3; do
	"$FIVECHECK" -q --shard $shard/3 -a --stock-tolerance 0.4 -f ndjson -s s.xml m.xml p.nc | grep '"kind":"[cr]' || :
done >three
wc -l <one
cmp one two
sort one >sorted
sort three | cmp sorted -
