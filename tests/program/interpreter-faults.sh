# Text that cannot be interpreted is an error with its place; the verdict is incomplete.
small_machine
program a.nc <<'NC'
G0 X10
G0 Q17
NC
status fivecheck m.xml a.nc
echo 'G0 X10 B5' >b.nc
status fivecheck -q -f ndjson m.xml b.nc
status fivecheck -q --dump-path -o path m.xml b.nc
[ ! -e path ]
