# A program that is still being written: its first lines are checked, and findings reported, before more lines arrive.
small_machine
# read_until LINE - the results up to a finding in this line of the program
read_until() {
	while read -r line <&4; do
		case $line in
		"<stdin>:$1:"*collision* | *'"kind":"collision"'*'"line":'"$1",*) echo "line $1" && return ;;
		esac
	done
}
for threads in 1 2 3; do
	for format in text ndjson; do
		rm -f program results
		mkfifo program results
		"$FIVECHECK" -a -q -j $threads -f $format m.xml - <program >results 2>err &
		checker=$!
		exec 3>program 4<results
		# The reader has only these lines, and the second one is not complete.
		printf 'G21 G90\nG1 Z-110 F1000\nG0 Z' >&3
		read_until 2
		printf '0\nG1 X60\r\nG1 Z-110\r\n' >&3
		read_until 5
		printf 'G0 Z0\r\nG1 X-20 Z-120\r\n' >&3
		read_until 7
		exec 3>&-
		cat <&4 >/dev/null
		exec 4<&-
		wait $checker
		echo "$threads $format: status $?"
	done
done
# The first finding ends a check without -a, although the writer has not closed the pipe.
for threads in 1 2; do
	rm -f program
	mkfifo program
	"$FIVECHECK" -q -j $threads m.xml - <program >out 2>err &
	checker=$!
	exec 3>program
	printf 'G21 G90\nG1 Z-110 F1000\n' >&3
	wait $checker
	echo "$threads: status $?"
	grep -c collision out
	exec 3>&-
done
