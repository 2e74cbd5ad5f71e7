small_machine
echo 'G0 X10' | status fivecheck -q m.xml -
# Closed or empty standard input is no program that may pass for a checked one.
status fivecheck -q m.xml - <&- 2>/dev/null
