# A word twice in one block is an error that names both; --duplicates=last opts in and says so.
small_machine
echo 'G0 X10 X20' >a.nc
status fivecheck -q m.xml a.nc
status fivecheck --duplicates=last --dump-path m.xml a.nc
