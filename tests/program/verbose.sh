small_machine
echo 'G0 Z-90' >a.nc
fivecheck -v m.xml a.nc
