# A program that was written only in part: its blocks are checked, and a warning names the line.
small_machine
printf 'G21 G90\nG1 F100 X1\nG1 X12' >cut.nc
fivecheck m.xml cut.nc >/dev/null
# From a pipe, with other line ends; the last program has an end, but its last line has no line end.
printf 'G1 F100 X1\r\nG1 X12' | fivecheck --parse-only m.xml - >/dev/null
printf 'G1 F100 X1\nG1 X12\nM30' | fivecheck --parse-only m.xml - >/dev/null
# The report has the warning too, also with -q.
fivecheck -q -f text -f ndjson=cut.json m.xml cut.nc
sed -n 's/.*"\(1 warning: cut.nc:3:\).*/\1/p' cut.json
