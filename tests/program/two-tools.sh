# A rule about all holders and cutters is about those of one tool: two tools are never in the spindle at once.
small_machine
sed 's|</machine>|<pairs><pair a="holder" b="cutter" check="always"/></pairs></machine>|' m.xml >rule.xml
setup s.xml <<'XML'
  <tool number="1" length="40"><holder><section length="20" diameter="20"/></holder>
    <cutter><section length="20" diameter="10"/></cutter></tool>
  <tool number="2" length="60"><holder><section length="10" diameter="20"/></holder>
    <cutter><section length="50" diameter="10"/></cutter></tool>
XML
fivecheck --list-pairs -s s.xml rule.xml | grep 'T1.*T2'
sed 's|a="holder" b="cutter"|a="T1 holder" b="T2 cutter"|' rule.xml >named.xml
printf 'T1 M6\nG0 X10\nT2 M6\nG0 X0\n' >p.nc
status fivecheck -q -s s.xml named.xml p.nc
