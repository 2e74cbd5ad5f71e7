# An output that would overwrite an input is refused.
small_machine
program a.nc <<'NC'
G0 X10
NC
setup s.xml <<'XML'
XML
ln a.nc other.nc
for arguments in '-o a.nc' '-o m.xml' '-o s.xml' '-o other.nc' '--pose a.nc' '--pose s.xml' '-o x --pose x' '-f sarif=x -f junit=./x'; do
	# shellcheck disable=SC2086 # words, on purpose
	status fivecheck -q $arguments -s s.xml m.xml a.nc
done
cat a.nc
# A device keeps nothing, so several outputs may go to it.
status fivecheck -q -f text=/dev/null -f sarif=/dev/null m.xml a.nc
# Meshes of any file are protected.
box vise 60 60 0 70 70 10
setup s.xml <<'XML'
<fixture name="vise" mesh="vise.stl"/>
XML
ln head.stl same.stl
cp head.stl before.stl
for arguments in '-o head.stl' '-o ./same.stl' '-o vise.stl' '--pose table.stl' '--parse-only -o head.stl'; do
	# shellcheck disable=SC2086 # words, on purpose
	status fivecheck -q $arguments -s s.xml m.xml a.nc
done
status fivecheck -q -o head.stl --check-machine m.xml
status fivecheck -q -f json=head.stl --check-machine m.xml
status fivecheck -q -f json=m.xml --list-pairs m.xml
cmp head.stl before.stl
for file in *.new*; do
	[ ! -e "$file" ] || echo "left: $file"
done
# The file to which the shell sends the results is protected.
"$FIVECHECK" -q --record report m.xml a.nc >report 2>messages
echo "status $?"
cat messages report
# Without results on standard output, this file is allowed.
"$FIVECHECK" -q -f ndjson=/dev/stdout m.xml a.nc >report
echo "status $?"
grep -c '"kind"' report

# Subprograms, which the command line does not name, are protected: a report replaces only a report.
printf 'o<sub> call\nM2\n' >p.ngc
printf 'o<sub> sub\nG0 X11\no<sub> endsub\n' >sub.ngc
cp sub.ngc sub-p.ngc
for option in --report --glb; do
	status fivecheck -q $option=sub.ngc m.xml p.ngc
	status fivecheck -q $option=sub.ngc m.xml p.ngc a.nc
done
cmp sub.ngc sub-p.ngc
status fivecheck -q --report=again.html m.xml p.ngc
status fivecheck -q --report=again.html m.xml p.ngc
# A table does not replace a tool library or a subprogram either, nor a result the file that is standard input.
printf 'number,name,type,length,diameter\n1,a,flat,50,10\n' >tools.csv
echo '<tools href="tools.csv"/>' | setup tools.xml
mkdir before
cp tools.csv sub.ngc a.nc before
for mode in --list-pairs --check-machine --depends; do
	status fivecheck -q $mode -o tools.csv -s tools.xml m.xml
done
status fivecheck -q --dump-path -o tools.csv -s tools.xml m.xml a.nc
status fivecheck -q --dump-path -o sub.ngc m.xml p.ngc
status fivecheck -q -o a.nc m.xml - <a.nc
status fivecheck -q --dump-path -o a.nc m.xml - <a.nc
echo a.nc >list
status fivecheck -q -o list m.xml --files-from - <list
cat list
# The files of a job are protected from the other jobs, before any of them is checked.
cat >op.xml <<'XML'
<jobs version="1">
  <job name="op" machine="m.xml"><program file="p.ngc"/></job>
  <job name="m2" machine="m.xml" setup="s.xml"><program file="a.nc"/></job>
</jobs>
XML
sed 's/"m.xml" setup/"m2.xml" setup/; s/name="m2"/name="b"/; s/name="op"/name="m2"/' op.xml >jobs.xml
cp m.xml m2.xml
cp op.xml m2.xml before
status fivecheck -q -f junit=%.xml op.xml
status fivecheck -q -f junit=%.xml jobs.xml
sed "s/name=\"b\"/name=\"a\"/" jobs.xml >again.xml
status fivecheck -q -f text=%.nc again.xml
for file in before/*; do
	cmp "$file" "${file#before/}"
done
