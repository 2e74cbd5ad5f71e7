# A job file names machine, setup and programs: several setups are checked in one command, and make gets all inputs.
small_machine
setup low.xml <<'XML'
<work_offset name="G54" Z="0"/>
<tool number="1" length="50"><cutter><section length="50" diameter="10"/></cutter></tool>
XML
sed 's/length="50"/length="90"/g' low.xml >long.xml
program a.nc <<'NC'
G21 G90 G54 G49
T1 M6
G0 X10
Z-45
M2
NC
sed 's/Z-45/Z-30/' a.nc >b.nc
cat >jobs.xml <<'XML'
<jobs version="1">
  <job name="op10" machine="m.xml" setup="low.xml"><program file="a.nc"/><program file="b.nc"/></job>
  <job name="op20" machine="m.xml" setup="long.xml"><program file="b.nc"/></job>
</jobs>
XML
"$FIVECHECK" jobs.xml 2>&1 | grep -v 'time\|G64'
echo "the same as each check by itself:"
findings jobs.xml | tee all
{
	findings -s low.xml m.xml a.nc b.nc
	findings -s long.xml m.xml b.nc
} | cmp - all
status "$FIVECHECK" -q jobs.xml >/dev/null
status "$FIVECHECK" -q jobs.xml | tail -1
sed '/op20/d' jobs.xml >one.xml
status "$FIVECHECK" -q one.xml
echo "a file for each job:"
"$FIVECHECK" -q -f ndjson=out-%.ndjson --report=%.html --depfile=%.d jobs.xml
grep -c '"kind"' out-op10.ndjson out-op20.ndjson
ls -- *.html
cat op20.d
"$FIVECHECK" -q -f ndjson=all.ndjson jobs.xml
status "$FIVECHECK" -q -o same one.xml
echo "for make:"
"$FIVECHECK" --depends jobs.xml
"$FIVECHECK" --depends -s low.xml m.xml a.nc
echo "paths are relative to the job file:"
mkdir sub
sed 's/="\([a-z]*\.\)/="..\/\1/g' one.xml >sub/jobs.xml
findings sub/jobs.xml
echo "an incomplete job is told, and the others are checked all the same:"
sed 's/low.xml/gone.xml/' jobs.xml >gone-jobs.xml
status "$FIVECHECK" -q gone-jobs.xml 2>&1 | grep -v '^    '
echo "no report takes the place of that of another job:"
sed 's/op20/op10-b/' jobs.xml >same-jobs.xml
status "$FIVECHECK" -q --report=%.html same-jobs.xml 2>&1
"$FIVECHECK" -q -f ndjson=%.ndjson same-jobs.xml
echo "faults:"
fault() { # SED-SCRIPT [OPTION...]
	sed "$1" jobs.xml >bad.xml
	shift
	status "$FIVECHECK" -q "$@" bad.xml 2>&1
}
fault 's/op20/op10/'
fault 's/op20/..\/op/'
fault 's/name="op10" //'
fault 's/machine="m.xml"//'
fault '/<job /d'
fault 's/<program[^>]*>//g'
fault 's/<job name="op10"/<job name="op10" clearance="1"/'
fault 's/version="1"/version="2"/'
fault '' -s low.xml
fault '' --waivers w.xml
fault '' --shard 1/2
fault '' -s low.xml --shard 1/2
fault '' --list-pairs
status "$FIVECHECK" -q jobs.xml a.nc
fault '' -f junit
fault '' -f sarif=-
