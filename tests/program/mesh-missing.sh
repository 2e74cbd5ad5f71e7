# Every mesh that the machine or the setup names is read, whether or not a pair of bodies needs it: with the same result
# in every mode.
box head -5 -5 0 5 5 10
machine m.xml <<'XML'
  <body name="bed" mesh="nofile.stl"/>
  <axis name="X" type="linear" direction="1 0 0" limit_min="-10" limit_max="10" rate_max="6000">
    <body name="head" mesh="head.stl"/>
    <body name="door" mesh="nothing.stl"/>
  </axis>
XML
program p.nc <<'NC'
G1 X5 F100
NC
for option in -j1 -j2 --report=r.html --pose=p.stl --method=conventional; do
	echo "$option:"
	status fivecheck -q "$option" m.xml p.nc 2>&1
done
for mode in --list-pairs --check-machine; do
	echo "$mode:"
	status fivecheck "$mode" m.xml 2>&1
done
ls r.html p.stl 2>/dev/null || echo "nothing is written"
