# --explain takes the treatment of a code from the tables of the interpreter: for all dialects that have it, or for one.
fivecheck --explain G43.4 --dialect=haas
# LinuxCNC itself has neither of these.
fivecheck --explain G43.4 --dialect=linuxcnc | tail -n 1
fivecheck --explain G50 --dialect=linuxcnc | tail -n 1
fivecheck --explain m08
fivecheck --explain 'while[...]do m' --dialect=fanuc
status fivecheck --explain G999 2>&1 | sed 's/nor one of .*/nor one of .../'
status fivecheck --explain G43.4 --dialect=heidenhain 2>&1 | sed 's/one of .*/one of .../'

# A code that is refused is an error, and one that is ignored or read is not; this agrees with the list.
small_machine
sed 's|<base|<controller dialect="haas" power_on_units="mm" power_on_distance="absolute" power_on_plane="xy"/><base|' m.xml >haas.xml
for state in ignored refused; do
	fivecheck --explain codes --dialect=haas | awk -F '\t' -v state=$state '$2 == state && $1 ~ /^[GM][0-9]/ { print $1 }' >$state
	for code in $(cat $state); do
		printf '%s\nM30\n' "$code" >a.nc
		if "$FIVECHECK" -q --parse-only haas.xml a.nc >/dev/null 2>out; then
			echo "codes that are $state pass"
		else
			echo "codes that are $state:$(grep -o -m 1 ' is not supported' out)"
		fi
	done | sort -u
done
