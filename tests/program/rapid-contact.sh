# A cutter that does not cut must stay out of the finished part. The part is a block of 60 x 60 x 20 mm on the
# table; the tool is 10 mm thick and 60 mm long, so that at rapid its core has a radius of 4.9 mm.
small_machine
box block -30 -30 0 30 30 20

# job PART_ATTRIBUTES CUTTER - s.xml
job() {
	setup s.xml <<XML
  <work_offset name="G54" X="0" Z="-100" C="0"/>
  <part name="block" mesh="block.stl" $1/>
  <tool number="1" length="60" ${3:-}>$2</tool>
XML
}

flat='<cutter><section length="60" diameter="10"/></cutter>'
ball='<cutter tip="ball"><section length="60" diameter="10"/></cutter>'

# run TITLE [OPTION...] - the moves in standard input, above the block and with the tool length active
run() {
	echo "== $1"
	shift
	{
		echo 'G21 G90 G94 T1 M6'
		echo 'G0 X-60'
		echo 'G43 H1 Z60'
		cat
		echo 'M2'
	} >p.nc
	findings "$@" -s s.xml m.xml p.nc
	fivecheck -q "$@" -s s.xml m.xml p.nc >verdict
	echo "status $?"
}

job '' "$flat"
# Its core meets the side of the block at X-34.9: (60 - 34.9) / 120 of the path.
run 'straight through at rapid' <<'NC'
G0 Z10
X60
NC
grep -E 'error:|at  ' verdict
run 'the same at feed, with the spindle on' <<'NC'
M3 S1000
G0 Z10
G1 X60 F1000
NC
run 'the same at feed, with the spindle off' <<'NC'
G0 Z10
G1 X60 F1000
NC
grep 'error:' verdict
run 'the same at feed, with the spindle on at S0' <<'NC'
M3 S0
G0 Z10
G1 X60 F1000
NC
run 'a drill that dives at rapid: 40 of 60 mm to the top, and 0.1 to the core' <<'NC'
G0 X0
Z0
NC
run 'down at feed, then sideways at rapid: the core is inside from the start' <<'NC'
M3 S1000
G0 X0 Z21
G1 Z5 F100
G0 X60
NC
run 'out again at rapid along the way in: the hole is not in the finished part' <<'NC'
M3 S1000
G0 X0 Z21
G1 Z5 F100
G0 Z60
NC
run 'along the surface, and 0.05 mm deep' <<'NC'
G0 Z20
X0
Z19.95
X60
NC
run '0.2 mm deep' <<'NC'
G0 X0
Z19.8
NC
job 'rapid_allowance="1"' "$flat"
run '0.2 mm deep where 1 mm is allowed' <<'NC'
G0 X0
Z19.8
NC
job '' "$ball"
run 'a ball end: its core ends 0.1 mm above its tip' <<'NC'
G0 X0
Z19.95
Z19.85
NC

echo '== what the part says of a cut: at most 0.05 mm too deep'
job 'gouge="0.05"' "$flat"
run 'deep at feed' <<'NC'
M3 S1000
G0 X0
G1 Z19.97 F1000
Z19.9
NC
grep -E 'error:' verdict

echo '== a nozzle needs no spindle'
job '' "$flat" 'kind="nozzle"'
run 'a nozzle at feed' <<'NC'
G0 Z10
G1 X60 F1000
NC
run 'a nozzle at rapid' <<'NC'
G0 Z10
X60
NC

echo '== a probe touches where it measures'
job '' "$flat" 'kind="probe"'
run 'a probe at feed' <<'NC'
M3 S1000
G0 Z10
G1 X60 F1000
NC
run 'a probe that measures, and its retract' <<'NC'
G0 X0
G38.2 Z15 F100
G1 Z60
NC
run 'a probe at rapid' <<'NC'
G0 Z10
X60
NC

echo '== what is above the flutes rubs'
job '' '<cutter flute_length="10"><section length="60" diameter="10"/></cutter>'
run '9 mm deep, and 15' <<'NC'
M3 S1000
G0 X-60 Z11
G1 X60 F1000
G0 X60 Z60
X-60
Z5
G1 X60
NC
grep -E 'error:' verdict

echo "== the builder's M-codes for the spindle"
job '' "$flat"
sed 's|<base>|<controller><mcode number="13" action="spindle-on"/><mcode number="14" action="spindle-off"/></controller>&|' \
	m.xml >codes.xml
cat >p.nc <<'NC'
T1 M6
G0 X-60
G43 H1 Z60
M13 S1000
Z10
G1 X60 F1000
M14
X-60
M2
NC
findings -s s.xml codes.xml p.nc

echo '== a mesh for a cutter has no core'
box drill -5 -5 -60 5 5 0
job '' '<cutter mesh="drill.stl"/>'
run 'at rapid' <<'NC'
G0 Z10
X60
NC
fivecheck -s s.xml m.xml p.nc | grep mesh
job 'gouge="0.05"' '<cutter mesh="drill.stl"/>'
fivecheck -s s.xml m.xml p.nc | grep mesh

echo '== the user has the last word'
job '' "$flat"
sed 's|</machine>|<pairs><pair a="cutter" b="part" check="never" reason="foam"/></pairs></machine>|' m.xml >never.xml
sed 's|</machine>|<pairs><pair a="cutter" b="part" check="always"/></pairs></machine>|' m.xml >always.xml
cat >p.nc <<'NC'
T1 M6
G0 X-60
G43 H1 Z60
M3 S1000
Z10
G1 X60 F1000
M2
NC
findings -s s.xml always.xml p.nc
sed 's/G1 X60/G0 X60/' p.nc >rapid.nc
findings -s s.xml never.xml rapid.nc
status fivecheck -q -s s.xml never.xml rapid.nc | tail -n 1
for jobs in 1 2 3; do
	findings -a -j $jobs -s s.xml m.xml rapid.nc
done
fivecheck --list-pairs -s s.xml m.xml | grep cutting
