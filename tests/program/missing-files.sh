small_machine
program a.nc <<'NC'
G0 X10
NC
mkdir folder
status fivecheck -q nowhere.xml a.nc
status fivecheck -q -s nowhere.xml m.xml a.nc
status fivecheck -q m.xml nowhere.nc
status fivecheck -q m.xml folder
status fivecheck -q folder a.nc
rm head.stl
status fivecheck -q m.xml a.nc
# No body is used, so a missing mesh is no error.
status fivecheck -q --parse-only m.xml a.nc
# A folder of --include that is no folder, before anything is read.
status fivecheck -q --include=folder --include=nowhere --include=a.nc m.xml a.nc
status fivecheck -q --include=folder --parse-only m.xml a.nc
