# With the tool guided (TCP) and the table turning: the result for the tool length against runs with a changed setup.
top=${LIB%/*}/../..
cp "$top"/examples/ac-trunnion/*.stl .
# check SETUP OPTION...
check() {
	fivecheck -q -s "$@" "$top/machines/ac-trunnion/machine.xml" "$top/examples/ac-trunnion/clear.nc" 2>/dev/null
}
check "$top/examples/ac-trunnion/setup.xml" --sensitivity 0,0,0,5 -f ndjson=out.json
sed -n 's/.*"sensitivity":\[\(.*\)\]}$/\1/p' out.json | sed 's/},{/}\n{/g' >answers
sed 's/\(proved\|tried\|turn\)":[0-9.]*/\1":*/g' answers
for key in proved turn; do
	amount=$(sed -n '/"direction":"-"/s/.*"'$key'":\([0-9.]*\).*/\1/p' answers)
	awk -v by="$amount" '
		match($0, /<tool .* length="[0-9.]+"/) {
			split($0, part, / length="/)
			length_of = part[2] + 0
			sub(/ length="/, sprintf(" length_offset=\"%.9f\" length=\"", length_of - by))
			changed++
		}
		{ print }
		END { print changed " tools" >"changed" }' "$top/examples/ac-trunnion/setup.xml" >changed.xml
	cat changed
	status check changed.xml -o /dev/null
done
