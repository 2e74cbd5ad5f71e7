# PREDEF in a cycle stands for the value of GLOBAL DEF: the same path as with the numbers, in a tilted plane and in
# inches, too; scan lists GLOBAL DEF.
root=$(dirname "$LIB")/../..
cp -r "$root/machines/ac-trunnion/stl" stl
sed 's|<controller dialect="[a-z]*" rapid="linear"/>|<controller dialect="klartext" rapid="linear" tcp_zero="offset"><tool_change/></controller>|' \
	"$root/machines/ac-trunnion/machine.xml" >machine.xml
# $1: the unit; $2: GLOBAL DEF; $3 to $5: Q200, Q204, Q211
drill()
{
	cat <<NC
BEGIN PGM D $1
$2TOOL CALL 1 Z S2000 F500
L Z+3 R0 FMAX M3
PLANE SPATIAL SPA-10 SPB+0 SPC+0 TURN FMAX SEQ- TABLE ROT
CYCL DEF 200 DRILLING ~
  Q200=$3 ;SET-UP CLEARANCE ~
  Q201=-0.2 ;DEPTH ~
  Q206=150 ~
  Q202=0.2 ~
  Q210=0 ~
  Q203=+1.5 ~
  Q204=$4 ~
  Q211=$5
L X+1 Y+0 R0 FMAX M99
L X-1 FMAX M99
PLANE RESET TURN FMAX
END PGM D $1
NC
}
globals='GLOBAL DEF 100 GENERAL ~
  Q200=+0.5 ;SET-UP CLEARANCE ~
  Q204=+1 ;2ND SET-UP CLEARANCE ~
  Q253=+750 ;F PRE-POSITIONING ~
  Q208=+999 ;RETRACTION FEED RATE
GLOBAL DEF 105 DRILLING ~
  Q256=+0.2 ~
  Q210=+0 ~
  Q211=+0.5 ;DWELL TIME AT DEPTH
'
for unit in MM INCH; do
	drill $unit '' 0.5 1 0.5 >numbers.h
	drill $unit "$globals" PREDEF PREDEF PREDEF >predef.h
	for name in numbers predef; do
		"$FIVECHECK" --dump-path -s "$root/examples/stock/setup.xml" machine.xml $name.h 2>&1 | cut -f2- >$name.path
	done
	cmp numbers.path predef.path && wc -l <predef.path
done
sed -n 4,6p predef.path | cut -f1-3,5,6
for threads in 1 2; do
	fivecheck -q -j $threads -s "$root/examples/stock/setup.xml" machine.xml predef.h 2>&1 | grep '^predef'
done
"$FIVECHECK" scan predef.h 2>/dev/null | grep '^GLOBAL'
