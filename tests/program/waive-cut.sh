# waive and merge refuse results from which lines were removed or to which lines were added.
small_machine
printf 'G0 X10\nG1 Z-120 F6000\nZ0\nZ-110\nM2\n' >a.nc
fivecheck -q -a -f ndjson m.xml a.nc >whole.json 2>/dev/null
grep -c '"kind":"collision"' whole.json
for edit in 2d 3d '2,4d' 3p; do
	sed "$edit" whole.json >cut.json
	[ $edit != 3p ] || sed -n "p;3p" whole.json >cut.json
	echo "== $edit"
	status fivecheck waive --reason=tried --until=2999-12-31 cut.json
	status fivecheck merge cut.json
done
echo '== a summary that says less'
sed '$s/"findings":3/"findings":2/' whole.json >cut.json
status fivecheck waive --reason=tried --until=2999-12-31 cut.json
echo '== a verdict that does not belong to the findings, and none'
for verdict in clear nonsense; do
	sed "s/\"verdict\":\"found\"/\"verdict\":\"$verdict\"/" whole.json >cut.json
	status fivecheck merge cut.json
done
sed 's/"verdict":"found",//' whole.json >cut.json
status fivecheck merge cut.json
echo '== as it was written'
fivecheck waive --reason=tried --until=2999-12-31 whole.json | grep -c '<waiver '
