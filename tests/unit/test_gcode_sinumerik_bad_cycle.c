/* test_gcode_sinumerik_bad_cycle.c - what is refused of the cycles of the sinumerik dialect, and of calls behind motions. */
#include "sinumerik_refused.h"
#include "suite.h"

static const struct refused_program programs[] = {
	{"G500 F6 G0 Z10\nMCALL CYCLE81(10,0,2,-5)\nSUPA X0\n", 3, 1,
	 "SUPA, G53 and G153 while CYCLE81 is called behind each motion; MCALL first"},
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
	{"$P_UIFR[1,A,TR]=5\nT1 M6\nG54 G17\nCYCLE800(0,\"\",0,57,0,0,0,30,0,0,0,0,0,1)\n", 4, 1,
	 "A is offset, and a parameter of the control (TRAFO5_ROT_OFFSET_FROM_FRAME) decides whether TRAORI and "
	 "CYCLE800 count it from there: set tcp_zero=\"machine\" or \"offset\" in the machine file's <controller>"},
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
	/* Their results. */
	{"_OVI[9]=2.4\nIF _OVI[9]<>2\nSETAL(65000)\nENDIF\nR1=_OVR[4]\n", 5, 4,
	 "_OVR[4] keeps its value from one program to the next, and this program has not set it: set <variable "
	 "name=\"_OVR[4]\" value=\"\"/> in the machine file's <controller>"},
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
	{"G500 F6 X10 Z10\nCYCLE81(10,0,2,-5)\nCT X20 Y10\n", 3, 1,
	 "CT goes on in the direction of the motion before it, which is not known here: move in its plane, by G1, G2 or G3, "
	 "right before it"},
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
	{"CYCLE800(0,\"\",0,57,0,0,0,30,0,0,0,0,0,1)\nG505\nR1=$P_EP[Z]\n", 3, 4,
	 "another work offset was selected while CYCLE800 has swivelled, and whether the plane goes with it is not "
	 "certain: write CYCLE800 behind it"},
	{"CYCLE800(0,\"\",0,57,0,0,0,30,0,0,0,0,0,1)\nG505\nG111 X1\nG110 X1\nCYCLE800()\n", 4, 1,
	 "another work offset was selected while CYCLE800 has swivelled, and whether the plane goes with it is not "
	 "certain: write CYCLE800 behind it"},
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
	return run_suite("gcode_sinumerik_bad_cycle", tcase);
}
