# If a report cannot be made, the message says what is missing, and the exit status is 2; an old file stays.
small_machine
program a.nc <<'NC'
G1 Z-120 F600
NC
status fivecheck -q --report=nowhere/a.html m.xml a.nc
status fivecheck -q --picture=nowhere/a.svg m.xml a.nc
status fivecheck -q --picture=a.jpg m.xml a.nc
status fivecheck -q --report=- m.xml a.nc
status fivecheck -q --report-size=1 m.xml a.nc
status fivecheck -q --report=a.nc m.xml a.nc
status fivecheck -q --report=same --picture=same.svg -o same m.xml a.nc
status fivecheck -q --report=a.html --shard=1/2 m.xml a.nc
status fivecheck -q --report=a.html --list-pairs m.xml
echo old >kept.html
chmod a-w kept.html
if [ "$(id -u)" != 0 ]; then
	fivecheck -q --report=kept.html m.xml a.nc >/dev/null 2>&1
	[ $? = 2 ] || echo "a file that may not be written was written"
fi
[ -e /dev/full ] && fivecheck -q --report=/dev/full m.xml a.nc
echo "status $?"
# An error in the program: the report says so.
program bad.nc <<'NC'
G1 Z-20 F600
G999
NC
status fivecheck -q --report=bad.html m.xml bad.nc
grep -o 'G999[^<]*</li>' bad.html
# A report that cannot be written adds an error after those in the output.
[ -e /dev/full ] && fivecheck -q --report=/dev/full -f ndjson m.xml bad.nc >bad.ndjson
echo "status $?"
grep -o '"errors":.*' bad.ndjson
# A missing program.
status fivecheck -q --report=none.html m.xml none.nc
grep -o 'incomplete: the program could not be opened' none.html | head -n 1
# An accepted finding is in the report, too, and the status stays 0.
status fivecheck -q --fail-on=limit --report=accepted.html m.xml a.nc | tail -n 1
grep -o 'does not fail the run: [^<]*' accepted.html
