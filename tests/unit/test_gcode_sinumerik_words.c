/* test_gcode_sinumerik_words.c - the sinumerik dialect: polar coordinates, threads, several programs in a file. */
#include "sinumerik_refused.h"

static const struct program {
	const char *text, *moves;
} programs[] = {
	/* "Polar coordinates": G111 from the zero, G110 from the tool, G112 from the last pole. */
	{"F6 R1=2 G[8]=R1 G[6]=1\nG[1]=1 X1 Y1\nG[8]=6\nG[1]=2 X1\nG[8]=1 G[14]=1 X5\n",
	 "rapid 11 21 0 0 0\nfeed 2 21 0 0 0\nfeed 5 21 0 0 0\n"},
	/* "Contour definition": 10 tan 30, in G18 from Z, backward under G91. */
	{"F6 G500 G17 G0 X10 Y5\nG1 X20 ANG=30\nY5 ANG=-90 RND=1\nX0 ANG=180\n",
	 "rapid 10 5 0 0 0\nfeed 20 10.7735027 0 0 0\nfeed 20 6 0 0 0\n"
	 "arc 19 5 0 0 0 centre 19 6 0 normal 0 0 1 sweep -90\nfeed 0 5 0 0 0\n"},
	{"F6 G500 G18 G0 X10 Z5\nG91 G1 X10 ANG=45\n", "rapid 10 0 5 0 0\nfeed 20 0 15 0 0\n"},
	{"F6 G500 G17\nG111 X10 Y10\nG0 RP=20 AP=30 Z5\nAP=90\nG1 AP=IC(90)\nRP=10\n",
	 "rapid 27.3205081 20 5 0 0\nrapid 10 30 5 0 0\nfeed -10 10 5 0 0\nfeed 0 10 5 0 0\n"},
	{"F6 G500 G17\nRP=5 AP=0\nX1 Y2\nG110 X1 Y1\nRP=1 AP=180\nG112 AP=90 RP=2\nRP=1 AP=0\n",
	 "feed 5 0 0 0 0\nfeed 1 2 0 0 0\nfeed 1 3 0 0 0\nfeed 3 5 0 0 0\n"},
	/* The pole is the centre of a circle; a helix may have full turns. */
	{"F6 G500 G17\nG111 X10 Y0\nG1 RP=10 AP=180\nG3 AP=270 RP=10\nG2 AP=180 Z-5 TURN=1\n",
	 "feed 0 0 0 0 0\narc 10 -10 0 0 0 centre 10 0 0 normal 0 0 1 sweep 90\n"
	 "arc 0 0 -5 0 0 centre 10 0 0 normal 0 0 1 sweep -450\n"},
	{"F6 G500 G18\nG111 Z1 X2\nRP=3 AP=90\n",
	 "feed 5 0 1 0 0\n"},
	/* "Thread cutting (G33)", "Rigid tapping": the pitch in each turn; G63 at its feed, for its block. */
	{"F6 G500 G0 Z2\nG331 Z-10 K1.5 S600\nG332 Z2 K1.5\nG0 X1\nG63 Z-3 F60\nZ0\n",
	 "rapid 0 0 2 0 0\nfeed 0 0 -10 0 0\nfeed 0 0 2 0 0\nrapid 1 0 2 0 0\nfeed 1 0 -3 0 0\n"
	 "rapid 1 0 0 0 0\n"},
	{"F6 G500 S60 M3\nG33 Z-10 K2\nZ-12 K1\n",
	 "feed 0 0 -10 0 0\nfeed 0 0 -12 0 0\n"},
	/* G25 and G26 move no axis, and S of them is no speed. */
	{"F6 G500 S100\nG25 X-1000 Y5 S50\nG26 S9000\nG95 F1\nX6\n",
	 "feed 6 0 0 0 0\n"},
	/* Lists of values in DEF; data of the tool in force. */
	{"F6 G500\nDEF REAL QR[2,2]=(1,2,3)\nT1 D2 M6\nG53 X=QR[0,1] Y=QR[1,0] D0\nD2\nR1=$P_TOOLR R2=$P_TOOLL[1] D0\nX=R1 Y=R2\n",
	 "tool 1\nfeed 2 3 0 0 0\nfeed 4 90 0 0 0\n"},
	/* CT goes on in the direction of the motion before it; no motion may stand between. */
	{"F6 G500 G17\nX10\nCT X20 Y10\nX10 Y20\nMSG(\"A\")\nX5\nX0 Y25\nG2 X5 Y30 I5\nCT X10 Y35 Z1\n",
	 "feed 10 0 0 0 0\narc 20 10 0 0 0 centre 10 10 0 normal 0 0 1 sweep 90\n"
	 "arc 10 20 0 0 0 centre 10 10 0 normal 0 0 1 sweep 90\nfeed 5 20 0 0 0\n"
	 "arc 0 25 0 0 0 centre 5 25 0 normal 0 0 1 sweep -90\n"
	 "arc 5 30 0 0 0 centre 5 25 0 normal 0 0 1 sweep -90\n"
	 "arc 10 35 1 0 0 centre 5 35 0 normal 0 0 1 sweep 90\n"},
	{"F6 G500 G18 TRANS X100\nMIRROR Z0\nZ10\nCT Z20 X10\n",
	 "feed 0 0 -10 0 0\narc 10 0 -20 0 0 centre 10 0 -10 normal 0 1 0 sweep -90\n"},
	{"%_N_MAIN_MPF\nF6 G500\nPCALL/_N_WKS_DIR/_N_A_WPD/_N_SUB_A_SPF(4, 5) ; twice\nPCALL SUB_A(6)\nM30\n"
	 /* The search for SUB_A reads a last line that is only a blank, without a line end. */
	 "%_N_SUB_A_SPF\nPROC SUB_A(REAL QX, REAL QY=9)\nX=QX Y=QY\nRET\n ",
	 "feed 4 5 0 0 0\nfeed 6 9 0 0 0\n"},
	/* "Macro technique": the text takes the place of the name, not in strings and comments. */
	{"F6 G500\nDEFINE GO_ON AS G1 X=IC(1) ; a comment\ndefine deep as Z-5\nGO_ON deep\nN10 GO_ON Y2 ; DEEP\n"
	 "MSG(\"DEEP\")\nDEFINE DEEP AS Z-6\nX9 DEEP\nDEFINE QDEEP AS 3\nX=QDEEP*2\n",
	 "feed 1 0 -5 0 0\nfeed 2 2 -5 0 0\nfeed 9 2 -6 0 0\nfeed 6 2 -6 0 0\n"},
	/* Each round of P has the arguments of its call, whatever the round before has called. */
	{"%_N_MAIN_MPF\nF6 G500\nQOUT P2\nP2 QOUT(4)\nQOUT(5) P=2\nM30\n%_N_QOUT_SPF\nPROC QOUT(REAL QA=7)\nX=QA\nQIN(3)\n"
	 "RET\n%_N_QIN_SPF\nPROC QIN(REAL QB)\nZ=QB\nRET\n",
	 "feed 7 0 0 0 0\nfeed 7 0 3 0 0\nfeed 7 0 3 0 0\nfeed 7 0 3 0 0\nfeed 4 0 3 0 0\nfeed 4 0 3 0 0\n"
	 "feed 4 0 3 0 0\nfeed 4 0 3 0 0\nfeed 5 0 3 0 0\nfeed 5 0 3 0 0\nfeed 5 0 3 0 0\nfeed 5 0 3 0 0\n"},
	/* An archive with a subprogram before the main one; labels and GOTOS are those of the main one. */
	{"%_N_SUB_A_SPF\nAGAIN: X7\nM17\n%_N_MAIN_MPF\n;$PATH=/_N_MPF_DIR\nF6 G500\nR1=$P_EP[Y]\nSUB_A\nAGAIN: Y=R1+1\n"
	 "IF R1<1 GOTOS\nM30\n%_N_OTHER_SPF\nX9\nM17\n",
	 "feed 7 0 0 0 0\nfeed 7 1 0 0 0\nfeed 7 1 0 0 0\nfeed 7 2 0 0 0\n"},
	{"%_N_SUB_A_SPF\nF6 G500\nX7\nM17\n%_N_SUB_B_SPF\nX8\nM17\n", "feed 7 0 0 0 0\n"},
	/* GOTOS begins the program again. */
	{"F6 G500\nR1=$P_EP[X]+1 X=R1\nIF R1<3 GOTOS\nX9\n",
	 "feed 1 0 0 0 0\nfeed 2 0 0 0 0\nfeed 3 0 0 0 0\nfeed 9 0 0 0 0\n"},
	/* Several programs in one file: labels and loops end with theirs. */
	{"%_N_MAIN_MPF\nF6 G500\nSUB_A\nL20 P2\nGOTOC LATER\nM30\n%_N_SUB_A_SPF\nR1=0\nLATER: R1=R1+1\nX=R1\n"
	 "IF R1<2 GOTOB LATER\nM17\n%_N_L20_SPF\n;$PATH=/_N_SPF_DIR\nPROC L20\nY=IC(1)\nRET\n",
	 "feed 1 0 0 0 0\nfeed 2 0 0 0 0\nfeed 2 1 0 0 0\nfeed 2 2 0 0 0\n"},
	{"%_N_MAIN_MPF\nF6 G500\nX1\n%_N_SUB_A_SPF\nX2\n",
	 "feed 1 0 0 0 0\n"},
	/* Blanks before '=' are none: R1 and not R0 gets the value. */
	{"F6 G500\nR1 = 4\nR2= 5 R3 =6\nR[4] = 7\nX = R1 Y = R2 Z =  R3\nX=R [ 4 ] Y=R3-6\n",
	 "feed 4 5 6 0 0\nfeed 7 0 6 0 0\n"},
	{"F6 G500\nDEF REAL AA = 3\nAA = AA * 2\nFOR R5 = 1 TO 2\nX = AA + R5\nENDFOR\n",
	 "feed 7 0 0 0 0\nfeed 8 0 0 0 0\n"},
	/* Settings that decide no path, outputs, data of tools as the setup has them. */
	{"F6 G500 R2=1\n$SC_SD_MAX_PATH_JERK=5 X1\n$SN_JOG_VELO=9\n$SA_SPIND_S[1]=R[2] X2\n$A_OUT[R[2]]=TRUE X3\n"
	 "$TC_DP3[1,1]=100 $TC_DP6[1,2]=4 $TC_DP1[1,1]=120 $TC_DP12[1,1]=0 $TC_MOP1[1,1]=5 X4\n",
	 "feed 1 0 0 0 0\nfeed 2 0 0 0 0\nfeed 3 0 0 0 0\nfeed 4 0 0 0 0\n"},
	/* The shift of a frame by one axis; the work offset in force takes its new value. */
	{"F6 G54\nROT Z90\n$P_PFRAME[X,TR]=5\nX1 Y0\n$P_UIFR[1,X,TR]=100\n$P_IFRAME=$P_UIFR[1]\nX1 Y0\n",
	 "feed 15 21 0 0 0\nfeed 105 21 0 0 0\n"},
	/* Base frames that are taken back. */
	{"F6 G500\n$P_UBFR=CTRANS()\n$P_CHBFR[0]=CTRANS(X,0,Y,0.0)\n$P_BFRAME = CTRANS( ) X2\n", "feed 2 0 0 0 0\n"},
	/* Synchronous actions that move no axis and change nothing of the program are stepped over. */
	{"F6 G500 R1=2\nID=1 WHENEVER ($AA_IM[Z] < 5) AND ($A_IN[1]==TRUE) DO $AC_OVR=50 $A_OUT[ 2 ] = R1 + 3 * (4 - 1) M8\n"
	 "X=R1\nWHEN $AC_TIMEC>0.1 DO $A_DBB[4]=$A_DBB[4]+1 SETAL(65000, \"DO ; it\") RDISABLE ; comment\nDO STOPREOF M41\n"
	 "when true do $AC_MARKER[1]=-1 $A_OUTA[1]=10.5*$AA_IM[X]\nIDS=2 EVERY $A_IN[2] DO M9\nX3\n",
	 "feed 2 0 0 0 0\nfeed 3 0 0 0 0\n"},
	/* S and M with the number of the master spindle are as those without. */
	{"SETMS(3) S3=600 M3=3\nG500 G4 S10\nSETMS()\nS1=60 M1=5\nG4 S1\nSETMS(2)\nS2=30\nSETMS\nS1=15\nG4 S1\n",
	 "dwell 1\ndwell 1\ndwell 4\n"},
	{"T1=\"DRILL\" M6\nT1=1 M1=6\n", "tool 2\ntool 1\n"},
	/* System variables: a settable work offset by its shift; timers and markers have no geometry. */
	{"F6 R1=0 $AC_TIMER[1]=0 $AC_MARKER[2]=R1\n$P_UIFR[1,X,TR]=5 $P_UIFR[1,Y,FI]=0\n$P_UIFR[2]=CTRANS(X,1,Z,R1+3)\nG54\nX1\n"
	 "G55 X1 Z0\n",
	 "feed 6 0 0 0 0\nfeed 2 0 3 0 0\n"},
	/* ORISON and G60; K0 beside a circle in XY; RET of a subprogram that is started by itself. */
	{"PROC ALONE(REAL AT) SAVE\nF6 G500 G17\nORISON G60 X1\nORISOF OSOF X2\nCANCEL(1,2)\nG2 X4 I1 J0 K0\nRET\nX9\n",
	 "feed 1 0 0 0 0\nfeed 2 0 0 0 0\narc 4 0 0 0 0 centre 3 0 0 normal 0 0 1 sweep -180\n"},
	{"F6 G500 TOWSTD CUTCONOF TRAILOF(Y) FB=5\nWAITM(1,1,2)\nX1\n",
	 "feed 1 0 0 0 0\n"},
	/* "Axial zero offset": G58 replaces what TRANS has shifted, G59 what ATRANS has added, of the axes named. */
	{"F6 G500\nTRANS X10 Y20\nATRANS X1\nX0 Y0\nG58 X30\nX0 Y0\nG59 X2 Y3\nX0 Y0\nTRANS\nTRANS X5\nG59 X1\nX0 Y0\n"
	 "TRANS\nX0\n",
	 "feed 11 20 0 0 0\nfeed 31 20 0 0 0\nfeed 32 23 0 0 0\nfeed 6 0 0 0 0\nfeed 0 0 0 0 0\n"},
	{"G700 F6 G500\nG58 X1\nX1\n", "feed 50.8 0 0 0 0\n"},
	/* Only TRANS with an axis is in doubt after G59: a frame as a whole replaces the one before it. */
	{"F6 G500\nG59 X1\n$P_PFRAME=CTRANS(X,10)\nX0\nTRANS X2\nX0\n", "feed 10 0 0 0 0\nfeed 2 0 0 0 0\n"},
	/* Words that cancel what was never active, and words without geometry. */
	{"F6 G500 TOFFL=0 OFFN=0 TCARR=0 CUTMOD=0 TOFF[Z]=0\nSETPIECE(1) CP ORIC TCOABS DRFOF LFOF NEWCONF\nOVRRAP=50 WAITE(1) X1\n",
	 "feed 1 0 0 0 0\n"},
	{"G500 TRAORI(1,0,0,1)\nG1 F6 X1\nTRAFOOF\nTRAORI(1,,,1)\nX2\n",
	 "tcp on length 0 zero A0 C0\nfeed 1 0 0 0 0 tcp\ntcp off length 0 zero A0 C0\ntcp on length 0 zero A0 C0\n"
	 "feed 2 0 0 0 0 tcp\n"},
	/* "Constant cutting rate": G97 has feeds per revolution, G971 per minute. */
	{"G500 S60\nG97 F1 X1\nG971 F60 X2\nG972 X3\n", "feed 1 0 0 0 0\nfeed 2 0 0 0 0\nfeed 3 0 0 0 0\n"},
	/* The programmable frame as a variable: parts are chained as the forms with A are. */
	/* A change takes effect at the next selection; D, TRANS and SUPA may stand in between. */
	{"F6 G54 X0\n$P_UIFR[1,X,TR]=$P_UIFR[1,X,TR]+5 TRANS Y1\nD0 SUPA G0 X1\nG54 G1 X2 Y2\n$P_UIFR[1]=CTRANS(Y,7)\n"
	 "G500 X0\nG54 Y0\n",
	 "feed 10 0 0 0 0\nrapid 1 0 0 0 0\nfeed 17 23 0 0 0\nfeed 0 23 0 0 0\nfeed 0 8 0 0 0\n"},
	{"F6 G500\n$P_UIFR[1]=CTRANS(X,1,Y,2):CFINE(X,0.5):CROT(X,0,Z,0):CSCALE(X,1)\nG54 X0 Y0\n"
	 "$P_UIFR[1]=CROT()\nG54 X0 Y0\n",
	 "feed 1.5 2 0 0 0\nfeed 0 0 0 0 0\n"},
	{"F6 G500\nTRANS X1\n$P_PFRAME=$P_PFRAME:CTRANS(X,10,Y,20):CROT(Z,90)\nX1 Y0\n", "feed 11 21 0 0 0\n"},
	{"F6 G500\nTRANS X1\n$P_PFRAME=CTRANS(X,10,Y,20):CROT(Z,90)\nX1 Y0\n$P_PFRAME=CMIRROR(X):CTRANS(X,5)\nX1 Y1\n"
	 "$P_PFRAME=CSCALE(X,2,Y,2)\nX1 Y1\n$P_PFRAME=CTRANS()\nX1 Y1\n",
	 "feed 10 21 0 0 0\nfeed -6 1 0 0 0\nfeed 2 2 0 0 0\nfeed 1 1 0 0 0\n"},
	/* With G70 variables of the control stay in its own unit, with G700 they do not. */
	{"F6 G500\nX25.4\nG70\nR1=$P_EP[X] R2=$AA_IW[X]\nG700\nR3=$P_EP[X]\nG710 X=R1+1 Y=R2 Z=R3\n",
	 "feed 25.4 0 0 0 0\nfeed 26.4 25.4 1 0 0\n"},
	{"F6 G500\nG70\n$P_UIFR[1]=CTRANS(X,1)\nG700\n$P_UIFR[2]=CTRANS(X,1)\nG710 G54 X0\nG55 X0\nG70\n$P_PFRAME=CTRANS(Y,2)\n"
	 "G71 Y0\n",
	 "feed 1 0 0 0 0\nfeed 25.4 0 0 0 0\nfeed 25.4 2 0 0 0\n"},
	/* Lengths and radii of tools come from the setup, in the program's unit. */
	{"F6 G500\nX=$TC_DP3[1,1] Y=$TC_DP6[1,1]\nX=$TC_DP3[1,2] Y=$TC_DP6[1,2]\nG700\nR1=$TC_DP3[1,1]\nG710 X=R1\nRNDM=0\n",
	 "feed 100 5 0 0 0\nfeed 90 4 0 0 0\nfeed 3.93700787 4 0 0 0\n"},
	/* "Position pattern": without a modal cycle it only goes there. */
	{"F6 G500 G0 Z10\nMCALL CYCLE81(10,0,1,-2)\nCYCLE802(111111111,111111111,1,2,3,4,,,,,,,,,,,,,,,0,0,1)\nMCALL\n"
	 "HOLES1(0,0,0,10,5,2)\n",
	 "rapid 0 0 10 0 0\nrapid 1 2 10 0 0\nrapid 1 2 1 0 0\nfeed 1 2 -2 0 0\nrapid 1 2 10 0 0\n"
	 "rapid 3 4 10 0 0\nrapid 3 4 1 0 0\nfeed 3 4 -2 0 0\nrapid 3 4 10 0 0\nrapid 10 0 10 0 0\n"
	 "rapid 15 0 10 0 0\n"},
	/* MCALL of a subprogram: it is called at each position of a pattern, which begins at the end nearer to the tool. */
	{"F6 G500 G0 X30 Z10\nMCALL PECK(-3)\nHOLES1(0,0,0,10,5,2)\nX1 Y2\nMCALL\nX0 Y0\nM30\n%_N_PECK_SPF\n"
	 "PROC PECK(REAL DEEP)\nG1 Z=DEEP\nG0 Z10\nRET\n",
	 "rapid 30 0 10 0 0\nrapid 15 0 10 0 0\nfeed 15 0 -3 0 0\nrapid 15 0 10 0 0\nrapid 10 0 10 0 0\n"
	 "feed 10 0 -3 0 0\nrapid 10 0 10 0 0\nrapid 1 2 10 0 0\nfeed 1 2 -3 0 0\nrapid 1 2 10 0 0\n"
	 "rapid 0 0 10 0 0\n"},
	/* In a loop, and with a subprogram that leaves the tool elsewhere and calls another one. */
	{"F6 G500 G0 Z10\nFOR R1=1 TO 2\nMCALL AWAY\nHOLES2(0,0,R1,0,90,2)\nMCALL\nENDFOR\nX0 Y0\nM30\n%_N_AWAY_SPF\n"
	 "Y=IC(50)\nDEEPER\nM17\n%_N_DEEPER_SPF\nZ=IC(-1)\nM17\n",
	 "rapid 0 0 10 0 0\nrapid 1 0 10 0 0\nrapid 1 50 10 0 0\nrapid 1 50 9 0 0\nrapid 0 1 9 0 0\nrapid 0 51 9 0 0\n"
	 "rapid 0 51 8 0 0\nrapid 2 0 8 0 0\nrapid 2 50 8 0 0\nrapid 2 50 7 0 0\nrapid 0 2 7 0 0\nrapid 0 52 7 0 0\n"
	 "rapid 0 52 6 0 0\nrapid 0 0 6 0 0\n"},
	/* A pattern is a subprogram with SAVE: G1, G91 and TRANS of what runs at its holes end with it. */
	{"F6 G500 G0 Z10\nMCALL LEAVES\nHOLES1(0,0,0,10,5,2)\nMCALL\nX0 Y1\nM30\n%_N_LEAVES_SPF\nTRANS X100\nG91 G1 Z-1\nM17\n",
	 "rapid 0 0 10 0 0\nrapid 10 0 10 0 0\nfeed 10 0 9 0 0\nrapid 115 0 9 0 0\nfeed 115 0 8 0 0\nrapid 0 1 8 0 0\n"},
};

static const struct refused_words bad[] = {
	{"F6 G500 G0 Z10\nMCALL TURNS\nHOLES1(0,0,0,10,5,2)\nM30\n%_N_TURNS_SPF\nG18\nM17\n",
	 "TURNS has changed the plane or the unit of length (G17 to G19, G70 to G710) at a hole of HOLES1; PROC with SAVE "
	 "brings them back"},
	{"F6 G500 G450 T1 D1 M6 G0 Z10\nMCALL BESIDE\nHOLES1(0,0,0,10,5,2)\nM30\n%_N_BESIDE_SPF\nG1 G41 X=IC(20)\nX=IC(20)\nM17\n",
	 "BESIDE has left tool radius compensation on at a hole of HOLES1; G40 first"},
	{"F6 G500 G0 Z10\nMCALL ROWS\nHOLES1(0,0,0,10,5,2)\nM30\n%_N_ROWS_SPF\nHOLES1(0,0,0,1,1,2)\nM17\n",
	 "HOLES1 in the subprogram ROWS, which MCALL calls, is not supported"},
	{"X=$TC_DP6[9,1]\n", "$TC_DP6[9,1]: the setup defines no radius of edge D1 of tool T9"},
	{"G500 G0 X1 Y1\nG1 F9 ANG=30\n",
	 "ANG= is supported beside one coordinate of the plane, X or Y; where two blocks determine each other, write the "
	 "point where they meet"},
	{"G500 G0 X1 Y1\nG1 F9 X2 Y3 ANG=30\n",
	 "ANG= is supported beside one coordinate of the plane, X or Y; where two blocks determine each other, write the "
	 "point where they meet"},
	{"G500 G0 X1 Y1\nG1 F9 X0 ANG=30\n", "a line at 30 degrees does not lead to this coordinate"},
	{"G500 G0 X1 Y1\nG1 F9 X2 ANG=90\n", "a line at 90 degrees does not lead to this coordinate"},
	{"G500 G0 X1 Y1\nTRANS X5\nG1 F9 X9 ANG=10\n",
	 "ANG= after a change of frames, offsets or the tool: where the line begins depends on settings of the control; "
	 "write a whole position first"},
	{"G500 G0 X1 Y1\nG2 F9 X2 ANG=90 CR=5\n",
	 "ANG= belongs to a straight line (G0, G1) in the program's coordinates"},
	{"G500 G0 X1 Y1\nSUPA X2 ANG=90\n",
	 "ANG= belongs to a straight line (G0, G1) in the program's coordinates"},
	{"DL=1\n", "DL: sum offset of the tool is not supported, only DL=0"},
	{"FZ=0.1\n", "FZ: feed per tooth (F can say it) is not supported"},
	{"G[8]=101\n", "the number of a G-code in its group must be a whole number from 1 to 100, not 101"},
	{"G[10]=1\n", "G[10]=1 is not supported: of the groups 1, 6, 7, 8, 13 and 14 only the usual codes"},
	{"X=$TC_DP25[1,1]\n", "the value of $TC_DP25[1,1] is known to the control alone; if it stays the same "
	 "while the program runs, set <variable name=\"$TC_DP25[1,1]\" value=\"\"/> in the machine file's "
	 "<controller>"},
	{"X=$TC_DP3[1]\n", "',' is needed behind the tool"},
	{"$P_PFRAME=CTRANS(X,1\n", "',' or ')' is needed here"},
	{"$P_UIFR[1]=CTRANS(X,1):CROT(X,0,Z,10)\n",
	 "$P_UIFR that turns or scales is not supported, only its shift; ROT and SCALE behind the work offset can say it"},
	{"$P_PFRAME=5\n", "CTRANS, CROT, CSCALE or CMIRROR is needed here"},
	{"$P_PFRAME=CSCALE(X,0)\n", "a scale must be greater than 0"},
	{"RNDM=1\n", "RNDM: rounding between all blocks (RND in each can say it) is not supported, only RNDM=0"},
	{"F6 G54 X0\n$P_UIFR[1,X,TR]=5\nX1\n",
	 "G54 was changed by assignment while it was active, and controls differ in when that takes effect; select G54 "
	 "again before the next move"},
	{"F6 G54 X0\n$P_UIFR[1,X,TR]=5\nR1=$P_EP[X]\n",
	 "G54 was changed by assignment while it was active, and controls differ in when that takes effect; select G54 "
	 "again before the next move"},
	{"T1 M6 D1 G54\n$P_UIFR[1,X,TR]=5\nCYCLE800(0,\"\",0,57,0,0,0,30,0,0,0,0,0,1)\n",
	 "G54 was changed by assignment while it was active, and controls differ in when that takes effect; select G54 "
	 "again before the next move"},
	{"T1 M6 D1 G54\nCYCLE800(0,\"\",0,57,0,0,0,30,0,0,0,0,0,1)\n$P_UIFR[1,X,TR]=5\nG54\nG0 X0\n",
	 "another work offset was selected while CYCLE800 has swivelled, and whether the plane goes with it is not certain: "
	 "write CYCLE800 behind it"},
	{"$P_UIFR[1,X,RT]=5\n", "$P_UIFR with RT is not supported, only with TR"},
	{"$P_UIFR[1]=CMIRROR(X)\n",
	 "$P_UIFR is given a shift, CTRANS(), here; other frames are not supported"},
	{"$TC_DP3[1,1]=5\n", "$TC_DP3[1,1]=5, but the setup has 100, and the setup counts: give edge D1 of tool T1 the "
			      "length there that the program writes"},
	{"$TC_DP12[1,1]=0.1\n", "$TC_DP12=0.1 adds to the size of the tool, which the setup has as a whole: 0 is supported "
				 "alone"},
	{"$TC_DP1[1,1]=500\n", "$TC_DP1=500: only types of milling and drilling tools are supported, 100 to 299"},
	{"$SC_FRAME_OFFSET_INCR_PROG=1\n", "$SC_FRAME_OFFSET_INCR_PROG=1: what increments do has one answer for "
					   "the whole program; set increments_after_shift=\"traverse\" in the "
					   "machine file's <controller>, which has the same meaning"},
	{"$P_PFRAME[X,RT]=5\n", "$P_PFRAME with RT is not supported, only with TR; ROT, SCALE and MIRROR can say it"},
	{"$P_IFRAME=$P_UIFR[2]\n", "$P_IFRAME is given the work offset that is in force here, $P_UIFR[1] of G54; others are "
				   "selected by G54 and the like"},
	{"SETMS(3) S1=5\n",
	 "S1: only the master spindle is supported, which is the one of SETMS; SETMS(1) before it makes this one the "
	 "master, if it turns the tool"},
	{"SETMS(0)\n", "the number of a spindle must be a whole number from 1 to 20, not 0"},
	{"SETMS(2\n", "')' is needed behind the number of a spindle"},
	{"$P_CHBFR[0]=CTRANS(X,1)\n",
	 "$P_CHBFR: of base frames only the shift of none, CTRANS(), is supported; a work offset can say it"},
	{"$P_UBFR=CROT(Z,1)\n",
	 "$P_UBFR: of base frames only the shift of none, CTRANS(), is supported; a work offset can say it"},
	{"$P_UBFR=CTRANS(X,0\n", "',' or ')' is needed here"},
	{"$P_UBFR=CTRANS(\n", "an axis of the machine is needed here"},
	{"CUTCONON\n", "CUTCONON: suspended cutter compensation is not supported"},
	{"F6 G500\nAP=30\n", "AP= without any RP= before"},
	{"F6 G500\nRP=30\n", "RP= without any AP= before"},
	{"F6 G500\nRP=-3 AP=0\n", "RP= is an absolute radius that is not negative"},
	{"F6 G500\nRP=IC(3) AP=0\n", "RP= is an absolute radius that is not negative"},
	{"F6 G500\nRP=3 AP=DC(0)\n", "AP takes AC() and IC(), not DC()"},
	{"F6 G500\nRP=3 AP=IC(5)\n", "AP=IC() without any AP= before"},
	{"F6 G500 G91\nRP=3 AP=5\n", "AP= under G91: write AP=AC() or AP=IC()"},
	{"F6 G500\nRP=3 AP=5 X1\n", "AP= and RP= stand in place of the coordinates X and Y"},
	{"F6 G500\nG2 RP=3 AP=5 CR=3\n", "a circle to AP= and RP= has its centre at the pole, and no CR=, AR=, I, J or K"},
	{"F6 G500\nX1\nG2 RP=3 AP=5\n", "the radius of the circle is 1 mm at its start and 3 mm at its end"},
	{"G110\n", "G110 needs the coordinates of the pole"},
	{"G111 X1 Z5\n", "G111 has coordinates of the plane only, X and Y"},
	{"G111 AP=5\n", "a pole has AP= and RP=, or coordinates"},
	{"F6 G500\nG331 Z-5 S100\n", "G331 needs the pitch of its axis: I of X, J of Y, K of Z"},
	{"F6 G500 S100\nSUPA G33 Z-5 K1\n",
	 "G33 beside SUPA, TRAORI, a chamfer or tool radius compensation is not supported"},
	{"F6 G500\nG63\n", "G63 needs the axis that it moves"},
	{"F6 G500 G0 Z10\nCYCLE802(211111111,111111111,1,2)\n",
	 "CYCLE802 with positions that are not all absolute (its first two arguments must be 111111111) is not supported"},
	{"F6 G500 G0 Z10\nCYCLE802(111111111,111111111,1)\nCYCLE802(111111111,111111111,1,)\n",
	 "a position of CYCLE802 has one coordinate only"},
	{"F6 G500 G0 Z10\nCYCLE83(10,0,1,-20,,-5,,1,0,0,1,0,1)\n",
	 "_AXN=1 has the cycle drill along X, which is not the axis across the plane in force; select its plane"},
	{"%_N_A_MPF\nG500\nSUB_A\n%_N_SUB_A_SPF\nR1=1\n%_N_SUB_B_SPF\nM17\n", "the subprogram ends without M17 or RET"},
};

START_TEST(moves)
{
	struct gcode_case c;

	sinumerik_case_init(&c);
	c.show_spread = true;
	ck_assert_msg(case_run(&c, programs[_i].text), "%s%s", programs[_i].text, strbuf_text(&c.messages));
	ck_assert_str_eq(strbuf_text(&c.moves), programs[_i].moves);
	case_release(&c);
}
END_TEST

/* An axis that the machine file does not have follows A, and the machine file says that nothing else moves. */
START_TEST(coupled_axes)
{
	static const struct builder_macro macros[] = {{.name = "TRAILON", .action = MACRO_NONE}};
	struct gcode_case c;

	sinumerik_case_init(&c);
	c.config.controller.macros = macros;
	c.config.controller.macro_count = 1;
	ck_assert_msg(case_run(&c, "G500 TRAILON(A1,A,-1)\nG0 X1 A90\nTRAILOF(A1,A)\nX2\n"), "%s",
		      strbuf_text(&c.messages));
	ck_assert_str_eq(strbuf_text(&c.moves), "rapid 1 0 0 90 0\nrapid 2 0 0 90 0\n");
	case_release(&c);
	/* An axis of the machine file would move, whatever the machine file says of the others. */
	sinumerik_case_init(&c);
	c.config.controller.macros = macros;
	c.config.controller.macro_count = 1;
	case_refuses(&c, "TRAILON makes C follow another axis, which is not supported for an axis of the machine file",
		     "TRAILON(C,A)\n");
}
END_TEST

START_TEST(refused)
{
	sinumerik_refuses_words(&bad[_i]);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("programs");

	tcase_add_loop_test(tcase, moves, 0, COUNT(programs));
	tcase_add_test(tcase, coupled_axes);
	tcase_add_loop_test(tcase, refused, 0, COUNT(bad));
	return run_suite("gcode_sinumerik_words", tcase);
}
