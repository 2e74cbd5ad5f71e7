# The same bytes of findings and verdict for every number of threads, and on every run.
small_machine
awk 'BEGIN {
	for (i = 0; i < 2000; i++)
		printf "G1 X%.3f Z%.3f C%d F60000\n", (i * 37) % 300 - 150, -(i * 61 % 149), i * 7 }' >a.nc
fivecheck -q -a m.xml a.nc >one
fivecheck -q -a -j 3 m.xml a.nc >three
fivecheck -q -a -f ndjson m.xml a.nc >one.json
fivecheck -q -a -j 8 -f ndjson m.xml a.nc >eight.json
cmp one three && cmp one.json eight.json
grep -c '' one.json | awk '{ print ($1 > 100) }'

# The head turns within a hair of the table until it cuts a corner: what threads share is the same work for all.
awk 'BEGIN {
	print "G0 X20 Z-99.99"
	for (i = 0; i < 5000; i++)
		printf "G1 X%.3f Z%.4f C%d F60000\n", 20 + i % 7, i < 4321 ? -99.995 : -100.01, i * 3
}' >b.nc
for j in 1 2 5; do
	fivecheck --stats -j $j m.xml b.nc | sed '/^  time/d' >b.$j
done
cmp b.1 b.2 && cmp b.1 b.5
head -1 b.1 | cut -d: -f1-4
