# Waivers: the named findings are accepted, with the reason, until the last day; nothing else is, and nothing silently.
small_machine
export SOURCE_DATE_EPOCH=1767225599 # 2025-12-31, the last second of it
printf 'G0 X10\nG1 Z-120 F6000\nG0 Z0\nG0 X300\nG0 X0\n' >a.nc
rows() {
	grep -e '^[a-z]' -e waived -e accepted
}
waivers() {
	{ echo '<waivers version="1">'; cat; echo '</waivers>'; } >w.xml
}
# As the text report has it: the block's text, the axes.
fivecheck -q -a m.xml a.nc | sed -n '1,5p'
waivers <<'XML'
<waiver program="a.nc" kind="collision" a="table" b="head" block="G1 Z-120 F6000"
  axes="X 10.0000 mm, Z -100.0000 mm, C 0.0000 deg" reason="a brush &amp; it bends" expires="2025-12-31"/>
<waiver program="a.nc" kind="collision" a="head" b="table" block="G0 Z0" axes="X10 Z-120 C0" reason="the same" expires="2026-02-28"/>
<waiver program="a.nc" kind="limit" axis="X" block="G0 X300" axes="X200Z0C0" reason="the stop was moved" expires="2026-01-01"/>
<waiver program="a.nc" kind="limit" axis="X" block="G0 X0" axes="X300Z0C0" reason="the stop was moved" expires="2026-01-01"/>
XML
status fivecheck --waivers w.xml -f text -f ndjson=out.json -f sarif=out.sarif -f junit=out.xml -f github=out.txt \
	--record r.json m.xml a.nc | rows
sed -n 's/.*\("accepted":.*\)}/\1/p' out.json
grep -o '"suppressions":.*' out.sarif
sed -n '/system-out/,/system-out/p' out.xml
cat out.txt
grep -e waive r.json
echo "a day later, the first has expired:"
export SOURCE_DATE_EPOCH=1767225600
status fivecheck -a --waivers w.xml m.xml a.nc 2>&1 | rows
echo "it stops there without --all:"
status fivecheck -q --waivers w.xml m.xml a.nc | rows
export SOURCE_DATE_EPOCH=0
echo "the same contact again, and another in the same words:"
printf 'G1 Z-120\nG0 Z0\nG0 X40\nG1 Z-120 F6000\n' >>a.nc
status fivecheck -q -a --waivers w.xml m.xml a.nc | rows
echo "nothing to waive:"
echo 'G0 X10' >a.nc
status fivecheck --waivers w.xml m.xml a.nc 2>&1 | rows
cp a.nc b.nc
fivecheck --waivers w.xml m.xml b.nc 2>&1 >/dev/null
echo "parse-only:"
printf 'G0 X300\nG0 X0\n' >a.nc
status fivecheck --parse-only --waivers w.xml m.xml a.nc 2>&1 | rows
echo "faulty files:"
waivers <<'XML'
<waiver program="a.nc" kind="collision" a="head" b="table" block="G0" axes="X0 Z0 C0" expires="2025-12-31"/>
<waiver program="a.nc" kind="collision" a="head" b="table" block="G0" axes="X0 Z0 C0" reason=" " expires="2025-02-29"/>
<waiver program="a.nc" kind="crash" a="head" b="table" block="G0" axes="X0 Z0 C0" reason="r"/>
XML
status fivecheck --waivers w.xml m.xml a.nc 2>&1
waivers <<'XML'
<waiver program="a.nc" kind="collision" a="head" block="G0" axes="X0 Z0 C0" reason=" " expires="2025-02-28"/>
<waiver program="a.nc" kind="limit" a="head" b="table" block="G0" axes="X0 Z0" reason="r" expires="2025-02-28"/>
<waiver program="a.nc" kind="limit" axis="B" block="G0" axes="X0 Z0 C0 X0" reason="r" expires="2025-02-28" within="11" times="0"/>
<waiver program="a.nc" kind="limit" axis="X" block="G0" axes="X0 Z0 C0 mm" reason="r" expires="2025-02-28"/>
XML
status fivecheck --waivers w.xml m.xml a.nc 2>&1
status fivecheck --waivers m.xml m.xml a.nc 2>&1
status fivecheck --waivers nowhere.xml m.xml a.nc 2>&1
status fivecheck --waivers w.xml -o w.xml m.xml a.nc 2>&1
waivers </dev/null
SOURCE_DATE_EPOCH=tomorrow status fivecheck --waivers w.xml m.xml a.nc 2>&1
