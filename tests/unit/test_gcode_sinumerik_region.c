/* test_gcode_sinumerik_region.c - milling cycles of the sinumerik dialect that are regions, and their messages. */
#include "sinumerik_refused.h"

struct program {
	const char *text, *moves;
};

static const struct program programs[] = {
	{"G500 T1 D1 M6 G0 X0 Y0 Z0\nPOCKET1(10,0,2,-5,,40,30,5,50,60,0,100,200)\nX0 Z20\nY0\nX1\n",
	 "tool 1\nrapid 0 0 100 0 0\nrapid 32.5 35 105 0 0 spread 32.5 35 5\n"
	 "rapid 50 60 110 0 0 spread 15 10 0\nrapid 50 60 102 0 0 spread 15 10 0\n"
	 "rapid 50 60 102 0 0 spread 15 10 0\nfeed 50 60 95 0 0 spread 15 10 0\n"
	 "feed 50 60 102 0 0 spread 15 10 0\nrapid 50 60 102 0 0 spread 15 10 0\n"
	 "rapid 50 60 110 0 0 spread 15 10 0\nrapid 0 60 120 0 0 spread 15 10 0\n"
	 "rapid 0 0 120 0 0 spread 0 10 0\nrapid 1 0 120 0 0\n"},
	{"G500 T1 D1 M6 F6 G0 X50 Y60 Z10\nPOCKET1(10,0,2,,5,40,30,5,50,60,90)\n",
	 "tool 1\nrapid 50 60 110 0 0\nrapid 50 60 110 0 0 spread 10 15 0\n"
	 "rapid 50 60 110 0 0 spread 10 15 0\nrapid 50 60 102 0 0 spread 10 15 0\n"
	 "rapid 50 60 102 0 0 spread 10 15 0\nfeed 50 60 95 0 0 spread 10 15 0\n"
	 "feed 50 60 102 0 0 spread 10 15 0\nrapid 50 60 102 0 0 spread 10 15 0\n"
	 "rapid 50 60 110 0 0 spread 10 15 0\n"},
	{"G500 T1 D1 M6 F6 G0 X0 Y0 Z10\nPOCKET2(10,0,2,-5,,20,50,60)\n",
	 "tool 1\nrapid 0 0 110 0 0\nrapid 32.5 37.5 110 0 0 spread 32.5 37.5 0\n"
	 "rapid 50 60 110 0 0 spread 15 15 0\nrapid 50 60 102 0 0 spread 15 15 0\n"
	 "rapid 50 60 102 0 0 spread 15 15 0\nfeed 50 60 95 0 0 spread 15 15 0\n"
	 "feed 50 60 102 0 0 spread 15 15 0\nrapid 50 60 102 0 0 spread 15 15 0\n"
	 "rapid 50 60 110 0 0 spread 15 15 0\n"},
	{"G500 T1 D1 M6 F6 G0 X0 Y0 Z10\nPOCKET3(10,0,2,-5,40,30,5,50,60,0)\n",
	 "tool 1\nrapid 0 0 110 0 0\nrapid 42.5 42.5 110 0 0 spread 42.5 42.5 0\n"
	 "rapid 50 60 110 0 0 spread 35 25 0\nrapid 50 60 102 0 0 spread 35 25 0\n"
	 "rapid 50 60 102 0 0 spread 35 25 0\nfeed 50 60 95 0 0 spread 35 25 0\n"
	 "feed 50 60 102 0 0 spread 35 25 0\nrapid 50 60 102 0 0 spread 35 25 0\n"
	 "rapid 50 60 110 0 0 spread 35 25 0\n"},
	{"G500 T1 D1 M6 F6 G0 X0 Y0 Z10\nPOCKET3(10,0,2,5,40,30,5,50,60,0,,,,,,,,,,,,,,,,,1100,1,1)\n",
	 "tool 1\nrapid 0 0 110 0 0\nrapid 32.5 35 110 0 0 spread 32.5 35 0\n"
	 "rapid 50 60 110 0 0 spread 15 10 0\nrapid 50 60 102 0 0 spread 15 10 0\n"
	 "rapid 50 60 102 0 0 spread 15 10 0\nfeed 50 60 95 0 0 spread 15 10 0\n"
	 "feed 50 60 102 0 0 spread 15 10 0\nrapid 50 60 102 0 0 spread 15 10 0\n"
	 "rapid 50 60 110 0 0 spread 15 10 0\n"},
	{"G500 T1 D1 M6 F6 G0 X0 Y0 Z10\nPOCKET4(10,0,2,-5,20,50,60)\n",
	 "tool 1\nrapid 0 0 110 0 0\nrapid 32.5 37.5 110 0 0 spread 32.5 37.5 0\n"
	 "rapid 50 60 110 0 0 spread 15 15 0\nrapid 50 60 102 0 0 spread 15 15 0\n"
	 "rapid 50 60 102 0 0 spread 15 15 0\nfeed 50 60 95 0 0 spread 15 15 0\n"
	 "feed 50 60 102 0 0 spread 15 15 0\nrapid 50 60 102 0 0 spread 15 15 0\n"
	 "rapid 50 60 110 0 0 spread 15 15 0\n"},
	{"G500 T1 D1 M6 F6 G0 X0 Y0 Z10\nSLOT1(10,0,2,-5,,2,30,12,0,0,20,0,180)\n",
	 "tool 1\nrapid 0 0 110 0 0\nrapid 0 0 110 0 0 spread 50 1 0\nrapid 0 0 110 0 0 spread 50 1 0\n"
	 "rapid 0 0 102 0 0 spread 50 1 0\nrapid 35 0 102 0 0 spread 15 1 0\nfeed 35 0 95 0 0 spread 15 1 0\n"
	 "feed 35 0 102 0 0 spread 15 1 0\nrapid -35 0 102 0 0 spread 15 1 0\n"
	 "feed -35 0 95 0 0 spread 15 1 0\nfeed -35 0 102 0 0 spread 15 1 0\nrapid 0 0 102 0 0 spread 50 1 0\n"
	 "rapid 0 0 110 0 0 spread 50 1 0\n"},
	{"G500 T1 D1 M6 F6 G0 X0 Y0 Z10\nLONGHOLE(10,0,2,-5,,4,30,0,0,20,0,0)\n",
	 "tool 1\nrapid 0 0 110 0 0\nrapid 0 0 110 0 0 spread 50 50 0\nrapid 0 0 110 0 0 spread 50 50 0\n"
	 "rapid 0 0 102 0 0 spread 50 50 0\nrapid 35 0 102 0 0 spread 15 0 0\nfeed 35 0 95 0 0 spread 15 0 0\n"
	 "feed 35 0 102 0 0 spread 15 0 0\nrapid 0 35 102 0 0 spread 0 15 0\nfeed 0 35 95 0 0 spread 0 15 0\n"
	 "feed 0 35 102 0 0 spread 0 15 0\nrapid -35 0 102 0 0 spread 15 0 0\n"
	 "feed -35 0 95 0 0 spread 15 0 0\nfeed -35 0 102 0 0 spread 15 0 0\n"
	 "rapid 0 -35 102 0 0 spread 0 15 0\nfeed 0 -35 95 0 0 spread 0 15 0\n"
	 "feed 0 -35 102 0 0 spread 0 15 0\nrapid 0 0 102 0 0 spread 50 50 0\n"
	 "rapid 0 0 110 0 0 spread 50 50 0\n"},
	{"G500 T1 D1 M6 F6 G0 X0 Y0 Z10\nSLOT2(10,0,2,-5,,3,70,15,60,60,42,0,120)\n",
	 "tool 1\nrapid 0 0 110 0 0\nrapid 52.25 52.25 110 0 0 spread 52.25 52.25 0\n"
	 "rapid 60 60 110 0 0 spread 44.5 44.5 0\nrapid 60 60 102 0 0 spread 44.5 44.5 0\n"
	 "rapid 60 60 102 0 0 spread 44.5 44.5 0\nfeed 60 60 95 0 0 spread 44.5 44.5 0\n"
	 "feed 60 60 102 0 0 spread 44.5 44.5 0\nrapid 60 60 102 0 0 spread 44.5 44.5 0\n"
	 "rapid 60 60 110 0 0 spread 44.5 44.5 0\n"},
	{"G500 T1 D1 M6 F6 G0 X0 Y0 Z10\nCYCLE71(10,0,2,-11,100,100,60,40,10,6,10,5,0,4000,31,2)\n",
	 "tool 1\nrapid 0 0 110 0 0\nrapid 89.391108 84.7524758 110 0 0 spread 89.391108 84.7524758 0\n"
	 "rapid 126.071269 124.9056 110 0 0 spread 52.710947 44.5993512 0\n"
	 "rapid 126.071269 124.9056 102 0 0 spread 52.710947 44.5993512 0\n"
	 "rapid 126.071269 124.9056 102 0 0 spread 52.710947 44.5993512 0\n"
	 "feed 126.071269 124.9056 89 0 0 spread 52.710947 44.5993512 0\n"
	 "feed 126.071269 124.9056 102 0 0 spread 52.710947 44.5993512 0\n"
	 "rapid 126.071269 124.9056 102 0 0 spread 52.710947 44.5993512 0\n"
	 "rapid 126.071269 124.9056 110 0 0 spread 52.710947 44.5993512 0\n"},
	{"G500 T1 D1 M6 F6 G0 X0 Y0 Z10\nCYCLE61(10,1,1,0,0,0,100,100,1,12,0,1000,31,0,1,10)\n",
	 "tool 1\nrapid 0 0 110 0 0\nrapid 50 50 110 0 0 spread 61 61 0\nrapid 50 50 110 0 0 spread 61 61 0\n"
	 "rapid 50 50 102 0 0 spread 61 61 0\nrapid 50 50 102 0 0 spread 61 61 0\n"
	 "feed 50 50 100 0 0 spread 61 61 0\nfeed 50 50 102 0 0 spread 61 61 0\n"
	 "rapid 50 50 102 0 0 spread 61 61 0\nrapid 50 50 110 0 0 spread 61 61 0\n"},
	{"G500 T1 D1 M6 F6 G0 X0 Y0 Z10\nCYCLE90(10,0,2,-40,,60,50,2,500,2,0,60,50)\n",
	 "tool 1\nrapid 0 0 110 0 0\nrapid 42.5 37.5 110 0 0 spread 42.5 37.5 0\n"
	 "rapid 60 50 110 0 0 spread 25 25 0\nrapid 60 50 102 0 0 spread 25 25 0\n"
	 "rapid 60 50 102 0 0 spread 25 25 0\nfeed 60 50 60 0 0 spread 25 25 4\n"
	 "feed 60 50 102 0 0 spread 25 25 4\nrapid 60 50 102 0 0 spread 25 25 0\n"
	 "rapid 60 50 110 0 0 spread 25 25 0\n"},
	{"G500 T1 D1 M6 F6 G0 X0 Y0 Z10\nCYCLE70(10,0,2,-40,60,1,0,2,1,5,500,0,60,50)\n",
	 "tool 1\nrapid 0 0 110 0 0\nrapid 42.5 37.5 110 0 0 spread 42.5 37.5 0\n"
	 "rapid 60 50 110 0 0 spread 25 25 0\nrapid 60 50 102 0 0 spread 25 25 0\n"
	 "rapid 60 50 102 0 0 spread 25 25 0\nfeed 60 50 60 0 0 spread 25 25 4\n"
	 "feed 60 50 102 0 0 spread 25 25 4\nrapid 60 50 102 0 0 spread 25 25 0\n"
	 "rapid 60 50 110 0 0 spread 25 25 0\n"},
	{"G500 F6 G18 G0 X0 Y10 Z0\nPOCKET2(10,0,2,-5,,20,50,60)\nZ1\nX1\n",
	 "rapid 0 10 0 0 0\nrapid 40 10 35 0 0 spread 40 0 35\nrapid 60 10 50 0 0 spread 20 0 20\n"
	 "rapid 60 2 50 0 0 spread 20 0 20\nrapid 60 2 50 0 0 spread 20 0 20\n"
	 "feed 60 -5 50 0 0 spread 20 0 20\nfeed 60 2 50 0 0 spread 20 0 20\n"
	 "rapid 60 2 50 0 0 spread 20 0 20\nrapid 60 10 50 0 0 spread 20 0 20\n"
	 "rapid 60 10 1 0 0 spread 20 0 20\nrapid 1 10 1 0 0 spread 20 0 0\n"},
	{"G500 T1 D1 M6 F6 AROT Z90\nG0 X0 Y0 Z10\nPOCKET1(10,0,2,-5,,40,30,5,50,60,0)\nG0 X0\nY0\nX0 Y0 Z10\nX1\n",
	 "tool 1\nrapid 0 0 110 0 0\nrapid -35 32.5 110 0 0 spread 35 32.5 0\n"
	 "rapid -60 50 110 0 0 spread 10 15 0\nrapid -60 50 102 0 0 spread 10 15 0\n"
	 "rapid -60 50 102 0 0 spread 10 15 0\nfeed -60 50 95 0 0 spread 10 15 0\n"
	 "feed -60 50 102 0 0 spread 10 15 0\nrapid -60 50 102 0 0 spread 10 15 0\n"
	 "rapid -60 50 110 0 0 spread 10 15 0\nrapid -60 0 110 0 0 spread 10 15 0\n"
	 "rapid 0 0 110 0 0 spread 10 15 0\nrapid 0 0 110 0 0 spread 10 15 0\nrapid 0 1 110 0 0\n"},
	/* CYCLE800 while the place is open: then it may be open along any axis. */
	{"G500 T1 D1 M6 F6 G0 X0 Y0 Z10\nPOCKET2(10,0,2,-5,,20,50,60)\nCYCLE800(0,\"TC1\",0,57,0,0,0,30,0,0,0,0,0,-1)\n"
	 "G0 X1 Y2\nX1 Y2 Z3\nX2\n",
	 "tool 1\nrapid 0 0 110 0 0\nrapid 32.5 37.5 110 0 0 spread 32.5 37.5 0\n"
	 "rapid 50 60 110 0 0 spread 15 15 0\nrapid 50 60 102 0 0 spread 15 15 0\n"
	 "rapid 50 60 102 0 0 spread 15 15 0\nfeed 50 60 95 0 0 spread 15 15 0\n"
	 "feed 50 60 102 0 0 spread 15 15 0\nrapid 50 60 102 0 0 spread 15 15 0\n"
	 "rapid 50 60 110 0 0 spread 15 15 0\norient 0 -0.5 0.866025404\n"
	 "rapid 50 60 110 -30 0 spread 21.2132034 21.2132034 21.2132034\ntcp on length 100 zero A0 C0\n"
	 "rapid 1 12.4019238 -17.4807621 -30 0 spread 21.2132034 21.2132034 21.2132034 tcp\n"
	 "rapid 1 0.232050808 3.59807621 -30 0 spread 21.2132034 21.2132034 21.2132034 tcp\n"
	 "rapid 2 0.232050808 3.59807621 -30 0 tcp\n"},
	/* Drilled and milled where the last cycle has left it. */
	{"G500 T1 D1 M6 F6 G0 X0 Y0 Z10\nPOCKET2(10,0,2,-5,,20,50,60)\nPOCKET2(10,0,2,-5,,20,50,60)\nCYCLE81(10,0,2,-9)\n",
	 "tool 1\nrapid 0 0 110 0 0\nrapid 32.5 37.5 110 0 0 spread 32.5 37.5 0\n"
	 "rapid 50 60 110 0 0 spread 15 15 0\nrapid 50 60 102 0 0 spread 15 15 0\n"
	 "rapid 50 60 102 0 0 spread 15 15 0\nfeed 50 60 95 0 0 spread 15 15 0\n"
	 "feed 50 60 102 0 0 spread 15 15 0\nrapid 50 60 102 0 0 spread 15 15 0\n"
	 "rapid 50 60 110 0 0 spread 15 15 0\nrapid 50 60 110 0 0 spread 30 30 0\n"
	 "rapid 50 60 110 0 0 spread 15 15 0\nrapid 50 60 102 0 0 spread 15 15 0\n"
	 "rapid 50 60 102 0 0 spread 15 15 0\nfeed 50 60 95 0 0 spread 15 15 0\n"
	 "feed 50 60 102 0 0 spread 15 15 0\nrapid 50 60 102 0 0 spread 15 15 0\n"
	 "rapid 50 60 110 0 0 spread 15 15 0\nrapid 50 60 102 0 0 spread 15 15 0\n"
	 "feed 50 60 91 0 0 spread 15 15 0\nrapid 50 60 110 0 0 spread 15 15 0\n"},
	{"G700 G500 T1 D1 M6 F6 G0 X0 Y0 Z1\nPOCKET2(1,0,.1,-.5,,2,5,6)\n",
	 "tool 1\nrapid 0 0 125.4 0 0\nrapid 86.4 99.1 125.4 0 0 spread 86.4 99.1 0\n"
	 "rapid 127 152.4 125.4 0 0 spread 45.8 45.8 0\nrapid 127 152.4 102.54 0 0 spread 45.8 45.8 0\n"
	 "rapid 127 152.4 102.54 0 0 spread 45.8 45.8 0\nfeed 127 152.4 87.3 0 0 spread 45.8 45.8 0\n"
	 "feed 127 152.4 102.54 0 0 spread 45.8 45.8 0\nrapid 127 152.4 102.54 0 0 spread 45.8 45.8 0\n"
	 "rapid 127 152.4 125.4 0 0 spread 45.8 45.8 0\n"},
};

static const struct refused_program bad[] = {
	{"MCALL POCKET1(1)\n", 1, 7,
	 "MCALL POCKET1: milling cycles are supported where they are called without MCALL"},
	{"G500 POCKET1(10,0,2)\n", 1, 6,
	 "POCKET1 needs RTP, RFP and one of DP and DPR"},
	{"G500 POCKET3(10,0,2)\n", 1, 6,
	 "POCKET3 needs RTP, RFP and DP"},
	{"G500 POCKET2(10,0,2,-5,,20,50,60)\n", 1, 6,
	 "POCKET2 without a feed rate"},
	{"G500 F6 SLOT1(10,0,2,-5,,0,30,12,0,0,20,0,180)\n", 1, 9,
	 "SLOT1 needs a number of slots, NUM, from 1 to 1000"},
	{"G500 F6 LONGHOLE(10,0,2,-5,,1.5,30,0,0,20,0,0)\n", 1, 9,
	 "LONGHOLE needs a number of slots, NUM, from 1 to 1000"},
	{"G500 F6 CYCLE90(10,0,2,-40,,60,50,2,500,2,1,60,50)\n", 1, 9,
	 "CYCLE90 on an outside thread: how far aside the tool goes is not known"},
	{"G500 F6 CYCLE90(10,0,2,-40,,60,50,,500,2,0,60,50)\n", 1, 9,
	 "CYCLE90 needs the pitch of its thread in mm or inches, PIT"},
	{"G500 F6 CYCLE70(10,0,2,-40,60,1,0,2,1,5,500,0,60,50,,,2)\n", 1, 9,
	 "CYCLE70 with a pitch in threads an inch or in modules (_PITA) is not supported"},
	{"G500 G19 F6 POCKET4(10,0,2,-5,20,50,60,,,,,,,,,,,,,,,,,1)\n", 1, 13,
	 "_DMODE of POCKET4 works in the plane of G17, and G19 is in force; select G17 before it"},
	{"G500 F6 POCKET4(10,0,2,-5,20,50,60,,,,,,,,,,,,,,,,,1,3)\n", 1, 9,
	 "the units of _AMODE of POCKET4 must be 0, 1 or 2, not 3"},
	{"G500 F6 POCKET3(-10,0,2,-5,20,50)\n", 1, 9,
	 "the return plane RTP must not lie below the reference plane RFP, and the depth not above it (the "
	 "control's alarm 61101): RTP -10, RFP 0, depth -5 mm"},
	{"T1 D1 M6 G500 F6 G41 X10 Y10\nPOCKET2(10,0,2,-5,,20,50,60)\n", 2, 1,
	 "POCKET2 while tool radius compensation is on; G40 first"},
	{"CYCLE76(50,0,1,,10,60,40)\n", 1, 1,
	 "CYCLE76: milling round a spigot, from how far outside is not published, is not supported yet"},
	{"CYCLE72(\"KONTUR\",50,0,1,-5)\n", 1, 1,
	 "CYCLE72: milling of a contour is not supported yet"},
	{"T1 D1 M6 G500 F6 G0 X0 Y0 Z10\nPOCKET2(10,0,2,-5,,20,50,60)\nG91 X5\n", 3, 5,
	 "an increment from where a milling cycle has left the tool: where it stands over its region is not "
	 "known; go to an absolute position in the plane first"},
	{"T1 D1 M6 G500 F6 G0 X0 Y0 Z10\nPOCKET2(10,0,2,-5,,20,50,60)\nX0\nY=IC(5)\n", 4, 1,
	 "an increment from where a milling cycle has left the tool: where it stands over its region is not "
	 "known; go to an absolute position in the plane first"},
	{"T1 D1 M6 G500 F6 G0 X0 Y0 Z10\nPOCKET2(10,0,2,-5,,20,50,60)\nG2 X0 Y0 CR=50\n", 3, 1,
	 "a circle from where a milling cycle has left the tool: where it stands over its region is not known; go "
	 "to an absolute position in the plane first"},
	{"T1 D1 M6 G500 F6 G0 X0 Y0 Z10\nPOCKET2(10,0,2,-5,,20,50,60)\nG1 G41 X0 Y0\n", 3, 4,
	 "tool radius compensation from where a milling cycle has left the tool: where it stands over its region "
	 "is not known; go to an absolute position in the plane first"},
	{"T1 D1 M6 G500 F6 G0 X0 Y0 Z10\nPOCKET2(10,0,2,-5,,20,50,60)\nG110 X0 Y0\n", 3, 1,
	 "a pole (G110) from where a milling cycle has left the tool: where it stands over its region is not "
	 "known; go to an absolute position in the plane first"},
	{"T1 D1 M6 G500 F6 G0 X0 Y0 Z10\nPOCKET2(10,0,2,-5,,20,50,60)\nR1=$AA_IW[X]\n", 3, 4,
	 "a position from where a milling cycle has left the tool: where it stands over its region is not known; "
	 "go to an absolute position in the plane first"},
	{"T1 D1 M6 G500 F6 G0 X0 Y0 Z10\nPOCKET2(10,0,2,-5,,20,50,60)\nHOLES1(0,0,0,10,5,2)\n", 3, 1,
	 "HOLES1 from where a milling cycle has left the tool: where it stands over its region is not known; go "
	 "to an absolute position in the plane first"},
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

START_TEST(refused)
{
	sinumerik_refuses(&bad[_i]);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("gcode_sinumerik_region");
	TCase *tcase = tcase_create("programs");
	SRunner *runner;
	int failed;

	tcase_add_loop_test(tcase, moves, 0, sizeof(programs) / sizeof(programs[0]));
	tcase_add_loop_test(tcase, refused, 0, sizeof(bad) / sizeof(bad[0]));
	suite_add_tcase(suite, tcase);
	runner = srunner_create(suite);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
