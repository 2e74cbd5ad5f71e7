# The clearance of each block against a closed form: never more than the true value, and up to the cap at least 0.85 of
# it.
small_machine
cat >a.nc <<'NC'
G0 Z-50
G0 Z-95
G1 X30 F6000
X0 Z-99
M0
C90 X-60
Z-99.99 X0
X160
NC
# distances CAP LINE:MM ... - compares a report of the pair with the known values
distances() {
	awk -F, -v known="$*" 'BEGIN { count = split(known, k, /[ :]/); cap = k[1]; for (i = 2; i < count; i += 2) mm[k[i]] = k[i + 1] }
		NR == 1 { print; next }
		{ most = mm[$3] > cap ? cap : mm[$3]; good = $7 <= most && $7 >= 0.85 * most - 0.001 && ($8 == 1) == ($7 == cap)
		  print $1, $2, $3, $4, $5, $6, (good ? "as it is, or a little less" : $7 " is wrong") ($8 ? ", capped" : "") }' report.csv
}
status fivecheck -q --clearance-report report.csv m.xml a.nc
distances 10 1:50 2:5 3:5 4:1 6:1 7:0.01 8:0.01
fivecheck -q --clearance-report report.csv --clearance-cap 3.5 -o verdict m.xml a.nc
distances 3.5 1:50 2:5 3:5 4:1 6:1 7:0.01 8:0.01
# The verdict is the same without the report; the report is the same for any number of threads.
fivecheck -q -o without m.xml a.nc
cmp verdict without
fivecheck -q -j 8 --clearance-report again.csv --clearance-cap 3.5 -o verdict m.xml a.nc
cmp report.csv again.csv
# A step measured as clear is not checked again; a step within clearance and tolerance is.
spans() { awk '$1 == "measured" || $1 == "budgets" || $1 == "planes" { print $1, $2 }'; }
fivecheck --stats --clearance-report again.csv m.xml a.nc | spans
fivecheck -a --stats --clearance 1 --clearance-report again.csv m.xml a.nc | spans
fivecheck -a --stats --clearance 1 --clearance-cap 0.5 --clearance-report again.csv m.xml a.nc | spans
# A block that moves nothing has no row, wherever the pieces of a batch end: here one between two blocks of many moves.
for before in 0 1 2 3 4 5 6 7; do
	{
		printf '%s\n' 'G0 Z-95' F6000
		awk -v n="$before" 'BEGIN { while (n-- > 0) print "X" n }'
		printf '%s\n' 'G73 X130 R-70 Z-95 Q5' 'M3 S1' X150 G80 'G0 X0'
	} >quiet.nc
	fivecheck -q --clearance-report quiet.csv --clearance-cap 30 -o /dev/null m.xml quiet.nc
	tail -n +2 quiet.csv | cut -d , -f 3 | paste -s -d ' ' -
done
# Up to the block that ended the check, or for all blocks.
box "table, big" -50 -50 -20 50 50 0
sed -e 's/name="table" mesh="table.stl"/name="table, big" mesh="table, big.stl"/' m.xml >big.xml
printf '%s\n' 'G0 Z-95' 'G0 Z-101' 'G0 Z-95' 'G0 Z0' >b.nc
status fivecheck -q --clearance-report report.csv -o /dev/null big.xml b.nc
cut -d , -f 3- report.csv | sed 's/4\.[0-9]*,0/*,0/'
status fivecheck -q -a --clearance-report report.csv -o /dev/null big.xml b.nc
cut -d , -f 3- report.csv | sed 's/4\.[0-9]*,0/*,0/'
# A body wholly inside another has no clearance, however far its surface is away.
rectangle block 10 10 10
rectangle bead 2 2 2
machine in.xml <<'XML'
  <body name="block" mesh="block.stl"/>
  <axis name="X" type="linear" direction="1 0 0" rate_max="6000" home="30"><body name="bead" mesh="bead.stl"/></axis>
XML
printf 'G0 X%s\n' 28 0 1 30 31 >in.nc
fivecheck -q -a --clearance-report report.csv --clearance-cap 16 -o verdict in.xml in.nc
fivecheck -q -a -o without in.xml in.nc
cmp verdict without
cut -d , -f 3,7,8 report.csv | sed 's/1[3-8]\..*,0/*,0/'
# Several programs, subprograms, a program that breaks off, standard input.
printf 'o<near> sub\nG0 X%s\no<near> endsub\n' 20 >near.ngc
echo 'o<near> call' >c.nc
printf '%s\n' 'G0 X10' 'G0 Q1' >d.nc
echo 'G0 X5' | status fivecheck -q -j 4 --clearance-report report.csv -o /dev/null m.xml d.nc c.nc - 2>/dev/null
cat report.csv
# Invalid options.
status fivecheck --clearance-report a.nc m.xml a.nc
status fivecheck --clearance-report - m.xml a.nc
status fivecheck --clearance-report x.csv --timing x.csv m.xml a.nc
status fivecheck --clearance-report x.csv --method conventional m.xml a.nc
status fivecheck --clearance-cap 5 m.xml a.nc
status fivecheck -q --clearance-report nowhere/x.csv m.xml a.nc
status fivecheck -q --clearance-report /dev/full -o /dev/null m.xml a.nc
# The depfile names the report.
fivecheck -q --clearance-report report.csv --depfile d -o /dev/null m.xml a.nc
head -n 1 d
# On a whole machine, with the tool guided (TCP): the smallest clearance is recorded, and is near the true one.
top=${LIB%/*}/../..
check() {
	fivecheck -q "$@" -s "$top/examples/ac-trunnion/setup.xml" "$top/machines/ac-trunnion/machine.xml" "$top/examples/ac-trunnion/clear.nc"
}
check --clearance-report report.csv -o /dev/null
least=$(tail -n +2 report.csv | cut -d , -f 7 | sort -n | head -n 1)
check -o /dev/null --clearance "$least"
echo "kept: status $?"
check -o /dev/null --clearance "$(awk -v least="$least" 'BEGIN { print least / 0.85 + 0.01 }')"
echo "and no more: status $?"
