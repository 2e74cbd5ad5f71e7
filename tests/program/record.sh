# A record for an audit: the same inputs give the same bytes; every file has its digest, as another program computes it.
small_machine
box vise -10 -10 0 10 10 5
setup setup.xml <<'XML'
<fixture name="vise" mesh="vise.stl"/>
XML
cat >near.ngc <<'NC'
o<near> sub
G0 X20
o<near> endsub
NC
echo 'o<near> call' >a.nc
printf 'G0 X10\nG1 Z-120 F6000\n' >b.nc
echo 'G0 B1' >c.nc
status fivecheck -q --record r.json -s setup.xml m.xml a.nc b.nc c.nc >/dev/null 2>&1
status fivecheck -q -j 8 --record again.json -s setup.xml m.xml a.nc b.nc c.nc >/dev/null 2>&1
cmp r.json again.json
cat r.json | sed 's/"fivecheck": ".*"/"fivecheck": "*"/'
sed -n 's/.*"file": "\(.*\)",$/\1/p' r.json | head -n 9 >files
sed -n 's/.*"sha256": "\(.*\)"$/\1/p' r.json >digests
paste -d ' ' digests files | sed 's/ /  /' | sha256sum --check --quiet && grep -c . digests
# One byte more, or another option, is another record.
echo >>head.stl
fivecheck -q --record other.json -s setup.xml m.xml a.nc b.nc c.nc >/dev/null 2>&1
diff r.json other.json | grep -c '^>'
fivecheck -q --clearance 1 --record other.json -s setup.xml m.xml a.nc >/dev/null
fivecheck -q --record r.json -s setup.xml m.xml a.nc >/dev/null
diff r.json other.json | sed -n 's/^> *"\([a-z0-9_]*\)".*/\1/p'
# A file that changes during the check cannot be recorded. The run waits for a program in a pipe, which is refused as
# well.
mkfifo slow.nc
fivecheck -q --parse-only --record racy.json m.xml slow.nc >/dev/null 2>messages &
run=$!
# The pipe opens once the machine is read. The time of the change is set back, as by a wrong clock; the size reveals the
# change.
{
	touch -r m.xml before
	echo '<!-- -->' >>m.xml
	touch -r before m.xml
	echo 'G0 X1'
} >slow.nc
wait $run
echo "status $?"
cat messages
