# scan, merge and waive do not overwrite what they read, and scan needs files that can be read twice.
small_machine
printf 'G21 G61 G0 X10\nG0 Z-120\n' >a.nc
printf 'o<sub> sub\nG0 X1\no<sub> endsub\n' >sub.ngc
printf 'o<sub> call\nM2\n' >c.ngc
fivecheck -q -f ndjson=run.json m.xml a.nc
fivecheck -q --shard 1/1 -f ndjson=shard.json m.xml a.nc
mkdir before
cp -- a.nc sub.ngc c.ngc run.json shard.json before
ln a.nc hard.nc
status fivecheck scan -d linuxcnc -o a.nc c.ngc a.nc
status fivecheck scan -d linuxcnc -o ./hard.nc a.nc
status fivecheck scan -d linuxcnc -o sub.ngc c.ngc c.ngc
status fivecheck merge -o shard.json shard.json
status fivecheck waive --reason=known --until=9999-12-31 -o run.json run.json
for file in before/*; do
	cmp "$file" "${file#before/}"
done
# The program of a pipe would be empty when it is read again.
cat a.nc | status fivecheck scan -d linuxcnc - | tail -n 1
cat a.nc | status fivecheck scan -d linuxcnc /dev/stdin | tail -n 1
status fivecheck scan - <a.nc
