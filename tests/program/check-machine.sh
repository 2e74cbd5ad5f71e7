small_machine
# An open mesh, and a mesh that overlaps the head at home.
grep -v '^endsolid' table.stl | head -n 78 >open.stl
echo 'endsolid' >>open.stl
box post 10 10 0 30 30 150
sed -e 's/mesh="table.stl"/mesh="open.stl"/' \
	-e '/<body name="table"/a <body name="post" mesh="post.stl" location="0 0 -10"/>' m.xml >odd.xml
fivecheck --check-machine m.xml
fivecheck --check-machine odd.xml | sed -n '/^oddities/,$p'
# The place is in machine coordinates even if the first body was drawn elsewhere.
box high -20 -20 600 20 20 700
sed 's/mesh="head.stl"/mesh="high.stl" location="0 0 -500"/' odd.xml >high.xml
fivecheck --check-machine high.xml | sed -n '/^oddities/,$p'
# A cylinder whose last side ends at the sine of two pi is closed; one that lacks a side is open.
cylinder() { # NAME FROM: the sides from this one on
	awk -v from="$2" 'BEGIN {
		print "solid"
		turn = 2 * atan2(0, -1)
		for (i = from; i < 12; i++) {
			x = 50 * cos(i * turn / 12); y = 50 * sin(i * turn / 12)
			u = 50 * cos((i + 1) * turn / 12); v = 50 * sin((i + 1) * turn / 12)
			side("0 0 0", u " " v " 0", x " " y " 0")
			side("0 0 9", x " " y " 9", u " " v " 9")
			side(x " " y " 0", u " " v " 0", u " " v " 9")
			side(x " " y " 0", u " " v " 9", x " " y " 9")
		}
		print "endsolid"
	}
	function side(a, b, c) {
		printf "facet normal 0 0 0\nouter loop\nvertex %s\nvertex %s\nvertex %s\nendloop\nendfacet\n", a, b, c
	}' OFMT=%.17g CONVFMT=%.17g >"$1.stl"
}
cylinder round 0
cylinder cut 1
for name in round cut; do
	sed "s/mesh=\"table.stl\"/mesh=\"$name.stl\"/" m.xml >"$name.xml"
	echo "== $name"
	grep -c 'e-1[45]' "$name.stl"
	fivecheck --check-machine "$name.xml" | sed -n '/^oddities/,$p'
done
