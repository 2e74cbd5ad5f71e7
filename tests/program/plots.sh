# The gnuplot scripts draw the two reports, with any names in them. Without gnuplot this is skipped.
plots=${LIB%/*}/../../examples/plots
need gnuplot
small_machine
sed -e 's/body name="table"/body name="big_1 {x}"/' m.xml >odd.xml
printf 'G0 Z%s\n' 0 -95 -98 -95 0 >a.nc
printf 'G0 X%s\n' 0 10 >b.nc
fivecheck -q --clearance-report c.csv --timing t.csv -o /dev/null odd.xml a.nc b.nc
# drawn SCRIPT ARGUMENT... - draws, and prints the texts of the picture and the numbers of lines and points
drawn() {
	gnuplot -c "$plots/$@" 2>/dev/null || echo "gnuplot failed"
	for word in "Proven clearance" "Time to check" 'head - big_1 {x}' "nothing came" interpreted checked "in a.nc"; do
		grep -q -F "$word" "$3" && echo "$1: $word"
	done
}
drawn clearance.gnuplot c.csv c.svg
drawn clearance.gnuplot c.csv c.svg a.nc
drawn clearance.gnuplot c.csv c.svg b.nc
drawn timing.gnuplot t.csv t.svg
drawn timing.gnuplot t.csv t.svg b.nc
fivecheck -q --clearance-report c.csv -o /dev/null m.xml b.nc
echo G4 P1 >c.nc
drawn clearance.gnuplot c.csv c.svg
# Without checked blocks, or without a table, there is no picture.
fivecheck -q --clearance-report e.csv -o /dev/null m.xml c.nc
for table in e.csv absent.csv; do
	gnuplot -c "$plots/clearance.gnuplot" $table e.svg 2>/dev/null
	echo "status $?"
done
[ -e e.svg ] || echo "no picture"
gnuplot -c "$plots/timing.gnuplot" t.csv t.png && head -c 4 t.png | tail -c 3
echo
status gnuplot -c "$plots/timing.gnuplot" 2>&1
