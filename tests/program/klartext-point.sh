# The point angle of a tool of the setup: Q343=1 of cycle 240 centres to a diameter, Q395=1 counts to the full diameter.
# 90 degrees: 3 mm of depth for 6 mm of diameter; 118 degrees: 5 / tan 59 degrees = 3.004303 mm.
small_machine
sed 's|<base|<controller dialect="klartext" path_tolerance="0.01"><tool_change/></controller><base|' m.xml >k.xml
cat >s.xml <<'XML'
<setup version="1" units="mm"><work_offset name="G54.1 P1" X="0" Z="0"/>
  <tool number="1" length="20"><cutter tip="cone" angle="90"><section length="20" diameter="10"/></cutter></tool>
  <tool number="2" length="25"><cutter tip="cone" angle="118"><section length="25" diameter="10"/></cutter></tool>
  <tool number="3" length="25"><cutter tip="flat"><section length="25" diameter="10"/></cutter></tool>
</setup>
XML
for tool in 1 2 3; do
	program p.h <<NC
0 BEGIN PGM P MM
1 TOOL CALL $tool Z S1000 F100
2 CYCL DEF 240 CENTERING ~
    Q200=+2 ~
    Q343=+1 ~
    Q201=-1 ~
    Q344=-6 ~
    Q206=AUTO ~
    Q211=+0 ~
    Q203=+0 ~
    Q204=+20
3 L X+1 FMAX M99
4 CYCL DEF 200 DRILLING ~
    Q200=+2 ~
    Q201=-8 ~
    Q206=+100 ~
    Q202=+20 ~
    Q210=+0 ~
    Q203=+0 ~
    Q204=+20 ~
    Q211=+0 ~
    Q395=+1
5 L X+2 FMAX M99
6 END PGM P MM
NC
	status fivecheck --dump-path -s s.xml k.xml p.h | cut -f 1-5
done
