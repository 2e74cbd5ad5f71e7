# Motion after the end of a program is never executed: the verdict says so, with the line, in every format.
small_machine
sed -i 's|<base>|<controller dialect="fanuc"/><base>|' m.xml
machine_of() { sed "s|dialect=\"fanuc\"|dialect=\"$1\"|" m.xml >"$1.xml"; }
machine_of linuxcnc
# A block after M30, and a second program with an O-number.
printf '%%\nO1\nG21 G90\nG0 X10.\nM30\n(X1) M5\n\nG0 Z-149.\n%%\n' >behind.nc
printf '%%\nO1\nG21 G90\nG0 X10.\nM30\nO2\nG0 Z-149.\nM30\n%%\n' >second.nc
for program in behind second; do
	status fivecheck -q --parse-only m.xml $program.nc
done
# Allowed after the end: subprograms, local subprograms between an N-number and M99, and comments.
printf '%%\nO1\nG21 G90\nM98 P2\nM30\nO2\nG0 X10.\nM99\nN100 G0 X5.\nG0 X7. M99\n(G0 X9.)\nN5 M5\n%%\n' >subs.nc
status fivecheck -q --parse-only m.xml subs.nc
printf 'G21 G90\nG0 X10\nM2\no<late> sub\nG0 X20\no<late> endsub\n' >late.nc
status fivecheck -q --parse-only linuxcnc.xml late.nc
printf 'G21 G90\nG0 X10\nM2\n; X1\nthis is text about X and Y\nG1 Y5 X 20\n' >text.nc
status fivecheck -q --parse-only linuxcnc.xml text.nc
# A second '%' ends a program, too.
printf '%%\nG21 G90\nG0 X10\n%%\nG0 X20\n' >percent.nc
for format in text ndjson junit; do
	fivecheck -q --parse-only -f $format linuxcnc.xml percent.nc | grep -o 'percent.nc:5: this line moves axes' | head -n 1
done
for format in github sarif; do
	fivecheck --parse-only -f $format linuxcnc.xml percent.nc 2>&1 >/dev/null | grep -o 'percent.nc:5: .*this line moves axes' | head -n 1
done
# A pipe is not read any further: its writer may be waiting.
cat behind.nc | fivecheck -q --parse-only m.xml -
# An archive: subprograms stand behind the end, but a second main program would be without a verdict.
sed 's|dialect="fanuc"|dialect="sinumerik"|' m.xml >sinumerik.xml
printf '%%_N_A_MPF\nG90 G71 G500\nG0 X10\nDRILL\nM30\n%%_N_DRILL_SPF\nG0 X20\nM17\n' >archive.mpf
printf '%%_N_FACE_MPF\nG0 X30\nM30\n' | cat archive.mpf - >archive-2.mpf
sed 's|^DRILL$|FACE|' archive-2.mpf >archive-called.mpf
for program in archive archive-2 archive-called; do
	status fivecheck -q --parse-only sinumerik.xml $program.mpf
done
# A repeated part after M30 is executed; the line after it is not.
printf 'G90 G71 G500\nREPEAT A B\nM30\nA: G0 X10\nB:\n' >part.mpf
sed '$aG0 X20' part.mpf >behind-part.mpf
for program in part behind-part; do
	status fivecheck -q --parse-only sinumerik.xml $program.mpf
done
