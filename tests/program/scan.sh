# scan needs no machine file: it lists the codes of programs, and what a machine file must answer before they are checked.
program a.nc <<'NC'
%
O1 (G99 IN A COMMENT)
G0X10G90
N20G1Z-2F100M8
G43 H1 Z5.
M6 T2
M25
G65 P9810 X1.
G28 Z0.
G68.2 X0. Y0. Z0. I0. J0. K0.
M30
%
NC
program b.nc <<'NC'
%
O2
G21 G90 G17
G47 P0 (A) E9. F9.
G4.7
M30
%
NC
program c.ngc <<'NC'
#<_depth> = 2
o<hole> sub
  G1 F9 Z-#<_depth>
o<hole> endsub
o<hole> call
M2
NC
status fivecheck scan --dialect=fanuc a.nc 2>&1
status fivecheck scan c.ngc 2>&1
status fivecheck scan --dialect=haas b.nc -o out 2>&1
cat out
status fivecheck scan a.nc b.nc 2>&1
# A file without a block is not readable.
: >zero.nc
printf '%%\n(a comment)\n%%\n' >comment.nc
status fivecheck scan --dialect=fanuc zero.nc comment.nc b.nc 2>&1
status fivecheck scan --dialect=mine a.nc 2>&1
status fivecheck scan 2>&1
status fivecheck scan --dialect=haas nowhere.nc 2>&1
fivecheck scan --help | head -3
