# Several programs at once say the same as one after the other: findings, faults and warnings in the order given.
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
