/* test_gcode_sinumerik_bad_more.c - programs of the sinumerik dialect that are refused, each with message and place. */
#include "sinumerik_refused.h"
#include "suite.h"

static const struct refused_program programs[] = {
	/* AC() and its like belong to coordinates. */
	{"F=IC(100)\n", 1, 1, "F takes a plain value, not IC()"},
	{"G1 X10 F6 S=AC(500)\n", 1, 11, "S takes a plain value, not AC()"},
	{"T=IC(1) M6\n", 1, 1, "T takes a plain value, not IC()"},
	{"G500 G0 X1 D=IC(1)\n", 1, 12, "D takes a plain value, not IC()"},
	{"G4 F=DC(2)\n", 1, 4, "F takes a plain value, not DC()"},
	{"G500 F6 G2 X10 CR=AC(5)\n", 1, 16, "CR takes a plain value, not AC()"},
	{"G500 F6 G2 X10 I5 J0 TURN=IC(2)\n", 1, 22, "TURN takes a plain value, not IC()"},
	{"G500 F6 G2 X10 I=DC(5) J0\n", 1, 16, "I takes AC() and IC(), not DC()"},
	{"G500 F6 CIP X10 Y10 I1=ACP(5) J1=0\n", 1, 21, "I1 takes AC() and IC(), not ACP()"},
	{"TRANS X=IC(5)\n", 1, 7, "X takes a plain value, not IC()"},
	{"TRANS X5\nAROT Z=IC(10)\n", 2, 6, "Z takes a plain value, not IC()"},
	{"TRAORI\nG1 F6 A3=IC(1) B3=0 C3=1\n", 2, 7, "A3 takes a plain value, not IC()"},
	{"G500 F6 G0 Z10\nMCALL CYCLE81(10,0,2,-5)\nSUPA X0\n", 3, 1,
	 "SUPA, G53 and G153 while CYCLE81 is called behind each motion; MCALL first"},
	{"TOFFL=0.1\n", 1, 1,
	 "TOFFL: programmed offset of the tool (put it into its data) is not supported, only TOFFL=0"},
	{"TRAORI(2)\n", 1, 7,
	 "TRAORI(2): the axes of any transformation but the first are not known; only TRAORI(1) is supported"},
	{"TRAORI(1,1,0,0)\n", 1, 7,
	 "TRAORI whose tool does not lie along Z at first is not supported"},
	{"PTP X1\n", 1, 1,
	 "PTP: each axis on its own way under a transformation is not supported"},
	{"G961 S100\n", 1, 1,
	 "G961: constant cutting speed is not supported"},
	{"G97 G94\n", 1, 5,
	 "this and the word at column 1 are of one group; a block can have only one of them"},
	{"ROT Z30\nG58 X5\n", 2, 1,
	 "G58 and G59 while ROT, SCALE or MIRROR is in force are not supported"},
	{"PROC\n", 1, 5,
	 "PROC needs the name of its subprogram"},
	{"CALL\n", 1, 5,
	 "a value is needed here"},
	{"CALL \"../.SPF\"\n", 1, 6,
	 ".SPF is neither a word that is known nor a subprogram: no file .SPF.SPF (or .spf, .MPF, .mpf, in upper "
	 "or lower case) lies beside the program or in a folder of --include; if .SPF is the builder's and moves "
	 "no axis, set <macro program=\".SPF\" action=\"none\"/> in the machine file's <controller>"},
	{"NOSUCH\n", 1, 1,
	 "NOSUCH is neither a word that is known nor a subprogram: no file NOSUCH.SPF (or .spf, .MPF, .mpf, in "
	 "upper or lower case) lies beside the program or in a folder of --include; if NOSUCH is the builder's and "
	 "moves no axis, set <macro program=\"NOSUCH\" action=\"none\"/> in the machine file's <controller>"},
	{"NOSUCH(1,2)\n", 1, 1,
	 "NOSUCH is neither a word that is known nor a subprogram: no file NOSUCH.SPF (or .spf, .MPF, .mpf, in "
	 "upper or lower case) lies beside the program or in a folder of --include; if NOSUCH is the builder's and "
	 "moves no axis, set <macro program=\"NOSUCH\" action=\"none\"/> in the machine file's <controller>"},
	{"L100 P2\n", 1, 1,
	 "L100 is neither a word that is known nor a subprogram: no file L100.SPF (or .spf, .MPF, .mpf, in upper "
	 "or lower case) lies beside the program or in a folder of --include; if L100 is the builder's and moves "
	 "no axis, set <macro program=\"100\" action=\"none\"/> in the machine file's <controller>"},
	/* Another program than L9. */
	{"L009\n", 1, 1,
	 "L009 is neither a word that is known nor a subprogram: no file L009.SPF (or .spf, .MPF, .mpf, in upper "
	 "or lower case) lies beside the program or in a folder of --include; if L009 is the builder's and moves "
	 "no axis, set <macro program=\"L009\" action=\"none\"/> in the machine file's <controller>"},
	{"L\n", 1, 1,
	 "L without a number"},
	{"X1 NOSUCH\n", 1, 4,
	 "a call stands in a block without axis words"},
	{"NOSUCH X1\n", 1, 1,
	 "a call stands in a block without axis words"},
	{"NOSUCH(1) Y5\n", 1, 11,
	 "nothing can follow a call in its block"},
	{"G500 F6 G0 Z10\nMCALL CYCLE81(10,0,2,-5)\nF200\n", 3, 1,
	 "F, S, G0 or G1 without axes while MCALL CYCLE81 is in force: the control calls CYCLE81 here, too; write it "
	 "before MCALL or beside the next position"},
	{"G500 F6 G0 Z10\nMCALL CYCLE81(10,0,2,-5)\nN3 G1\n", 3, 4,
	 "F, S, G0 or G1 without axes while MCALL CYCLE81 is in force: the control calls CYCLE81 here, too; write it "
	 "before MCALL or beside the next position"},
	{"G500 F6 G0 Z10\nMCALL CYCLE81(10,0,2,-5)\nCYCLE800(1)\n", 3, 1,
	 "CYCLE800 while CYCLE81 is called behind each motion; MCALL first"},
	{"G500 F6 G0 Z10\nMCALL CYCLE81(10,0,2,-5)\nG75 Z1=0\n", 3, 1,
	 "G75 while CYCLE81 is called behind each motion; MCALL first"},
	{"DEF STRING[3] S_=\"ABCD\"\n", 1, 18,
	 "a text of 4 bytes in S_, which has room for 3"},
	{"X=NUMBER(\"1EX3\")\n", 1, 9,
	 "NUMBER of a text that is no plain number: \"1EX3\""},
	{"X=INDEX(\"ABC\",\"AB\")\n", 1, 15,
	 "INDEX looks for one byte"},
	{"G500 G1 F6 POS[X]=5 Y3\n", 1, 12,
	 "POS beside other axes that do not move with G0: which way they all go is not known; write POS in a block of "
	 "its own"},
	{"G500 ROT Z30\nPOS[X]=5\n", 2, 1,
	 "POS with TRAORI, CYCLE800, ROT, SCALE, MIRROR, tool radius compensation, a chamfer, SUPA or MCALL is not "
	 "supported"},
	{"POSA[X]=5\n", 1, 1,
	 "POSA: positioning axis that goes on while the next blocks move (POS waits for it) is not supported"},
	{"T1 M6\nG500 G17\nTRAORI\nTRANS C30\nG0 X1 Y0 Z0\n", 5, 4,
	 "C is offset, and a parameter of the control (TRAFO5_ROT_OFFSET_FROM_FRAME) decides whether TRAORI and "
	 "CYCLE800 count it from there: set tcp_zero=\"machine\" or \"offset\" in the machine file's <controller>"},
	{"$P_UIFR[1,A,TR]=5\nT1 M6\nG54 G17\nCYCLE800(0,\"\",0,57,0,0,0,30,0,0,0,0,0,1)\n", 4, 1,
	 "A is offset, and a parameter of the control (TRAFO5_ROT_OFFSET_FROM_FRAME) decides whether TRAORI and "
	 "CYCLE800 count it from there: set tcp_zero=\"machine\" or \"offset\" in the machine file's <controller>"},
	{"T1 M6\nG500 G17\nTRAORI\nG0 X1 Y0 Z0\nTOROT\nX1\n", 6, 1,
	 "TOROT and TOFRAME lay Z along the tool; where X and Y then point is a matter of the control's settings "
	 "(MD21110, SD42980): only Z and rotary axes are supported before TOROTOF; a plane by CYCLE800 or ROT has all "
	 "three"},
	{"T1 M6\nG500 G17\nTRAORI\nG0 X1 Y0 Z0\nTOROT\nG111 X1 Y1\n", 6, 1,
	 "a pole while TOROT or TOFRAME is in force; TOROTOF first"},
	{"MCALL CYCLE61(1)\n", 1, 7,
	 "MCALL CYCLE61: a face is milled where the cycle itself says"},
	{"MCALL POCKET4(10,0,2,-5,20,0)\n", 1, 7,
	 "MCALL POCKET4 with a place of its own (arguments 6 and 7): whether this or the position counts is not "
	 "certain; leave them empty"},
	{"G500 G17 G71 G90 G0 X0 Y0 Z10 F6\nMCALL POCKET4(10,0,2,-5,20)\nX1 Y1\nX2\n", 4, 1,
	 "POCKET4 from where a milling cycle has left the tool: where it stands over its region is not known; "
	 "go to an absolute position in the plane first"},
	{"CYCLE62(,3,\"A\",\"B\")\n", 1, 1,
	 "CYCLE62 with a contour of type 3 is not supported, only 0 (a subprogram), 1 (a contour's name) and 2 (two labels)"},
	{"CYCLE63(\"KONTUR\")\n", 1, 1,
	 "CYCLE63: milling of a contour's pocket is not supported; lines and circles (G1, G2, G3) can say "
	 "its moves"},
	{"G500 G18\nCYCLE800(0,\"\",0,57,0,0,0,30,0,0,0,0,0,1)\n", 2, 1,
	 "CYCLE800 with G18 or G19 turns another axis towards the tool than Z, which is not supported; G17 before it, or 1 in "
	 "the units of DMODE"},
	{"G500 G17\nCYCLE800(0,\"\",0,57,0,0,0,30,0,0,0,0,0,1,,103)\n", 2, 1,
	 "CYCLE800 with G18 or G19 turns another axis towards the tool than Z, which is not supported; G17 before it, or 1 in "
	 "the units of DMODE"},
	{"CYCLE207(1)\n", 1, 1,
	 "CYCLE207 is neither a word that is known nor a subprogram: no file CYCLE207.SPF (or .spf, .MPF, .mpf, in "
	 "upper or lower case) lies beside the program or in a folder of --include; if CYCLE207 is the builder's "
	 "and moves no axis, set <macro program=\"CYCLE207\" action=\"none\"/> in the machine file's <controller>"},
	/* The log of measuring: it moves no axis. */
	{"CYCLE150(10,1001)\n", 1, 1,
	 "CYCLE150 is neither a word that is known nor a subprogram: no file CYCLE150.SPF (or .spf, .MPF, .mpf, in "
	 "upper or lower case) lies beside the program or in a folder of --include; if CYCLE150 is the builder's "
	 "and moves no axis, set <macro program=\"CYCLE150\" action=\"none\"/> in the machine file's <controller>"},
	/* The parameters of measuring cycles are variables of each control: the fault is in the cycle. */
	{"_PRNUM=1 _VMS=0 _NMSP=1 _FA=5 _TSA=2\n_TNAME=\"PROBE\" _SETV[7]=5\n_MVAR=100 _SETVAL=20 _MA=1\nCYCLE978\n",
	 4, 1,
	 "CYCLE978: where a probe stops is not known before the program runs; if it stays near its place, set "
	 "<macro program=\"CYCLE978\" action=\"around\" X=\"\" Y=\"\" Z=\"\"/> in the machine file's <controller> "
	 "to say how far it moves"},
	{"R1=_SETVAL\n", 1, 4,
	 "_SETVAL keeps its value from one program to the next, and this program has not set it: set <variable "
	 "name=\"_SETVAL\" value=\"\"/> in the machine file's <controller>"},
	{"_SETVAL=20\nR1=_SETVAL\nDEF INT _MVAR=3\nR1=_MVAR\n_FOO=1\n", 5, 1,
	 "_FOO is neither an axis of the machine nor a variable of this program; if the machine's maker or a user "
	 "has defined it (GUD), set <variable name=\"_FOO\" type=\"\"/> in the machine file's <controller>"},
	{"CYCLE977(1)\n", 1, 1,
	 "CYCLE977: where a probe stops is not known before the program runs; if it stays near its place, set "
	 "<macro program=\"CYCLE977\" action=\"around\" X=\"\" Y=\"\" Z=\"\"/> in the machine file's <controller> "
	 "to say how far it moves"},
	{"CYCLE951(1)\n", 1, 1,
	 "CYCLE951: turning is not supported; lines and circles (G1, G2, G3) can say "
	 "its moves"},
	{"CYCLE899(1)\n", 1, 1,
	 "CYCLE899: milling of an open slot, from how far outside is not published, is not supported; lines and circles (G1, G2, G3) can say "
	 "its moves"},
	{"G500 CYCLE81(10,0,2)\n", 1, 6,
	 "CYCLE81 needs RTP, RFP and one of DP and DPR"},
	{"G500 CYCLE81(-1,0,2,-5)\n", 1, 6,
	 "the return plane RTP must not lie below the reference plane RFP, and the depth not above it (the "
	 "control's alarm 61101): RTP -1, RFP 0, depth -5 mm"},
	{"G500 CYCLE81(10,0,2,5)\n", 1, 6,
	 "the return plane RTP must not lie below the reference plane RFP, and the depth not above it (the "
	 "control's alarm 61101): RTP 10, RFP 0, depth 5 mm"},
	{"G500 CYCLE81(10,0,2,0)\n", 1, 6,
	 "the depth of CYCLE81 is its reference plane RFP: the control does nothing, or goes to RTP, by its version; "
	 "leave the call out"},
	{"G500 CYCLE82(10,0,2,-5,,0,10,1,12)\n", 1, 6,
	 "_GMODE=10 of CYCLE82 is not supported, only 0: the depth is that of the tool's tip"},
	{"G500 G18 CYCLE82(10,0,2,-5,,0,0,1,12)\n", 1, 10,
	 "_DMODE of CYCLE82 works in the plane of G17, and G18 is in force; select G17 before it"},
	{"G500 CYCLE82(10,0,2,-5,,0,0,4,12)\n", 1, 6,
	 "the units of _DMODE of CYCLE82 must be 0 to 3, not 4"},
	{"G500 CYCLE82(10,0,2,-5,,0,0,1,13)\n", 1, 6,
	 "the units of _AMODE of CYCLE82 must be 0, 1 or 2, not 3"},
	{"G500 CYCLE82(10,0,2,-5,,0,0,1,11)\n", 1, 6,
	 "_AMODE of CYCLE82 needs the depth DPR, which is not given"},
	{"G500 CYCLE801(0,0,0,5,5,2,2,1)\n", 1, 6,
	 "CYCLE801 as a frame of holes (the units of _VARI) is not supported: in which order the control goes is not "
	 "known"},
	{"G500 CYCLE801(0,0,0,5,5,2,2,0,,30)\n", 1, 6,
	 "CYCLE801 as a parallelogram (_ANG1, _ANG2) is not supported"},
	{"G500 CYCLE801(0,0,0,5,5,2,2,0,,,,\"2\")\n", 1, 6,
	 "CYCLE801 that leaves holes out (_HIDE) is not supported"},
	{"G500 CYCLE801(0,0,0,5,5,2,0)\n", 1, 6,
	 "CYCLE801 needs a number of holes, _NUM2, from 1 to 9999"},
	{"G500 HOLES2(0,0,5,5,5,2,10)\n", 1, 6,
	 "HOLES2 whose holes are approached on a circle (the tens of _VARI) is not supported"},
	{"G500 HOLES1(0,0,0,5,5,2,0,0,\"\",,2)\n", 1, 6,
	 "_DMODE of HOLES1 works in the plane of G18, and G17 is in force; select G18 before it"},
	{"G500 CYCLE85(10,0,2,-5)\n", 1, 6,
	 "CYCLE85 needs its feeds FFR and RFF"},
	{"G500 F6 CYCLE83(10,0,1,-10,,0)\n", 1, 9,
	 "the pecks of CYCLE83 never reach its depth"},
	{"MCALL X1\n", 1, 1,
	 "MCALL stands in a block without axis words"},
	{"CYCLE800(0,\"\",0,128,0,0,0,0,30,0,0,0,0,1)\n", 1, 1,
	 "MODE=128 of CYCLE800, projection angles, must name two axes and then Z"},
	{"CYCLE800(0,\"\",0,185,0,0,0,90,30,0,0,0,0,1)\n", 1, 1,
	 "two projection angles of CYCLE800 must lie between -90 and 90 degrees"},
	{"G18 CYCLE800(0,\"\",0,185,0,0,0,10,30,0,0,0,0,1)\n", 1, 5,
	 "CYCLE800 with G18 or G19 turns another axis towards the tool than Z, which is not supported; G17 before it, or 1 in "
	 "the units of DMODE"},
	{"CYCLE800(0,\"\",0,192,0,0,0,0,30,0,0,0,0,1)\n", 1, 1,
	 "MODE=192 of CYCLE800, a plane by positions of the rotary axes, is not supported other than 0: in which direction X of "
	 "the plane then points is not certain; axis by axis (MODE=57 and the like) it is"},
	{"CYCLE800(0,\"\",0,64,0,0,0,0,0,5,0,0,0,1)\n", 1, 1,
	 "MODE=64 of CYCLE800 names no axis for angle 3"},
	{"CYCLE800(0,\"\",0,300,0,0,0,0,30,0,0,0,0,1)\n", 1, 1,
	 "MODE of CYCLE800 must lie between 0 and 255, not 300"},
	{"CYCLE800(0,\"\",0,57,0,0,0,0,0,0,0,0,0,2)\n", 1, 1,
	 "DIR of CYCLE800 must be -1, 0 or 1"},
	{"CYCLE800(0,\"\",0,57,0,0,0,30,0,0,0,0,0,0)\n", 1, 1,
	 "CYCLE800 with DIR=0 moves no axis, and the tool does not stand on this plane; turn the rotary axes first, or "
	 "give DIR 1 or -1"},
	{"CYCLE800(0,\"\",10,57,0,0,0,0,0,0,0,0,0,1)\n", 1, 1,
	 "CYCLE800 that guides the tool's tip while it swivels (tens of ST) is not supported"},
	{"CYCLE800(0,\"\",200100,57,0,0,0,0,0,0,0,0,0,1)\n", 1, 1,
	 "CYCLE800 that sets the tool up (hundreds of ST) is not supported"},
	{"CYCLE800(0,\"\",300000,57,0,0,0,0,0,0,0,0,0,1)\n", 1, 1,
	 "the hundred thousands of ST of CYCLE800 must be 0, 1 or 2"},
	{"G500 G0 C30\nCYCLE800(0,\"\",0,57,0,0,0,0,0,0,0,0,0,1)\n", 2, 1,
	 "any position of C suits the plane of CYCLE800, and the machine's maker decides whether C then goes to 0: "
	 "set swivel_pole=\"zero\" or \"stays\" in the machine file's <controller>"},
	{"G500 TRAORI ORIAXES\nG1 F6 A2=0 B2=10\n", 2, 1,
	 "a parameter of the control (MD21102) decides what the angles A2= B2= C2= are: write ORIEULER, ORIRPY or "
	 "ORIRPY2 before them"},
	{"G500 TRAORI ORIAXES ORIRPY\nG1 F6 A2=0 B3=1\n", 2, 1,
	 "the block turns the tool by angles (A2= B2= C2=) and by a direction (A3= B3= C3=)"},
	{"G500 ORIRPY\nG1 F6 A2=0\n", 2, 1,
	 "A2=, B2= and C2= need TRAORI, which turns the tool by these angles"},
	{"X=1EX100\n", 1, 4,
	 "an exponent has at most two digits"},
	{"X='X12'\n", 1, 3,
	 "'H' or 'B' and digits stand between such quotes: 'H1F', 'B101'"},
	{"X='B12'\n", 1, 3,
	 "this is no whole number to the base of 2"},
	{"X='H12\n", 1, 3,
	 "this quote is not closed"},
	{"X=$A_IN[1]\n", 1, 3,
	 "the value of $A_IN[1] is known to the control alone; if it stays the same while the program runs, set "
	 "<variable name=\"$A_IN[1]\" value=\"\"/> in the machine file's <controller>"},
	{"X=$P_UIFR[1,X,QQ]\n", 1, 3,
	 "a component of $P_UIFR is TR, FI, RT, SC or MI"},
	{"X=$P_UIFR[6,X,TR]\n", 1, 3,
	 "the setup defines no work offset G506: add <work_offset name=\"G506\" X=\"\" Y=\"\" Z=\"\"/> with its values"},
	{"T1 M6\nX=$P_TOOLL[4]\n", 2, 12,
	 "the number of a length must be a whole number from 1 to 3, not 4"},
	{"G500 F6\nCT X10 Y10\n", 2, 1,
	 "CT goes on in the direction of the motion before it, which is not known here: move in its plane, by G1, G2 or G3, "
	 "right before it"},
	{"G500 F6 X10\nG0 Z5\nCT X20 Y10\n", 3, 1,
	 "CT goes on in the direction of the motion before it, which is not known here: move in its plane, by G1, G2 or G3, "
	 "right before it"},
	{"G500 F6 X10\nTRANS X1\nCT X20 Y10\n", 3, 1,
	 "CT goes on in the direction of the motion before it, which is not known here: move in its plane, by G1, G2 or G3, "
	 "right before it"},
	{"G500 F6 X10 Z5\nSUPA X5\nCT X20 Y10\n", 3, 1,
	 "CT goes on in the direction of the motion before it, which is not known here: move in its plane, by G1, G2 or G3, "
	 "right before it"},
	{"G500 F6 X10 Z10\nCYCLE81(10,0,2,-5)\nCT X20 Y10\n", 3, 1,
	 "CT goes on in the direction of the motion before it, which is not known here: move in its plane, by G1, G2 or G3, "
	 "right before it"},
	{"G500 F6 X10\nCT X5\n", 2, 1,
	 "CT cannot lead straight back"},
	{"G500 F6 X10\nCT X10 Z5\n", 2, 1,
	 "CT needs an end that is not its start"},
	{"G500 F6 X10\nCT X20 Y10 CR=5\n", 2, 1,
	 "CT has only an end: no centre, CR=, AR=, TURN=, AP= or RP="},
	{"DEFINE M6 AS L6\n", 1, 8,
	 "DEFINE needs a name that begins with two letters, of at most 32 bytes"},
	{"DEFINE TRANS AS ROT\n", 1, 8,
	 "TRANS means something else: a DEFINE of it is not supported"},
	{"DEFINE GO_ON X1\n", 1, 14,
	 "AS is needed behind the name of DEFINE"},
	{"DEFINE DONE AS ENDIF\n", 1, 16,
	 "DEFINE of ENDIF, a statement of its own block, is not supported"},
	{"DEFINE DONE AS N10 \"IF\" ENDIF\n", 1, 25,
	 "DEFINE of ENDIF, a statement of its own block, is not supported"},
	{"F6 G500 G17\nG1 X1\nSUPA G0 Z9\nCT X2 Y1\n", 4, 1,
	 "CT goes on in the direction of the motion before it, which is not known here: move in its plane, by G1, G2 or "
	 "G3, right before it"},
	{"R1='HFFFFFFFF'\n", 1, 4,
	 "a number of more than 31 bits"},
	{"CYCLE800(3,\"\",0,57,0,0,0,0,0,0,0,0,0,1)\n", 1, 1,
	 "FR of CYCLE800 must be 0, 1, 2, 4 or 5, not 3"},
	{"CYCLE800(5,\"\",0,57,0,0,0,0,0,0,0,0,0,1,-1)\n", 1, 1,
	 "FR=5 of CYCLE800 needs a way FR_I that is not negative"},
	{"CYCLE832(0.05,112113)\n", 1, 1,
	 "the tens of 112113, the kind of machining of CYCLE832, may switch a transformation; write TRAORI or TRAFOOF and "
	 "leave them 0"},
	{"G500 CYCLE832(-1)\n", 1, 6,
	 "the tolerance of CYCLE832 cannot be negative"},
	{"CYCLE800(0,\"\",0,8,0,0,0,10,0,0,0,0,0,1)\n", 1, 1,
	 "MODE=8 of CYCLE800 names no axis for angle 1"},
	{"CYCLE800(0.5)\n", 1, 1,
	 "FR of CYCLE800 must be a whole number, not 0.5"},
	{"G500 CYCLE800(0,\"\",0,57,0,0,0,0,0,0,0,0,0,1)\nSCALE X2\nCYCLE800(0,\"\",1,57,0,0,0,0,0,0,0,0,0,1)\n", 3, 1,
	 "CYCLE800 that adds a plane (units of ST 1) while SCALE or MIRROR is in force is not supported"},
	{"G500 TRANS X1\nCYCLE800()\nG0 X1\n", 3, 4,
	 "CYCLE800() was called while TRANS, ROT, SCALE or MIRROR was in force, and whether it deletes them is not "
	 "certain: write TRANS, or TRANS with its values, behind it, or set frames_outlive_cycle800=\"yes\" or "
	 "\"no\" in the machine file's <controller>"},
	/* Positions are read as they are moved to: not where it is open which offset, frame, plane or edge counts. */
	{"G500 TRANS X1\nCYCLE800()\nR1=$AA_IM[X]\nR1=$P_EP[X]\n", 4, 4,
	 "CYCLE800() was called while TRANS, ROT, SCALE or MIRROR was in force, and whether it deletes them is not "
	 "certain: write TRANS, or TRANS with its values, behind it, or set frames_outlive_cycle800=\"yes\" or "
	 "\"no\" in the machine file's <controller>"},
	{"R1=$AA_IW[X]\n", 1, 4,
	 "a parameter of the control (MD20150) decides which work offset is in force at power-on: select G54 or "
	 "the like, or G500, or set power_on_work_offset=\"G500\" or \"G54\" in the machine file's <controller>"},
	{"CYCLE800(0,\"\",0,57,0,0,0,30,0,0,0,0,0,1)\nG505\nR1=$P_EP[Z]\n", 3, 4,
	 "another work offset was selected while CYCLE800 has swivelled, and whether the plane goes with it is not "
	 "certain: write CYCLE800 behind it"},
	{"CYCLE800(0,\"\",0,57,0,0,0,30,0,0,0,0,0,1)\nG505\nG111 X1\nG110 X1\nCYCLE800()\n", 4, 1,
	 "another work offset was selected while CYCLE800 has swivelled, and whether the plane goes with it is not "
	 "certain: write CYCLE800 behind it"},
	{"G110 X1\n", 1, 1,
	 "a parameter of the control (MD20150) decides which work offset is in force at power-on: select G54 or "
	 "the like, or G500, or set power_on_work_offset=\"G500\" or \"G54\" in the machine file's <controller>"},
	{"G500 TRANS X1\nCYCLE800()\nATRANS Y1\n", 3, 1,
	 "this adds to a frame that CYCLE800() may have deleted; write TRANS before it, with the values that are "
	 "meant, or set frames_outlive_cycle800=\"yes\" or \"no\" in the machine file's <controller>"},
	{"CYCLE800(0,\"\",0,57,0,0,0,30,0,0,0,0,0,1)\nG500 G0 C5\n", 2, 9,
	 "C while CYCLE800 has swivelled: the tool would leave the direction of its plane; CYCLE800() first"},
	{"CYCLE800(0,\"\",0,57,0,0,0,30,0,0,0,0,0,1)\nG505\nG0 X1\n", 3, 4,
	 "another work offset was selected while CYCLE800 has swivelled, and whether the plane goes with it is not "
	 "certain: write CYCLE800 behind it"},
	{"CYCLE800(0,\"\",0,57,0,0,0,30,0,0,0,0,0,1)\nG505\nCYCLE800(0,\"\",1,57,0,0,0,0,0,0,0,0,0,1)\n", 3, 1,
	 "CYCLE800 that adds a plane (units of ST 1) to one that another work offset may have changed"},
	{"CYCLE800(0,\"\",0,57,0,0,0,30,0,0,0,0,0,1)\nTRAORI\n", 2, 1,
	 "TRAORI while CYCLE800 has swivelled; CYCLE800() first"},
	{"TRAORI\nCYCLE800(0,\"\",0,57,0,0,0,0,0,0,0,0,0,1)\n", 2, 1,
	 "CYCLE800 while TRAORI is on; TRAFOOF first"},
	{"TRAORI\nSUPA G0 Z5\n", 2, 1,
	 "positions of the machine's axes (SUPA, G53, G153) while TRAORI is on; TRAFOOF first"},
	{"TRAORI\nG74 X1=0\n", 2, 1,
	 "G74 while TRAORI is on; TRAFOOF first"},
	{"TRAORI ORIVECT\nG500 G0 C5\n", 2, 9,
	 "the great circle (ORIVECT) ends with C at 0 degrees, and the block gives 5: the control changes over at the pole "
	 "or alarms; ORIAXES turns the axes evenly"},
	{"TRAORI ORIVECT ORIMKS\nG500 G0 A5\n", 2, 9,
	 "a great circle (ORIVECT) in the machine's coordinates (ORIMKS) is not supported; use ORIWKS"},
	{"TRAORI ORIVECT\nG500 G1 F6 X1 A3=0 B3=0 C3=-1\n", 2, 12,
	 "the tool turns round to the opposite direction: the plane of a great circle (ORIVECT) is not certain"},
	{"TRAORI ORIVECT\nG500 F6 G2 X1 CR=1 A5\n", 2, 9,
	 "a circle during which the tool turns on a great circle (ORIVECT) is not supported"},
	{"TRAORI ORIVECT\nG500 F6 X1 A5 RND=1\n", 2, 9,
	 "CHF, CHR or RND in a block that turns the tool is not supported"},
	{"TRAORI\nG500 G0 A3=0 B3=0 C3=0\n", 2, 1,
	 "the direction A3= B3= C3= has no length"},
	{"TRAORI\nG500 G0 C5 A3=0 C3=1\n", 2, 9,
	 "the block turns the tool by C and by a direction (A3= B3= C3=)"},
	{"TRAORI ORIMKS\nG500 G0 A3=0 C3=1\n", 2, 1,
	 "a direction A3= B3= C3= with ORIMKS is not supported; use ORIWKS"},
	{"TRAORI\nG500 G0 LEAD=5\n", 2, 9,
	 "LEAD: orientation by an angle of lead is not supported"},
	{"TRANSMIT\n", 1, 1,
	 "TRANSMIT: milling on the face of a turning part is not supported"},
	{"TRACYL(40)\n", 1, 1,
	 "TRACYL: milling on a cylinder is not supported"},
	{"ORIPATH\n", 1, 1,
	 "ORIPATH: orientation by the path is not supported"},
	{"ASPLINE X1\n", 1, 1,
	 "ASPLINE: spline interpolation (short lines of G1 can say it) is not supported"},
	{"BSPLINE\n", 1, 1,
	 "BSPLINE: spline interpolation (short lines of G1 can say it) is not supported"},
	{"POLY X1\n", 1, 1,
	 "POLY: polynomial interpolation (short lines of G1 can say it) is not supported"},
	{"RND=5\n", 1, 1,
	 "CHF, CHR and RND need a block with G1, G2 or G3"},
	{"CHF=2\n", 1, 1,
	 "CHF, CHR and RND need a block with G1, G2 or G3"},
	{"MEAS=1 X1\n", 1, 1,
	 "MEAS: measuring with a probe is not supported"},
	{"G4\n", 1, 1,
	 "G4 needs its time: F in seconds, or S in turns of the spindle"},
	{"G4 S5\n", 1, 1,
	 "G4 S counts turns of the spindle, whose speed is not known"},
	{"G4 F-1\n", 1, 1,
	 "a dwell cannot be negative"},
	{"G4 F1 X5\n", 1, 7,
	 "G4 stands in a block without motion"},
	{"G75\n", 1, 1,
	 "G75 needs the axes that it moves: X1=0 and the like"},
	{"G75 FP=9 X1=0\n", 1, 1,
	 "G75 FP= must be a whole number from 1 to 3"},
	{"G0 X1=5\n", 1, 4,
	 "names of the machine's axes (X1=) are supported with G74 and G75 only"},
	{"FP=1\n", 1, 1,
	 "FP belongs to G75"},
	{"P5\n", 1, 1,
	 "P belongs to the call of a subprogram"},
	{"F-1\n", 1, 1,
	 "a feed rate cannot be negative"},
	{"S-1\n", 1, 1,
	 "a spindle speed cannot be negative"},
	{"S2=5\n", 1, 1,
	 "S2: only the master spindle is supported, which is the first one; SETMS(2) before it makes this one the master, "
	 "if it turns the tool"},
	{"R1 5\n", 1, 1,
	 "a blank inside the number of R; what a control makes of it differs"},
	{"DEF REAL AB=1 2x\n", 1, 13,
	 "a blank inside a number"},
	{"M2=3\n", 1, 1,
	 "M2: only the master spindle is supported, which is the first one; SETMS(2) before it makes this one the master, "
	 "if it turns the tool"},
	{"T-1\n", 1, 1,
	 "T must be a whole number that is not negative, not -1"},
	{"T1.5\n", 1, 1,
	 "T must be a whole number that is not negative, not 1.5"},
	{"T=\"NOSUCH\"\n", 1, 1,
	 "the setup defines no tool named \"NOSUCH\": add <tool number=\"\" name=\"NOSUCH\" length=\"\"/> "
	 "with what it is made of"},
	{"T=\"Twin\"\n", 1, 1,
	 "the setup has two tools named \"Twin\", T3 and T4, and the control decides which it loads: keep the one in the "
	 "spindle, or give the other one another name"},
	{"R1=GETT(\"TWIN\",1)\n", 1, 4,
	 "the setup has two tools named \"TWIN\", T3 and T4, and the control decides which it loads: keep the one in the "
	 "spindle, or give the other one another name"},
	{"M6\n", 1, 1,
	 "M6 without a tool: write T first"},
	{"T9 M6\n", 1, 4,
	 "the setup defines no tool T9: add <tool number=\"9\" length=\"\"/> with its shape"},
	{"T1 M6 D7\n", 1, 7,
	 "the setup defines no edge D7 of tool T1: add <edge number=\"7\" length=\"\"/> to it"},
	{"D1.5\n", 1, 1,
	 "D must be a whole number from 0 to 32000, not 1.5"},
	{"T1 M6 G18 D1\nG500 G0 Z1\n", 2, 9,
	 "in the plane of G18 a parameter of the control (SD42940) decides along which axis the tool's length "
	 "acts: set tool_length_axis=\"z\" in the machine file's <controller> if it is Z in every plane; the other "
	 "way is not supported"},
	{"G56\n", 1, 1,
	 "the setup defines no work offset G56: add <work_offset name=\"G56\" X=\"\" Y=\"\" Z=\"\"/> with its values"},
	{"G500 G0 C=DC(10)\n", 1, 9,
	 "DC, ACP and ACN are for rotary axes that count modulo 360 degrees; wrap=\"shortest\" of this axis "
	 "in the machine file says that C is one, and rotary_way=\"plain\" or \"shorter\" of <controller> how it turns "
	 "without them"},
	{"G500 G0 X=DC(10)\n", 1, 9,
	 "DC, ACP and ACN are for rotary axes that count modulo 360 degrees; wrap=\"shortest\" of this axis "
	 "in the machine file says that X is one, and rotary_way=\"plain\" or \"shorter\" of <controller> how it turns "
	 "without them"},
	{"G500 G0 X=CAC(1)\n", 1, 11,
	 "positions of a table of the control (CAC)"},
	{"SUPA G0 X=IC(5)\n", 1, 9,
	 "positions of the machine's axes are absolute; an increment beside SUPA, G53 or G153 is not supported"},
	{"SUPA G91 G0 X5\n", 1, 13,
	 "positions of the machine's axes are absolute; an increment beside SUPA, G53 or G153 is not supported"},
	{"SUPA F6 G2 X5 I1\n", 1, 1,
	 "SUPA, G53 and G153 need G0 or G1, not a circle"},
	{"G500 G0 X1\nTRANS X5\nX=IC(1)\n", 3, 1,
	 "X by an increment after a change of frames, offsets or the tool: settings of the control (SD42440, "
	 "SD42442) decide whether the change is traversed, too: set increments_after_shift=\"traverse\" or "
	 "\"stay\" in the machine file's <controller>"},
	{"SETAL(65000\n", 1, 6,
	 "this '(' is not closed"},
	{"MSG(\"a\"\n", 1, 4,
	 "this '(' is not closed"},
	{"T=\"abc\n", 1, 3,
	 "this text is not closed: '\"' is missing"},
	{"DIAMON\n", 1, 1,
	 "DIAMON: diameter programming is not supported"},
	{"KONTC\n", 1, 1,
	 "KONTC: start of cutter compensation on a curve is not supported"},
	{"G461\n", 1, 1,
	 "G461: end of cutter compensation, drawn out by a circle is not supported"},
	{"G70 OFFN=1\n", 1, 5,
	 "whether OFFN is in mm or inches where G70 or G71 differs from the control's own unit is not known here; write G700 "
	 "or G710"},
	{"T1 D1 M6 G500 G71 G17 F6 G0 X0 Y0 Z0\nG41 X10 Y0 OFFN=1\nY10 OFFN=2\n", 3, 5,
	 "another OFFN while tool radius compensation is on; G40 first"},
	{"RTLIOF\n", 1, 1,
	 "RTLIOF: rapids in which each axis goes at its own rate is not supported"},
	{"TCARR=1\n", 1, 1,
	 "TCARR: orientable tool carrier is not supported, only TCARR=0"},
	{"TOROT\n", 1, 1,
	 "TOROT and TOFRAME without TRAORI are not supported; CYCLE800 gives a plane"},
	{"CROTS X10 Y10\n", 1, 1,
	 "CROTS: turning by solid angles in a frame that the control keeps is not supported"},
	{"G71 ROTS X10 Y10 Z10\n", 1, 5,
	 "ROTS and AROTS have one or two solid angles: X and Y, Z and X, or Y and Z"},
	{"G71 ROTS X10 Y90\n", 1, 5,
	 "two solid angles must lie between -90 and 90 degrees"},
	{"x(5)\n", 1, 1,
	 "X without a number"},
	{"G500 G43 X1\n", 1, 6,
	 "G43 is not known; it is a code of ISO mode (G291), the language of Fanuc, which is not read here"},
	{"5\n", 1, 1,
	 "unexpected '5'"},
	{"!\n", 1, 1,
	 "unexpected '!'"},
	{"X1 ) Y2\n", 1, 4,
	 "unexpected ')'"},
	{"G\n", 1, 1,
	 "G without a number"},
	{"M\n", 1, 1,
	 "M without a number"},
	{"G500 G2 X5 R5 F6\n", 1, 12,
	 "R5 needs '=' and a value; the radius of a circle is CR="},
};

START_TEST(refused)
{
	sinumerik_refuses(&programs[_i]);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("programs");

	tcase_add_loop_test(tcase, refused, 0, COUNT(programs));
	return run_suite("gcode_sinumerik_bad_more", tcase);
}
