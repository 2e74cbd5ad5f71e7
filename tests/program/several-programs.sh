# One after the other, in the order given; what cannot be read does not hide the rest, and 2 beats 1.
small_machine
echo 'G0 X10' >good.nc
echo 'G0 X300' >bad.nc
status fivecheck -q --parse-only m.xml bad.nc good.nc
status fivecheck -q --parse-only m.xml bad.nc nowhere.nc good.nc
echo 'G0 X10' | status fivecheck --parse-only m.xml good.nc - bad.nc
