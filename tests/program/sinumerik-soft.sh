# A soft approach is on the side of G41 or G42, and goes down at the rapid rate to DISCL above the contour: beside the
# block that is clear, and above the block the cutter enters it. Threads, shards and a report of clearances change
# nothing.
root=$(dirname "$LIB")/../..
cp -r "$root/machines/ac-trunnion/stl" stl
sed 's|<controller dialect="[a-z]*" rapid="linear"/>|<controller dialect="sinumerik" rapid="linear" power_on_units="mm" edge_after_tool_change="first"><tool_change/></controller>|' \
	"$root/machines/ac-trunnion/machine.xml" >machine.xml
soft()
{
	cat >part.mpf <<NC
G54 G17 G71 G90 G94 G60
T1 D1 M6
S8000 M3 F1000
G0 X-80 Y0 A0 C0
Z20
$1
G1 Y20
$2
M30
NC
	check
	check -j 2
	check --clearance-report=clearances.tsv
	for k in 1 2; do
		"$FIVECHECK" -q --shard=$k/2 -f ndjson=shard$k.json -s "$root/examples/stock/setup.xml" machine.xml part.mpf \
			>/dev/null 2>&1
	done
	"$FIVECHECK" merge shard1.json shard2.json | sed -n 's/.*"verdict":"\([a-z]*\)","blocks":\([0-9]*\).*/merged: \1, \2 blocks/p'
}
check()
{
	fivecheck -q "$@" -s "$root/examples/stock/setup.xml" machine.xml part.mpf 2>&1 | grep '^part' | sed 's/ \[.*//'
}
away='G40 G248 DISR=15 DISCL=4 X-80 Y40 Z20'
soft 'G41 NORM G450 G341 G247 DISR=15 DISCL=4 FAD=300 X-60 Y-20 Z-8 F1500' "$away"
soft 'G42 NORM G450 G341 G247 DISR=15 DISCL=4 FAD=300 X-60 Y-20 Z-8 F1500' 'G40 G0 Z20'
# P0 to P4 and back: the moves of the blocks by their lines and numbers, at the ends.
cat >path.mpf <<'NC'
G54 G17 G71 G90 G94 G60
T1 D1 M6
S8000 M3 F1000
G0 X-80 Y0 Z20 A0 C0
G41 NORM G450 G341 G147 DISR=15 DISCL=4 FAD=300 Z-8 F1500
G1 X-60 Y-20
Y20
G40 G340 G148 DISR=15 DISCL=4 X-80 Y40 Z20
M30
NC
"$FIVECHECK" --dump-path -s "$root/examples/stock/setup.xml" machine.xml path.mpf | cut -f1-6
"$FIVECHECK" scan path.mpf 2>/dev/null | grep '^G[123]4\|^DIS\|^FAD'
