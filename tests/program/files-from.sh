# A list of programs from a file or standard input; shards; totals. One bad file does not stop the others.
small_machine
for i in 1 2 3 4 5; do echo "G0 X${i}0" >p$i.nc; done
echo 'G0 X300' >bad.nc
printf 'p1.nc\r\n\np2.nc\nnowhere.nc\nbad.nc\np3.nc' >list
names() {
	sed -n 's/^\([a-z0-9]*\.nc\): .*/\1/p' | tr '\n' ' '
	echo
}
status fivecheck -q --parse-only --files-from list m.xml p5.nc >out 2>err
tail -n 1 out
names <out
cat err
# The same for any number of threads, from standard input.
fivecheck -q --parse-only -j 4 --files-from - m.xml p5.nc <list 2>err.4 | sed '$a status 2' | cmp - out
cmp err err.4
# Shards: each program in exactly one, and too many shards are no error.
for k in 1 2 3; do
	fivecheck -q --parse-only --files-from list --shard $k/3 m.xml p5.nc 2>/dev/null | names
done
fivecheck -q --parse-only --shard 3/4 -f ndjson m.xml p1.nc p2.nc
# Totals, and progress in plain lines.
fivecheck --parse-only --progress=plain m.xml p1.nc p2.nc bad.nc nowhere.nc 2>&1 |
	grep -e '^fivecheck: [0-9]' -e '^  programs'
fivecheck --parse-only --progress=none m.xml p1.nc p2.nc 2>&1 | grep -c '^fivecheck: [0-9]' || true
# Not lists: a file with a NUL byte is refused at that byte, and an endless file is too long.
printf 'p1.nc\0p2.nc' >zeros
for list in zeros /dev/zero . nowhere; do
	fivecheck -q --parse-only --files-from $list m.xml 2>&1
done
status fivecheck -q --parse-only --files-from /dev/zero m.xml 2>/dev/null
yes p1.nc | status fivecheck -q --parse-only --files-from - m.xml 2>&1
