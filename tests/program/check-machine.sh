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
