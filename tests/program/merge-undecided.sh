# Shards that cannot decide a pair: joined, they have the verdict and the errors of the whole program, in its order.
# The drawings are too far from the origin for the tolerance. Of two shards, the second has the blocks 1025 to 2048.
small_machine
box head 899999936 -16 900000064 900000064 16 900000128
box quill 899999936 20 900000064 900000064 44 900000128
box table 899999936 -48 899999936 900000064 48 900000000
sed -i 's,</base>,<axis name="W" type="linear" direction="0 0 1" rate_max="6000"><body name="quill" mesh="quill.stl"/>\
</axis></base>,' m.xml
idle='for (i = 0; i < 600; i++) print "G0 X1\nG0 X0"'
awk "BEGIN { $idle; $idle; print \"G1 Z-63.99999 F6000\nG0 Z0\"; $idle }" | sed '1100s/.*/G1 W-63.99999 F6000/
1101s/.*/G0 W0/' >late.nc
# Without --all the check ends with the first finding, X300, so that later errors do not count.
sed '1s/.*/G0 X300/' late.nc >found.nc
sed '1900s/.*/G0 X300/' late.nc >between.nc
outcome() {
	sed -n 's/.*"verdict":\("[a-z]*"\).*"errors":/\1 /p; s/.*"summary","status":\([0-9]\).*/status \1/p' "$1"
}
for program in late.nc found.nc between.nc; do
	for all in "" -a; do
		fivecheck -q --tolerance 1e-6 $all -f ndjson m.xml $program >run.ndjson 2>/dev/null || :
		for k in 1 2; do
			fivecheck -q --tolerance 1e-6 $all --shard=$k/2 -f ndjson m.xml $program >s$k.ndjson 2>/dev/null || :
		done
		fivecheck merge s1.ndjson s2.ndjson >joined.ndjson 2>/dev/null || :
		echo "$program $all"
		outcome run.ndjson | tee whole | sed 's/ cannot be decided[^"]*"/ ..."/g'
		outcome joined.ndjson | cmp whole -
	done
done
