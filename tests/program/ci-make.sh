# The makefile of examples/ci: checks only what changed, and stops at a collision.
small_machine
cp "$(dirname "$LIB")/../../examples/ci/Makefile" .
mv m.xml machine.xml
echo 'G0 X10' >a.nc
echo 'G0 X20' >b.nc
status make -s -k check
cat a.checked
echo "again:"
status make -s -k check
echo 'G0 X-10' >b.nc
touch -d '-1 hour' a.nc a.checked
touch -d '-2 hours' ./*.stl machine.xml a.nc
echo "one changed:"
status make -s -k check
echo "a mesh changed:"
# Files written one after the other may have the same time.
touch -d '-1 hour' a.checked b.checked
touch head.stl
status make -s -k check
touch -d '-1 minute' ./*.stl
touch -d '-30 seconds' a.checked b.checked
printf 'G1 Z-120 F6000\n' >b.nc
echo "a collision:"
status make -s -k check 2>/dev/null
ls b.checked 2>&1 || true
make -s clean
ls
