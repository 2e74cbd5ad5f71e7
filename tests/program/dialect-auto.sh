# --dialect=auto takes the dialect that all signs in a program agree on, reports the sign, and never guesses: undecided
# or contradictory signs are an error.
small_machine
sed 's|<base|<controller dialect="linuxcnc"/><base|' m.xml >c.xml
printf '%%\nO1\nG90 G21\nG187 P3\nG0 X1.\nM30\n%%\n' >haas.nc
printf '%%\nO1\nG90 G21\nG05.1 Q1\nG0 X1.\nM30\n%%\n' >fanuc.nc
printf 'G21\n#<depth> = 3\nG0 X#<depth>\nM2\n' >linuxcnc.nc
printf '%%\nO1\nG90 G21\nG0 X1.\nM30\n%%\n' >either.nc
printf 'G21\nG0 X1\nM2\n' >plain.nc
printf '%%\nO1\n#<depth> = 3\nM30\n%%\n' >both.nc
mkdir folder.nc
gzip -c haas.nc >packed.nc
iconv -t UTF-16 haas.nc >wide.nc
: >empty.nc
printf 'G21\0\nG0 X1\n' >nul.nc
head -c 70000 /dev/zero | tr '\0' X >long.nc
for name in haas fanuc linuxcnc either plain both missing folder packed wide empty nul long; do
	echo "$name"
	status fivecheck --dialect=auto --parse-only c.xml $name.nc 2>&1 | grep -v '^  \|^[0-9]* blocks\|incomplete'
done
status fivecheck --dialect=auto --parse-only c.xml haas.nc fanuc.nc 2>&1 | grep -v incomplete
status fivecheck --dialect=auto --parse-only c.xml - 2>&1 <haas.nc | grep -v incomplete
# A named pipe without a writer is not even opened.
mkfifo pipe.nc
status fivecheck --dialect=auto --parse-only c.xml pipe.nc 2>&1 | grep -v incomplete
status fivecheck scan pipe.nc 2>&1
