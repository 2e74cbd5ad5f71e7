# Findings at rest, before a block moves the axes, come before findings at the start of the motion: the first finding is
# the same with --all, although its pair is second in the machine file.
box near 20.03 -20 0 40 20 40
box deep -40 -20 0 -19 20 40
box head -20 -20 0 20 20 40
machine m.xml <<'XML'
  <body name="near" mesh="near.stl"/>
  <body name="deep" mesh="deep.stl"/>
  <axis name="X" type="linear" direction="1 0 0" rate_max="6000">
    <axis name="Z" type="linear" direction="0 0 1" rate_max="6000">
      <body name="head" mesh="head.stl"/>
    </axis>
  </axis>
XML
sed 's|<base>|<controller path_tolerance="0.1"/><base>|' m.xml >near.xml
printf 'G0 X-1\n' >p.nc
findings() {
	fivecheck -q -f ndjson "$@" | jq -r 'select(.fraction) | "\(.kind) \(.a) \(.b) line \(.line) at \(.fraction)"'
}
need jq
findings near.xml p.nc
findings --all near.xml p.nc | head -n 1
# Pairs with the stock are checked after all others, but are reported in the order of the file.
sed 's|<body name="near".*|<workholding location="0 0 0"/>|; s|<body name="deep".*||
	s|<body name="head".*|&<spindle location="0 0 5" direction="0 0 -1"/>|' m.xml >stock.xml
box vise -40 -20 -11 -19 20 -1
setup s.xml <<'XML'
  <fixture name="vise" mesh="vise.stl"/>
  <stock box="20 20 20"/>
XML
sed 's|<setup |<setup initial_tool="1" |; s|</setup>|<tool number="1" length="30"><holder><section length="20" diameter="60"/></holder>\
	<cutter><section length="10" diameter="4"/></cutter></tool></setup>|' s.xml >tool.xml
findings -s tool.xml stock.xml p.nc
findings --all -s tool.xml stock.xml p.nc | head -n 1
# The last block of the second of two shards of a long program is a tool change that puts the holder into a post. The
# next block, in the first shard, begins with the same contact at the same time.
box post -20 -20 0 20 20 90
box high -20 -20 100 20 20 150
sed 's|<body name="near".*|<body name="post" mesh="post.stl"/>|; s|<body name="deep".*||
	s|<body name="head".*|<body name="head" mesh="high.stl"/><spindle location="0 0 100" direction="0 0 -1"/>|' m.xml >long.xml
setup long-setup.xml <<'XML'
  <tool number="1" length="60"><holder><section length="60" diameter="10"/></holder></tool>
XML
awk 'BEGIN { print "G0 Z5"; for (i = 1; i < 2047; i++) print "G1 F1000 X" i % 2; print "T1 M6\nG1 X0.5 Z4\nG1 X0" }' >long.nc
for all in '' --all; do
	findings $all -s long-setup.xml long.xml long.nc
	for k in 1 2; do
		fivecheck -q $all --shard=$k/2 -f ndjson=shard$k.json -s long-setup.xml long.xml long.nc 2>shard$k
	done
	fivecheck merge -o joined.json shard1.json shard2.json
	jq -r 'select(.fraction) | "joined: \(.kind) line \(.line)"' joined.json
done
