# With standard output closed, the next file that is opened must not receive the report.
small_machine
program a.nc <<'NC'
G0 X10
NC
cp m.xml before.xml
fivecheck -q m.xml a.nc >&-
echo "status $?"
fivecheck -q --dump-path m.xml a.nc >&- 2>&-
echo "status $?"
# Even without findings, NDJSON has a header and a summary; the GitHub format has no output to lose.
fivecheck -q -f ndjson m.xml a.nc >&- 2>&-
echo "status $?"
fivecheck -q -f github m.xml a.nc >&-
echo "status $?"
fivecheck -q -o report m.xml a.nc >&- 2>&- <&-
echo "status $?"
cmp m.xml before.xml
head -n 1 report
