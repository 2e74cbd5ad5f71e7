# A tool that cuts with the length of another tool causes a warning, also beside the verdict.
need jq
stock_mill
setup s.xml <<'XML'
  <work_offset name="G54" Z="-100"/>
  <tool number="1" length="100">
    <holder><section length="50" diameter="50"/></holder><cutter><section length="50" diameter="20"/></cutter>
  </tool>
  <tool number="2" length="140">
    <holder><section length="50" diameter="50"/></holder><cutter><section length="90" diameter="10"/></cutter>
  </tool>
  <offset number="31" length="101.5"/>
XML
program own.nc <<'NC'
G61
T1 M6
G43 H1
S5000 M3
G0 X0 Y0 Z50
G1 Z20 F500
G0 Z150
T2 M6
G43 H2
M3
G1 Z30
G0 Z150
M2
NC
sed 's/H1/H2/' own.nc >wrong.nc
sed '/H2/d' own.nc >forgotten.nc
sed 's/H1/H31/' own.nc >wear.nc
sed 's/^M3$//; s/^G43 H2/G43 H1/' own.nc >standing.nc
said() { # ARGUMENT...
	"$FIVECHECK" "$@" 2>&1 | sed -n 's/^\([a-z]*\.nc\): \(clear\|incomplete\|within\).*/\1: \2/p; s/^\([a-z]*\.nc:[0-9]*: warning: .*\); check.*/\1/p'
}
said -s s.xml m.xml own.nc wrong.nc forgotten.nc wear.nc standing.nc
echo "the same for -j 8, shards and limits alone:"
said -s s.xml m.xml wrong.nc >expected
said -j8 -s s.xml m.xml wrong.nc | cmp - expected
said --shard 2/3 -s s.xml m.xml wrong.nc
said --parse-only -s s.xml m.xml wrong.nc
echo "as a failure, on a Fanuc, and silenced:"
"$FIVECHECK" -q --fail-on=warning -s s.xml m.xml wrong.nc >/dev/null 2>&1 || echo "status $?"
sed 's|<base>|<controller dialect="fanuc" least_input="1" power_on_units="mm" power_on_plane="xy" power_on_distance="absolute" power_on_motion="rapid" length_offset_moves="no"><tool_change/></controller>&|' m.xml >fanuc.xml
sed 's/^G61/G21 G90 G17 G61 G94 G49/' forgotten.nc >o.nc
said -s s.xml fanuc.xml o.nc
sed 's/<tool/& checked="r"/' s.xml >checked.xml
said -s checked.xml m.xml wrong.nc
for format in text ndjson github sarif junit; do
	"$FIVECHECK" -f $format -s s.xml m.xml wrong.nc >$format.out 2>/dev/null
	printf '%s: %s\n' $format "$(grep -c 'T1 cuts with the length of T2' $format.out)"
done
