# Options and operands in any order, values with = or without, -- ends the options; POSIXLY_CORRECT changes nothing.
small_machine
program a.nc <<'NC'
G0 X10
NC
cp a.nc ./-a.nc
for order in '-q m.xml a.nc --parse-only' 'm.xml -q a.nc --parse-only' 'm.xml --parse-only a.nc -q' \
	'--parse-only -q -- m.xml a.nc' '-q --parse-only m.xml -- -a.nc'; do
	# shellcheck disable=SC2086 # words, on purpose
	fivecheck $order
	# shellcheck disable=SC2086
	POSIXLY_CORRECT=1 fivecheck $order
done
fivecheck -q --clearance=1 m.xml a.nc
fivecheck -q --clearance 1 m.xml a.nc
