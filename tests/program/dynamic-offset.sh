# Haas' G254 and G255, from the program to --dump-path: on a table with B about Y through X5 Z80 and C about Z through
# X30 Y40, the work zero agrees with the closed form, and X, Y, Z are relative to it along the axes.
# Haas mill operator's manual (NGC), "G254 Dynamic Work Offset (DWO)".
table='
  <axis name="Y" type="linear" direction="0 1 0" rate_max="6000">
    <axis name="X" type="linear" direction="1 0 0" rate_max="6000">
      <axis name="Z" type="linear" direction="0 0 1" rate_max="6000">
        <spindle location="0 0 300" direction="0 0 -1"/>
      </axis></axis></axis>
  <axis name="B" type="rotary" checked="the sums above count this way" direction="0 1 0" location="5 0 80" rate_max="3600">
    <axis name="C" type="rotary" checked="the sums above count this way" direction="0 0 1" location="30 40 0" rate_max="3600">
      <workholding location="30 40 80"/>
    </axis></axis>'
echo "$table" | machine base.xml
sed 's|<base>|<controller dialect="haas" power_on_units="mm" power_on_distance="absolute" power_on_plane="xy" least_input="1"><tool_change/></controller><base>|' base.xml >m.xml
setup s.xml <<'XML'
<work_offset name="G54" X="41" Y="38" Z="-180"/>
<tool number="1" length="80"><cutter tip="flat"><section length="80" diameter="6"/></cutter></tool>
XML
program part.nc <<'NC'
%
O1 (TWO SIDES)
T1 M6
G0 G90 G53 Z0.
G54 B30. C-50.
G254
X1. Y2.
G43 H1 Z5.
G1 Z-3. F900.
X11. Y22. Z3.
G0 Z50.
G53 Z0.
G255
B0. C0.
G54 X1. Y2.
Z5.
M30
%
NC
fivecheck -q -s s.xml --dump-path m.xml part.nc | awk '
BEGIN {
	d = atan2(0, -1) / 180; cb = cos(30 * d); sb = sin(30 * d); cc = cos(-50 * d); sc = sin(-50 * d)
	# The gauge point is at (41, 38, -180 + 300) at rotary zero.
	x = cc * (41 - 30) - sc * (38 - 40) + 30 - 5; y = sc * (41 - 30) + cc * (38 - 40) + 40; z = -180 + 300 - 80
	x0 = cb * x + sb * z + 5; y0 = y; z0 = cb * z - sb * x + 80 - 300 + 80
}
NR > 1 {
	printf "line %d: X%s Y%s Z%s B%s C%s", $1, $4, $5, $6, $7, $8
	if ($7 == 30 && $1 > 6) printf ", in the program %.6f %.6f %.6f", $4 - x0, $5 - y0, $6 - z0
	print ""
}'

# Behaviour that the manual does not define is an error at its line.
refuse() {
	printf 'G54 G0 B30. C-50.\nG254\n%b\n' "$1" >bad.nc
	status fivecheck -q -s s.xml --parse-only "${2:-m.xml}" bad.nc
}
refuse 'G1 X0. Y0. Z0. F9.'
refuse 'X0. Y0. Z0.\nG1 X1. C0. F9.'
refuse 'X0. Y0. Z0.\nG91 G28 Z0.\nG28 B0. C0.'
refuse 'G55'
refuse 'G91 Z5.'
sed '/name="B"/,$d' m.xml >head.xml
head='<axis name="B" type="rotary" direction="0 1 0" location="0 0 500" rate_max="3600">'
sed -i "s|<spindle .*|$head&</axis>|" head.xml
cat >>head.xml <<'XML'
<axis name="C" type="rotary" checked="the sums above count this way" direction="0 0 1" location="30 40 0" rate_max="3600">
  <workholding location="30 40 80"/></axis>
</base></machine>
XML
refuse X0. head.xml
