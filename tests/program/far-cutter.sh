# A cutter that feeds and turns but never comes near the part is a caution beside the verdict, with every method.
need jq
stock_mill
box cube -20 -20 0 20 20 30
# The tip of both tools is at the workholding at Z0; the part is 30 mm high.
setup s.xml <<'XML'
  <work_offset name="G54" Z="-100"/>
  <part name="cube" mesh="cube.stl"/>
  <tool number="1" length="100">
    <holder><section length="50" diameter="50"/></holder><cutter><section length="50" diameter="20"/></cutter>
  </tool>
  <tool number="2" length="100">
    <holder><section length="50" diameter="50"/></holder><cutter><section length="50" diameter="4"/></cutter>
  </tool>
XML
said() { # ARGUMENT... - the verdict and what is said of cutters
	fivecheck "$@" 2>&1 | sed -n 's/^caution: \(.*\); check.*/  \1/p; s/^    \([^ ].*\); check the work.*/  \1/p; s/^[a-z.]*: \([a-z ]*\):.*/\1/p'
}
program near.nc <<'NC'
T1 M6
G43 H1
S5000 M3
G0 X0 Y0 Z50
G1 Z29.5 F500
G1 X40
G0 X0 Z150
T2 M6
G43 H2
M3
G1 Z34
M2
NC
sed 's/Z50/Z80/; s/Z29.5/Z67/; s/Z34/Z69/' near.nc >far.nc
sed 's/Z34/Z69/' near.nc >one.nc
echo "near, both tools far, one of them:"
for p in near far one; do
	said -s s.xml m.xml $p.nc
done

echo "near is the radius of the cutter, but 5 mm at least; the tips are so far above the part:"
for z in 39.9 40.1; do
	echo "tool 1 at $z:"
	sed "s/Z29.5/Z$z/" near.nc >z.nc
	said -s s.xml m.xml z.nc
done
for z in 34.9 35.1; do
	echo "tool 2 at $z:"
	sed "s/Z34/Z$z/" near.nc >z.nc
	said -s s.xml m.xml z.nc
done
echo "with a blank of 34 mm, 1 mm:"
sed 's|</setup>|<stock box="50 50 34"/>&|' s.xml >stock.xml
for z in 34.9 35.1; do
	sed "s/Z34/Z$z/" near.nc >z.nc
	said -s stock.xml m.xml z.nc
done
echo "the same for every way to check:"
said -s s.xml m.xml far.nc | grep '^  ' >cautions
for option in -j2 -j8 -a -v --timing=t.tsv --clearance-report=c.tsv --method=conventional --method=interpolated --fail-on=limit; do
	said "$option" -s s.xml m.xml far.nc | grep '^  ' | cmp - cautions || echo "$option differs"
done
for k in 1 2 3; do
	"$FIVECHECK" -q -s s.xml --shard $k/3 -f ndjson=s$k.json m.xml far.nc 2>/dev/null
done
fivecheck merge s1.json s2.json s3.json | jq -r 'select(.kind == "program") | .verdict, (.cautions[] | select(test("comes near")))'
echo "several programs, and a job file:"
"$FIVECHECK" -j8 -s s.xml -f ndjson m.xml near.nc far.nc one.nc 2>/dev/null | jq -r 'select(.kind == "program") |
	.file + ": " + (.cautions | map(select(test("comes near")))[] // "nothing")' | sed 's/;.*//'
echo '<jobs version="1"><job name="op" machine="m.xml" setup="s.xml"><program file="one.nc"/></job></jobs>' >jobs.xml
said jobs.xml
echo "in every format:"
for format in text ndjson github sarif junit; do
	"$FIVECHECK" -f $format -s s.xml m.xml far.nc >$format.out 2>$format.err
	printf '%s: status %s, said %s\n' $format $? "$(cat $format.out $format.err | grep -c 'no cutter comes near')"
done
jq -c '[.runs[0].results[], .runs[0].invocations[].toolExecutionNotifications[]? | select(tostring | test("no cutter")) | keys]' sarif.out
echo "nothing is said: limits alone, no end because of a finding, an error, or a tool or part that is marked:"
fivecheck --parse-only -s s.xml m.xml far.nc 2>&1 | grep -c 'comes near'
sed 's/^M2/G0 X0 Z-20/' far.nc >found.nc
fivecheck -s s.xml m.xml found.nc 2>&1 | grep 'comes near\|finding'
sed 's/^M2/G0 Q/' far.nc >error.nc
fivecheck -s s.xml m.xml error.nc 2>&1 | grep -c 'comes near'
sed 's/<tool/& checked="r"/' s.xml >tools.xml
said -s tools.xml m.xml far.nc
sed 's/<part/& checked="r"/' s.xml >part.xml
said -s part.xml m.xml far.nc
sed 's/<tool/& kind="nozzle"/' s.xml >nozzle.xml
said -s nozzle.xml m.xml far.nc
echo "with --all the program is read to its end:"
fivecheck -a -s s.xml m.xml found.nc 2>&1 | grep 'comes near\|finding' | sed 's/;.*//'
echo "in a subprogram:"
program sub.nc <<'NC'
o100 sub
G1 Z67 F500
o100 endsub
T1 M6
G43 H1
S5000 M3
o100 call
M2
NC
said -s s.xml m.xml sub.nc
fivecheck --explain far-cutter | head -3

echo "of several programs at once, too:"
programs="near.nc far.nc one.nc near.nc far.nc one.nc"
fivecheck -q -s s.xml m.xml $programs >alone
for j in 2 3 8; do
	fivecheck -q -j $j -s s.xml m.xml $programs >together 2>err || echo "-j $j: status $?"
	cmp alone together && cat err
done
