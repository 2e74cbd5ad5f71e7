/* test_gcode_klartext_path.c - Klartext: circles, corners, coordinates, planes, cycles, by hand and closed forms. */
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

/* CYCL DEF 1, 2, 17, 200 to 207, 240, 241, with their calls. */
static const struct klartext_program cycles[] = {
	{"CYCL DEF 200 DRILLING ~\n Q200=2 ;SET-UP ~\n Q201=-10 ~\n Q206=150 ~\n Q202=5 ~\n Q210=0 ~\n"
	 " Q203=+0 ~\n Q204=50 ~\n Q211=0.5\nL X+10 Y+20 R0 FMAX M99\n",
	 "rapid 10 20 0 0 0\nrapid 10 20 2 0 0\nfeed 10 20 -5 0 0\nrapid 10 20 2 0 0\nrapid 10 20 -3 0 0\n"
	 "feed 10 20 -10 0 0\ndwell 0.5\nrapid 10 20 2 0 0\nrapid 10 20 50 0 0\n"},
	{"CYCL DEF 200 DRILLING\nQ200=2\nQ201=-10\nQ206=150\nQ202=10\nQ210=0\nQ203=+5\nQ204=20\nQ211=0\n"
	 "5 L X+10 FMAX M99\n6 L X+20 FMAX M99\n",
	 "rapid 10 0 0 0 0\nrapid 10 0 7 0 0\nfeed 10 0 -5 0 0\nrapid 10 0 7 0 0\nrapid 10 0 25 0 0\n"
	 "rapid 20 0 25 0 0\nrapid 20 0 7 0 0\nfeed 20 0 -5 0 0\nrapid 20 0 7 0 0\nrapid 20 0 25 0 0\n"},
	{"CYCL DEF 200 DRILLING Q200=2 Q201=-4 Q206=150 Q202=4 Q203=+0 Q204=1\nL X+1 FMAX\nCYCL CALL M3\n",
	 "rapid 1 0 0 0 0\nrapid 1 0 2 0 0\nfeed 1 0 -4 0 0\nrapid 1 0 2 0 0\n"},
	{"CYCL DEF 200 DRILLING Q200=2 Q201=-4 Q206=150 Q202=4 Q203=+0 Q204=9\nL X+1 FMAX M89\n"
	 "L X+2 FMAX\nL X+3 FMAX M99\nL X+4 FMAX\n",
	 "rapid 1 0 0 0 0\nrapid 1 0 2 0 0\nfeed 1 0 -4 0 0\nrapid 1 0 2 0 0\nrapid 1 0 9 0 0\n"
	 "rapid 2 0 9 0 0\nrapid 2 0 2 0 0\nfeed 2 0 -4 0 0\nrapid 2 0 2 0 0\nrapid 2 0 9 0 0\n"
	 "rapid 3 0 9 0 0\nrapid 3 0 2 0 0\nfeed 3 0 -4 0 0\nrapid 3 0 2 0 0\nrapid 3 0 9 0 0\n"
	 "rapid 4 0 9 0 0\n"},
	/* A change of coordinates that does not move the pole: about it, along the tool, and there and back. */
	{"CC X+0 Y+0\nCYCL DEF 10.0\nCYCL DEF 10.1 ROT+90\nCYCL DEF 10.0\nCYCL DEF 10.1 ROT+0\nCYCL DEF 7.0\nCYCL DEF 7.1 X+5\n"
	 "CYCL DEF 7.0\nCYCL DEF 7.1 X+0\nCYCL DEF 7.2 Z-5\nLP PR+10 PA+90 FMAX\nL Z+0 FMAX\nLP IPA+90 FMAX\nCC Y+20\n"
	 "LP PR+20 PA+90 FMAX\n",
	 "rapid 0 10 0 0 0\nrapid 0 10 -5 0 0\nrapid -10 0 -5 0 0\nrapid 0 40 -5 0 0\n"},
	/* M89 also acts after polar coordinates and circles; a pole moves nothing. */
	{"CYCL DEF 200 DRILLING Q200=2 Q201=-4 Q206=150 Q202=4 Q203=+0 Q204=9\nCC X+0 Y+0\nLP PR+10 PA+0 FMAX M89\n"
	 "LP PA+90 FMAX\nCC X+5 Y+10\nLP PR+5 PA+0 FMAX M99\nLP PR+2 PA+0 FMAX\n",
	 "rapid 10 0 0 0 0\nrapid 10 0 2 0 0\nfeed 10 0 -4 0 0\nrapid 10 0 2 0 0\nrapid 10 0 9 0 0\n"
	 "rapid 0 10 9 0 0\nrapid 0 10 2 0 0\nfeed 0 10 -4 0 0\nrapid 0 10 2 0 0\nrapid 0 10 9 0 0\n"
	 "rapid 10 10 9 0 0\nrapid 10 10 2 0 0\nfeed 10 10 -4 0 0\nrapid 10 10 2 0 0\nrapid 10 10 9 0 0\n"
	 "rapid 7 10 9 0 0\n"},
	/* An empty line and a comment do not end what '~' continues: Q395=1 is the definition's. */
	{"TOOL CALL 2 Z S100\nCYCL DEF 200 DRILLING ~\n Q200=2 ~\n\n Q201=-4 ~\n Q206=150 ~\n Q202=9 ~\n Q203=+0 ~\n Q204=2 ~\n"
	 "; the tip goes deeper\n Q395=1\nL X+1 FMAX M99\n",
	 "tool 2\nrapid 1 0 0 0 0\nrapid 1 0 42 0 0\nfeed 1 0 33.5 0 0\nrapid 1 0 42 0 0\n"},
	/* With M128 a cycle works along Z while the tool lies along Z. */
	{"L M128\nCYCL DEF 200 DRILLING Q200=2 Q201=-4 Q206=150 Q202=4 Q203=+0 Q204=2\nL X+1 FMAX M99\n",
	 "tcp on length 0 zero A0 C0\nrapid 1 0 0 0 0 tcp\nrapid 1 0 2 0 0 tcp\nfeed 1 0 -4 0 0 tcp\n"
	 "rapid 1 0 2 0 0 tcp\n"},
	/*
	 * A dwell that differs from the definition, as some posts write it in a block of its own, does not change the
	 * path.
	 */
	{"10 CYCL DEF 200 DRILLING Q200=2 Q201=-4 Q206=150 Q202=4 Q210=0 Q203=+0 Q204=2 Q211=0\n20 Q211=.001\n"
	 "30 L X+1 FMAX\n40 CYCL CALL\n",
	 "rapid 1 0 0 0 0\nrapid 1 0 2 0 0\nfeed 1 0 -4 0 0\nrapid 1 0 2 0 0\n"},
	{"CYCL DEF 200 DRILLING Q200=2 Q201=0 Q206=150 Q202=4 Q203=+0 Q204=9\nL X+1 FMAX M99\n",
	 "rapid 1 0 0 0 0\n"},
	{"CYCL DEF 201 REAMING Q200=2 Q201=-10 Q206=100 Q211=0.5 Q208=250 Q203=+0 Q204=20\n"
	 "L X+1 FMAX M99\n",
	 "rapid 1 0 0 0 0\nrapid 1 0 2 0 0\nfeed 1 0 -10 0 0\ndwell 0.5\nfeed 1 0 2 0 0\n"
	 "rapid 1 0 20 0 0\n"},
	{"CYCL DEF 202 BORING Q200=2 Q201=-10 Q206=100 Q211=0 Q208=0 Q203=+0 Q204=20 Q214=1 Q336=0\n"
	 "L X+1 FMAX M99\n",
	 "rapid 1 0 0 0 0\nrapid 1 0 2 0 0\nfeed 1 0 -10 0 0\nrapid 0.8 0 -10 0 0\nfeed 0.8 0 2 0 0\n"
	 "rapid 0.8 0 20 0 0\nrapid 1 0 20 0 0\n"},
	{"CYCL DEF 202 BORING Q200=2 Q201=-10 Q206=100 Q211=0 Q208=0 Q203=+0 Q204=20 Q214=0 Q336=0\n"
	 "L X+1 FMAX M99\n",
	 "rapid 1 0 0 0 0\nrapid 1 0 2 0 0\nfeed 1 0 -10 0 0\nfeed 1 0 2 0 0\nrapid 1 0 20 0 0\n"},
	{"CYCL DEF 203 UNIVERSAL DRILLING Q200=2 Q201=-9 Q206=100 Q202=3 Q210=0 Q203=+0 Q204=20 Q212=0 "
	 "Q213=2 Q205=0 Q211=0 Q208=500 Q256=0.2\nL X+1 FMAX M99\n",
	 "rapid 1 0 0 0 0\nrapid 1 0 2 0 0\nfeed 1 0 -3 0 0\nrapid 1 0 -2.8 0 0\nfeed 1 0 -6 0 0\n"
	 "rapid 1 0 -5.8 0 0\nfeed 1 0 -9 0 0\nrapid 1 0 2 0 0\nrapid 1 0 20 0 0\n"},
	{"CYCL DEF 205 PECKING Q200=2 Q201=-9 Q206=100 Q202=4 Q203=+0 Q204=20 Q212=1 Q205=2 Q258=0.2 "
	 "Q259=0.2 Q257=0 Q256=0.2 Q211=0 Q379=0 Q253=750\nL X+1 FMAX M99\n",
	 "rapid 1 0 0 0 0\nrapid 1 0 2 0 0\nfeed 1 0 -4 0 0\nrapid 1 0 2 0 0\nrapid 1 0 -2 0 0\n"
	 "feed 1 0 -7 0 0\nrapid 1 0 2 0 0\nrapid 1 0 -5 0 0\nfeed 1 0 -9 0 0\nrapid 1 0 2 0 0\n"
	 "rapid 1 0 20 0 0\n"},
	{"CYCL DEF 206 TAPPING Q200=2 Q201=-9 Q206=100 Q211=0.25 Q203=+0 Q204=20\nL X+1 FMAX M99\n",
	 "rapid 1 0 0 0 0\nrapid 1 0 2 0 0\nfeed 1 0 -9 0 0\ndwell 0.25\nfeed 1 0 2 0 0\n"
	 "rapid 1 0 20 0 0\n"},
	{"S600\nCYCL DEF 207 RIGID TAPPING Q200=2 Q201=-9 Q239=1 Q203=+0 Q204=20\nL X+1 FMAX M99\n",
	 "rapid 1 0 0 0 0\nrapid 1 0 2 0 0\nfeed 1 0 -9 0 0\nfeed 1 0 2 0 0\nrapid 1 0 20 0 0\n"},
	{"CYCL DEF 240 CENTERING Q200=2 Q343=0 Q201=-2 Q344=-10 Q206=100 Q211=0 Q203=+0 Q204=20\n"
	 "L X+1 FMAX M99\n",
	 "rapid 1 0 0 0 0\nrapid 1 0 2 0 0\nfeed 1 0 -2 0 0\nrapid 1 0 2 0 0\nrapid 1 0 20 0 0\n"},
	/* A point of 90 degrees is as high as half the diameter; the tool is 40 long and has 5. */
	{"TOOL CALL 2 Z\nCYCL DEF 240 CENTERING Q200=2 Q343=1 Q201=-2 Q344=-3 Q206=100 Q211=0 Q203=+0 Q204=20\n"
	 "L X+1 FMAX M99\n",
	 "tool 2\nrapid 1 0 0 0 0\nrapid 1 0 42 0 0\nfeed 1 0 38.5 0 0\nrapid 1 0 42 0 0\nrapid 1 0 60 0 0\n"},
	{"TOOL CALL 2 Z\nCYCL DEF 200 DRILLING Q200=2 Q201=-4 Q206=100 Q202=9 Q203=+0 Q204=20 Q395=1\nL X+1 FMAX M99\n",
	 "tool 2\nrapid 1 0 0 0 0\nrapid 1 0 42 0 0\nfeed 1 0 33.5 0 0\nrapid 1 0 42 0 0\nrapid 1 0 60 0 0\n"},
	{"CYCL DEF 241 SINGLE-LIP Q200=2 Q201=-20 Q206=100 Q211=0 Q203=+0 Q204=20 Q379=0 Q253=750 "
	 "Q208=1000\nL X+1 FMAX M99\n",
	 "rapid 1 0 0 0 0\nrapid 1 0 2 0 0\nfeed 1 0 -20 0 0\nfeed 1 0 2 0 0\nrapid 1 0 20 0 0\n"},
	{"CYCL DEF 204 BACK BORING Q200=2 Q249=0 Q250=20\nL X+1 FMAX M99\n",
	 "rapid 1 0 0 0 0\n"},
	{"L Z+2 FMAX\nCYCL DEF 1.0 PECKING\nCYCL DEF 1.1 SET UP 2\nCYCL DEF 1.2 DEPTH -10\n"
	 "CYCL DEF 1.3 PECKG 6\nCYCL DEF 1.4 DWELL 0\nCYCL DEF 1.5 F100\nL X+5 FMAX M99\n",
	 "rapid 0 0 2 0 0\nrapid 5 0 2 0 0\nrapid 5 0 2 0 0\nfeed 5 0 -6 0 0\nrapid 5 0 2 0 0\n"
	 "rapid 5 0 -4 0 0\nfeed 5 0 -10 0 0\nrapid 5 0 2 0 0\n"},
	{"L Z+2 FMAX\nCYCL DEF 2.0 TAPPING\nCYCL DEF 2.1 SET UP 2\nCYCL DEF 2.2 DEPTH -10\n"
	 "CYCL DEF 2.3 DWELL 0\nCYCL DEF 2.4 F100\nX+5 R0 FMAX M99\n",
	 "rapid 0 0 2 0 0\nrapid 5 0 2 0 0\nrapid 5 0 2 0 0\nfeed 5 0 -10 0 0\nfeed 5 0 2 0 0\n"},
	{"S1000\nL Z+2 FMAX\nCYCL DEF 17.0 RIGID TAPPING\nCYCL DEF 17.1 SET UP 2\n"
	 "CYCL DEF 17.2 DEPTH -10\nCYCL DEF 17.3 PITCH 1.5\nL X+5 FMAX M99\n",
	 "rapid 0 0 2 0 0\nrapid 5 0 2 0 0\nrapid 5 0 2 0 0\nfeed 5 0 -10 0 0\nfeed 5 0 2 0 0\n"},
	{"L Z+20 FMAX\nCYCL DEF 200 DRILLING Q200=2 Q201=-4 Q206=150 Q202=4 Q203=+0 Q204=9\n"
	 "CYCL CALL POS X+3 Y+4 Z+0\nCYCL CALL POS X+5 Y+4 Z+0 M3\n",
	 "rapid 0 0 20 0 0\nrapid 3 4 20 0 0\nrapid 3 4 2 0 0\nfeed 3 4 -4 0 0\nrapid 3 4 2 0 0\n"
	 "rapid 3 4 9 0 0\nrapid 5 4 9 0 0\nrapid 5 4 2 0 0\nfeed 5 4 -4 0 0\nrapid 5 4 2 0 0\n"
	 "rapid 5 4 9 0 0\n"},
	/* A comment of several lines; without a block number the comment ends with its first line. */
	{"1 ; FREE SOFTWARE:~\n UNDER THE TERMS~\n of a licence.\n2 L X+1 FMAX\n; DONE ~\nL X+2 FMAX\n3 ;~\n4 L X+3 FMAX\n",
	 "rapid 1 0 0 0 0\nrapid 2 0 0 0 0\nrapid 3 0 0 0 0\n"},
	/* Strings: joined, as numbers, as names. */
	{"DECLARE STRING QS1 = \"1\"\nQS2 = QS1 || \"2.\" || \"5\"\nQS2 = \"\" || QS2\nQ5 = TONUMB ( SRC_QS2 )\nL X+Q5 FMAX\n",
	 "rapid 12.5 0 0 0 0\n"},
	{"DECLARE STRING QS12 = \"DRILL 5\"\nTOOL CALL QS12 Z S100\n",
	 "tool 2\n"},
	/* Z shifts the surface. */
	{"L Z+20 FMAX\nCYCL DEF 200 DRILLING Q200=2 Q201=-4 Q206=150 Q202=4 Q203=+1 Q204=9\n"
	 "CYCL CALL POS X+3 Y+4 Z+5\nCYCL CALL POS X+3 Y+4 Z+0\n",
	 "rapid 0 0 20 0 0\nrapid 3 4 20 0 0\nrapid 3 4 8 0 0\nfeed 3 4 2 0 0\nrapid 3 4 8 0 0\n"
	 "rapid 3 4 15 0 0\nrapid 3 4 15 0 0\nrapid 3 4 3 0 0\nfeed 3 4 -3 0 0\nrapid 3 4 3 0 0\nrapid 3 4 10 0 0\n"},
	/* These statements act as the cycles 8, 10 and 247. */
	{"TRANS MIRROR AXIS X\nL X+1 Y+2 FMAX\nTRANS MIRROR AXIS X Y\nL X+1 Y+2 FMAX\nTRANS MIRROR RESET\n"
	 "L X+1 Y+2 FMAX\n",
	 "rapid -1 2 0 0 0\nrapid -1 -2 0 0 0\nrapid 1 2 0 0 0\n"},
	{"TRANS ROTATION ROT+90\nL X+1 Y+2 FMAX\nTRANS ROTATION RESET\nTRANS SCALE RESET\nL X+1 Y+2 FMAX\n",
	 "rapid -2 1 0 0 0\nrapid 1 2 0 0 0\n"},
	{"PRESET SELECT #1\nL X+1 FMAX\nQ5=1\nPRESET SELECT #Q5 KEEP TRANS WP\nL X+2 FMAX\n",
	 "rapid 1 0 0 0 0\nrapid 2 0 0 0 0\n"},
	{"FUNCTION LIFTOFF TCS X+0 Y+0.5 Z+0.5\nFUNCTION LIFTOFF RESET\nFUNCTION RESET S-PULSE\nFUNCTION POLARKIN OFF\n"
	 "FUNCTION PARAXCOMP DISPLAY Z\nFUNCTION PARAXCOMP OFF Z\nFUNCTION PARAXMODE OFF\nFUNCTION CORRDATA RESET #TCS\n"
	 "FUNCTION PROG PATH OFF\nL X+1 FMAX\n",
	 "rapid 1 0 0 0 0\n"},
	{"PLANE SPATIAL SPA-90 SPB+0 SPC+0 TURN FMAX\n"
	 "CYCL DEF 200 DRILLING Q200=2 Q201=-4 Q206=150 Q202=4 Q203=+0 Q204=9\nL X+1 Y+2 FMAX M99\n",
	 "orient 0 1 0\nrapid 0 0 0 90 0\ntcp on length 0 zero A0 C0\nrapid 1 0 -2 90 0 tcp\n"
	 "rapid 1 2 -2 90 0 tcp\nfeed 1 -4 -2 90 0 tcp\nrapid 1 2 -2 90 0 tcp\nrapid 1 9 -2 90 0 tcp\n"},
	{"TOOL CALL 1 Z F120\nCYCL DEF 200 DRILLING Q200=2 Q201=-4 Q206=FAUTO Q202=4 Q203=+0 Q204=9\n"
	 "L X+1 FMAX M99\n",
	 "tool 1\nrapid 1 0 0 0 0\nrapid 1 0 102 0 0\nfeed 1 0 96 0 0\nrapid 1 0 102 0 0\n"
	 "rapid 1 0 109 0 0\n"},
	{"Q8=-3\nCYCL DEF 200 DRILLING Q200=2 Q201=Q8 Q206=150 Q202=4 Q203=+0 Q204=9\nL X+1 FMAX M99\n",
	 "rapid 1 0 0 0 0\nrapid 1 0 2 0 0\nfeed 1 0 -3 0 0\nrapid 1 0 2 0 0\nrapid 1 0 9 0 0\n"},
	{"17 CYCL DEF 240 CENTERING ~\n    Q200=+2  ;SET-UP CLEARANCE\n    Q343=+0      ;SELECT\n"
	 "    Q201=-3   ;DEPTH\n    Q206=12.5 \n    Q203=+1\n    Q204=+9\n18 L X+4 FMAX M99\n",
	 "rapid 4 0 0 0 0\nrapid 4 0 3 0 0\nfeed 4 0 -2 0 0\nrapid 4 0 3 0 0\nrapid 4 0 10 0 0\n"},
	{"CYCL DEF 200 DRILLING ~\nQ200=2\nQ201=-4\nQ206=150\nQ202=4\nQ203=+0\nQ204=9\nQ1=7\n"
	 "L X+Q1 FMAX M99\n",
	 "rapid 7 0 0 0 0\nrapid 7 0 2 0 0\nfeed 7 0 -4 0 0\nrapid 7 0 2 0 0\nrapid 7 0 9 0 0\n"},
	{"CYCL DEF 200 DRILLING ~\nQ200=2 ~\nQ201=-4 ~\nQ206=150 ~\nQ202=4 ~\nQ203=+0 ~\nQ204=9\nQ300=7\n"
	 "L X+Q300 FMAX M99\n",
	 "rapid 7 0 0 0 0\nrapid 7 0 2 0 0\nfeed 7 0 -4 0 0\nrapid 7 0 2 0 0\nrapid 7 0 9 0 0\n"},
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

START_TEST(cycles_table)
{
	klartext_expect(&cycles[_i], false);
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
	tcase_add_loop_test(tcase, cycles_table, 0, COUNT(cycles));
	tcase_add_loop_test(tcase, directed_table, 0, COUNT(directed));
	tcase_add_test(tcase, vector_beside_pole);
	return run_suite("gcode_klartext_path", tcase);
}
