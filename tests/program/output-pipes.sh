# Files beside the results may be pipes: they are opened once, after the check.
stock_mill
setup s.xml <<'XML'
  <work_offset name="G54" X="0" Y="0" Z="-100"/>
  <stock box="40 30 10"/>
  <tool number="1" length="100"><cutter><section length="100" diameter="10"/></cutter></tool>
XML
printf '%s\n' 'G21 G90 G94 G61 T1 M6' 'M3 S1000' 'G0 G43 H1 Z100' 'G0 X-30 Z9' 'G0 X30' >p.nc
for option in report=page.html glb=scene.glb picture=p.svg picture=p.png pose=p.stl stock-out=s.stl; do
	file=${option#*=}
	"$FIVECHECK" -q -a "--$option" -s s.xml m.xml p.nc >/dev/null
	mv "$file" "regular-$file"
	mkfifo "$file"
	timeout 60 cat "$file" >read &
	timeout 60 "$FIVECHECK" -q -a "--$option" -s s.xml m.xml p.nc >/dev/null
	echo "--$option: status $?"
	wait
	cmp read "regular-$file"
	rm "$file"
done
