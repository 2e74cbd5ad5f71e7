# The clearance of bodies from the remaining stock, against closed forms, and changes that move the cuts.
stock_mill
setup s.xml <<'XML'
  <work_offset name="G54" X="0" Y="0" Z="-100"/>
  <stock box="40 30 30" location="0 0 -20" rapid_allowance="1"/>
  <tool number="1" length="100">
    <holder><section length="50" diameter="40"/></holder>
    <shank><section length="30" diameter="8"/></shank>
    <cutter><section length="20" diameter="10"/></cutter>
  </tool>
XML

# program_of - blocks on standard input, after blocks that move the tool above the stock, which is 10 mm high
program_of() {
	echo 'G21 G90 G94 G61 T1 M6'
	echo 'M3 S1000'
	echo 'G0 G43 H1 Z100'
	cat
}

# bounds - rows of the table as "line body below-the-distance above-half-of-it"; the distances are on standard input
bounds() {
	awk -F, 'NR == FNR { distance[$1 "," $2] = $3; next }
		 $5 == "stock" && ($3 "," $6) in distance {
			d = distance[$3 "," $6]
			print $3, $6, ($7 <= d), ($7 > 0.5 * (d - 0.8)), $8
		 }' - "$1"
}

echo '== the holder above, the shank in the hole that the cutter makes and above a wall; line 9 sweeps the holder past'
program_of >p.nc <<'NC'
G0 X0 Y0 Z12
G1 Z-14 F6000
G0 Z12
G0 X-48
G0 Z-60
G0 Y60
NC
fivecheck -q --stock-tolerance=0.8 --clearance-report=one.csv -s s.xml m.xml p.nc >verdict
cat >distances <<'CSV'
4,T1 holder,10
4,T1 shank,10
5,T1 holder,10
5,T1 shank,1
6,T1 shank,1
8,T1 holder,8
9,T1 holder,8
CSV
bounds one.csv <distances
grep -c 'stock,T1 cutter' one.csv
fivecheck -q -j 2 --stock-tolerance=0.8 --clearance-report=two.csv -s s.xml m.xml p.nc | cmp - verdict
cmp one.csv two.csv

echo '== a finding: nothing is kept in its block, nor in the next one, which begins in the stock'
program_of >p.nc <<'NC'
G0 X-45 Y0
G0 Z-60
G1 X-37 F6000
G1 X-45
NC
status fivecheck -q -a --stock-tolerance=0.8 --clearance-report=one.csv -s s.xml m.xml p.nc >verdict
tail -n 1 verdict
cut -d , -f 3,5- one.csv | grep 'holder'

echo '== a rapid 0.2 mm above the blank, of which 1 mm may be entered'
program_of >p.nc <<'NC'
G0 X-30 Z10.2
G0 X30
NC
status fivecheck -q --stock-tolerance=0.8 --sensitivity=0,0,1.3,0 -s s.xml m.xml p.nc

echo '== a rapid where the wall was cut away: moved towards +X the cut leaves a skin'
program_of >p.nc <<'NC'
G0 X-15.4 Y-25 Z5
G1 Y25 F6000
G0 Z20
G0 X-60 Y0
G0 Z5
G0 X-15.4
NC
status fivecheck -q --stock-tolerance=0.8 --sensitivity=0.25,0,0,0 -s s.xml m.xml p.nc

echo '== past the wall, about as near as the least distance that is told from none: the search ends'
for gap in 0.04 0.05 0.06 0.07 0.09; do
	printf 'G0 X-80 Y-60 Z-60\nG1 X-%s F6000\nY60\n' "$(awk "BEGIN { print 40 + $gap }")" | program_of >p.nc
	fivecheck -q --stock-tolerance=0.8 --clearance-report=near.csv -s s.xml m.xml p.nc | head -n 1
	awk -F, -v gap="$gap" '$3 == 6 && $6 == "T1 holder" { print gap, $7 <= gap, ($7 > 0.5 * gap), $8 }' near.csv
done
