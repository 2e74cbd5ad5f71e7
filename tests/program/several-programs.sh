# One after the other, in the order given; an unreadable program does not hide the others, and status 2 has priority
# over 1.
small_machine
echo 'G0 X10' >good.nc
echo 'G0 X300' >bad.nc
status fivecheck -q --parse-only m.xml bad.nc good.nc
status fivecheck -q --parse-only m.xml bad.nc nowhere.nc good.nc
echo 'G0 X10' | status fivecheck --parse-only m.xml good.nc - bad.nc
