# Two bodies on one axis need no work while only that axis moves, however close they are.
box low -50 -50 0 50 50 10
box high -5 -5 10.01 5 5 20
machine m.xml <<'XML'
  <axis name="X" type="linear" direction="1 0 0" limit_min="0" limit_max="100" rate_max="6000">
    <body name="low" mesh="low.stl"/>
    <axis name="Z" type="linear" direction="0 0 1" limit_min="0" limit_max="100" rate_max="6000">
      <body name="high" mesh="high.stl"/>
    </axis>
  </axis>
--
  <pairs><pair a="low" b="high" check="always"/></pairs>
XML
awk 'BEGIN { for (i = 0; i < 20000; i++) print "G1 X" (i % 2 ? 0 : 50) " F1000" }' >shuttle.nc
fivecheck --stats m.xml shuttle.nc | grep -E 'clear|queries|bisections' | sed 's/  *$//'
