# A motion known only as a set of paths must keep the limits with all of them: the overrun of G60, cutter compensation
# whose form is not given. Positions between covered ones are not farther out.
box post 105.5 20 0 120 40 50
machine m.xml <<'XML'
  <axis name="X" type="linear" direction="1 0 0" limit_min="0" limit_max="200" rate_max="6000">
    <axis name="Y" type="linear" direction="0 1 0" limit_min="-50" limit_max="50" rate_max="6000">
      <axis name="Z" type="linear" direction="0 0 1" limit_min="-100" limit_max="0" rate_max="6000">
        <body name="head" mesh="head.stl"/>
        <spindle location="0 0 0" direction="0 0 -1"/>
      </axis>
    </axis>
  </axis>
  <body name="post" mesh="post.stl"/>
--
<controller dialect="fanuc" unidirectional_overrun="1.5" path_tolerance="0.02" power_on_units="mm"
  power_on_distance="absolute" power_on_plane="xy"><tool_change/></controller>
XML
box head -5 -5 0 5 5 50
setup s.xml <<'XML'
  <work_offset name="G54"/>
  <offset number="1" radius="5"/>
XML

echo '== G60 is clear where its overrun is inside'
echo 'G60 X198.5 Y48.5
G0 X0
M30' >clear.nc
status fivecheck -q --parse-only -s s.xml m.xml clear.nc
echo '== and not where a part of it may be outside'
printf 'G60 X199.\nM30\n' >g60.nc
status fivecheck -q --parse-only -s s.xml m.xml g60.nc
echo '== also where it goes nowhere, and with the whole check'
printf 'G60 X0\nM30\n' >still.nc
status fivecheck -q -s s.xml m.xml still.nc
echo '== nor is it free of collisions then'
printf 'G0 X100. Y30.\nG60 X100.\nM30\n' >post.nc
status fivecheck -q -s s.xml m.xml post.nc
echo '== a path is printed without it'
fivecheck --dump-path -s s.xml m.xml g60.nc
echo '== data'
fivecheck -q -f ndjson --parse-only -s s.xml m.xml g60.nc | python3 -c '
import json, sys
for f in map(json.loads, sys.stdin):
    if f["kind"] == "limit":
        print({k: f[k] for k in ("axis", "bound", "target", "excess", "path_tolerance", "fraction")}, f["axes"]["X"])'
fivecheck -q --format=github --parse-only -s s.xml m.xml g60.nc | grep limit
echo '== compensation: the way in may be beside the drawn one; where it is given, it is clear'
echo 'G17 G54
G0 X50.
F1000 G41 D1 G1 X100. Y44.5
X150.
G40 X160. Y0
M30' >comp.nc
sed 's/<controller /&cutter_comp_start="A" cutter_comp_corner="linear" /' m.xml >known.xml
status fivecheck -q --parse-only -s s.xml m.xml comp.nc
status fivecheck -q --parse-only -s s.xml known.xml comp.nc
echo '== the path tolerance is not held to them: a corner is rounded on its inner side'
printf 'G0 X200.\nX0\nG53 Z0\nM30\n' >corner.nc
status fivecheck -q --parse-only -s s.xml m.xml corner.nc
