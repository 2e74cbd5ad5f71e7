# fivecheck waive writes waivers from a run: its findings are accepted, also in other lines; new ones fail.
small_machine
export SOURCE_DATE_EPOCH=1767225599 # 2025-12-31
printf 'G0 X10\nG1 Z-120 F6000\nG0 Z0\nG0 X300\nG0 X0\n' >a.nc
rows() {
	grep -e '^[a-z]'
}
status fivecheck -q -a -f ndjson=run.json m.xml a.nc 2>/dev/null
status fivecheck waive --reason 'a "brush", it bends' --until 2026-06-30 run.json 2>&1 | sed 's/[0-9a-f]\{64\}/DIGEST/'
status fivecheck waive --reason 'a "brush", it bends' --until 2026-06-30 -o w.xml run.json 2>&1
status fivecheck -q --waivers w.xml m.xml a.nc | rows
echo "moved down:"
{ echo '(a new first line)'; cat a.nc; } >b.nc && mv b.nc a.nc
status fivecheck -q --waivers w.xml -f text -f ndjson=out.json -f sarif=out.sarif -f junit=out.xml \
	-f github=out.txt m.xml a.nc | rows
grep -c '"accepted":"waiver"' out.json
grep -c '"suppressions":' out.sarif
grep -e 'testsuites ' out.xml
wc -l <out.txt
tail -n 1 out.json
echo "what is waived is not waived again:"
fivecheck waive --reason r --until 2026-06-30 out.json 2>&1 | sed 's/[0-9a-f]\{64\}/DIGEST/'
echo "something new, and the same once more:"
echo 'G0 X-300' >>a.nc
printf 'G0 X10\nG1 Z-120 F6000\n' >>a.nc
status fivecheck -q --waivers w.xml m.xml a.nc | rows
status fivecheck -q -a --waivers w.xml m.xml a.nc | rows
echo "twice the same contact is one waiver:"
status fivecheck -q -a -f ndjson=run.json m.xml a.nc 2>/dev/null
fivecheck waive --reason r --until 2026-06-30 -o twice.xml run.json 2>&1
grep -B1 -c times= twice.xml
status fivecheck -q -a --waivers twice.xml m.xml a.nc | rows
echo "incomplete all the same:"
echo 'G0 B1' >>a.nc
status fivecheck -q -a --waivers twice.xml m.xml a.nc 2>/dev/null | tail -n 1
echo "another machine, another setup:"
cp m.xml keep.xml
echo '<!-- edited -->' >>m.xml
status fivecheck -q --waivers w.xml m.xml a.nc 2>&1
sed -i 's/machine_sha256="[^"]*"//' w.xml
fivecheck -q --waivers w.xml m.xml a.nc 2>/dev/null | rows
cp keep.xml m.xml
setup s.xml </dev/null
status fivecheck -q --waivers w.xml -s s.xml m.xml a.nc 2>&1
sed -i 's/setup_sha256="[^"]*"//' w.xml
fivecheck -q --waivers w.xml -s s.xml m.xml a.nc 2>/dev/null | rows
echo "no results of a run:"
head -n 3 run.json >cut.json
sed 's/"format":2/"format":1/' run.json >other.json
cat run.json run.json >twice.json
: >empty.json
tr '\n' '\0' <run.json >zeros.json
sed 's/"sha256":"[^"]*"/"sha256":null/' run.json >nobody.json
mkdir folder
for file in cut.json other.json twice.json empty.json zeros.json nobody.json /dev/zero folder a.nc nowhere.json; do
	status fivecheck waive --reason r --until 2026-06-30 $file 2>&1
done
echo "usage:"
for options in '' 'run.json' '--reason=r run.json' '--until=2026-06-30 run.json' '--reason= --until=2026-06-30 run.json' \
	'--reason=r --until=2026-02-30 run.json' '--reason=r --until=tomorrow run.json' \
	'--reason=r --until=2025-12-30 run.json' \
	'--reason=r --until=2026-06-30 run.json run.json' '--reson=r'; do
	# shellcheck disable=SC2086 # words, on purpose
	fivecheck waive $options 2>&1 | head -n 1
done
fivecheck waive -h | head -n 1
