# The manual page describes every option that the program has, and no other.
page=$(dirname "$LIB")/../../man/fivecheck.1
commands=$("$FIVECHECK" --help | sed -n 's/^       fivecheck \([a-z][a-z]*\) .*/\1/p')
for command in '' $commands; do
	# shellcheck disable=SC2086 # no word if there is no command
	"$FIVECHECK" $command --help | sed -n 's/^  \(-\(.\), \|    \)--\([a-z-]*\).*/\2 \3/p'
done | awk '{ print $NF; if (NF > 1) print $1 }' | sort -u >wanted
# .It Fl s Ar file , Fl -setup Ns = Ns Ar file
sed -n 's/^\.It \(Fl .*\)/\1/p' "$page" | tr ' ' '\n' | awk 'was == "Fl" { sub(/^-/, ""); print } { was = $0 }' |
	sort -u >found
for command in $commands; do
	grep -q "^\.Cm $command" "$page" || echo "not in the manual: the command $command"
done
diff wanted found | sed 's/^</not in the manual: /; s/^>/in the manual only: /'
