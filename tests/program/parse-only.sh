small_machine
program good.nc <<'NC'
G0 X100
G0 Z-120
NC
program bad.nc <<'NC'
G0 X100
G0 X-300 (too far)
G0 X-310
NC
# It does not check collisions.
status fivecheck -q --parse-only m.xml good.nc
status fivecheck -q --parse-only m.xml bad.nc
status fivecheck -q --parse-only -a m.xml bad.nc
