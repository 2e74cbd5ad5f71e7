# A setup without its option is read as a program; the fault says what may have been meant.
small_machine
setup s.xml <<'XML'
<work_offset name="G54" Z="1"/>
XML
fivecheck m.xml s.xml >/dev/null
echo "status $?" >&2
