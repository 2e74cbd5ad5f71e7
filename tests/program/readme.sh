# The README section "Your own machine" shows the output of its commands. (MAKE_README=1 prints it.)
root=$(dirname "$LIB")/../..
ln -s "$root/machines" machines
awk '/^## / { on = $0 == "## Your own machine" } on && /^    / { print substr($0, 5) }' "$root/README.md" >shown
# Commands begin with "$ " and continue after a backslash.
awk '
/^\$ / { sub(/^\$ /, ""); command = $0; while (/\\$/) { getline; command = command "\n" $0 } print command; print "" }
' shown | awk 'BEGIN { RS = "" } { print > ("command" NR) } END { print NR }' >count
i=1
while [ "$i" -le "$(cat count)" ]; do
	sed '1s/^/$ /' "command$i"
	sh -c 'PATH=$(dirname "$FIVECHECK"):$PATH; . "./$0"' "command$i" 2>&1 || echo "(exit status $?)"
	i=$((i + 1))
done >printed
if [ -n "${MAKE_README:-}" ]; then
	cat printed
else
	diff shown printed
fi
