# What is known is accepted, wherever it stands now; what is new fails, and what cannot be checked even more so.
small_machine
printf 'G0 X10\nG1 Z-120 F6000\nG0 Z0\nG0 X300\nG0 X0\n' >a.nc
status fivecheck -q -a -f ndjson=known.json m.xml a.nc 2>/dev/null
status fivecheck -q --baseline known.json m.xml a.nc
echo "moved down:"
{ echo '(a new first line)'; cat a.nc; } >b.nc && mv b.nc a.nc
status fivecheck -q --baseline known.json -f text -f ndjson=out.json -f sarif=out.sarif -f junit=out.xml \
	-f github=out.txt m.xml a.nc |
	grep -e '^[a-z]'
grep -c '"accepted":"baseline"' out.json
grep -c '"suppressions":' out.sarif
grep -e 'testsuites ' out.xml
wc -l <out.txt
tail -n 1 out.json
echo "something new, and the same once more:"
echo 'G0 X-300' >>a.nc
printf 'G0 X10\nG1 Z-120 F6000\n' >>a.nc
status fivecheck -q --baseline known.json m.xml a.nc | grep -e '^[a-z]'
status fivecheck -q -a --baseline known.json m.xml a.nc | grep -e '^[a-z]'
echo "incomplete all the same:"
echo 'G0 B1' >>a.nc
status fivecheck -q -a --baseline known.json m.xml a.nc 2>/dev/null | tail -n 1
echo "no baselines:"
head -n 3 known.json >cut.json
sed 's/"format":2/"format":1/' known.json >other.json
cat known.json known.json >twice.json
: >empty.json
tr '\n' '\0' <known.json >zeros.json
mkdir folder
for file in cut.json other.json twice.json empty.json zeros.json /dev/zero folder a.nc nowhere.json; do
	fivecheck -q --baseline $file m.xml a.nc 2>&1
done
status fivecheck -q --baseline known.json -o known.json m.xml a.nc 2>&1
