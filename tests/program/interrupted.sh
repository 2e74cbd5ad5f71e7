# An interrupted run leaves the old file of results unchanged.
small_machine
echo before >report
mkfifo endless consumed
{ yes 'G1 X1 F100' | head -n 100000; echo >consumed; yes 'G1 X1 F100'; } >endless 2>/dev/null &
writer=$!
"$FIVECHECK" -o report m.xml - <endless &
# Far more bytes were read than a pipe holds.
read -r _ <consumed
kill $! && wait $! 2>/dev/null
echo "status $?"
kill $writer 2>/dev/null
cat report
