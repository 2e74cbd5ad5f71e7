# A probe inside a block, drawn in various ways: the overlap is found, or a caution says that it is unknown.
box block -50 -50 -50 50 50 50
box probe -5 -5 -5 5 5 5
inside_out() {
	awk '/vertex/ { v[++n] = $0; if (n == 3) { print v[1]; print v[3]; print v[2]; n = 0 } next } { print }' "$1"
}
join_up() {
	echo "solid all"
	cat "$@" | grep -v solid
	echo "endsolid all"
}
cp block.stl once.stl
inside_out block.stl >inverted.stl
join_up once.stl inverted.stl >twice.stl
box hollow -40 -40 -40 40 40 40
join_up once.stl hollow.stl >nested.stl
inside_out hollow.stl >hole.stl
join_up once.stl hole.stl >cavity.stl
head -n 78 block.stl >open.stl
echo "endsolid" >>open.stl
inside_out open.stl >open-inverted.stl
join_up open.stl open-inverted.stl >open-twice.stl
machine m.xml <<'XML'
  <body name="block" mesh="block.stl"/>
  <axis name="X" type="linear" direction="1 0 0" rate_max="6000">
    <body name="probe" mesh="probe.stl"/>
  </axis>
XML
program a.nc <<'NC'
G0 X10
G0 X0
NC
for drawing in once inverted twice nested cavity open open-twice; do
	echo "== $drawing"
	cp $drawing.stl block.stl
	"$FIVECHECK" -q m.xml a.nc | grep -E 'start-overlap|clear|surfaces' | sed 's/no setup.*//'
	"$FIVECHECK" --check-machine m.xml | sed -n '/^oddities/,$p' | grep -v overlap
done
# A tool change inside an open body, and a shard that starts there.
cp open.stl block.stl
machine t.xml <<'XML'
  <body name="block" mesh="block.stl"/>
  <axis name="X" type="linear" direction="1 0 0" limit_min="-500" limit_max="500" rate_max="6000">
    <spindle location="0 0 5" direction="0 0 -1"/>
  </axis>
XML
setup s.xml <<'XML'
  <tool number="1" length="10"><cutter tip="flat"><section length="10" diameter="4"/></cutter></tool>
XML
program t.nc <<'NC'
G0 X100
G0 X0
T1 M6
G0 X1
NC
"$FIVECHECK" -q -s s.xml t.xml t.nc | grep surfaces
echo "== a probe that comes down through the missing lid"
awk '/^facet|^ *facet/ { facet = ""; top = 1; inside = 1 } inside { facet = facet $0 "\n" } /vertex/ && $4 != 50 { top = 0 }
	/endfacet/ { if (!top) printf "%s", facet; inside = 0; next } !inside' once.stl >lidless.stl
for drawing in once lidless reason; do
	cp ${drawing%reason}.stl block.stl 2>/dev/null || true
	machine z.xml <<XML
  <body name="block" mesh="block.stl" $([ $drawing != reason ] || echo 'checked="a chip tray"')/>
  <axis name="Z" type="linear" direction="0 0 1" limit_min="-500" limit_max="0" rate_max="6000">
    <body name="probe" mesh="probe.stl" location="0 0 200"/>
  </axis>
XML
	echo "G0 Z-200" >z.nc
	"$FIVECHECK" -q z.xml z.nc | grep -E 'collision:|clear|open mesh' || true
done
