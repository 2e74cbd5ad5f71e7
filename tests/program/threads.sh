# The same bytes of findings and verdict for every number of threads, and on every run.
small_machine
awk 'BEGIN { for (i = 0; i < 2000; i++) printf "G1 X%.3f Z%.3f C%d F60000\n", (i * 37) % 300 - 150, -(i * 61 % 149), i * 7 }' >a.nc
fivecheck -q -a m.xml a.nc >one
fivecheck -q -a -j 3 m.xml a.nc >three
fivecheck -q -a -f ndjson m.xml a.nc >one.json
fivecheck -q -a -j 8 -f ndjson m.xml a.nc >eight.json
cmp one three && cmp one.json eight.json
grep -c '' one.json | awk '{ print ($1 > 100) }'
