/* test_gcode_klartext_path.c - Klartext: circles, corners, coordinates and planes, by hand and closed forms. */
#include "klartext_case.h"

/* CC, C, CR, CT, LP, CP, RND, CHF. */
static const struct klartext_program circles[] = {
	/* FK blocks that determine their element alone: by its end, an angle with a length or a coordinate, FPOL. */
	{"F100\nFL X+10 Y+5\nFL AN+90 LEN5\nFL AN+0 X+30\nFL AN 45 Y+20\nFL AN+45 LEN2 X+41.414\n",
	 "feed 10 5 0 0 0\nfeed 10 10 0 0 0\nfeed 30 10 0 0 0\nfeed 40 20 0 0 0\nfeed 41.414 21.414 0 0 0\n"},
	{"F100\nFPOL X+20 Y+20\nFL PR+10 PA+90\nFC DR- CCPR+0 CCPA+0 PR+10 PA+0\nFC DR+ CCX+20 CCY+20 R10 CCA90\n",
	 "feed 20 30 0 0 0\narc 30 20 0 0 0 centre 20 20 0 normal 0 0 1 sweep -90\n"
	 "arc 20 30 0 0 0 centre 20 20 0 normal 0 0 1 sweep 90\n"},
	/* Tangential elements, by the radius or by the end. */
	{"L X+10 F100\nFCT DR+ R5 CCA90\nFLT Y+20\nFCT DR+ X+5 Y+30\nFCT DR- R10 CCA180\n",
	 "feed 10 0 0 0 0\narc 15 5 0 0 0 centre 10 5 0 normal 0 0 1 sweep 90\nfeed 15 20 0 0 0\n"
	 "arc 5 30 0 0 0 centre 5 20 0 normal 0 0 1 sweep 90\narc 5 50 0 0 0 centre 5 40 0 normal 0 0 1 sweep -180\n"},
	/*
	 * The circles of the next blocks determine where an element ends: tangents on the same side of both circles; a
	 * tangent that crosses between two circles of radius 15 whose centres are 50 apart, from (9, 12) to (41, -12);
	 * circles that touch each other from outside and from inside. CLSD- ends where CLSD+ has begun.
	 */
	{"L X-10 F100\nFC DR- R10 CLSD+ CCX+0 CCY+0\n; comment\nFLT\n3 FCT DR- R10 CCX+40 CCY+0\n4 * - part\n5 FLT\n"
	 "FCT DR- R10 CLSD- CCX+0 CCY+0\n",
	 "feed -10 0 0 0 0\narc 0 10 0 0 0 centre 0 0 0 normal 0 0 1 sweep -90\nfeed 40 10 0 0 0\n"
	 "arc 40 -10 0 0 0 centre 40 0 0 normal 0 0 1 sweep -180\nfeed 0 -10 0 0 0\n"
	 "arc -10 0 0 0 0 centre 0 0 0 normal 0 0 1 sweep -90\n"},
	{"L Y+15 F100\nFC DR- R15 CCX+0 CCY+0\nFLT\nFCT DR+ R15 CCX+50 CCY+0 X+65 Y+0\n",
	 "feed 0 15 0 0 0\narc 9 12 0 0 0 centre 0 0 0 normal 0 0 1 sweep -36.8698976\nfeed 41 -12 0 0 0\n"
	 "arc 65 0 0 0 0 centre 50 0 0 normal 0 0 1 sweep 126.869898\n"},
	{"FPOL X+10 Y+0\nL Y+20 F100\nFC DR- R20 CCX+0 CCY+0\nFCT DR+ R10 CCPR+20 CCPA+0 CCA90\n",
	 "feed 0 20 0 0 0\narc 20 0 0 0 0 centre 0 0 0 normal 0 0 1 sweep -90\n"
	 "arc 30 -10 0 0 0 centre 30 0 0 normal 0 0 1 sweep 90\n"},
	{"L Y+20 F100\nFC DR- R20 CCX+0 CCY+0\nFCT DR- R5 CCX+15 CCY+0 CCA90\n",
	 "feed 0 20 0 0 0\narc 20 0 0 0 0 centre 0 0 0 normal 0 0 1 sweep -90\n"
	 "arc 15 -5 0 0 0 centre 15 0 0 normal 0 0 1 sweep -90\n"},
	{"Q1=18\nFC DR- RQ1 CCXQ1 CCY+0 X+18 Y+18 F100\nRND R2\nFLT X+50\n",
	 "arc 18 18 0 0 0 centre 18 0 0 normal 0 0 1 sweep -90\nfeed 50 18 0 0 0\n"},
	{"L X+10 Y+0 F100\nCC X+0 Y+0\nC X+0 Y+10 DR+\n",
	 "feed 10 0 0 0 0\narc 0 10 0 0 0 centre 0 0 0 normal 0 0 1 sweep 90\n"},
	{"L X+10 Y+0 F100\nCC X+0 Y+0\nC X+0 Y+10 DR-\n",
	 "feed 10 0 0 0 0\narc 0 10 0 0 0 centre 0 0 0 normal 0 0 1 sweep -270\n"},
	{"L X+10 Y+0 F100\nCC X+0 Y+0\nC X+10 Y+0 DR+\n",
	 "feed 10 0 0 0 0\narc 10 0 0 0 0 centre 0 0 0 normal 0 0 1 sweep 360\n"},
	{"L X+10 F100\nCC IX-10 IY+0\nC X-10 DR-\n",
	 "feed 10 0 0 0 0\narc -10 0 0 0 0 centre 0 0 0 normal 0 0 1 sweep -180\n"},
	{"L X+10 Y+5 F100\nCC\nL X+20 Y+5\nC X+10 Y+15 DR+\n",
	 "feed 10 5 0 0 0\nfeed 20 5 0 0 0\narc 10 15 0 0 0 centre 10 5 0 normal 0 0 1 sweep 90\n"},
	{"L X+10 Y+0 F100\nCC X+0\nCC Y+0\nC X+0 Y+10 DR+\n",
	 "feed 10 0 0 0 0\narc 0 10 0 0 0 centre 0 0 0 normal 0 0 1 sweep 90\n"},
	{"L X+10 Z+0 F100\nCC X+0 Z+0\nC X+0 Z+10 DR-\n",
	 "feed 10 0 0 0 0\narc 0 0 10 0 0 centre 0 0 0 normal 0 1 0 sweep -90\n"},
	{"L Y+10 F100\nCC Y+0 Z+0\nC Y+0 Z+10 DR+\n",
	 "feed 0 10 0 0 0\narc 0 0 10 0 0 centre 0 0 0 normal 1 0 0 sweep 90\n"},
	/*
	 * CC with X, Y and Z: the plane of the tool axis if the circle lies in it, else the only plane in which it
	 * lies.
	 */
	{"L X+10 Z+5 F100\nCC X+0 Y+0 Z+5\nC X+10 Y+0 DR-\n",
	 "feed 10 0 5 0 0\narc 10 0 5 0 0 centre 0 0 5 normal 0 0 1 sweep -360\n"},
	{"L X+10 Z+5 F100\nCC X+0 Y+0 Z+0\nC X+0 Y+10 Z+5 DR+\n",
	 "feed 10 0 5 0 0\narc 0 10 5 0 0 centre 0 0 5 normal 0 0 1 sweep 90\n"},
	{"L X+10 F100\nCC X+0 Y+0 Z+0\nC X+0 Y+0 Z+10 DR-\n",
	 "feed 10 0 0 0 0\narc 0 0 10 0 0 centre 0 0 0 normal 0 1 0 sweep -90\n"},
	{"L Y+10 F100\nCC X+0 Y+0 Z+0\nC X+0 Y+0 Z+10 DR+\n",
	 "feed 0 10 0 0 0\narc 0 0 10 0 0 centre 0 0 0 normal 1 0 0 sweep 90\n"},
	{"F100\nCR X+10 Y+10 R+10 DR+\n",
	 "arc 10 10 0 0 0 centre 0 10 0 normal 0 0 1 sweep 90\n"},
	{"F100\nCR X+10 Y+10 R-10 DR-\n",
	 "arc 10 10 0 0 0 centre 0 10 0 normal 0 0 1 sweep -270\n"},
	{"F100\nCR X+20 Y+0 R10 DR-\n",
	 "arc 20 0 0 0 0 centre 10 0 0 normal 0 0 1 sweep -180\n"},
	{"L X+10 F100\nCT X+20 Y+10\n",
	 "feed 10 0 0 0 0\narc 20 10 0 0 0 centre 10 10 0 normal 0 0 1 sweep 90\n"},
	{"L X+10 F100\nCT X+20 Y+0\n",
	 "feed 10 0 0 0 0\nfeed 20 0 0 0 0\n"},
	{"L X+10 F100\nCT X+20 Y-10\nCT X+30 Y-20\n",
	 "feed 10 0 0 0 0\narc 20 -10 0 0 0 centre 10 -10 0 normal 0 0 1 sweep -90\n"
	 "arc 30 -20 0 0 0 centre 30 -10 0 normal 0 0 1 sweep 90\n"},
	{"L X+10 F100\nCC X+10 Y+10\nC X+20 Y+10 DR+\nCT X+10 Y+20\n",
	 "feed 10 0 0 0 0\narc 20 10 0 0 0 centre 10 10 0 normal 0 0 1 sweep 90\n"
	 "arc 10 20 0 0 0 centre 10 10 0 normal 0 0 1 sweep 90\n"},
	{"CC X+0 Y+0\nLP PR+10 PA+30 F100\n",
	 "feed 8.66025404 5 0 0 0\n"},
	{"CC X+5 Y+5\nLP PR+10 PA+0 FMAX\nLP IPA+90 F100\nLP PR+5\nLP IPR+1 PA+180\n",
	 "rapid 15 5 0 0 0\nfeed 5 15 0 0 0\nfeed 5 10 0 0 0\nfeed -1 5 0 0 0\n"},
	{"CC X+0 Y+0\nLP PR+10 PA+0 F100\nCP PA+90 DR+\n",
	 "feed 10 0 0 0 0\narc 0 10 0 0 0 centre 0 0 0 normal 0 0 1 sweep 90\n"},
	{"CC X+0 Y+0\nLP PR+10 PA+0 F100\nCP IPA+1080 IZ-9 DR+\n",
	 "feed 10 0 0 0 0\narc 10 0 -9 0 0 centre 0 0 0 normal 0 0 1 sweep 1080\n"},
	{"CC X+0 Y+0\nLP PR+10 PA+0 F100\nCP IPA-90 IZ+2 DR-\n",
	 "feed 10 0 0 0 0\narc 0 -10 2 0 0 centre 0 0 0 normal 0 0 1 sweep -90\n"},
	{"CC X+0 Y+0\nLP PR+10 PA+0 F100\nCP PA+90 Z-5 DR-\n",
	 "feed 10 0 0 0 0\narc 0 10 -5 0 0 centre 0 0 0 normal 0 0 1 sweep -270\n"},
	{"CC X+0 Y+0\nLP PR+10 PA+0 F100\nLP PR+10 PA+90\nCTP PR+5 PA+180\n",
	 "feed 10 0 0 0 0\nfeed 0 10 0 0 0\n"
	 "arc -5 0 0 0 0 centre -4.16666667 5.83333333 0 normal 0 0 1 sweep 216.869898\n"},
	{"CC X+0 Y+0\nLP PR+10 PA+0 F100\nCP IPA+360 DR+\n",
	 "feed 10 0 0 0 0\narc 10 0 0 0 0 centre 0 0 0 normal 0 0 1 sweep 360\n"},
	{"F100\nL X+10\nRND R2\nL Y+10\n",
	 "feed 8 0 0 0 0\narc 10 2 0 0 0 centre 8 2 0 normal 0 0 1 sweep 90\nfeed 10 10 0 0 0\n"},
	{"F100\nL X+10\nRND R2 F50\nL Y-10\nL X+0\n",
	 "feed 8 0 0 0 0\narc 10 -2 0 0 0 centre 8 -2 0 normal 0 0 1 sweep -90\nfeed 10 -10 0 0 0\n"
	 "feed 0 -10 0 0 0\n"},
	{"F100\nL X+10\nCHF 2\nL Y+10\n",
	 "feed 8 0 0 0 0\nfeed 10 2 0 0 0\nfeed 10 10 0 0 0\n"},
	{"F100\nL X+10\n5 RND R2\nL Y+10\nRND R3\nL X+0\n",
	 "feed 8 0 0 0 0\narc 10 2 0 0 0 centre 8 2 0 normal 0 0 1 sweep 90\nfeed 10 7 0 0 0\n"
	 "arc 7 10 0 0 0 centre 7 7 0 normal 0 0 1 sweep 90\nfeed 0 10 0 0 0\n"},
	{"F100\nL X+10\nRND R1\nL X+20\n",
	 "feed 10 0 0 0 0\nfeed 20 0 0 0 0\n"},
};

/* CYCL DEF 7, 8, 9, 10, 11, 13, 19, 26, 32. */
static const struct klartext_program frames[] = {
	{"CYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 X+10\nCYCL DEF 7.2 Y+20\nCYCL DEF 7.3 Z-5\n"
	 "L X+1 Y+1 Z+1 FMAX\n",
	 "rapid 11 21 -4 0 0\n"},
	{"CYCL DEF 7.0\nCYCL DEF 7.1 X+10\nL X+0 FMAX\nCYCL DEF 7.0\nCYCL DEF 7.1 IX+5\nL X+0 FMAX\n"
	 "CYCL DEF 7.0\nCYCL DEF 7.1 X+0\nL X+0 FMAX\n",
	 "rapid 10 0 0 0 0\nrapid 15 0 0 0 0\nrapid 0 0 0 0 0\n"},
	{"CYCL DEF 7.0\nCYCL DEF 7.1 C+30\nL C+10 FMAX\n",
	 "rapid 0 0 0 0 40\n"},
	{"CYCL DEF 8.0 MIRROR IMAGE\nCYCL DEF 8.1 X\nL X+1 Y+2 FMAX\nCYCL DEF 8.0\nCYCL DEF 8.1\n"
	 "L X+1 Y+2 FMAX\n",
	 "rapid -1 2 0 0 0\nrapid 1 2 0 0 0\n"},
	{"CYCL DEF 8.0\nCYCL DEF 8.1 X Y\nL X+1 Y+2 FMAX\n",
	 "rapid -1 -2 0 0 0\n"},
	{"CYCL DEF 8.0\nCYCL DEF 8.1 X\nL X+10 F100\nCC X+0 Y+0\nC X+0 Y+10 DR+\n",
	 "feed -10 0 0 0 0\narc 0 10 0 0 0 centre 0 0 0 normal 0 0 1 sweep -90\n"},
	{"CYCL DEF 10.0 ROTATION\nCYCL DEF 10.1 ROT+90\nL X+1 Y+2 FMAX\nCYCL DEF 10.0\n"
	 "CYCL DEF 10.1 ROT+0\nL X+1 Y+2 FMAX\n",
	 "rapid -2 1 0 0 0\nrapid 1 2 0 0 0\n"},
	{"CYCL DEF 7.0\nCYCL DEF 7.1 X+10\nCYCL DEF 10.0\nCYCL DEF 10.1 ROT+90\nL X+1 Y+2 FMAX\n"
	 "CYCL DEF 10.0\nCYCL DEF 10.1 IROT+90\nL X+1 Y+2 FMAX\n",
	 "rapid 8 1 0 0 0\nrapid 9 -2 0 0 0\n"},
	{"CYCL DEF 10.0\nCYCL DEF 10.1 ROT+90\nL X+10 F100\nCC X+0 Y+0\nC X+0 Y+10 DR+\n",
	 "feed 0 10 0 0 0\narc -10 0 0 0 0 centre 0 0 0 normal 0 0 1 sweep 90\n"},
	/* A preset cancels the shift. */
	{"CYCL DEF 7.0\nCYCL DEF 7.1 X+5 C+10\nL X+0 C+0 FMAX\nCYCL DEF 247 Q339=1\nL X+1 C+0 FMAX\n",
	 "rapid 5 0 0 0 10\nrapid 1 0 0 0 0\n"},
	{"CYCL DEF 26.0 AXIS-SPECIFIC SCALING\nCYCL DEF 26.1 X2 Y0.5\nL X+1 Y+2 Z+3 FMAX\n",
	 "rapid 2 1 3 0 0\n"},
	{"CYCL DEF 26.0\nCYCL DEF 26.1 X2 Y2 CCX+10 CCY+0\nL X+11 Y+1 FMAX\n",
	 "rapid 12 2 0 0 0\n"},
	{"CYCL DEF 11.0 SCALING\nCYCL DEF 11.1 SCL 1\nL X+1 FMAX\n",
	 "rapid 1 0 0 0 0\n"},
	{"CYCL DEF 26.0\nCYCL DEF 26.1 X2 Y2 Z2\nL X+10 F100\nCC X+0 Y+0\nC X+0 Y+10 DR+\n",
	 "feed 20 0 0 0 0\narc 0 20 0 0 0 centre 0 0 0 normal 0 0 1 sweep 90\n"},
	{"CYCL DEF 7.0\nCYCL DEF 7.1 X+10\nL X+0 FMAX\nL IX+1 FMAX\nCYCL DEF 7.0\nCYCL DEF 7.1 X+0\n"
	 "L X+2 IY+1 FMAX\nL IX+1 FMAX\n",
	 "rapid 10 0 0 0 0\nrapid 11 0 0 0 0\nrapid 2 1 0 0 0\nrapid 3 1 0 0 0\n"},
	{"CYCL DEF9 .0 DWELL TIME\nCYCL DEF9.1 V.ZEIT 1.5\n",
	 "dwell 1.5\n"},
	{"CYCL DEF 9.0 DWELL TIME\nCYCL DEF 9.1 DWELL 2\n",
	 "dwell 2\n"},
	{"CYCL DEF 13.0 ORIENTATION\nCYCL DEF 13.1 ANGLE 180\nL X+1 FMAX\n",
	 "rapid 1 0 0 0 0\n"},
};

/* PLANE, M128, TCPM, M91, M140: the case's A tilts the tool to (0, sin A, cos A), C turns the table. */
static const struct klartext_program planes[] = {
	{"Q1 = SGN -4 * SGN 3\nQ2 = LOG 1000\nQ3 = LN EXP 2\nL X+Q1 Y+Q2 Z+Q3 FMAX\n",
	 "rapid -1 3 2 0 0\n"},
	{"CYCL DEF 32.0 TOLERANCE\nCYCL DEF 32.1 T0.05\nCYCL DEF 32.2 HSC-MODE:1 TA0.5\nL X+1 FMAX\n"
	 "CYCL DEF 32.0\nCYCL DEF 32.1\nL X+2 FMAX\n",
	 "rapid 1 0 0 0 0\nrapid 2 0 0 0 0\n"},
	{"CYCL DEF 19.0 WORKING PLANE\nCYCL DEF 19.1 A+0 B+0 C+0\nCYCL DEF 19.0\nCYCL DEF 19.1\n"
	 "L X+1 FMAX\n",
	 "rapid 1 0 0 0 0\n"},
	{"CYCL DEF 19.0 WORKING PLANE\nCYCL DEF 19.1 A-90 B+0 C+0\nL A+Q120 C+Q122 FMAX\n"
	 "L X+1 Y+2 Z+3 FMAX\nCYCL DEF 19.0\nCYCL DEF 19.1 A+0 B+0 C+0\nCYCL DEF 19.0\nCYCL DEF 19.1\n"
	 "L Z+9 FMAX\n",
	 "orient 0 1 0\nrapid 0 0 0 90 0\ntcp on length 0 zero A0 C0\nrapid 1 3 -2 90 0 tcp\n"
	 "tcp off length 0 zero A0 C0\nrapid 1 3 9 90 0\n"},
	/* An angle of cycle 19 that is left out keeps its value. */
	{"CYCL DEF 19.0\nCYCL DEF 19.1 A-90 B+0 C+0\nL A+Q120 C+Q122 FMAX\nCYCL DEF 19.0\nCYCL DEF 19.1 B+0 C+0\n"
	 "L X+1 Y+2 Z+3 FMAX\n",
	 "orient 0 1 0\nrapid 0 0 0 90 0\ntcp on length 0 zero A0 C0\ntcp off length 0 zero A0 C0\norient 0 1 0\n"
	 "tcp on length 0 zero A0 C0\nrapid 1 3 -2 90 0 tcp\n"},
	{"PLANE SPATIAL SPA-30 SPB+0 SPC+0 TURN FMAX\nL X+0 Y+10 Z+0 FMAX\n",
	 "orient 0 0.5 0.866025404\nrapid 0 0 0 30 0\ntcp on length 0 zero A0 C0\n"
	 "rapid 0 8.66025404 -5 30 0 tcp\n"},
	/*
	 * TABLE ROT turns the table until the tilted X lies along the X of the machine; C turns in the opposite sense.
	 */
	{"PLANE SPATIAL SPA+0 SPB+0 SPC+30 TURN FMAX TABLE ROT\nL X+10 Y+0 Z+0 FMAX\n",
	 "orient 0 0 1\nrapid 0 0 0 0 -30\ntcp on length 0 zero A0 C0\nrapid 8.66025404 5 0 0 -30 tcp\n"},
	{"L C+20 FMAX\nPLANE SPATIAL SPA+0 SPB+0 SPC+0 TURN FMAX TABLE ROT\nL X+10 Y+0 Z+0 FMAX\n",
	 "rapid 0 0 0 0 20\norient 0 0 1\nrapid 0 0 0 0 0\ntcp on length 0 zero A0 C0\nrapid 10 0 0 0 0 tcp\n"},
	{"PLANE SPATIAL SPA-30 SPB+0 SPC+0 TURN FMAX SYM+\nL X+0 Y+10 Z+0 FMAX\n",
	 "orient 0 0.5 0.866025404\nrapid 0 0 0 30 0\ntcp on length 0 zero A0 C0\n"
	 "rapid 0 8.66025404 -5 30 0 tcp\n"},
	/* By positions of the axes: the coordinates do not turn with the table. */
	{"PLANE AXIAL A+30 TURN FMAX\nL X+0 Y+10 Z+0 FMAX\n",
	 "rapid 0 0 0 30 0\ntcp on length 0 zero A0 C0\nrapid 0 8.66025404 -5 30 0 tcp\n"},
	/* An increment counts from the position of the axis. */
	{"L A+10 FMAX\nPLANE AXIAL IA+20 IC+0 TURN FMAX\nL X+0 Y+10 Z+0 FMAX\n",
	 "rapid 0 0 0 10 0\nrapid 0 0 0 30 0\ntcp on length 0 zero A0 C0\nrapid 0 8.66025404 -5 30 0 tcp\n"},
	{"PLANE AXIAL A+0 C+90 STAY\nL C+90 FMAX\nL X+10 Y+0 FMAX\nPLANE RESET STAY\n",
	 "rapid 0 0 0 0 90\ntcp on length 0 zero A0 C0\nrapid 0 -10 0 0 90 tcp\ntcp off length 0 zero A0 C0\n"},
	{"PLANE SPATIAL SPA-90 SPB+0 SPC+0 STAY\nL A+Q120 C+Q122 FMAX\nL X+1 Y+2 Z+3 FMAX\n",
	 "orient 0 1 0\nrapid 0 0 0 90 0\ntcp on length 0 zero A0 C0\nrapid 1 3 -2 90 0 tcp\n"},
	{"PLANE SPATIAL SPA-90 SPB+0 SPC+0 TURN F1000\nL X+1 Y+2 Z+3 FMAX\nPLANE RESET STAY\nL Z+9 FMAX\n"
	 "PLANE RESET TURN FMAX\n",
	 "orient 0 1 0\nfeed 0 0 0 90 0\ntcp on length 0 zero A0 C0\nrapid 1 3 -2 90 0 tcp\n"
	 "tcp off length 0 zero A0 C0\nrapid 1 3 9 90 0\nrapid 1 3 9 0 0\n"},
	/* The same plane by vectors: X (0 cos30 -sin30), N (0 sin30 cos30). */
	{"PLANE PROJECTED PROPR+0 PROMIN-30 ROT+90 TURN FMAX\nL X+1 Y+2 Z+3 FMAX\n",
	 "orient 0 0.5 0.866025404\nrapid 0 0 0 30 0\ntcp on length 0 zero A0 C0\nrapid -2 2.3660254 2.09807621 30 0 tcp\n"},
	{"PLANE VECTOR BX+0 BY+0.866025404 BZ-0.5 NX+0 NY+0.5 NZ+0.866025404 TURN FMAX\nL X+1 Y+2 Z+3 FMAX\n",
	 "orient 0 0.5 0.866025404\nrapid 0 0 0 30 0\ntcp on length 0 zero A0 C0\nrapid -2 2.3660254 2.09807621 30 0 tcp\n"},
	{"PLANE EULER EULPR+0 EULNU-90 EULROT+0 TURN FMAX\nL Y+5 FMAX\n",
	 "orient 0 1 0\nrapid 0 0 0 90 0\ntcp on length 0 zero A0 C0\nrapid 0 0 -5 90 0 tcp\n"},
	{"PLANE VECTOR BX+1 BY+0 BZ+0 NX+0 NY+1 NZ+0 TURN FMAX\nL X+1 Y+2 Z+3 FMAX\n",
	 "orient 0 1 0\nrapid 0 0 0 90 0\ntcp on length 0 zero A0 C0\nrapid 1 3 -2 90 0 tcp\n"},
	{"PLANE POINTS P1X+0 P1Y+0 P1Z+0 P2X+10 P2Y+0 P2Z+0 P3X+0 P3Y+0 P3Z-10 TURN FMAX\n"
	 "L X+1 Y+2 Z+3 FMAX\n",
	 "orient 0 1 0\nrapid 0 0 0 90 0\ntcp on length 0 zero A0 C0\nrapid 1 3 -2 90 0 tcp\n"},
	{"PLANE SPATIAL SPA-45 SPB+0 SPC+0 TURN FMAX\nPLANE RELATIVE SPA-45 TURN FMAX\n"
	 "L X+1 Y+2 Z+3 FMAX\n",
	 "orient 0 0.707106781 0.707106781\nrapid 0 0 0 45 0\ntcp on length 0 zero A0 C0\n"
	 "tcp off length 0 zero A0 C0\norient 0 1 0\nrapid 0 0 0 90 0\ntcp on length 0 zero A0 C0\n"
	 "rapid 1 3 -2 90 0 tcp\n"},
	{"PLANE SPATIAL SPA+0 SPB+0 SPC+90 TURN FMAX COORD ROT\nL X+1 Y+2 FMAX\n",
	 "orient 0 0 1\nrapid 0 0 0 0 0\ntcp on length 0 zero A0 C0\nrapid -2 1 0 0 0 tcp\n"},
	{"CYCL DEF 7.0\nCYCL DEF 7.1 X+10\nPLANE SPATIAL SPA-90 SPB+0 SPC+0 TURN FMAX\nCYCL DEF 7.0\n"
	 "CYCL DEF 7.1 Z+5\nL X+1 Y+2 Z+3 FMAX\n",
	 "orient 0 1 0\nrapid 0 0 0 90 0\ntcp on length 0 zero A0 C0\nrapid 11 8 -2 90 0 tcp\n"},
	/*
	 * The shift is cancelled in the plane and again after it, as posts do at the end of a job and before the next
	 * one.
	 */
	{"CYCL DEF 7.0\nCYCL DEF 7.1 X+10\nPLANE SPATIAL SPA-90 SPB+0 SPC+0 TURN FMAX\nCYCL DEF 7.0\nCYCL DEF 7.1 X+0\n"
	 "PLANE RESET STAY\nCYCL DEF 7.0\nCYCL DEF 7.1 X+0\nL X+1 Y+2 FMAX\n",
	 "orient 0 1 0\nrapid 0 0 0 90 0\ntcp on length 0 zero A0 C0\ntcp off length 0 zero A0 C0\nrapid 1 2 0 90 0\n"},
	{"PLANE SPATIAL SPA-90 SPB+0 SPC+0 TURN FMAX\nF100\nL X+10 Y+0\nCC X+0 Y+0\nC X+0 Y+10 DR+\n",
	 "orient 0 1 0\nrapid 0 0 0 90 0\ntcp on length 0 zero A0 C0\nfeed 10 0 0 90 0 tcp\n"
	 "arc 0 0 -10 90 0 centre 0 0 0 normal 0 1 0 sweep 90 tcp\n"},
	{"PLANE SPATIAL SPA-90 SPB+0 SPC+0 TURN FMAX\nL Z+5 FMAX\nL Z+1 FMAX M91\nL Z+5 FMAX\n",
	 "orient 0 1 0\nrapid 0 0 0 90 0\ntcp on length 0 zero A0 C0\nrapid 0 5 0 90 0 tcp\n"
	 "tcp off length 0 zero A0 C0\nrapid 0 5 1 90 0\ntcp on length 0 zero A0 C0\n"
	 "rapid 0 5 1 90 0 tcp\n"},
	{"PLANE SPATIAL SPA-90 SPB+0 SPC+0 MOVE DIST10 FMAX\nL Z+5 FMAX\n",
	 "orient 0 1 0\ntcp on length 10 zero A0 C0\nrapid 0 0 -10 90 0 tcp\n"
	 "tcp off length 10 zero A0 C0\ntcp on length 0 zero A0 C0\nrapid 0 5 0 90 0 tcp\n"},
	{"PLANE SPATIAL SPA-90 SPB+0 SPC+0 TURN FMAX\nL M128\nL X+1 FMAX\nM129\nL X+2 FMAX\n",
	 "orient 0 1 0\nrapid 0 0 0 90 0\ntcp on length 0 zero A0 C0\ntcp on length 0 zero A0 C0\n"
	 "rapid 1 0 0 90 0 tcp\ntcp on length 0 zero A0 C0\nrapid 2 0 0 90 0 tcp\n"},
	{"PLANE SPATIAL SPA-90 SPB+0 SPC+0 TURN FMAX SEQ+\nL X+1 FMAX\n",
	 "orient 0 1 0\nrapid 0 0 0 90 0\ntcp on length 0 zero A0 C0\nrapid 1 0 0 90 0 tcp\n"},
	{"TOOL CALL 1 Z\nL C+90 FMAX\nL M128\nL X+5 Y+0 Z+0 FMAX\nM129\nL X+1 FMAX\nL IX+1 FMAX\n",
	 "tool 1\nrapid 0 0 0 0 90\ntcp on length 100 zero A0 C0\nrapid 5 0 0 0 90 tcp\n"
	 "tcp off length 100 zero A0 C0\nrapid 1 5 100 0 90\nrapid 2 5 100 0 90\n"},
	{"L M128 F1000\nL X+10 C+90 F500\nL M129\n",
	 "tcp on length 0 zero A0 C0\nfeed 10 0 0 0 90 tcp\ntcp off length 0 zero A0 C0\n"},
	/*
	 * The tool turns in the plane of the two directions, in pieces of at most a third of the turn; an axis that
	 * does not turn gets its end position at once.
	 */
	{"FUNCTION TCPM F TCP AXIS POS PATHCTRL VECTOR REFPNT TIP-TIP F1000\nL X+8 A+40 F500\nL X+9 A+40\n"
	 "FUNCTION TCPM F CONT AXIS POS PATHCTRL AXIS FMAX\nL X+0 A+0\n",
	 "tcp on length 0 zero A0 C0\n"
	 "feed 2 0 0 10 0 tcp\n"
	 "feed 4 0 0 20 0 tcp\n"
	 "feed 6 0 0 30 0 tcp\n"
	 "feed 8 0 0 40 0 tcp\n"
	 "feed 9 0 0 40 0 tcp\n"
	 "feed 0 0 0 0 0 tcp\n"},
	{"FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS\nL X+10 C+90 F500\nFUNCTION RESET TCPM\nL X+0 FMAX\n",
	 "tcp on length 0 zero A0 C0\nfeed 10 0 0 0 90 tcp\ntcp off length 0 zero A0 C0\n"
	 "rapid 0 10 0 0 90\n"},
	{"L X+1 C+10 FMAX M128\nL X+2 FMAX M129\nL X+3 FMAX\n",
	 "tcp on length 0 zero A0 C0\nrapid 1 0 0 0 10 tcp\nrapid 2 0 0 0 10 tcp\n"
	 "tcp off length 0 zero A0 C0\nrapid 3 0.347296355 0 0 10\n"},
	{"M126\nL C+170 FMAX\nM127\nL C+10 FMAX\n",
	 "rapid 0 0 0 0 170\nrapid 0 0 0 0 10\n"},
	{"M138 A C\nL X+1 FMAX\n",
	 "rapid 1 0 0 0 0\n"},
	{"L Z+50 FMAX\nM140 MB MAX F9999\nM140 MB50\n",
	 "rapid 0 0 50 0 0\nrapid 0 0 500 0 0\nrapid 0 0 550 0 0\n"},
	{"L X+5 M91 FMAX\nL X+5 FMAX\n",
	 "rapid 5 0 0 0 0\nrapid 5 0 0 0 0\n"},
	{"TOOL CALL 1 Z\nL Z+0 FMAX M91\nL Z+0 FMAX\n",
	 "tool 1\nrapid 0 0 0 0 0\nrapid 0 0 100 0 0\n"},
	{"CYCL DEF 7.0\nCYCL DEF 7.1 X+100\nL X+5 R0 FMAX M91\nL X+5 FMAX\n",
	 "rapid 5 0 0 0 0\nrapid 105 0 0 0 0\n"},
	{"FUNCTION MODE MILL\nL X+1 FMAX\n",
	 "rapid 1 0 0 0 0\n"},
	{"M94 C\nL C+5 FMAX\n",
	 "rapid 0 0 0 0 5\n"},
	{"LN X+1 Y+2 Z+3 NX+0 NY+0 NZ+1 F100 M128\n",
	 "tcp on length 0 zero A0 C0\nfeed 1 2 3 0 0 tcp\n"},
};

/* Blocks with tool directions, and uncertain paths. */
static const struct klartext_program directed[] = {
	/* A circle that may lie in YZ or in ZX: anywhere about its centre, also if a later CC does not name Z. */
	{"L X+1 Y+2 Z+10 F100\nCC X+1 Y+2 Z+5\nC X+1 Y+2 Z+0 DR+\nC Z+0 DR-\nCC X+1 Y+2\nC X+1 Y+2 Z+10 DR-\n",
	 "feed 1 2 10 0 0\nfeed 1 2 0 0 0 spread 5.016 5.016 10.016\nfeed 1 2 0 0 0 spread 5.016 5.016 10.016\n"
	 "feed 1 2 10 0 0 spread 5.016 5.016 10.016\n"},
	/* LN with a direction: M128 turns the axes; without words of axes, too. */
	{"M128\nLN X+1 Y+2 NX+0 NY+0 NZ+1 TX+0 TY+0.5 TZ+0.866025404 F100\nLN TX+0 TY+0 TZ+1\n",
	 "tcp on length 0 zero A0 C0\norient 0 0.5 0.866025404\nfeed 1 2 0 30 0 tcp\norient 0 0 1\nfeed 1 2 0 0 0 tcp\n"},
	/*
	 * AXIS SPAT: the same by angles, each of which is in force until it changes; with M128, A and C are positions
	 * of the axes again.
	 */
	{"FUNCTION TCPM F TCP AXIS SPAT PATHCTRL AXIS\nL X+1 Y+2 A-30 B+0 C+0 F100\nL A+0\nM128\nL A+5\n",
	 "tcp on length 0 zero A0 C0\norient 0 0.5 0.866025404\nfeed 1 2 0 30 0 tcp\norient 0 0 1\nfeed 1 2 0 0 0 tcp\n"
	 "feed 1 2 0 5 0 tcp\n"},
};

START_TEST(circles_table)
{
	klartext_expect(&circles[_i], false);
}
END_TEST

START_TEST(frames_table)
{
	klartext_expect(&frames[_i], false);
}
END_TEST

START_TEST(planes_table)
{
	klartext_expect(&planes[_i], false);
}
END_TEST

START_TEST(directed_table)
{
	klartext_expect(&directed[_i], true);
}
END_TEST

/*
 * It is not known how evenly the tool turns, by up to 0.039 of this turn. Where C turns quickly, it may also do so in
 * the neighbouring pieces.
 */
START_TEST(vector_beside_pole)
{
	struct gcode_case c;

	klartext_case(&c);
	c.show_turn_spread = true;
	ck_assert(klartext_run(&c, "FUNCTION TCPM F TCP AXIS POS PATHCTRL VECTOR\nL X+8 A+80 C+90 F500\n"));
	ck_assert_str_eq(strbuf_text(&c.moves), "tcp on length 0 zero A0 C0\n"
			 "feed 2 0 0 20 0 turned by 3.1194 0.0000 0.0000 tcp\n"
			 "feed 4 0 0 40 0 turned by 3.1194 0.0000 14.0368 tcp\n"
			 "feed 6 0 0 60 90 turned by 3.1194 0.0000 14.0368 tcp\n"
			 "feed 8 0 0 80 90 turned by 3.1194 0.0000 14.0368 tcp\n");
	case_release(&c);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("gcode_klartext_path");

	tcase_add_loop_test(tcase, circles_table, 0, COUNT(circles));
	tcase_add_loop_test(tcase, frames_table, 0, COUNT(frames));
	tcase_add_loop_test(tcase, planes_table, 0, COUNT(planes));
	tcase_add_loop_test(tcase, directed_table, 0, COUNT(directed));
	tcase_add_test(tcase, vector_beside_pole);
	return run_suite("gcode_klartext_path", tcase);
}
