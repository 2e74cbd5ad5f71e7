# The sampled methods never say "clear".
small_machine
echo 'G0 X10' >good.nc
echo 'G0 Z-120' >bad.nc
for method in interpolated conventional; do
	status fivecheck -q --method $method --step 0.05 m.xml good.nc bad.nc >out
	grep -q clear out && echo 'said "clear"'
	cat out
done
