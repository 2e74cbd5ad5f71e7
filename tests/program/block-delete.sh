small_machine
printf 'G0 X10\n/G0 X20\n' >a.nc
fivecheck --dump-path m.xml a.nc
fivecheck --block-delete --dump-path m.xml a.nc
