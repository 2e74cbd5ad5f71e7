# A doubt about the model is a caution beside the verdict in every format; checked="" with a reason removes it.
need python3
small_machine
program a.nc <<'NC'
G0 X10
NC
sed 's/direction="0 0 -1" location="0 0 0"/direction="0 0 1" location="0 0 0"/' m.xml >wrong.xml
sed 's/<axis name="C"/<axis name="C" checked="the maker counts this way"/' wrong.xml >checked.xml
sed 's/<axis name="C"/<axis name="C" checked=""/' wrong.xml >empty.xml
doubt='left-handed about Z'
for format in text ndjson github sarif junit; do
	"$FIVECHECK" -f $format wrong.xml a.nc >$format.out 2>$format.err
	printf '%s: status %s, said %s, ' $format $? "$(cat $format.out $format.err | grep -c "$doubt")"
	"$FIVECHECK" -f $format checked.xml a.nc 2>&1 | grep -c "$doubt"
done
fivecheck --check-machine wrong.xml | sed -n '/^what/,$p'
fivecheck --check-machine checked.xml | sed -n '/^what/,$p'
status fivecheck --check-machine empty.xml
# Reported without bodies, too.
fivecheck --parse-only wrong.xml a.nc | grep -c "$doubt"
# checked="" works on the spindle, the workholding and everything in the setup.
machine places.xml <<'XML'
  <axis name="X" type="linear" direction="1 0 0" limit_min="-200" limit_max="200" rate_max="6000">
    <axis name="Z" type="linear" direction="0 0 1" limit_min="-150" limit_max="50" rate_max="6000">
      <body name="head" mesh="head.stl"/>
      <spindle location="0 0 190" direction="0 0 -1"/>
    </axis>
  </axis>
  <body name="table" mesh="table.stl"/>
  <workholding location="0 0 100"/>
XML
box cube -10 -10 0 10 10 20
setup s.xml <<'XML'
  <work_offset name="G54" X="300"/>
  <part name="cube" mesh="cube.stl"/>
  <tool number="1" length="400" length_offset="40"><cutter tip="flat"><section length="400" diameter="4"/></cutter></tool>
XML
fivecheck --check-machine -s s.xml places.xml | sed -n '/^oddities/,$p' | sed 's/[:;].*//'
sed -e 's/<work_offset/& checked="r"/; s/<part/& checked="r"/; s/<tool/& checked="r"/' s.xml >sc.xml
sed -e 's/<spindle/& checked="r"/; s/<workholding/& checked="r"/' places.xml >pc.xml
fivecheck --check-machine -s sc.xml pc.xml | sed -n '/^oddities/,$p' | sed 's/[:;].*//'
# Missing bodies are reported for a machine with bodies on three links; checked="" on axis, spindle, workholding and
# tool removes these doubts.
drawn_mill drawn.xml
sed 's/ limit_max="100"//' drawn.xml >whole.xml
setup tools.xml <<'XML'
  <tool number="1" length="100"><cutter tip="flat"><section length="100" diameter="4"/></cutter></tool>
  <tool number="2" length="100"><cutter tip="flat"><section length="100" diameter="6"/></cutter></tool>
XML
missing() { # MACHINE SETUP
	fivecheck --check-machine -s "$2" "$1" | sed -n '/^oddities/,$p' | grep -e 'no body' -e 'unlimited travel' -e 'travel of' -e holder
}
echo "missing:"
missing whole.xml tools.xml
echo "without bed, head and table:"
for body in bed head table; do
	sed "/name=\"$body\"/d" whole.xml >without.xml
	missing without.xml tools.xml | grep body
done
echo "silenced:"
sed -e 's/<spindle/& checked="r"/; s/<workholding/& checked="r"/; s/<axis/& checked="r"/' without.xml >silent.xml
sed 's/<tool /& checked="r" /' tools.xml >ts.xml
missing silent.xml ts.xml
echo "the base has a reason of its own:"
sed '/name="bed"/d; s/<workholding/& checked="r"/' whole.xml >bed.xml
missing bed.xml ts.xml | grep -c 'no bed'
sed 's/<base>/<base checked="the bed is far below">/' bed.xml >own.xml
missing own.xml ts.xml | grep -c 'no bed'
sed 's/<base>/<base checked="">/' bed.xml >none.xml
"$FIVECHECK" --check-machine none.xml 2>&1 | grep error
# A disc whose middle is beside the axis, and one on it.
python3 - <<'PY'
import math
import struct
for name, beside in ("round", 0), ("beside", 4):
    ring = [(beside + 50 * math.cos(math.tau * k / 24), 50 * math.sin(math.tau * k / 24)) for k in range(24)]
    faces = []
    for (ax, ay), (bx, by) in zip(ring, ring[1:] + ring[:1]):
        faces += [((ax, ay, 0), (bx, by, 0), (bx, by, 9)), ((ax, ay, 0), (bx, by, 9), (ax, ay, 9)),
                  ((beside, 0, 9), (ax, ay, 9), (bx, by, 9)), ((beside, 0, 0), (bx, by, 0), (ax, ay, 0))]
    with open(name + ".stl", "wb") as f:
        f.write(bytes(80) + struct.pack("<I", len(faces)))
        for face in faces:
            f.write(struct.pack("<12fH", 0, 0, 0, *(c for p in face for c in p), 0))
PY
for mesh in round beside; do
	machine disc.xml <<XML
  <axis name="C" type="rotary" direction="0 0 -1" location="0 0 0" rate_max="6000">
    <body name="disc" mesh="$mesh.stl" location="0 0 70"/><workholding location="0 0 79"/>
  </axis>
  <axis name="Z" type="linear" direction="0 0 1" limit_min="-150" limit_max="100" rate_max="6000">
    <body name="head" mesh="head.stl"/><spindle location="0 0 190" direction="0 0 -1"/>
  </axis>
XML
	echo "$mesh:"
	fivecheck --check-machine disc.xml | grep circle
done
