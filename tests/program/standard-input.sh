small_machine
echo 'G0 X10' | status fivecheck -q m.xml -
# Closed or empty standard input must not count as a checked program.
status fivecheck -q m.xml - <&- 2>/dev/null
