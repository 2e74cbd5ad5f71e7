# A program that moves nothing is checked at its start pose, with a warning. A file without a block is an error: it is what
# is left of a program that could not be written, or was not copied.
small_machine
printf 'G21 G90\nM30\n' >still.nc
status fivecheck -q m.xml still.nc
: >zero.nc
printf '\n \t\n' >blank.nc
printf '(a comment)\n; and another\n' >comments.nc
printf '%%\n%%\n' >percent.nc
for name in zero blank comments percent; do
	status fivecheck -q m.xml $name.nc
done
status fivecheck -q --parse-only m.xml zero.nc
status fivecheck -q m.xml - </dev/null
# What stands in each other at the start is found as well.
box head -20 -20 -10 20 20 200
status fivecheck -q m.xml zero.nc
