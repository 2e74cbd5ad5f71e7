# Which kinds of findings fail the run; the others are warnings and do not stop it.
small_machine
printf 'G0 X300\nG0 X10\nG1 Z-120 F6000\n' >a.nc
rows() {
	grep -e '^[a-z]'
}
status fivecheck -q m.xml a.nc | rows
status fivecheck -q --fail-on collision,start-overlap m.xml a.nc | rows
status fivecheck -q --fail-on clearance m.xml a.nc | rows
status fivecheck -q --fail-on clearance -f github m.xml a.nc
status fivecheck -q --fail-on=none m.xml a.nc | rows
echo 'G0 B1' >b.nc
status fivecheck -q --fail-on=none m.xml a.nc b.nc 2>/dev/null | rows
# With a clearance a collision is of the kind clearance: without that kind it would pass.
status fivecheck -q --clearance 1 --fail-on collision -o /dev/null m.xml a.nc 2>&1
status fivecheck -q --clearance 1 --fail-on collision,clearance -o /dev/null m.xml a.nc
status fivecheck -q --clearance 1 --fail-on limit -o /dev/null m.xml a.nc
echo "warnings fail, too:"
printf '%s\n' 'G0 X10' 'G64' 'M30' 'G0 X20' >w.nc
status fivecheck -q m.xml w.nc 2>/dev/null | rows
status fivecheck -q --fail-on=warning -f text -f junit=w.xml m.xml w.nc 2>&1 | grep -e status -e '--fail-on'
grep -c '<failure' w.xml
status fivecheck -q --fail-on=warning m.xml b.nc 2>&1 | grep status
status fivecheck -q --fail-on=none,limit m.xml w.nc 2>&1 | head -n 1
