# An arc moves both axes of its plane: a machine without one of them cannot execute it.
small_machine
program flat.nc <<'NC'
G0 X50
F600 G2 X50 I-10
NC
program upright.nc <<'NC'
G18 G0 X50
G3 X30 Z0 I-10 K0 F600
NC
status fivecheck -q --parse-only m.xml flat.nc
status fivecheck -q --parse-only m.xml upright.nc
