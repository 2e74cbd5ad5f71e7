# A program that stops in the middle of a write: what is there is checked, and a warning names the line.
small_machine
printf 'G21 G90\nG1 F100 X1\nG1 X12' >cut.nc
fivecheck m.xml cut.nc >/dev/null
# Through a pipe, with other ends of lines; the last has an end of the program and no end of the line.
printf 'G1 F100 X1\r\nG1 X12' | fivecheck --parse-only m.xml - >/dev/null
printf 'G1 F100 X1\nG1 X12\nM30' | fivecheck --parse-only m.xml - >/dev/null
# Who reads the report alone, or with -q, is told as well.
fivecheck -q -f text -f ndjson=cut.json m.xml cut.nc
sed -n 's/.*"\(1 warning: cut.nc:3:\).*/\1/p' cut.json
