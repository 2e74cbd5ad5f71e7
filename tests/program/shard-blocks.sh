# One long program shared out by its blocks: every block is checked by exactly one shard, and together the shards have
# the findings of one run. The program has contacts, limits, tool changes, and bodies that stay inside others.
box probe -1 -1 100 1 1 102
box head -20 -20 150 20 20 200
box table -50 -50 -90 50 50 0
machine m.xml <<'XML'
  <axis name="X" type="linear" direction="1 0 0" limit_min="-200" limit_max="200" rate_max="6000">
    <axis name="Z" type="linear" direction="0 0 1" limit_min="-250" limit_max="50" rate_max="6000">
      <body name="head" mesh="head.stl"/>
      <body name="probe" mesh="probe.stl"/>
      <spindle location="60 0 150" checked="the tool stands beside the head" direction="0 0 -1"/>
    </axis>
  </axis>
  <axis name="C" type="rotary" direction="0 0 -1" location="0 0 0" rate_max="3600">
    <body name="table" mesh="table.stl"/>
    <workholding location="0 0 0"/>
  </axis>
XML
box block -10 -10 0 10 10 20
setup s.xml <<'XML'
<part name="block" mesh="block.stl" location="0 0 2"/>
<tool number="1" length="60"><holder><section length="60" diameter="10"/></holder></tool>
<tool number="2" length="4"><holder><section length="4" diameter="1"/></holder></tool>
XML
# 5200 blocks; the probe is inside the table in the blocks 900 to 2200, the short tool at its change.
awk 'BEGIN {
	srand(5)
	print "T1 M6"
	for (i = 1; i < 5200; i++) {
		if (i == 900 || i == 3500)
			print "G0 X0 Z-150"
		else if (i == 2200 || i == 3600)
			print "G0 Z0"
		else if (i > 900 && i < 2200)
			printf "G1 X%.3f Z%.3f F5000\n", 20 * rand() - 10, -150 + 10 * rand()
		else if (i == 3000 || i == 4000)
			printf "T%d M6\n", i / 1000 - 2
		else if (i == 3550)
			print "T2 M6"
		else if (i % 701 == 0)
			print "G0 X250"
		else if (i % 97 == 0)
			printf "G18 G2 X%.3f Z20 R%d F6000\n", 100 * rand() - 50, 1000
		else
			printf "G0 X%.3f Z%.3f C%d\n", 300 * rand() - 150, 60 - 120 * rand(), 360 * rand()
	}
}' >a.nc
in_order() {
	sed -e '/"kind":"header"/d' -e '/"kind":"program"/d' -e '/"kind":"summary"/d' "$@"
}
found() {
	in_order "$@" | sort
}
compare() { # SHARDS OPTION...
	shards=$1
	shift
	fivecheck -q -a "$@" -f ndjson=whole.json -s s.xml m.xml a.nc 2>/dev/null
	found whole.json >whole
	[ "$(wc -l <whole)" -gt 500 ] || echo "few findings"
	for n in $shards; do
		k=1
		while [ $k -le $n ]; do
			fivecheck -q -a "$@" --shard $k/$n -f ndjson=part$k.json -s s.xml m.xml a.nc 2>/dev/null
			k=$((k + 1))
		done
		found part?.json | cmp - whole
		in_order whole.json >whole_in_order
		fivecheck merge part?.json 2>/dev/null | in_order | cmp - whole_in_order
		cat part?.json | sed -n 's/.*"blocks":\([0-9]*\),"checked":\([0-9]*\),.*/\1 \2/p' |
			awk '{ sum += $2; if ($1 != 5200) exit 1 } END { if (sum != 5200) print sum " blocks of 5200" }'
		rm part?.json
	done
}
compare '1 2 3 4 5'
compare 3 --clearance 1.5 -j 2
compare 4 --parse-only
compare 5 --method=conventional --step 0.1
# Without --all, the first finding of the run is reported by its shard.
fivecheck -q -s s.xml m.xml a.nc | grep error >first
for k in 1 2 3; do
	fivecheck -q -f ndjson --shard $k/3 -s s.xml m.xml a.nc 2>/dev/null | sed -n 's/.*"line":\([0-9]*\),.*"time":\([0-9.]*\),.*/\2 \1/p'
done | sort -g | sed -n 's/.* //;1p' | sed 's/\(.*\)/a.nc:\1:/' >line
grep -q -F "$(cat line)" first || cat first line
# The verdict of one shard: it never calls the program clear.
printf 'G0 X10\n' >b.nc
status fivecheck -q --shard 1/2 -s s.xml m.xml b.nc
status fivecheck -q --shard 2/2 -s s.xml m.xml b.nc
fivecheck -q --shard 2/2 -f ndjson --record r.json -s s.xml m.xml b.nc 2>/dev/null
grep -e blocks_proved -e shard r.json
status fivecheck -q --shard 2/2 --waivers w.xml -s s.xml m.xml b.nc 2>&1
