# Inches: of one mesh, and of a whole file. The head ends 4 inches above the table: contact at Z-101.6.
small_machine
box head -1 -1 4 1 1 8
box table -2 -2 -1 2 2 0
sed -e 's,\(<body [^/]*\)/>,\1 units="inch"/>,' m.xml >body.xml
sed -e 's,units="mm",units="inch",; s,"-200","-8",; s,"200","8",; s,"-150","-6",; s,"50","2",; s,"6000","240",' m.xml >file.xml
echo 'G1 Z-150 F1000' >down.nc
echo 'G20 G1 Z-5.9 F50' >inch.nc
for machine in m body file; do
	for program in down inch; do
		fivecheck -q -f ndjson $machine.xml $program.nc |
			sed -n 's/.*"kind":"\([a-z]*\)".*"Z":\(-[0-9.]*\).*/\1 \2/p' | xargs printf '%s Z%.1f\n'
	done
done
fivecheck --check-machine file.xml | grep ' Z '
# Before any G20 or G21 a program is in the unit of the control.
echo 'G1 X1 F50' >own.nc
for machine in m file; do
	"$FIVECHECK" --dump-path $machine.xml own.nc
done
# A clearance in a message: what is left, and what is required.
status fivecheck -q --clearance 2 body.xml down.nc
# Too large to be true.
sed -i 's,"head.stl" units="inch","huge.stl" units="m",' body.xml
box huge -1 -1 4 1 1 1e8
status fivecheck -q body.xml down.nc
