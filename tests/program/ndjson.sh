# A header, findings, each program's verdict, and a summary last. The block's bytes may be anything.
# The verdict is told on standard error, too.
small_machine
printf 'G0 X100\nG0 X-300 (\351\033[31m)\n' >bad.nc
cp bad.nc "$(printf 'odd "\\\377.nc')"
status fivecheck --parse-only -f ndjson m.xml bad.nc
status fivecheck -q --parse-only -f ndjson m.xml odd*.nc
printf 'G0 X100 Z-50\nG0 X0 Z-150\n' | status fivecheck -q -f ndjson m.xml -
echo 'G0 X10' | status fivecheck -q -f ndjson m.xml -
