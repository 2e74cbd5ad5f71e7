# If a file cannot be written, the run is not a success.
[ -e /dev/full ] || exit 0
small_machine
program a.nc <<'NC'
G0 X10
NC
for arguments in '--help' '--version' 'm.xml a.nc' '--dump-path m.xml a.nc' '--list-pairs m.xml' \
	'--check-machine m.xml' '--parse-only m.xml a.nc'; do
	# shellcheck disable=SC2086 # words, on purpose
	fivecheck -q $arguments >/dev/full
	echo "status $?" >&2
done
fivecheck -q -o /dev/full m.xml a.nc
echo "status $?" >&2
# The command line of init is right, so nothing points to its options.
fivecheck init table-table --rotary=A,C --limits=X=none,Y=none,Z=none,A=none,C=none --location=A=0,0,0 \
	--location=C=0,0,0 --spindle=0,0,500 >/dev/full
echo "status $?" >&2
