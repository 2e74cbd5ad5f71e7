# Programs of G65 and M98 are found in the program's own file, in files beside it, in --include folders, nowhere else.
small_machine
mkdir lib
printf '%%\nO1 (MAIN)\nG65 P2 A1.\nM98 P3\nM98 P4\nG65 P5\nM30\nO2\nG21 G90 G0 X#1\nM99\n%%\n' >a.nc
printf '%%\nO0003\nG0 X3.\nM98 P6\nM99\nO6 (IN THE SAME FILE)\nX6.\nM99\n%%\n' >O0003.nc
printf 'G0 X4.\nM99\n' >4
printf 'O5\nG0 Q5.\nM99\n' >lib/O5.NC
fivecheck --dialect=fanuc --dump-path m.xml a.nc
echo "exit $?"
fivecheck --dialect=haas --dump-path --include=lib m.xml a.nc
echo "exit $?"
printf 'O9\nM99\n' >O0004.nc
fivecheck --dialect=fanuc --parse-only m.xml a.nc >/dev/null
echo "exit $?"
printf 'M98 P7\nM30\n' >b.nc
printf 'O8\nM99\n' >O7.nc
fivecheck --dialect=fanuc --parse-only m.xml b.nc >/dev/null
echo "exit $?"
printf 'O1 G21 G90\n#1=0\nWHILE [#1 LT 3] DO1\n#1=#1+1\nG0 X[#1*10.]\nEND1\nM30\n' |
	fivecheck --dialect=haas --dump-path m.xml -
echo "exit $?"
printf 'N1 G21 G90 G0 X1.\nGOTO 1\n' >c.nc
fivecheck --dialect=fanuc --parse-only --max-blocks=500 m.xml c.nc >/dev/null
echo "exit $?"
# Of two programs with one number none is called, on a pipe neither.
twice='O1\nG21 G90\nM98 P2\nM30\nO2\nM99\nO2\nG0 X5.\nM99\n'
printf "$twice" >d.nc
fivecheck --dialect=fanuc --parse-only m.xml d.nc >/dev/null
echo "exit $?"
printf "$twice" | fivecheck --dialect=fanuc --parse-only m.xml - >/dev/null
echo "exit $?"
# What a pipe brings after its window is not known.
{
	printf 'O1\nG21 G90\nM98 P2\nM30\nO2\nM99\n'
	head -c 4500000 /dev/zero | tr '\0' ' ' | fold -w 100
} | fivecheck --dialect=fanuc --parse-only m.xml - >/dev/null
echo "exit $?"
# A folder that ignores the case of names has one file of both names.
printf 'O6\nG0 X3.\nM99\n' >O6.nc
ln O6.nc O6.NC
printf 'G21 G90\nM98 P6\nM30\n' >e.nc
fivecheck --dialect=fanuc --parse-only m.xml e.nc >/dev/null
echo "exit $?"
