# Files that are no programs, and malicious programs: a message with its place, exit status 2, quickly and with little
# memory.
small_machine
check() {
	soon "$FIVECHECK" -q "$@" 2>&1 | cut -c1-150
	# A plain shell does not know the exit status of the first command of a pipe: run it again alone.
	soon "$FIVECHECK" -q "$@" >/dev/null 2>&1
	echo "status $?"
}
printf 'G1 X1\0 F100\n' >nul.nc
printf '\377\376G\0001\0 \0X\0001\000\n\000' >utf16.nc
printf '\376\377\000G\0001\000\n' >utf16be.nc
printf '\357\273\277G1 X1 F100\n' >utf8-mark.nc
awk 'BEGIN { for (i = 0; i < 1000000; i++) printf "(comment) " }' >long.nc
awk 'BEGIN { printf "G1"; for (i = 0; i < 300; i++) printf " "; print " X1 F100" }' >blanks.nc
printf 'G1 F100 X1\rG1 X2\rG1 X500\r' >cr.nc
printf 'G1 F100 X1\nG1 X500' >unended.nc
printf 'G1 F100 X1 (never closed\nG1 X2\n' >comment.nc
printf 'o1 while [1]\nG1 F100 X0\no1 endwhile\n' >endless.nc
printf 'o<f> sub\no<f> call\no<f> endsub\no<f> call\nM2\n' >deep.nc
printf 'G10 L2 P1 X1e300\nG1 F100 X1\n' >exponent.nc
printf 'G10 L2 P1 X%s\nG1 F100 X1\n' "$(printf '9%.0s' 1 2 3 4 5 6 7 8 9 0 1 2 3 4 5 6 7 8 9 0)" >offset.nc
printf '#1=1\no1 while [#1 GT 0]\n#1=[#1*10]\no1 endwhile\nG1 F100 X#1\n' >infinite.nc
head -c 20000 /dev/zero >zeros.nc
printf 'G1 F100 X' >middle.nc
for name in nul utf16 utf16be utf8-mark long blanks cr unended comment endless deep exponent offset infinite zeros \
	middle; do
	echo "# $name"
	check --max-blocks 10000 m.xml $name.nc
done
# The loops of the other dialects.
printf '%%\nO1\nN1 GOTO 1\nM30\n%%\n' >goto.nc
printf '%%\nO1\nM98 P1\nM30\n%%\n' >self.nc
printf '%%\nO1\nWHILE [1 EQ 1] DO1\nEND1\nM30\n%%\n' >while.nc
printf '%%\nO1\nM98 P999999999999 L999999999\nM30\n%%\n' >calls.nc
for dialect in fanuc haas; do
	for name in goto self while calls; do
		echo "# $dialect $name"
		check --max-blocks 10000 --dialect $dialect m.xml $name.nc
	done
done
# Offsets so large that a move is below their precision: the move must still arrive.
printf 'G92 X-10000000000000000\nG91\nG1 F100 X1\nX1\nX1.3\n' >shift.nc
fivecheck --dump-path m.xml shift.nc
