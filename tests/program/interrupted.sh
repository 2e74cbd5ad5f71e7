# What ends in the middle leaves the file of results as it was.
small_machine
echo before >report
mkfifo endless
yes 'G1 X1 F100' >endless 2>/dev/null &
writer=$!
"$FIVECHECK" -o report m.xml - <endless &
sleep 0.3
kill $! && wait $!
echo "status $?"
kill $writer 2>/dev/null
cat report
