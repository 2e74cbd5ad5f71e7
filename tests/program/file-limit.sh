# A file size limit is an error like a full disk: no file is half written, and no temporary file is left.
small_machine
awk 'BEGIN { for (i = 0; i < 2000; i++) print "G0 X" i % 2 }' >a.nc
echo before >path
(
	ulimit -f 8
	status fivecheck --dump-path -o path m.xml a.nc >&2
	fivecheck --dump-path m.xml a.nc >cut
	echo "status $?" >&2
)
cat path
ls
