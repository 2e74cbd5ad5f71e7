# One row per pair of bodies, in the order of the XML: machine, part, tools.
small_machine
box part -10 -10 0 10 10 30
setup s.xml <<'XML'
  <part name="cube &amp; co" mesh="part.stl"/>
  <tool number="1" name="end mill" length="50">
    <holder><section length="20" diameter="30"/></holder>
    <cutter tip="flat"><section length="30" diameter="10"/></cutter>
  </tool>
XML
fivecheck --list-pairs --clearance 0.25 -s s.xml m.xml | cut -f 1-4
fivecheck --list-pairs m.xml | awk -F '\t' '{ print NF }'
