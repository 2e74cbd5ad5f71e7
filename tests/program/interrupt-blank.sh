# SIGINT during blank lines and comments, or in a loop without motion, which produce no events.
need python3
cat >start.py <<'PY'
import os, signal, sys
signal.signal(signal.SIGINT, signal.SIG_DFL)
os.execv(sys.argv[1], sys.argv[1:])
PY
small_machine
for line in '' '(nothing)'; do
	for threads in 1 2; do
		# A new pipe each time: a writer that still has the old one would end the next program.
		rm -f endless consumed
		mkfifo endless consumed
		python3 start.py "$FIVECHECK" -q -j $threads m.xml - <endless 2>err &
		checker=$!
		{ yes "$line" | head -n 1000000; echo >consumed; yes "$line"; } 2>/dev/null >endless &
		writer=$!
		read -r _ <consumed
		kill -INT $checker
		wait $checker
		echo "status $?"
		kill $writer 2>/dev/null
		grep -o 'interrupted after line' err
	done
done
