# Several formats at once: each in its file, text on standard output, all with the same results.
small_machine
printf 'G0 X10\n\tG1 Z-120 F6000 (\303\244 & <b>)\r\n' >'a b,c:d%.nc'
echo 'G0 X10' >good.nc
echo 'G0 B90' >bad.nc
mkdir sub
cp good.nc sub/good.nc
status fivecheck -f text -f sarif=out.sarif -f junit=out.xml -f github=out.txt -f ndjson=out.json m.xml 'a b,c:d%.nc' \
	good.nc bad.nc nowhere.nc ./sub/good.nc >text 2>messages
tail -n 1 text
ls
cat out.txt

cat out.xml
# The results are the same for any number of threads.
fivecheck -j 4 -f sarif=four.sarif -f junit=four.xml -f github=four.txt -f ndjson=four.json \
	m.xml 'a b,c:d%.nc' good.nc \
	bad.nc nowhere.nc ./sub/good.nc 2>four.messages
sed -i 's/ time="[^"]*"//' out.xml four.xml
cmp out.sarif four.sarif && cmp out.xml four.xml && cmp out.txt four.txt && cmp out.json four.json
