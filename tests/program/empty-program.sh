# Nothing moves: the start pose is checked, with a warning.
small_machine
: >empty.nc
status fivecheck m.xml empty.nc
