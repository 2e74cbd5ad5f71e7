# A finding in a subprogram names the calls that led there, in every dialect and format; also if its block was delayed
# until the next corner, and if the block itself is a call or a return.
small_machine
told() {
	fivecheck -q --parse-only --all "$@" | grep -e '^[a-z].*error:' -e '    called '
}
controller() {
	sed "s|<base|<controller $1 path_tolerance=\"0.01\"><tool_change/></controller><base|" m.xml
}

# LinuxCNC: in separate files, two calls deep, and again after the return.
program p.ngc <<'NC'
G0 X0
o<outer> call
G0 X201
M2
NC
printf 'o<outer> sub\nG0 X202\no<inner> call [203]\nG0 X204\no<outer> endsub\n' >outer.ngc
printf '\n\no<inner> sub\nG0 X#1\no<inner> endsub\n' >inner.ngc
told m.xml p.ngc

echo 'Fanuc: the block with M98 is in the program, what M99 stands beside is in the subprogram.'
controller 'dialect="fanuc" power_on_units="mm" power_on_distance="absolute" power_on_plane="xy" least_input="1"' >f.xml
program f.nc <<'NC'
O1
G0 X201 M98 P2
G0 X0
G65 P3 A203
M30
O2
G0 X202 M99
O3
G0 X#1
M98 P2
M99
NC
told f.xml f.nc

echo 'Cutter compensation: the last block of the subprogram waits until the program goes on.'
sed 's|<axis name="X"|<axis name="Y" type="linear" direction="0 1 0" limit_min="-99" limit_max="99" rate_max="6000"/>&|' m.xml >y.xml
program c.ngc <<'NC'
G0 X0 Y0
G41.1 D10 G1 X190 F1000
o<past> call
G1 Y50
G40 X0
M2
NC
printf 'o<past> sub\nG1 X230\no<past> endsub\n' >past.ngc
told y.xml c.ngc

echo 'Sinumerik: a subprogram, and a part that is repeated.'
controller 'dialect="sinumerik"' >s840.xml
program s.mpf <<'NC'
G0 G90 G71 X0
DEEP(201)
X0
PART:
X=IC(101)
ENDPART:
REPEAT PART ENDPART
X202
M30
NC
printf 'PROC DEEP(REAL AT)\nG0 X=AT\nRET\n' >deep.spf
told s840.xml s.mpf

echo 'Klartext.'
controller 'dialect="klartext"' >k.xml
printf '0 BEGIN PGM SUB MM\n1 L X+202 FMAX\n2 END PGM SUB MM\n' >sub.h
program k.h <<'NC'
0 BEGIN PGM K MM
1 L X+0 R0 FMAX
2 CALL LBL 1
3 L X+203 FMAX
4 M30
5 LBL 1
6 L X+201 FMAX
7 CALL PGM sub.h
8 LBL 0
9 END PGM K MM
NC
told k.xml k.h

for format in ndjson sarif github junit; do
	echo "$format:"
	fivecheck -q --parse-only -f $format f.xml f.nc
	fivecheck -q --parse-only -a -f $format m.xml p.ngc
done | grep -o -e '^[a-z0-9]*:$' -e '"callers":.*]' -e '"relatedLocations":.*"properties"' -e '; called from .*' -e '    called .*'
