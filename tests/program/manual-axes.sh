# The manual page that explains the signs of axes shows what --check-machine prints.
folder="$(dirname "$LIB")/../.."
sed -n '/^\.Sh WHAT A POSITIVE VALUE DOES/,/^\.Sh WHAT A VERDICT/p' "$folder/man/fivecheck.7" |
	awk '/^\.Ed/ { shown = 0 } shown { if (/^  [A-Z]/) print ""; gsub(/^ +/, ""); printf "%s ", $0 } /^\.Bd/ { shown = 1 }' |
	sed 's/ $//' | grep . >manual
"$FIVECHECK" --check-machine "$folder/machines/ac-trunnion/machine.xml" | sed -n 's/^  \([A-Z]+10: .*\)/\1/p' >printed
grep -c . manual
diff manual printed
