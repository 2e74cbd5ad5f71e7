# A slip that would write over an input is refused.
small_machine
program a.nc <<'NC'
G0 X10
NC
setup s.xml <<'XML'
XML
ln a.nc other.nc
for arguments in '-o a.nc' '-o m.xml' '-o s.xml' '-o other.nc' '--pose a.nc' '--pose s.xml' '-o x --pose x'; do
	# shellcheck disable=SC2086 # words, on purpose
	status fivecheck -q $arguments -s s.xml m.xml a.nc
done
cat a.nc
