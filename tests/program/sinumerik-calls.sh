# Subprograms of the sinumerik dialect: parameters, references, SAVE, files in either case, modal calls, tools by name.
small_machine
sed 's/<base>/<controller dialect="sinumerik" path_tolerance="0.01" increments_after_shift="traverse"><tool_change\/><\/controller>\n<base>/' \
	m.xml >s.xml
program main.mpf <<'NC'
%_N_MAIN_MPF
N1 G500 G17 G71 G90 F600
DEF REAL DEPTH=2
DEF INT N_=0
HOLE(10, DEPTH)
HOLE(20)
COUNT(N_)
X=N_
L10 P2
CALL "HOLE"
EXTCALL("/_N_SPF_DIR/_N_PLAIN_SPF")
MCALL HOLE(7)
X40
C=50
MCALL
plain
T="Ball 10" M6
D1 X0 Z-50
M30
NC
program HOLE.SPF <<'NC'
; the head of a subprogram
PROC HOLE(REAL AT=1, REAL DOWN=3, STRING[10] TEXT_="x") SAVE DISPLOF
G91
TRANS X100
X0 Z=-DOWN
Z=DOWN
IF AT>15 GOTOF DONE
X=IC(AT)
DONE: RET
NC
printf 'PROC COUNT(VAR INT WHAT)\nWHILE WHAT<3\nWHAT=WHAT+1\nENDWHILE\nM17\n' >count.spf
printf 'G91 X1\nG90\nM17\n' >l10.spf
mkdir lib
printf 'X77\nM30\n' >lib/PLAIN.SPF
setup setup.xml <<'XML'
<work_offset name="G54" X="1" Z="2"/><work_offset name="G505" X="3"/>
<tool number="7" name="BALL 10" length="30"><edge number="2" length="29.5"/>
<cutter tip="ball"><section length="30" diameter="10"/></cutter></tool>
XML
fivecheck -s setup.xml --include=lib --dump-path s.xml main.mpf
echo "exit $?"
for call in 'HOLE(1,2,"a",4)' 'HOLE("a")' 'COUNT(5)' 'L10(5)' 'HOLE(1' 'PLAIN' 'T="NONE" M6' 'T7 M6 D3'; do
	printf 'G500 G17 G71 G90 F600\n%s\nM30\n' "$call" >bad.mpf
	fivecheck -s setup.xml --parse-only s.xml bad.mpf >/dev/null
	echo "exit $?"
done
# MCALL acts in subprograms, too; an MCALL that is still active at the end of a subprogram, and modes that SAVE must not
# restore.
printf 'X20\nX30\nM17\n' >AT.SPF
printf 'MCALL CYCLE81(10,0,2,-5)\nM17\n' >STAYS.SPF
printf 'PROC SMOOTH SAVE\nG641 ADIS=1\nRET\n' >SMOOTH.SPF
printf 'G500 G17 G71 G90 F600 G0 Z50\nMCALL CYCLE81(10,0,2,-5)\nAT\nMCALL\nX0\nM30\n' >modal.mpf
fivecheck --dump-path s.xml modal.mpf
for call in STAYS SMOOTH; do
	printf 'G500 G17 G71 G90 F600\n%s\nM30\n' "$call" >bad.mpf
	fivecheck --parse-only s.xml bad.mpf >/dev/null
	echo "exit $?"
done
# An endless loop, from a file and from a pipe; a subprogram without end.
printf 'G500 G71 G90\nLOOP\nENDLOOP\n' >loop.mpf
fivecheck --max-blocks=100 --parse-only s.xml loop.mpf >/dev/null
echo "exit $?"
printf 'R1=0\nWHILE R1<3\nR1=R1+1\nENDWHILE\nG500 G71 G90 G0 X=R1\nM30\n' | fivecheck --dump-path s.xml -
echo "exit $?"
printf 'X5\n' >OPEN.SPF
printf 'G500 G71 G90 F100\nOPEN\nM30\n' >main.mpf
fivecheck --parse-only s.xml main.mpf >/dev/null
echo "exit $?"
# Thousands of calls read the main program's file once for each subprogram.
printf 'X1\nM17\n' | tee L1.SPF >L25.SPF
awk 'BEGIN {
	print "G500 G71 G90 F100"
	for (i = 0; i < 300000; i++)
		print i % 75 == 0 ? "L1" : i % 75 == 1 ? "L25" : "X" i % 9
	print "M30"
}' >long.mpf
soon "$FIVECHECK" --parse-only s.xml long.mpf | sed -n '1s/;.*//p'
# Programs of the builder and a measuring cycle, described by name in the machine file.
sed 's|<tool_change/>|&<macro program="Cycle_HSC" action="none"/><macro program="CYCLE977" action="around" X="30" Z="20"/><macro program="L9" action="around" Z="3"/><macro program="H12" action="none"/>|' \
	s.xml >named.xml
printf 'G500 G17 G71 G90 G0 X1 Z3\nCYCLE_HSC(1,"a")\nCYCLE977(101,1,,1)\nTRANS X5\nL9\nX5\nX9 H12\nH1=12\nM30\n' >named.mpf
fivecheck --dump-path named.xml named.mpf
echo "exit $?"
for block in 'MIRROR X0\nL9' 'CYCLE_OTHER(1)' 'CYCLE63(1)'; do
	printf "G500 G17 G71 G90 G0 X1 Z3\n$block\nM30\n" >bad.mpf
	fivecheck --parse-only named.xml bad.mpf >/dev/null
	echo "exit $?"
done
# The same questions in a machine file for another control.
sed 's/dialect="sinumerik"/dialect="fanuc" swivel_axis="C" rotation_order="rpy"/' s.xml >f.xml
fivecheck --check-machine f.xml >/dev/null
echo "exit $?"
