# A doubt about the model stands beside the verdict in every format, and checked="" with a reason takes it away.
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
# Said without bodies, too.
fivecheck --parse-only wrong.xml a.nc | grep -c "$doubt"
# The spindle, the workholding and all that is set up are silenced likewise.
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
