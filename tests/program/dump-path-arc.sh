# Every point of the path lies on the circle, and the deviation column bounds the error of the chords.
small_machine
box table -50 -50 -20 50 50 0
machine m.xml <<'XML'
  <axis name="X" type="linear" direction="1 0 0" rate_max="6000">
    <axis name="Y" type="linear" direction="0 1 0" rate_max="6000">
      <body name="head" mesh="head.stl"/>
    </axis>
  </axis>
  <body name="table" mesh="table.stl"/>
XML
program a.nc <<'NC'
G0 X30
G3 X-30 Y0 I-30 J0 F600
NC
for tolerance in 1 0.01; do
	fivecheck --dump-path --tolerance $tolerance m.xml a.nc >path
	awk -v e=$tolerance '
	NR == 3 { x = 30; y = 0 }
	NR > 2 {
		radius = sqrt($4 * $4 + $5 * $5)
		half = sqrt(($4 - x) ^ 2 + ($5 - y) ^ 2) / 2
		sagitta = 30 - sqrt(900 - half * half)
		if (radius < 30 - 1e-9 || radius > 30 + 1e-9) print "off the circle:", $0
		if (sagitta > $7 + 1e-9) print "deviation too small:", $0, sagitta
		if ($7 > e) print "not flat enough:", $0
		x = $4; y = $5; spans++
	}
	END { print (spans > 1 ? "several spans" : "one span"), "end at", x,
	            (y < 1e-9 && y > -1e-9), ($6 > 9.7247 && $6 < 9.7249) }' path
done
