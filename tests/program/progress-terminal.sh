# The progress line on a terminal: it fits, shows whole seconds, and disappears when results are printed.
command -v script >/dev/null || skip "there is no script (bsdutils)"
script -q -e -f -c true /dev/null >/dev/null 2>&1 </dev/null || skip "there is no pseudo-terminal"
small_machine
echo 'G0 X10' >a.nc
cp a.nc b.nc
many() { # blocks until the terminal has shown a line; so many that a line must have come
	chunks=0
	until grep -q -e ': line ' -e ' programs, ' log || [ $chunks -ge 2000 ]; do
		chunks=$((chunks + 1))
		awk 'BEGIN { for (i = 0; i < 3000; i++) print "G0 X" i % 100 }'
	done
}
cat >run <<'RUN'
stty cols 80
many | "$FIVECHECK" --parse-only -o out m.xml a.nc b.nc -
RUN
export FIVECHECK
shown() { # COLUMNS ROWS - what a terminal was sent, a line for each time the cursor went to the left
	tr -d '\n' <log | tr '\r' '\n' | sed 's/\x1b\[K//g' | grep -e '^\[' -e ': line '
}
awk '/^many\(\)/, /^}/' "$0" | cat - run >both
script -q -e -f -c 'sh ./both' log >/dev/null </dev/null
shown >lines
grep -c . lines | sed 's/^[1-9][0-9]*$/some/'
awk 'length($0) > 79' lines
grep -v -E '^\[#+ *\] 2 of 3 programs, [0-9.]+/s, [0-9]+ s left; <' lines
# A file name cannot control the terminal; a single endless program has no bar.
cat >run <<'RUN'
stty cols 30
name=$(printf 'red \033[31m.nc')
mkfifo "$name"
many >"$name" &
"$FIVECHECK" --parse-only -o out m.xml "$name"
RUN
awk '/^many\(\)/, /^}/' "$0" | cat - run >both
script -q -e -f -c 'sh ./both' log >/dev/null </dev/null
shown >lines
awk 'length($0) > 29' lines
sed 's/: line [0-9].*/: line/' lines | sort -u
