# A cutter whose spindle stops in the finished part: the finding is at the stop, whether or not anything moves
# afterwards. The part and the tool are those of rapid-contact.sh: the core has a radius of 4.9 mm.
small_machine
box block -30 -30 0 30 30 20
setup s.xml <<'XML'
  <work_offset name="G54" X="0" Z="-100" C="0"/>
  <part name="block" mesh="block.stl"/>
  <tool number="1" length="60"><cutter><section length="60" diameter="10"/></cutter></tool>
  <tool number="2" length="60" kind="nozzle"><cutter><section length="60" diameter="10"/></cutter></tool>
XML

# cut DEPTH LINE... - the program p.nc: down to the depth at feed, then the lines
cut() {
	depth=$1
	shift
	printf '%s\n' 'G21 G90 G94 T1 M6' 'G0 X-60' 'G43 H1 Z60' 'M3 S1000' 'G0 X0 Z21' "G1 Z$depth F100" "$@" >p.nc
}

# run TITLE [OPTION...] - checks p.nc
run() {
	echo "== $1"
	shift
	findings "$@" -s s.xml m.xml p.nc
}

cut 5 M5 M30
run 'M5, and nothing moves afterwards'
fivecheck -q -s s.xml m.xml p.nc | grep 'error:'
for end in M2 M30 M0 M1; do
	cut 5 $end
	run "$end at the bottom"
done
cut 5 'T2 M6' M30
run 'M6 at the bottom'
cut 5 'T1 M6' M30
run 'M6 of the same tool, with --all: one finding of the pair in the block' -a
cut 5 M5 'G1 Z60' M30
run 'M5, then out at feed: found where it stops'
run 'and with --all once more on the way out' -a
cut 5 'G1 Z60' M5 M30
run 'out before the spindle stops'
cut 19.95 M5 M30
run 'within the allowance'
cut 5 'G1 Z60 M5' M30
run 'M5 in the block that retracts: LinuxCNC stops the spindle first'
cut 5 'G4 P1 M5' 'G4 P2' M30
run 'a dwell moves nothing'
cut 5 M5 M30
sed -e 's/T1/T2/' -e 's/H1/H2/' p.nc >nozzle.nc
mv nozzle.nc p.nc
run 'a nozzle needs no spindle'

echo '== the same for every number of threads, and in shards'
{
	printf '%s\n' 'G21 G90 G94 T1 M6' 'G0 X-60' 'G43 H1 Z60' 'G0 X0 Z21'
	i=0
	while [ $i -lt 300 ]; do
		printf '%s\n' 'M3 S1000' 'G1 Z5 F100' M5 'M3' 'G1 Z21'
		i=$((i + 1))
	done
	echo M30
} >p.nc
findings -a -j 1 -s s.xml m.xml p.nc >one
wc -l <one | tr -d ' '
for jobs in 2 3; do
	findings -a -j $jobs -s s.xml m.xml p.nc | cmp - one
done
for shard in 1 2 3; do
	findings -a --shard $shard/3 -s s.xml m.xml p.nc
done | sort -n -k 2 | grep -v '^status' >shards
grep -v '^status' one | sort -n -k 2 | cmp - shards

# Without S the speed of the control is not known, and may be 0.
printf '%s\n' 'G21 G90 G94 T1 M6' 'G0 X-60' 'G43 H1 Z60' M3 'G0 X0 Z21' 'G1 Z5 F100' M4 'G1 Z60' M30 >p.nc
fivecheck -q -s s.xml m.xml p.nc
fivecheck -s s.xml m.xml p.nc 2>&1 | grep M[34]
