# A cutter may enter the stock or a part a little at rapid. One that is thinner than that is checked all the same, and one
# that only touches the roof of its slot enters nothing.
stock_mill
box part -20 -15 0 20 15 10
box pin -0.15 -0.15 -100 0.15 0.15 -95

# tool STOCK_OR_PART SHANK CUTTER - s.xml
tool() {
	setup s.xml <<XML
  <work_offset name="G54" X="0" Y="0" Z="-100"/>
  <$1/>
  <tool number="1" length="100">
    <shank>$2</shank>
    <cutter$3</cutter>
  </tool>
XML
}

# cut TITLE X - slots at feed, 1 mm deep, from -X to X and back at rapid; then at rapid beside the slot
cut() {
	echo "== $1"
	printf '%s\n' 'G21 G90 G94 G61 T1 M6' 'M3 S1000' 'G0 G43 H1 Z100' "G0 X-$2 Y0" 'G0 Z9' "G1 X$2 F600" "G0 X-$2" \
		'G0 Y0.5' "G0 X$2" >p.nc
	findings -a -s s.xml m.xml p.nc
	"$FIVECHECK" -q -a -s s.xml m.xml p.nc | grep -o '[a-z]* ([A-Zbase]*) enters.*deep [a-z ]*'
	"$FIVECHECK" --list-pairs -s s.xml m.xml | grep -o 'the cutter cuts.*'
}

section() {
	printf '<section length="%s" diameter="%s"/>' "$1" "$2"
}

for body in 'stock box="40 30 10"' 'part name="block" mesh="part.stl"'; do
	what=${body%% *}
	tool "$body" "$(section 95 3)" ">$(section 5 0.8)"
	cut "$what: an end mill of 0.8 mm" 30
	tool "$body" "$(section 95 1)" ">$(section 5 0.15)"
	cut "$what: an end mill of 0.15 mm" 30
	tool "$body" "$(section 95 3)" " tip=\"ball\">$(section 5 0.15)"
	cut "$what: a ball of 0.15 mm" 30
	tool "$body" "$(section 90 3)" ">$(section 7 3)$(section 3 0.15)"
	cut "$what: a thin point below a thick cutter" 30
	tool "$body" "$(section 99.85 3)" ">$(section 0.15 40)"
	cut "$what: a saw, its shank above" 60
done

# through TITLE X - at rapid into the side of the blank, 1 mm below its top
through() {
	echo "== $1"
	printf '%s\n' 'G21 G90 G94 G61 T1 M6' 'M3 S1000' 'G0 G43 H1 Z100' 'G0 X-60 Y0' 'G0 Z9' "G0 X$2" >p.nc
	findings -s s.xml m.xml p.nc
}

tool 'stock box="40 30 10"' "$(section 99.85 3)" ">$(section 0.15 40)"
through 'the rim of a saw' -25
tool 'stock box="40 30 10"' "$(section 90 8)" ">$(section 9.85 8)$(section 0.15 40)"
through 'the rim of a saw below its arbor' -25
sed 's|<cutter>.*|<cutter mesh="pin.stl"/>|' s.xml >mesh.xml
mv mesh.xml s.xml
through 'a pin that is a mesh' 0

# A cone's core ends depth / sin(angle / 2) above its tip: at 0.1 mm 1.147 mm for 10 degrees, 0.576 mm for 20 degrees.
echo "== a point that has no core is said, with the length of it"
for body in 'part name="block" mesh="part.stl" gouge="0.02"' 'stock box="40 30 10"' \
	'stock box="40 30 10" rapid_allowance="0.01" checked="r"'; do
	for angle in 10 20; do
		tool "$body" "$(section 70 6)" " tip=\"cone\" angle=\"$angle\">$(section 30 4)"
		printf '%s\n' 'G21 G90 G94 G61 T1 M6' 'M3 S1000' 'G0 G43 H1 Z100' >p.nc
		echo "$body, $angle degrees"
		"$FIVECHECK" -s s.xml m.xml p.nc 2>/dev/null | grep 'so thin'
	done
done
sed -i 's/length="100">/length="100" checked="r">/; s/ rapid_allowance.*r"//' s.xml
"$FIVECHECK" -s s.xml m.xml p.nc 2>/dev/null | grep 'so thin'

# A slot with a roof on both sides, 5 mm high and 16 mm wide, with a slit of 7 mm.
box floor -40 -20 0 40 20 3
box left -40 8 3 40 20 12
box right -40 -20 3 40 -8 12
box leftroof -40 3.5 8 40 8 12
box rightroof -40 -8 8 40 -3.5 12
{
	echo '  <work_offset name="G54" X="0" Y="0" Z="-100"/>'
	for name in floor left right leftroof rightroof; do
		echo "  <part name=\"$name\" mesh=\"$name.stl\" gouge=\"0.05\"/>"
	done
	echo "  <tool number=\"1\" length=\"100\"><shank>$(section 95 6)</shank><cutter>$(section 5 16)</cutter></tool>"
} | setup slot.xml
for z in 3 3.04 3.2 2.96 2.8; do
	echo "== a T-slot cutter in its slot at Z$z"
	printf '%s\n' 'G21 G90 G94 G61 T1 M6' 'M3 S1000' 'G0 G43 H1 Z100' 'G0 X-60 Y0' "G0 Z$z" 'G1 X60 F600' 'G0 X-60' >p.nc
	findings -a -s slot.xml m.xml p.nc
done
