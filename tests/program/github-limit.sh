# Ten findings at most are shown beside the lines, then a count.
small_machine
awk 'BEGIN { for (i = 0; i < 14; i++) print "G0 X" (i % 2 ? -300 : 300) }' >a.nc
status fivecheck -q --parse-only -a -f github m.xml a.nc
echo 'G0 X300' >b.nc
status fivecheck -q --parse-only -f github m.xml b.nc
