# Doubts about tools that are drawn upside down, at the wrong position or with a diameter for a radius, and about a part
# outside its blank; no doubt just within the limits or with checked="".
small_machine
box cutter -4 -4 -100 4 4 -40
box short -4 -4 -98 4 4 -40
box nearly -4 -4 -99.5 4 4 -40
box up -4 -4 40 4 4 100
box holder -20 -20 -40 20 20 0
box aside 100 -20 -40 140 20 0
doubts() { # SETUP
	fivecheck --check-machine -s "$1" m.xml | sed -n '/^oddities/,$p' |
		grep -e thick -e 'bodies end' -e 'beside the spindle' -e 'radius of its D' -e 'out of' |
		sed 's/: .*\(, or give\)/\1/' >said
	[ -s said ] && cat said || echo "  silent"
}
both() { # TITLE; the setup is standard input
	setup s.xml
	echo "$1:"
	doubts s.xml
	sed 's/<tool /& checked="so drawn" /; s/<stock /& checked="so drawn" /' s.xml >checked.xml
	[ "$(doubts checked.xml)" = "  silent" ] || echo "said although it is checked"
}
for top in 30 29; do
	both "a holder that is $top mm thick at the gauge line and 50 mm below" <<XML
  <tool number="1" length="100">
    <holder><section length="20" diameter="$top"/><section length="20" diameter="50"/></holder>
    <cutter tip="flat"><section length="60" diameter="8"/></cutter>
  </tool>
XML
done
for mesh in cutter nearly short up; do
	both "a mesh of a cutter: $mesh" <<XML
  <tool number="1" length="100"><holder mesh="holder.stl"/><cutter mesh="$mesh.stl"/></tool>
XML
done
both "a holder beside the spindle's line" <<XML
  <tool number="1" length="100"><holder mesh="aside.stl"/><cutter mesh="cutter.stl"/></tool>
XML
for radius in 4 6 6.1 8; do
	both "D is $radius mm" <<XML
  <tool number="1" length="100">
    <holder mesh="holder.stl"/>
    <cutter tip="flat"><section length="60" diameter="8"/></cutter>
  </tool>
  <offset number="1" radius="$radius"/>
XML
done
# The part is a cube of 20 mm on the table; the blank is a cube about it, or beside its own part.
box cube -10 -10 0 10 10 20
for size in 20 18.5 17; do
	both "a blank of $size mm" <<XML
  <part name="cube" mesh="cube.stl"/>
  <stock box="$size 20 20"/>
XML
done
both "a part beside its blank" <<XML
  <part name="cube" mesh="cube.stl"/>
  <stock box="20 20 20" location="30 0 0"/>
XML
both "a second part that is cut from another blank" <<XML
  <part name="cube" mesh="cube.stl"/>
  <part name="next" mesh="cube.stl" location="30 0 0"/>
  <stock box="20 20 20"/>
XML
