# What is found where the axes stand, before a block moves them, comes before what is found as they begin to move: the
# first finding is the same with --all, though the pair that is found second stands first in the machine file.
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
# Bodies and the stock are checked after all others, and still take their place in the order of the file.
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
