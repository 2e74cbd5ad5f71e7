# --dump-path does not check: the path continues past a limit, with a warning at the first such place.
small_machine
program a.nc <<'NC'
G0 X100
G0 X300
G0 X310
NC
fivecheck --dump-path m.xml a.nc
