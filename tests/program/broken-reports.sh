# If the machine file has an error, the reports say so: a report of an earlier run must not look like one of this run.
small_machine
echo 'G0 X10' >a.nc
echo 'G0 X20' >b.nc
run() {
	fivecheck "$@" -f text -f ndjson=out.json -f sarif=out.sarif -f junit=out.xml -f github=out.txt --record out.record m.xml \
		a.nc b.nc
}
status run -q
sed -i 's/rate_max="3600"/rate="3600"/' m.xml
echo "broken:"
status run 2>&1
cat out.json out.xml
grep -o -e '"ruleId".*"uri":"[a-z.]*"' -e '"exit.*' out.sarif
# Text reports, records and all other files stay: such a file may be a mesh of the machine.
cat out.txt
grep -c clear out.record
cp head.stl before.stl
status fivecheck -q -f sarif=head.stl m.xml a.nc 2>/dev/null
cmp head.stl before.stl
status fivecheck -f github m.xml a.nc 2>/dev/null
echo "no setup, no waivers:"
sed -i 's/rate="3600"/rate_max="3600"/' m.xml
for option in -s --waivers; do
	status fivecheck -q $option nowhere.xml m.xml a.nc 2>/dev/null
done
echo "a file beside the reports cannot be written, or needs a stock:"
fivecheck -q -f text=old.txt -f junit=old.xml m.xml a.nc
cp old.txt before.txt
echo 'no report' >other
for option in --pose=none/a.stl --report=none/a.html --picture=none/a.svg --report=other --stock-out=a.stl; do
	status fivecheck -q "$option" -f text=old.txt -f junit=old.xml --depfile=a.d m.xml a.nc 2>&1
	cmp before.txt old.txt
	grep -o '<error message="[^"]*"' old.xml
done
ls a.d 2>&1 | grep -c '^a.d'
rm old.txt old.xml before.txt other
echo "subprograms and lists are inputs, too:"
printf 'o<sub> sub\nG0 X1\no<sub> endsub\n' >sub.ngc
echo 'o<sub> call' >c.nc
echo c.nc >list
for arguments in '-o sub.ngc' '-o /dev/null --record sub.ngc' '-o x --depfile sub.ngc' '--pose sub.ngc -o /dev/null' '-o list'; do
	# shellcheck disable=SC2086 # words, on purpose
	status fivecheck -q $arguments --files-from list m.xml 2>&1
done
head -n 1 sub.ngc list
ls
