# A program that looks like one for another control is reported before it is misread; with certain signs it is an error.
small_machine
sed 's|<base>|<controller dialect="fanuc" least_input="0.001"/><base>|' m.xml >fanuc.xml
sed 's|<base>|<controller dialect="haas" least_input="0.001"/><base>|' m.xml >haas.xml

# look TEXT - what each dialect reports about the control, and the exit status
look() {
	printf '%b' "$1" >p.nc
	for machine in m fanuc haas; do
		fivecheck -q --parse-only $machine.xml p.nc >said 2>&1
		echo "$machine $?: $(grep -o ':.*this looks like.*' said | head -n 1)"
	done
}

look '0 BEGIN PGM PART MM\n1 BLK FORM 0.1 Z X0 Y0 Z-10\n'
look '; head\n5 L X+10 Y-3 R0 FMAX M3\n'
look '%_N_PART_MPF\n;$PATH=/_N_WKS_DIR\nG0 X1\n'
look 'N10 G21 G90\nN20 TRAORI\nN30 G0 X1.\n'
look 'G21 G90\nCYCLE832(0.01,3,1)\n'
look '%\nO1234 (PART)\nG21 G90\nG0 X1.\nM30\n%\n'
look 'G21 G90\nG187 P1\nG0 X1.\nM30\n'
look 'G21 G90\no<sub> call\nM2\n'
look '$PART.MIN%\nOPART\nG15 H1\nG0 X1\n'
look 'G21 G90\no100 call [1]\nM2\n'
look 'G21 G90\nG1 X5 F100\nX=IC(5)\n'
look 'N5 G90\nN10 G2 X1 Y2 CR=5\n'
look '; head\nPROC PART(REAL DEPTH) SAVE\nG0 X1\n'
look 'MSG("PART")\nG0 X1\n'
look 'R1=5\nG0 X1\n'
look 'T="MILL 10"\nM6\n'
look 'IF $P_SIM GOTOF END_\nG0 X1\n'
look 'EXTCALL "PART"\n'
look 'WORKPIECE(,"",,"BOX",112,0,-50)\nG0 X1\n'
look '5 CYCL CALL M3\n'
look 'G21 G90\nG5 P10000\nM30\n'
look 'G21 G90\nG54.1 P3\nM30\n'
look 'G21 G90\nG65 P100\nM30\n'
look 'G0 G90 SUPA Z0\n'
look 'IF R1==1 GOTOB END_\n'
look 'G71\nG0 X1\n'
look 'G21 G90\nG0 X=0\n'
look 'G21 G90\nS1=500 M3\n'
look 'G21 G90\nT1 D1\n'
look 'G21 G90\nT1 M06 D1\n'
look 'G21 G90\nDEF BOOL FOUND\n'
look 'G21 G90\nATRANS X5\n'
look 'G21 G90\nROT RPL=45\n'
look 'G21 G90\nPOCKET3(50,0,1)\n'
look 'G21 G90\nG1 X5 RND=2 F100\n'
look 'G21 G90\nFFWON\n'
look 'G21 G90\nG500\n'
# No signs: words in comments, and text that only resembles a sign.
look 'G21 G90\n#<_supa>=5\n#<go_gotof>=1\nM2\n'
look '%\nO1\nPOPEN\nDPRNT[SUPA*GOTOF]\nPCLOS\nG21 G90\nM30\n%\n'
look '(PROC PART, X=IC(5), MSG, CR=5)\nG21 G90\nG0 X1.\nM30\n'
look 'PROCESS SHEET 5\nPROC 10 DEEP HOLES\n%\nG21 G90\n#1=ACOS[0.5] (GOTOF)\n#<_cr>=5\nG43.41\nM30\n%\n'
sed 's|<base>|<controller dialect="klartext"/><base>|' m.xml >klartext.xml
look '%\nO1\nG21 G90\nPOPEN\nDPRNT[X=#1*Y1=#2]\nPCLOS\nIF[#1EQ1]THEN#2=3\n#1=5\nM30\n%\n'
look '%\nO1\nG21 G90\nG71 I5. J0. L3\nT1 M6\nG41 D1 X5.\nM30\n%\n'
printf '0 BEGIN PGM P MM\n1 TRANS DATUM AXIS X+1\n2 Q1 = 5\n3 QS1 = "X=5"\n4 CONTOUR DEF P1 = LBL 1 I2 = LBL 2\n5 END PGM P MM\n' >p.h
fivecheck -q --parse-only klartext.xml p.h >said 2>&1
echo "klartext $?"
printf '0 BEGIN PGM P MM\n1 * - MILL / DM=8 CR=0 TL=50\n2 L X+1 R0 FMAX\n3 END PGM P MM\n' >p.h
fivecheck -q --parse-only klartext.xml p.h >said 2>&1
echo "klartext $?"
look '(BEGIN PGM, TRAORI, G187)\nG21 G90\nG0 X1.\nM30\n'
# Text before the '%' of a tape is no sign, a program without '%' has no such text, and Okuma's variables have '=' too.
look 'PART X=5 TRAORI\nR1=5\n%\nO1\nG21 G90\nG0 X1.\nM30\n%\n'
look 'G1 X=5\n%\nO1\nG21 G90\nG0 X1.\nM30\n%\n'
look 'TRAORI\nG0 X1\n'
look 'G15 H1\nVC1=5\nG0 X=VC1\n'
look 'G0 X=VC1+5\n'
look 'DEF REAL VC1\nG0 X=VC1\n'
