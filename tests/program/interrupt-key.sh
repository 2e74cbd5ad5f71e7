# SIGINT prints the findings so far and the last line; the status is never 0. It also wakes a waiting reader.
need python3
small_machine
mkfifo endless consumed silent
# A shell without job control starts background processes with SIGINT ignored.
cat >start.py <<'PY'
import os, signal, sys
signal.signal(signal.SIGINT, signal.SIG_DFL)
os.execv(sys.argv[1], sys.argv[1:])
PY
[ -e /proc/self/task ] || skip "there is no /proc"
# The reader has emptied the pipe and waits for more: every thread sleeps, and none has run between two observations.
wait_for_sleep() {
	now=
	until [ "$now" ] && [ "$now" = "$before" ] && ! echo "$now" | grep '^State' | grep -q -v '^State:.S'; do
		before=$now
		now=$(grep -h -e '^State' -e 'ctxt_switches' "/proc/$1/task/"*/status)
	done
}
interrupt() {
	python3 start.py "$FIVECHECK" "$@" <endless >out 2>err &
	checker=$!
	read -r _ <consumed
	[ -z "${asleep:-}" ] || wait_for_sleep $checker
	kill -INT $checker
	wait $checker
	echo "status $?"
	sed 's/line [0-9]*/line N/' err
	grep "finding\|incomplete" out
}
# After far more bytes were read than a pipe holds, the check is running.
{ echo 'G0 X500'; yes 'G1 X1 F100' | head -n 100000; echo >consumed; yes 'G1 X1 F100'; } 2>/dev/null >endless &
writer=$!
interrupt -a m.xml -
kill $writer 2>/dev/null
wait $writer 2>/dev/null
# The writer sends nothing more, and everything sent has been checked.
{ yes 'G1 X1 F100' | head -n 100000; echo >consumed; : <silent; } >endless &
writer=$!
asleep=1
interrupt -q m.xml -
kill $writer 2>/dev/null
