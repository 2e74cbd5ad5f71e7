# Which of two positions of the rotary axes PLANE takes: the table of the iTNC 530 user's manual, "Selection of alternate
# tilting possibilities", for PLANE SPATIAL SPA+0 SPB+45 SPC+0 on a machine with a rotary table C and a tilting table A.
# machine LIMIT_MIN LIMIT_MAX
machine() {
	cat >m.xml <<XML
<machine version="1" name="table" units="mm"><controller dialect="klartext"/>
<base>
 <axis name="X" type="linear" direction="1 0 0" limit_min="-999" limit_max="999" rate_max="9999"><axis name="Y" type="linear"
  direction="0 1 0" limit_min="-999" limit_max="999" rate_max="9999"><axis name="Z" type="linear" direction="0 0 1"
  limit_min="-999" limit_max="999" rate_max="9999"><spindle location="0 0 0" direction="0 0 -1"/></axis></axis></axis>
 <axis name="A" type="rotary" direction="-1 0 0" location="0 0 0" limit_min="$1" limit_max="$2" rate_max="9999">
  <axis name="C" type="rotary" direction="0 0 -1" location="0 0 0" wrap="shortest" rate_max="9999">
   <workholding location="0 0 0"/></axis></axis></base></machine>
XML
}

# row C SEQ - the axes from A0 and this C, which the control displays within a turn
row() {
	printf '%s\n' 'BEGIN PGM P MM' M126 "L A+0 C$1 R0 FMAX" "PLANE SPATIAL SPA+0 SPB+45 SPC+0 TURN FMAX $2" 'END PGM P MM' >p.h
	echo "C$1 ${2:-not programmed}:" "$(fivecheck --dump-path m.xml p.h 2>errors |
		awk 'NR > 1 { turned = "A" $7 " C" ($8 > -180 ? $8 : $8 + 360) } END { print turned }')"
	sed -n '/warning\|error\|caution/p' errors
}

machine -200 200
row +0 ''
row +0 SEQ+
row +0 SEQ-
row -105 ''
row -105 SEQ+
row -105 SEQ-
row -135 SEQ+
machine -90 10
row +0 ''
row +0 SEQ+
# Neither position is nearer in both axes.
machine -200 200
printf '%s\n' 'BEGIN PGM P MM' 'M126' 'L A+10 C-60 R0 FMAX' 'PLANE SPATIAL SPA+0 SPB+45 SPC+0 TURN FMAX' 'END PGM P MM' >p.h
status fivecheck --dump-path m.xml p.h
# DIST of MOVE has other names in other languages and versions of the control. The point 50 mm below the tip turns by 45
# degrees about X: Y by -50 sin 45 degrees, Z by 50 - 50 cos 45 degrees.
for word in DIST ABST SETUP SET-UP; do
	printf '%s\n' 'BEGIN PGM P MM' "PLANE SPATIAL SPA+0 SPB+45 SPC+0 MOVE ${word}50 FMAX SEQ+" 'END PGM P MM' >p.h
	echo "$word: $(fivecheck --dump-path -q m.xml p.h | awk 'END { print $1, $4, $5, $6, $7, $8 }')"
done
# Cycle 19 has no SEQ.
sed 's/dialect="klartext"/& cycle_19_angles="spatial"/' m.xml >c.xml
printf '%s\n' 'BEGIN PGM P MM' 'CYCL DEF 19.0 WORKING PLANE' 'CYCL DEF 19.1 A+0 B+45 C+0' 'L A+Q120 C+Q122 R0 FMAX' 'END PGM P MM' >p.h
status fivecheck --dump-path c.xml p.h
