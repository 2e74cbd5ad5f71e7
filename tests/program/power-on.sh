# Parameters of the control are attributes of the machine file, and are never guessed.
small_machine

# run_with ATTRIBUTES TEXT - the end position of a program with this text and these attributes of <controller>
run_with() {
	printf '%b' "$2" >p.nc
	for dialect in fanuc haas; do
		sed "s|<base>|<controller dialect=\"$dialect\" $1/><base>|" m.xml >c.xml
		printf '%s %s: ' "$dialect" "$1"
		fivecheck --dump-path c.xml p.nc >path 2>said || cat said >>path
		grep -E '(error|warning):|^[0-9]' path | tail -n 1
	done
}

all='power_on_units="mm" power_on_distance="absolute" power_on_plane="zx"'
# Units, before an axis word and before F; distance; plane.
run_with '' 'G90 G17\nG0 X10.\nM30\n'
run_with '' 'G90 G17\nG94 F100.\nM30\n'
run_with 'power_on_units="inch"' 'G90 G17\nG0 X1.\nM30\n'
run_with 'power_on_units="inch"' 'G21 G90 G17\nG0 X1.\nM30\n'
run_with '' 'G21 G17\nG0 X10.\nM30\n'
run_with 'power_on_distance="incremental"' 'G21\nG0 X10.\nX10.\nM30\n'
run_with 'power_on_distance="absolute"' 'G21\nG0 X10.\nX10.\nM30\n'
run_with '' 'G21 G90\nG0 X10.\nG2 X20. I5. F100.\nM30\n'
run_with "$all" 'G2 X20. I10. F100.\nM30\n'
# Whole numbers in increments of a thousandth, or in whole units.
run_with '' 'G21 G90\nG0 X0\nX-100\nM30\n'
run_with 'least_input="1"' 'G20 G90\nG0 X-1\nM30\n'
run_with 'least_input="0.001"' 'G20 G90\nG0 X-10000\nM30\n'
run_with 'least_input="0.001"' 'G21 G90\nG0 X-10000\nM30\n'
# The start modes of LinuxCNC's manual.
printf 'G0 X10\nM2\n' >p.nc
fivecheck --dump-path m.xml p.nc | tail -n 1
