# How far a setup may be wrong: 1 mm above the table, 2 mm from a limit, and values without effect.
small_machine
setup s.xml <<'XML'
<work_offset name="G54" X="10" Z="-99"/>
<tool number="1" length="0.5"><holder><section length="0.5" diameter="4"/></holder></tool>
XML
printf '%s\n' 'G54 G0 X188' 'G1 Z0 F6000' 'X0' 'G53 G0 Z0' >a.nc
printf '%s\n' 'T1 M6' 'G0 G43 H1 Z-0.5' 'G0 X-150' 'G49' >tool.nc
# ranges - of each changing answer in the text: is the bracket narrow enough, and does it contain the true value?
brackets() {
	awk -v known="$*" '
	BEGIN { split(known, k, " ") }
	!/; at / { print; next }
	{
		match($0, /up to [0-9.]+/); proved = substr($0, RSTART + 6, RLENGTH - 6) + 0
		match($0, /; at [0-9.]+/); turn = substr($0, RSTART + 5, RLENGTH - 5) + 0
		truth = k[++n] + 0
		good = proved <= truth && turn >= truth - 0.0011 && turn - proved <= 0.0062
		print substr($0, 1, 22) (good ? "turns at " truth : proved " to " turn " is wrong") ":" substr($0, RSTART + RLENGTH)
	}'
}
fivecheck -q --sensitivity 5,5,5,5 -s s.xml m.xml a.nc | brackets 2 1
fivecheck -q --sensitivity 5,0,20,0.5 -s s.xml m.xml tool.nc | brackets 0.5 0.5
# A tool that is loaded but never moved counts as well.
printf '%s\n' 'G54 G0 X0 Z0' 'T1 M6' >put.nc
fivecheck -q --sensitivity 0,0,5,0 -s s.xml m.xml put.nc | brackets 0.5
# The required clearance is kept; the same answers for any number of threads.
fivecheck -q --sensitivity 0,0,5,0 --clearance 0.25 -s s.xml m.xml a.nc | brackets 0.75
fivecheck -q --sensitivity 5,5,5,5 -s s.xml m.xml a.nc tool.nc >one
fivecheck -q -j 8 --sensitivity 5,5,5,5 -s s.xml m.xml a.nc tool.nc >eight
cmp one eight
# Independent runs: with the setup changed by the proved amount the verdict holds, with the other amount it does not.
fivecheck -q -f ndjson=out.json --sensitivity 20,0,20,0 -s s.xml m.xml a.nc
sed -n 's/^{"kind":"program".*"sensitivity":\[\(.*\)\]}$/\1/p' out.json | sed 's/},{/}\n{/g' >answers
sed 's/\(proved\|tried\|turn\)":[0-9.]*/\1":*/g' answers
while read -r answer; do
	value() { echo "$answer" | sed 's/.*"'"$1"'":"*\([^,"}]*\).*/\1/'; }
	[ "$(value turn)" != null ] || continue
	for change in "$(value proved)" "$(value turn)"; do
		awk -v axis="$(value quantity)" -v by="$(value direction)$change" '{
			name = toupper(axis)
			if (match($0, name "=\"[^\"]*\"")) {
				old = substr($0, RSTART + 3, RLENGTH - 4)
				$0 = substr($0, 1, RSTART + 2) sprintf("%.9f", old + by) substr($0, RSTART + RLENGTH - 1)
			}
			print }' s.xml >changed.xml
		fivecheck -q -o /dev/null -s changed.xml m.xml a.nc
		echo "$(value quantity) $(value direction): status $?"
	done
done <answers
# A program with a finding: tried in steps, without proof. And a program that cannot be interpreted.
printf '%s\n' 'G54 G0 X-50 Z-2' >b.nc
status fivecheck -q -a --sensitivity 1,0,5,0 -s s.xml m.xml b.nc | sed -n '/with one/,$p'
status fivecheck -q --sensitivity 1,0,5,0 -s s.xml m.xml absent.nc
printf '%s\n' 'G0 Q1' >c.nc
status fivecheck -q --sensitivity 1,0,5,0 -s s.xml m.xml c.nc
# Nothing is proved for a program that reads the offset and takes another path; one that then fails is reported.
printf '%s\n' '#1 = #5221' 'o1 if [#1 GT 13]' 'G0 X-100' 'o1 else' 'G0 X100' 'o1 endif' >course.nc
fivecheck -q --sensitivity 5,0,0,0 -s s.xml m.xml course.nc
printf '%s\n' '#1 = #5221' 'o1 if [#1 GT 13]' 'G0 Q1' 'o1 endif' 'G54 G0 X100' >fails.nc
fivecheck -q --sensitivity 5,0,0,0 -s s.xml m.xml fails.nc
# Standard input may be a file, which can be read again, but not a pipe.
fivecheck -q --sensitivity 0,0,5,0 -s s.xml m.xml - <a.nc | brackets 1
cat a.nc | status fivecheck -q --sensitivity 0,0,5,0 -s s.xml m.xml -
for value in 1 1,2,3 1,2,3,4,5 1,2,3,x 1,2,3,-4 0,0,0,0 1,,1,1 20000,1,1,1; do
	status fivecheck --sensitivity $value m.xml a.nc
done 2>&1 | grep -v note
status fivecheck --sensitivity 1,1,1,1 --method conventional m.xml a.nc
status fivecheck --sensitivity 1,1,1,1 --fail-on limit m.xml a.nc
status fivecheck --sensitivity 1,1,1,1 -f junit m.xml a.nc
