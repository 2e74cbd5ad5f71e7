# A setup without its option is read as a program; the error suggests the option.
small_machine
setup s.xml <<'XML'
<work_offset name="G54" Z="1"/>
XML
fivecheck m.xml s.xml >/dev/null
echo "status $?" >&2
