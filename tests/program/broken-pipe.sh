# If the reader closes the pipe, the run ends early and quietly, but not with success.
small_machine
awk 'BEGIN { for (i = 0; i < 100000; i++) printf "G0 X%d\n", i % 100 }' >long.nc
{
	fivecheck --dump-path m.xml long.nc
	echo "status $?" >&2
} | head -n 1
