# PLANE and M128 of Klartext on a trunnion, a head with a table, two heads, and nutating axes at 45 degrees: independent
# forward kinematics computes tip and tool direction on the workpiece from the axes of --dump-path.
slant=0.70710678118654752

# rotary NAME SENSE X Y Z PX PY PZ - an axis element, open; SENSE -1 is a table's
rotary() {
	echo "$@" | awk '{
		printf "<axis name=\"%s\" type=\"rotary\" direction=\"%.17g %.17g %.17g\" ", $1, $2 * $3, $2 * $4, $2 * $5
		printf "location=\"%s %s %s\" limit_min=\"-200\" limit_max=\"200\" rate_max=\"36\">\n", $6, $7, $8
	}'
}

# kinematics NAME TABLE HEAD - writes NAME.xml and NAME.axes; each axis is "letter x y z px py pz", from the base on, with commas
kinematics() {
	{
		echo '<controller dialect="klartext" path_tolerance="0.01"><tool_change/></controller><base>'
		for axis in $2; do
			# shellcheck disable=SC2046 # seven words
			rotary $(echo "$axis" | sed 's/^\(.\),/\1 -1 /; s/,/ /g')
			echo "table $axis" >>"$1.axes"
		done
		echo '<workholding location="0 0 0"/>'
		for axis in $2; do echo '</axis>'; done
		for letter in X Y Z; do
			echo "<axis name=\"$letter\" type=\"linear\" direction=\"$(echo "$letter" | sed 's/X/1 0 0/; s/Y/0 1 0/; s/Z/0 0 1/')\""
			echo 'limit_min="-5000" limit_max="5000" rate_max="500" home="0">'
		done
		for axis in $3; do
			# shellcheck disable=SC2046 # seven words
			rotary $(echo "$axis" | sed 's/^\(.\),/\1 1 /; s/,/ /g')
			echo "head $axis" >>"$1.axes"
		done
		echo '<spindle location="0 0 0" direction="0 0 -1"/>'
		for axis in $3 x x x; do echo '</axis>'; done
		echo '</base>'
	} | sed '1s|^|<machine version="1" name="kinematics" units="mm">|; $s|$|</machine>|' >"$1.xml"
}

# tip NAME LINE - the tip and the tool's direction on the workpiece at the end of a line of p.h
tip() {
	"$FIVECHECK" -q --dump-path -s s.xml "$1.xml" p.h | awk -v line="$2" -v length_="75.5" '
	function turn(angle,    c, s, t, i, v) {
		angle *= atan2(0, -1) / 180
		c = cos(angle); s = sin(angle); t = 1 - c
		for (i = 0; i < 2; i++) {
			v[0] = i ? d[0] : p[0] - at[0]; v[1] = i ? d[1] : p[1] - at[1]; v[2] = i ? d[2] : p[2] - at[2]
			dot = t * (n[0] * v[0] + n[1] * v[1] + n[2] * v[2])
			r[0] = c * v[0] + s * (n[1] * v[2] - n[2] * v[1]) + dot * n[0]
			r[1] = c * v[1] + s * (n[2] * v[0] - n[0] * v[2]) + dot * n[1]
			r[2] = c * v[2] + s * (n[0] * v[1] - n[1] * v[0]) + dot * n[2]
			for (k = 0; k < 3; k++) { if (i) d[k] = r[k]; else p[k] = r[k] + at[k] }
		}
	}
	function rounded(x) { return sprintf("%.3f", x) + 0 }
	NR == FNR { kind[++count] = $1; split($2, f, ","); letter[count] = f[1]; for (k = 0; k < 6; k++) value[count, k] = f[k + 2]; next }
	FNR == 1 { for (i = 1; i <= NF; i++) column[$i] = i; next }
	$column["line"] == line { for (name in column) q[name] = $column[name] }
	END {
		p[2] = -length_; d[2] = 1
		for (i = count; i > 0; i--) if (kind[i] == "head") { for (k = 0; k < 3; k++) { n[k] = value[i, k]; at[k] = value[i, k + 3] } turn(q[letter[i]]) }
		p[0] += q["X"]; p[1] += q["Y"]; p[2] += q["Z"]
		for (i = 1; i <= count; i++) if (kind[i] == "table") { for (k = 0; k < 3; k++) { n[k] = value[i, k]; at[k] = value[i, k + 3] } turn(q[letter[i]]) }
		print "tip", rounded(p[0]), rounded(p[1]), rounded(p[2]), "tool", rounded(d[0]), rounded(d[1]), rounded(d[2])
	}' "$1.axes" -
}

kinematics trunnion 'A,1,0,0,0,0,-50 C,0,0,1,10,20,0' ''
kinematics table "B,0,1,0,5,0,-30 C,0,0,1,0,0,0" ''
kinematics mixed 'C,0,0,1,0,0,0' 'B,0,1,0,0,0,150'
kinematics head '' 'C,0,0,1,0,0,0 A,1,0,0,0,0,200'
kinematics nutating 'C,0,0,1,3,4,0' "B,0,$slant,$slant,0,-30,120"
kinematics nutating_table "B,0,$slant,$slant,0,0,-40 C,0,0,1,3,4,0" ''
cat >s.xml <<'END'
<setup version="1" units="mm"><work_offset name="G54.1 P1" X="12" Y="-7" Z="33"/>
<tool number="1" length="75.5" checked="only its length counts here"/></setup>
END

# program BLOCKS - p.h with them, line 6 being the first
program() {
	printf 'BEGIN PGM P MM\nCYCL DEF 247 Q339=+1\nTOOL CALL 1 Z S100\nL Z+300 R0 FMAX\nCYCL DEF 7.0\n%s\nEND PGM P MM\n' "$1" >p.h
}

# rotary_words NAME - its axes with the angles computed by the control
rotary_words() {
	sed 's/^[a-z]* \(.\).*/\1/; s/A/A+Q120/; s/B/B+Q121/; s/C/C+Q122/' "$1.axes" | paste -sd ' '
}

# The point (10, 20, 5) of a plane that is tilted about X by 30, Y by 20 and Z by 40 degrees, shifted by (1, 2, 3).
for name in trunnion table mixed head nutating nutating_table; do
	for way in 'TURN FMAX' 'MOVE DIST20 F5000' STAY; do
		words=
		[ "$way" != STAY ] || words="L $(rotary_words $name) R0 FMAX"
		program "CYCL DEF 7.1 X+1
CYCL DEF 7.2 Y+2
CYCL DEF 7.3 Z+3
PLANE SPATIAL SPA+30 SPB+20 SPC+40 $way SEQ+ COORD ROT
$words
L X+10 Y+20 Z+5 R0 FMAX"
		echo "$name, PLANE $way: $(tip $name 11)"
	done
	# MOVE: a point 20 mm in front of the tip keeps its place on the workpiece.
	program "L X+10 Y+20 Z+5 R0 FMAX
PLANE SPATIAL SPA+30 SPB+20 SPC+40 MOVE DIST20 F5000 SEQ+ COORD ROT"
	echo "$name, before: $(tip $name 6); after: $(tip $name 7)"
	# M140: away from the workpiece along the tool, with and without the plane; MAX up to the limit of an axis at 5 m.
	program "L X+10 Y+20 Z+5 R0 FMAX
PLANE SPATIAL SPA+30 SPB+20 SPC+40 TURN F5000 SEQ+ COORD ROT
L X+10 Y+20 Z+5 R0 FMAX
M140 MB50
M140 MB MAX
PLANE RESET STAY"
	echo "$name, M140: $(tip $name 9), $("$FIVECHECK" -q --dump-path -s s.xml $name.xml p.h |
		awk '$1 == 10 { for (i = 4; i <= 6; i++) if ($i > 4999.999 || $i < -4999.999) far++ } END { print far + 0, "axis at its limit" }')"
	# M128: the tip moves to the programmed position with any rotary axes.
	first=$(sed -n '1s/^[a-z]* \(.\).*/\1/p' $name.axes)
	second=$(sed -n '2s/^[a-z]* \(.\).*/\1/p' $name.axes)
	program "L M128
L X+10 Y+20 Z+5 $first+30 $second-50 F1000
L X-10 Y+3 Z+1 $first-20 $second+70
M129"
	echo "$name, M128: $(tip $name 7), $(tip $name 8)"
	# PLANE AXIAL: the tilted Z is the tool, and X is the machine's as the head turns it: 100 mm of each from the preset.
	program "PLANE AXIAL $first+30 $second-50 TURN FMAX
L X+0 Y+0 Z+100 R0 FMAX
L X+100 Y+0 Z+0 R0 FMAX"
	echo "$name, PLANE AXIAL: $(tip $name 7), $(tip $name 8)"
done
