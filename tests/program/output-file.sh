small_machine
program a.nc <<'NC'
G0 X10
NC
echo before >report
chmod 640 report
status fivecheck -q -o report m.xml a.nc
cat report
ls -l report | cut -c 1-10
# An aborted run leaves the file unchanged, and no other file.
echo before >pairs
status fivecheck -q -o pairs --list-pairs nowhere.xml 2>/dev/null
cat pairs
ls
# Through a link, its target is written.
ln -s report link
status fivecheck -o link --list-pairs m.xml
test -h link && head -n 1 report
status fivecheck -q -o nowhere/report m.xml a.nc
# - is no file.
status fivecheck -q -o - --list-pairs m.xml
status fivecheck -q -f text=- m.xml a.nc
ls
