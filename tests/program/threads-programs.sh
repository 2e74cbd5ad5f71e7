# Several programs at once give the same output as one after the other: findings, errors and warnings in the given
# order.
small_machine
awk 'BEGIN { for (i = 0; i < 3000; i++) printf "G1 X%.3f Z%.3f C%d F60000\n", i % 150, -50 - i % 40, i * 7 }' >clear.nc
{ cat clear.nc; echo 'G0 X10 Z-110'; } >hit.nc
echo 'G1 X10 F100 G5.1' >bad.nc
: >empty.nc
set -- hit.nc clear.nc bad.nc empty.nc nowhere.nc hit.nc
for j in 1 2 3 16; do
	code=0
	fivecheck -a -j $j m.xml "$@" >$j.out 2>$j.err || code=$?
	sed -i '/^  time/d' $j.out
	echo "$j threads: exit status $code"
	cmp 1.out $j.out && cmp 1.err $j.err
done
grep -v '^ ' 1.out

# A thread without a program helps with that of another thread, from its middle: the same bytes, also in reports.
printf 'o<deep> sub\nG1 Z-10\no<deep> endsub\n' >deep.ngc
awk 'BEGIN {
	print "G0 X20 Z-90\nF60000"
	for (i = 0; i < 20000; i++)
		printf i == 18000 ? "o<deep> call\n" : i == 19500 ? "G1 Q1\n" : "G1 X%.3f Z%.4f C%d\n",
			20 + i % 7, i == 16500 ? -100.01 : -99.99, i * 3
}' >long.nc
for j in 1 2 3 5; do
	for all in '' -a; do
		fivecheck --stats $all -j $j --depfile=d --report=r.html -o out m.xml empty.nc long.nc clear.nc 2>err || :
		cat out err d r-long.html | sed -E '/^  time/d; s/[0-9.]+ s (load|interpret|check|of processor time)//g' >long.$j$all
	done
done
cmp long.1 long.2 && cmp long.1 long.3 && cmp long.1 long.5
cmp long.1-a long.2-a && cmp long.1-a long.3-a && cmp long.1-a long.5-a
grep -h '^long.nc:[0-9]*:[0-9]*: ' long.1 long.1-a | cut -d: -f1-4
grep -c 'deep\.ngc' long.1 long.1-a
