# The axes at the end of each span, in mm and degrees; rapids at the slowest axis' rate, feeds at F.
small_machine
program a.nc <<'NC'
G0 X100 C90
G1 Z-50 F600
G4 P2
G1 X100
G1 X40 Z-50 C-30 F1200
NC
fivecheck --dump-path m.xml a.nc
