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

# The head turns very close to the table until it cuts a corner: all threads share the same work.
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

# Nothing read after the batch that ends the check is reported: no error, no file of a subprogram, no block.
printf 'o<deep> sub\nG1 Z-10\no<deep> endsub\n' >deep.ngc
awk 'BEGIN {
	print "G0 X20 Z-90\nF60000"
	for (i = 0; i < 5000; i++)
		printf i == 3000 ? "o<deep> call\n" : i == 4500 ? "G1 Q1\n" : "G1 X%.3f Z%.4f\n", 20 + i % 7, i == 1500 ? -100.01 : -90
}' >c.nc
for j in 1 2 3; do
	for all in '' -a; do
		fivecheck --stats $all -j $j --depfile=c.d -o out m.xml c.nc 2>err
		cat out err c.d | sed '/^  time/d' >c.$j$all
	done
done
cmp c.1 c.2 && cmp c.1 c.3 && cmp c.1-a c.2-a && cmp c.1-a c.3-a
head -1 c.1 | cut -d: -f1-4
grep -c 'deep\.ngc\|Q' c.1 c.1-a

# A report shows the path up to the end of that batch, and nothing after it.
for j in 1 2 3; do
	fivecheck -q -j $j --report=r.html m.xml c.nc >out 2>err
	sed -E 's/[0-9.]+ s (load|interpret|check|of processor time)//g' r.html >r.$j
done
cmp r.1 r.2 && cmp r.1 r.3
