# With --all, a pair that cannot be decided in one block is checked again in the next one. So the findings and the errors
# are the same, however many blocks are checked together: with every option that only tells more.
small_machine
box head 899999936 -16 900000064 900000064 16 900000128
box table 899999936 -48 899999936 900000064 48 900000000
box post -20 -20 -300 20 20 -200
sed -i 's,</base>,<body name="post" mesh="post.stl"/></base>,' m.xml
# Of four blocks one cannot be decided, one is clear, and one has a finding; Z-160 leaves the travel of the axis.
awk 'BEGIN {
	for (i = 0; i < 700; i++)
		printf "G1 Z-63.99999 F6000\nG0 Z0\nG1 Z-%d\nG0 Z%d\n", i % 50 == 49 ? 160 : 70 + i % 9, i % 7
}' >p.nc
printf 'G1 Z-63.99999 F6000\nG0 Z0\nG1 X1\nG1 Z-70\nG0 Z0\n' >first.nc
way() {
	name=$1
	shift
	rc=0
	fivecheck --tolerance 1e-6 -f ndjson=$name.ndjson -f text m.xml "$@" >$name.out 2>$name.err || rc=$?
	{
		echo "status $rc"
		grep -E '^\{"kind":"(collision|limit)"' $name.ndjson
		grep -o '"errors":.*' $name.ndjson
	} >$name.list
}
for program in p.nc first.nc; do
	for all in "" -a; do
		way plain $all "$program"
		grep -c '"kind":"' plain.list
		for ways in -j2 -j3 -j8 -v --timing=t.csv --clearance-report=c.csv --stats --report=r.html; do
			way other $all $ways "$program"
			cmp plain.list other.list || echo "$program $all $ways"
		done
		way s1 $all --shard=1/2 "$program"
		way s2 $all --shard=2/2 "$program"
		fivecheck merge -o joined.ndjson s1.ndjson s2.ndjson 2>/dev/null || echo "joined: status $?"
		grep -E '^\{"kind":"(collision|limit)"' joined.ndjson >joined.list
		grep -E '^\{"kind":"(collision|limit)"' plain.ndjson | cmp - joined.list
	done
done
# Each pair is named once, not once for each of its blocks.
grep -c 'cannot be decided' plain.err
