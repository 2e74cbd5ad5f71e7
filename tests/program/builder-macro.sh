# <macro> in the machine file says what programs of the machine's builder do: nothing, a straight move to the X, Y and Z
# of the call, or moves somewhere around the place of the call. If the element is missing, the error names it.
small_machine
box post 120 -20 80 140 20 90
sed 's|<workholding|<body name="post" mesh="post.stl"/><workholding|
s|<base|<controller dialect="fanuc" rapid="linear" least_input="1" power_on_plane="xy"><!-- --></controller><base|' m.xml >bare.xml
sed 's|<!-- -->|<macro program="9810" action="move"/><macro program="9811" action="around" X="95" Z="30"/><macro program="9832" action="none"/><macro program="9010" code="107" action="none"/>|' bare.xml >m.xml
program probe.nc <<'NC'
%
O1(PROBE)
G90 G21 G94 G0 X0 Z40. F500
G65 P9832
G65 P9810 X5. Z10. F3000.
X8.
G65 P9811 Z-2. Q3.
M98 P9832
G107 X3. Y4. S6.
G1 X9.
M30
%
NC
status fivecheck -q --dump-path m.xml probe.nc | cut -f 1-7
# Within 95 mm of X8 the head meets the post, which no programmed move does.
status fivecheck -q m.xml probe.nc 2>&1 | sed -n 1,2p
# Scaled by 3 it moves 60 mm, in Z as well: the head, 55 mm above the table, meets it.
sed 's|X="95" Z="30"|X="20" Z="20"|' m.xml >a.xml
for scale in 1. 3.; do
	printf '%%\nG90 G21 G94 F500\nG53 G0 X-60. Z-45.\nG51 X0 Z0 P%s\nG65 P9811\nM30\n' "$scale" >a.nc
	status fivecheck -q a.xml a.nc 2>&1 | grep 'collision\|error\|status'
done
for block in 'G65 P9999' 'M98 P9999' 'G65 P77' 'M98 P9810' 'G66 P9811'; do
	printf '%%\nG90 G21\n%s\nM30\n' "$block" >a.nc
	status fivecheck -q --parse-only m.xml a.nc 2>&1 | grep -v '^ '
done
# A code whose program is not known.
sed 's|<!-- -->|<macro code="131.1" action="none"/><macro code="130" action="none"/>|' bare.xml >a.xml
printf '%%\nG90 G21\nG131.1 F3. R.001\nG0 X1.\nG130\nG65 P130\nM30\n' >a.nc
status fivecheck -q --parse-only a.xml a.nc 2>&1 | grep -v '^ '
for macro in 'action="none"' 'program="0" action="none"' 'program="9" action="none" X="1"' 'program="9" action="around"' \
	'program="9" action="around" A="1"' 'program="9" code="-1" action="none"' 'program="9" action="run"' \
	'program="9" action="none"/><macro program="9" action="none"' \
	'code="130" action="none"/><macro code="130" action="around" X="5"' 'program="PROBE" action="none"'; do
	sed "s|<!-- -->|<macro $macro/>|" bare.xml >a.xml
	status fivecheck -q --check-machine a.xml 2>&1 | grep 'error:\|status'
done
sed 's|<!-- -->|<macro program="9" action="none"/>|; s/dialect="fanuc"/dialect="linuxcnc"/; s/least_input="1" power_on_plane="xy"//' bare.xml >a.xml
status fivecheck -q --check-machine a.xml 2>&1 | grep 'error:\|status'
# A control that calls programs by name.
for macro in 'program="A-B" action="none"' 'program="PROBE" action="none"/><macro program="probe" action="none"'; do
	sed "s|<!-- -->|<macro $macro/>|; s/dialect=\"fanuc\"/dialect=\"sinumerik\"/; s/least_input=\"1\"//" bare.xml >a.xml
	status fivecheck -q --check-machine a.xml 2>&1 | grep 'error:\|status'
done
# A probing macro may leave its results in common variables, which are vacant on other Fanuc programs: one that the
# program has not set is a question after it, but not before it, and not after a macro that does nothing.
printf '%%\nG90 G21 F500\nG65 P9832\n#101=#138\n#100=7\nG65 P9811\nG0 X#100\nIF[#138GT0.1]GOTO9\nG0 X1.\nN9M30\n' >a.nc
status fivecheck -q --parse-only m.xml a.nc 2>&1 | grep -v '^ '
sed 's|<macro program="9832"|<variable name="#138" value="0"/>&|' m.xml >a.xml
status fivecheck -q --parse-only a.xml a.nc 2>&1 | grep -v '^ '
printf '%%\nG90 G21 F500\nG65 P9810 X5. F300.\nG0 X#500\nG0 X[#101+1.]\nM30\n' >a.nc
status fivecheck -q -a --parse-only m.xml a.nc 2>&1 | grep -v '^ '
# What the program has set before it, it may have changed.
printf '%%\nG90 G21 F500\n#100=0\n#101=2.\nWHILE[#100LT2]DO1\nG65 P9811\n#100=#100+1\nEND1\nG0 X#101\nM30\n' >a.nc
for macro in 9811 9832; do
	sed "s/9811/$macro/" a.nc >b.nc
	status fivecheck -q --parse-only m.xml b.nc 2>&1 | grep 'assigned\|status'
	fivecheck -q --dump-path m.xml b.nc | tail -n 1 | cut -f 2,4
done
