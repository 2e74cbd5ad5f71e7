# Oblique heads and tables at any inclination: with M128 the tip keeps its position on the work while the oblique axis
# turns; that position is computed independently by Rodrigues' formula about (0, sin i, cos i).
cat >s.xml <<'END'
<setup version="1" units="mm"><work_offset name="G54.1 P1"/>
<tool number="1" length="75.5" checked="only its length counts here"/></setup>
END
# inclined FAMILY FIRST,SECOND INCLINATION - of B, whose axis goes through 0 3 120; the gauge point is 220 high
inclined() {
	"$FIVECHECK" init "$1" --rotary "$2" --limits X=none,Y=none,Z=none,B=none,C=none --location B=0,3,120 --location C=0,0,0 \
		--spindle 0,0,220 --inclination B="$3" --dialect klartext 2>notes | grep -v '<body name' |
		sed 's|<controller[^>]*>|<controller dialect="klartext" path_tolerance="0.01"><tool_change/></controller>|' >m.xml
	grep -c 'look it up' m.xml
	for b in 0 60 -90 180 400; do
		printf 'BEGIN PGM P MM\nCYCL DEF 247 Q339=+1\nTOOL CALL 1 Z S100\nM128\nL X+10 Y+20 Z+30 F1000\nL B%+d\nEND PGM P MM\n' $b >p.h
		"$FIVECHECK" -q --dump-path -s s.xml m.xml p.h | awk -v family="$1" -v i="$3" -v b=$b '
		function turn(angle,    c, s, k, dot) { # p about (0, sin i, cos i) through 0 3 120
			c = cos(angle); s = sin(angle); p[1] -= 3; p[2] -= 120
			dot = (1 - c) * (n[1] * p[1] + n[2] * p[2])
			r[0] = c * p[0] + s * (n[1] * p[2] - n[2] * p[1])
			r[1] = c * p[1] + s * n[2] * p[0] + dot * n[1]
			r[2] = c * p[2] - s * n[1] * p[0] + dot * n[2]
			p[0] = r[0]; p[1] = r[1] + 3; p[2] = r[2] + 120
		}
		NR == 1 { for (k = 1; k <= NF; k++) column[$k] = k; next }
		{ for (name in column) q[name] = $column[name] }
		END {
			d = atan2(0, -1) / 180; n[1] = sin(i * d); n[2] = cos(i * d); head = family ~ "head"
			p[0] = 0; p[1] = 0; p[2] = 220 - 75.5
			if (head) turn(b * d)
			p[0] += q["X"]; p[1] += q["Y"]; p[2] += q["Z"]
			# Rotated by B against the axis of the table: back to the drawn position of the work.
			if (!head) turn(b * d)
			printf "%s, inclined by %s, B%s: %.3f %.3f %.3f\n", family, i, q["B"], p[0], p[1], p[2] }'
	done
}
inclined nutating-head C,B 45
inclined nutating-head C,B 30
inclined nutating-table B,C 40
inclined nutating-table B,C 117.5
inclined head-table B,C 45
inclined table-table B,C 90
# An angle that is probably in radians.
for angle in 0.785 24.9 25 155 155.1; do
	"$FIVECHECK" init nutating-head --rotary C,B --limits X=none,Y=none,Z=none,B=none,C=none --location B=0,3,120 \
		--location C=0,0,0 --spindle 0,0,220 --inclination B=$angle 2>&1 >m.xml | grep inclination
done
# The same axes as with --direction.
write() { "$FIVECHECK" init head-head --rotary C,A --limits X=none,Y=none,Z=none,A=none,C=none --location A=0,0,0 --location C=0,0,0 --spindle 0,0,9 "$@" 2>notes; }
write --inclination A=90 >a.xml
write --direction A=1,0,0 | cmp - a.xml
