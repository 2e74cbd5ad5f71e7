# The time of each block: one row per block, a sum not above the time of the run, and the same verdict.
small_machine
cat >a.nc <<'NC'
( a block without words is none )
G0 Z-50 C90
G4 P3
G1 X30 F6000
G2 X-30 I-30 J0 F3000
NC
sed -i 's|</base>|<axis name="Y" type="linear" direction="0 1 0" rate_max="6000"/></base>|' m.xml
# In us, by a monotonic clock. It may pause on a busy computer: one more second is allowed.
uptime_us() {
	awk '{ printf "%d\n", $1 * 1e6 }' /proc/uptime
}
start=$(uptime_us)
status fivecheck -q --timing t.csv -o verdict m.xml a.nc
end=$(uptime_us)
cat verdict
awk -F, -v whole=$((end - start + 1000000)) '
	NR == 1 { print; next }
	{ print $1, $2, $3, $4, ($5 > 1 ? "many" : $5) " steps", $6 " s"; sum += $7 + $8; good += $7 >= 0 && $8 >= 0; moving += $5 && $8 > 0 }
	END { print NR - 1 " rows, " good " with times, " moving " checked, " (sum > 0 && sum < whole ? "within the run" : sum " of " whole) }' t.csv
# The sampled methods, as the paper compares them; several programs; one that ends at its finding; both tables at once.
for method in interpolated conventional; do
	fivecheck -q --timing t.csv --method $method -o /dev/null m.xml a.nc
	cut -d , -f 1-4 t.csv | tail -n 1
done
printf 'G0 Z%s\n' -50 -101 0 >b.nc
status fivecheck -q -j 3 --timing t.csv --clearance-report c.csv -o /dev/null m.xml b.nc a.nc b.nc
cut -d , -f 1-6 t.csv
cut -d , -f 1-4 c.csv
