# Where a probe stops is not known. What moves from there is followed from the end of the probe's way, which is said
# beside the verdict unless the probed axis is led back along that way first.
small_machine
program beside.nc <<'NC'
G21 G90 G94 F100
G0 X10 Z40
G38.2 Z-20
X0
G0 Z30
M2
NC
program back.nc <<'NC'
G21 G90 G94 F100
G0 X10 Z40
G38.2 Z-20
G0 Z30
X0
M2
NC
for name in beside back; do
	status fivecheck -q --parse-only m.xml $name.nc 2>&1
done
