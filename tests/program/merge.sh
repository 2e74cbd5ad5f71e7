# The results of shards, joined by fivecheck merge, are those of one run; whatever is missing is an error.
need jq
small_machine
printf 'G0 X300\nG0 X10\nG1 Z-120 F6000\n' >a.nc
for i in 1 2 4 5 6 7; do echo "G0 X${i}0" >p$i.nc; done
echo 'G0 B1' >p3.nc
awk 'BEGIN { for (i = 0; i < 4000; i++) printf "G0 X%d Z%d\n", i % 203, -(7 * i % 103) }' >long.nc
same() { # A B
	jq -c . "$1" >a.lines
	jq -c . "$2" >b.lines
	cmp a.lines b.lines && echo same
}
shards() { # N OPTION...
	n=$1
	shift
	rm -f s*.json
	for k in $(seq "$n"); do
		fivecheck -q -a --shard "$k/$n" -f ndjson=s"$k".json "$@" 2>/dev/null
	done
}
# A list, dealt out.
fivecheck -q -a -f ndjson=whole.json m.xml a.nc p?.nc 2>/dev/null
for n in 1 2 3 10; do
	shards $n m.xml a.nc p?.nc
	status fivecheck merge s*.json >merged.json 2>messages
	tail -n 1 merged.json
	sed '$d' merged.json >lines && same lines whole.json
done
# One program.
fivecheck -q -a -f ndjson=whole.json m.xml long.nc 2>/dev/null
for n in 1 2 3; do
	shards $n m.xml long.nc
	status fivecheck merge s*.json >merged.json
	tail -n 1 merged.json
	sed '$d' merged.json >lines && same lines whole.json
done
echo "one shard keeps its order:"
# Their times have 12 digits: late in a program, two findings of one block may have the same one.
printf 'G0 X10\nG1 Z-120 F6000\n' >z.nc
shards 2 m.xml z.nc
sed -e '/^{"kind":"collision"/ { p; s/"a":"head"/"a":"arm"/; s/"fraction":0.8333/"fraction":0.8334/; }' \
	-e 's/"findings":1/"findings":2/' s1.json >twice.json
fivecheck merge twice.json s2.json | jq -r '.a | values'
echo "stops at the first that fails:"
{ echo 'G0 X250'; cat long.nc; } >limit.nc
fivecheck -q --fail-on collision -f ndjson=whole.json m.xml limit.nc 2>/dev/null
for k in 1 2 3; do
	fivecheck -q --fail-on collision --shard $k/3 -f ndjson=s$k.json m.xml limit.nc 2>/dev/null
done
status fivecheck merge s?.json >merged.json
tail -n 1 merged.json
grep -v -e '"program"' -e '"summary"' merged.json | sed '$d' >lines
grep -v -e '"program"' -e '"summary"' whole.json >rest.json
same lines rest.json
shards 2 m.xml p1.nc
status fivecheck merge s*.json | sed -n 's/.*\("verdict":"[a-z]*"\).*/\1/p;$p'
# What is said beside a verdict keeps its order, and is said once.
sed -i -e 's/"cautions":\[/&"there was no setup",/' -e 's/"errors":\[/&"in line 9","in line 10"/' s1.json s2.json
fivecheck merge s1.json s2.json | grep -o '"cautions":.*'
fivecheck -q -f ndjson=s1.json m.xml p1.nc 2>/dev/null
status fivecheck merge s1.json >merged.json
sed '$d' merged.json >lines && same lines s1.json
echo "faults:"
shards 3 m.xml long.nc
status fivecheck merge s1.json s3.json 2>&1
status fivecheck merge s1.json s2.json s2.json s3.json 2>&1
status fivecheck merge s1.json s2.json s2.json 2>&1
sed '$d' s2.json >cut.json
status fivecheck merge s1.json cut.json s3.json 2>&1
: >empty.json
status fivecheck merge s1.json empty.json s3.json 2>&1
head -c 1000 s2.json >torn.json
fivecheck merge s1.json torn.json s3.json >out 2>/dev/null
echo "status $?, $(wc -c <out) bytes"
fivecheck -q -a --clearance 1 --shard 2/3 -f ndjson=other.json m.xml long.nc 2>/dev/null
status fivecheck merge s1.json other.json s3.json 2>&1
fivecheck -q -a --shard 2/3 -f ndjson=other.json m.xml a.nc 2>/dev/null
status fivecheck merge s1.json other.json s3.json 2>&1
fivecheck -q -a --shard 2/3 -f ndjson=other.json m.xml a.nc p1.nc 2>/dev/null
status fivecheck merge s1.json other.json s3.json 2>&1
sed 's/"checked":[0-9]*/"checked":1/' s3.json >other.json
status fivecheck merge s1.json s2.json other.json 2>&1
grep -v '^{"kind":"program"' s2.json >other.json
status fivecheck merge s1.json other.json s3.json 2>&1
sed 's/\("file":"m.xml"\),"sha256":"[0-9a-f]*"/\1/' s2.json >other.json
status fivecheck merge s1.json other.json s3.json 2>&1
status fivecheck merge s1.json nowhere.json 2>&1
cat s1.json s2.json >other.json
status fivecheck merge other.json s3.json 2>&1
echo "stale shards:"
# Every shard must have read the same bytes with the same options.
stale() { # WHAT: the first shard is of today, the second of before
	fivecheck -q -a --shard 2/2 $2 -f ndjson=s2.json m.xml long.nc 2>/dev/null
	status fivecheck merge s1.json s2.json 2>&1
}
fivecheck -q -a --shard 1/2 -f ndjson=s1.json m.xml long.nc 2>/dev/null
stale "nothing changed" | tail -n 1
cp long.nc long.keep
echo 'G0 X1' >>long.nc
stale program
cp long.keep long.nc
cp m.xml m.keep
echo '<!-- edited -->' >>m.xml
stale machine
cp m.keep m.xml
cp head.stl head.keep
box head -9 -9 0 9 9 100
stale mesh
cp head.keep head.stl
stale options --block-delete
stale options --dialect=fanuc
stale options --tolerance=0.01
stale options --stock-tolerance=0.5
fivecheck -q -a --shard 1/2 -f ndjson=s1.json m.xml - <long.nc 2>/dev/null
fivecheck -q -a --shard 2/2 -f ndjson=s2.json m.xml - <long.nc 2>/dev/null
status fivecheck merge s1.json s2.json 2>&1
# A list that has changed since, and a subprogram.
fivecheck -q -a --shard 1/2 -f ndjson=s1.json m.xml p1.nc p2.nc p4.nc 2>/dev/null
fivecheck -q -a --shard 2/2 -f ndjson=s2.json m.xml p1.nc p2.nc 2>/dev/null
status fivecheck merge s1.json s2.json 2>&1 | sed 's/[0-9a-f]\{64\}/DIGEST/g'
printf 'o<sub> sub\nG0 X20\no<sub> endsub\nM2\n' >sub.ngc
printf 'o<sub> call\nM2\n' >c1.nc
cp c1.nc c2.nc
fivecheck -q -a --shard 1/2 -f ndjson=s1.json m.xml c1.nc c2.nc 2>/dev/null
fivecheck -q -a --shard 2/2 -f ndjson=s2.json m.xml c1.nc c2.nc 2>/dev/null
status fivecheck merge s1.json s2.json | tail -n 2 | sed 's/[0-9a-f]\{64\}/DIGEST/g'
sed -i s/X20/X21/ sub.ngc
fivecheck -q -a --shard 2/2 -f ndjson=s2.json m.xml c1.nc c2.nc 2>/dev/null
status fivecheck merge s1.json s2.json 2>&1
status fivecheck merge 2>&1
fivecheck merge --help | head -n 1
status fivecheck merge -o s1.json s1.json 2>&1
# A whole run.
status fivecheck merge whole.json whole.json 2>&1
# With --fail-on=warning a clear program fails the run: the summary is that of the whole run.
printf 'G21 G61 G0 X1 X2\n' >w1.nc
printf 'G21 G61 G0 X2\n' >w2.nc
fivecheck -q --duplicates=last --fail-on=warning -f ndjson=whole.json m.xml w1.nc w2.nc 2>/dev/null
for k in 1 2; do
	fivecheck -q --duplicates=last --fail-on=warning --shard $k/2 -f ndjson=s$k.json m.xml w1.nc w2.nc 2>/dev/null
done
status fivecheck merge s1.json s2.json | tail -n 2
tail -n 1 whole.json
