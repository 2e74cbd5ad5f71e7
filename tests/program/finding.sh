# The complete report of a finding. The head moves down onto the table: 100 mm of 120.
small_machine
program a.nc <<'NC'
G0 X10
	N20 g1 z-120 F6000 ; down
NC
status fivecheck -q m.xml a.nc
status fivecheck m.xml a.nc
status fivecheck --stats m.xml a.nc
