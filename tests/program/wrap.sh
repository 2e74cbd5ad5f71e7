# How a rotary axis takes absolute targets: as written, the shorter way, or the sign as direction and the value as angle.
small_machine
printf 'G0 C350\nG0 C10\nG0 C-90\n' >a.nc
for wrap in none shortest sign; do
	sed "s,type=\"rotary\",type=\"rotary\" wrap=\"$wrap\"," m.xml >$wrap.xml
	echo $wrap $(fivecheck --dump-path $wrap.xml a.nc | awk 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "C") c = i; next } { print $c }')
done
