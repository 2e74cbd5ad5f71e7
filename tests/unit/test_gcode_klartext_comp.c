/* test_gcode_klartext_comp.c - Klartext: RL, RR, R0 and M97, RND and CHF beside circles; by hand and closed forms. */
#include "klartext_case.h"

#define START "TOOL CALL 1 Z\nL X-20 Y-20 R0 FMAX\n"
#define STARTED "tool 1\nrapid -20 -20 0 0 0\n"

/* T1 has a radius of 5 mm. */
static const struct klartext_program paths[] = {
	/* The first block ends beside the start of the second, outside corners are rounded, the last one leaves. */
	{START "L X+0 Y+0 RL F100\nL Y+50\nL X+50\nL X+50 Y-20 R0\n",
	 STARTED "feed -5 0 0 0 0\nfeed -5 50 0 0 0\narc 0 55 0 0 0 centre 0 50 0 normal 0 0 1 sweep -90\n"
	 "feed 50 55 0 0 0\nfeed 50 -20 0 0 0\n"},
	/* Inside corners are where the paths cross. */
	{START "L X+0 Y+0 RR F100\nL Y+50\nL X+50\nL X+50 Y-20 R0\n",
	 STARTED "feed 5 0 0 0 0\nfeed 5 45 0 0 0\nfeed 50 45 0 0 0\nfeed 50 -20 0 0 0\n"},
	/* A repeated RL and a blank R keep the compensation in force; an arc outside and inside. */
	{START "L X+0 Y+0 RL F100\nL Y+50 RL\nCC X+50 Y+50\nC X+50 Y+100 DR-\nL X+90 R\nL X+100 Y+150 R0\n",
	 STARTED "feed -5 0 0 0 0\nfeed -5 50 0 0 0\narc 50 105 0 0 0 centre 50 50 0 normal 0 0 1 sweep -90\n"
	 "feed 90 105 0 0 0\nfeed 100 150 0 0 0\n"},
	{START "L X+0 Y+0 RR F100\nL Y+50 RR\nCC X+50 Y+50\nC X+50 Y+100 DR-\nL X+90 R\nL X+100 Y+150 R0\n",
	 STARTED "feed 5 0 0 0 0\nfeed 5 50 0 0 0\narc 50 95 0 0 0 centre 50 50 0 normal 0 0 1 sweep -90\n"
	 "feed 90 95 0 0 0\nfeed 100 150 0 0 0\n"},
	/* A helix by CP, more than a turn. */
	{START "L X+0 Y+0 RR F100\nL Y+50\nCC X+50 Y+50\nCP IPA-450 IZ-9 DR-\nL X+90\nL X+100 Y+150 R0\n",
	 STARTED "feed 5 0 0 0 0\nfeed 5 50 0 0 0\narc 50 95 -9 0 0 centre 50 50 0 normal 0 0 1 sweep -450\n"
	 "feed 90 95 -9 0 0\nfeed 100 150 -9 0 0\n"},
	/* DR of TOOL CALL is added. */
	{"TOOL CALL 1 Z DR+1\nL X-20 Y-20 R0 FMAX\nL X+0 Y+0 RR F100\nL Y+50\nL X+50\nL X+50 Y-20 R0\n",
	 STARTED "feed 6 0 0 0 0\nfeed 6 44 0 0 0\nfeed 50 44 0 0 0\nfeed 50 -20 0 0 0\n"},
	/* With a radius of 0 the tool is on the path; behind R0 a TOOL CALL may give another radius. */
	{"TOOL CALL 1 Z DR-5\nL X-20 Y-20 R0 FMAX\nL X+0 Y+0 RR F100\nL Y+50\nL X+50 Y-20 R0\nTOOL CALL DR+0\nL X+0 Y+0 RR\n"
	 "L Y+50\nL X-20 R0\n",
	 STARTED "feed 0 0 0 0 0\nfeed 0 50 0 0 0\nfeed 50 -20 0 0 0\nfeed 5 0 0 0 0\nfeed 5 50 0 0 0\nfeed -20 50 0 0 0\n"},
	{"TOOL CALL 1 Z DR-5\nL X-20 Y-20 R0 FMAX\nL X+0 Y+0 RR F100\nL Y+50\nL Z+5 R0\nTOOL CALL DR+0\nL X+1\n",
	 STARTED "feed 0 0 0 0 0\nfeed 0 50 0 0 0\nfeed 0 50 105 0 0\nfeed 1 50 105 0 0\n"},
	/* RND and CHF belong to the path that is compensated. */
	{START "L X+0 Y+0 RL F100\nL Y+50\nRND R8\nL X+50\nCHF 10\nL Y+0\nL X+60 Y-20 R0\n",
	 STARTED "feed -5 0 0 0 0\nfeed -5 42 0 0 0\narc 8 55 0 0 0 centre 8 42 0 normal 0 0 1 sweep -90\n"
	 "feed 40 55 0 0 0\narc 43.5355339 53.5355339 0 0 0 centre 40 50 0 normal 0 0 1 sweep -45\n"
	 "feed 53.5355339 43.5355339 0 0 0\narc 55 40 0 0 0 centre 50 40 0 normal 0 0 1 sweep -45\n"
	 "feed 55 0 0 0 0\nfeed 60 -20 0 0 0\n"},
	/* M97: both paths are extended to their intersection. */
	{START "L X+0 Y+0 RL F100\nL Y+50 M97\nL X+50\nL Y+0\nL X+60 Y-20 R0\n",
	 STARTED "feed -5 0 0 0 0\nfeed -5 55 0 0 0\nfeed 50 55 0 0 0\n"
	 "arc 55 50 0 0 0 centre 50 50 0 normal 0 0 1 sweep -90\nfeed 55 0 0 0 0\nfeed 60 -20 0 0 0\n"},
	/* A shift and a rotation move the path; a mirror image exchanges the sides. */
	{"CYCL DEF 7.0\nCYCL DEF 7.1 X+100\nCYCL DEF 10.0\nCYCL DEF 10.1 ROT+90\n"
	 START "L X+0 Y+0 RL F100\nL Y+50\nL X+50\nL X+50 Y-20 R0\n",
	 "tool 1\nrapid 120 -20 0 0 0\nfeed 100 -5 0 0 0\nfeed 50 -5 0 0 0\n"
	 "arc 45 0 0 0 0 centre 50 0 0 normal 0 0 1 sweep -90\nfeed 45 50 0 0 0\nfeed 120 50 0 0 0\n"},
	{"CYCL DEF 8.0\nCYCL DEF 8.1 X\n"
	 START "L X+0 Y+0 RL F100\nL Y+50\nL X+50\nL X+50 Y-20 R0\n",
	 "tool 1\nrapid 20 -20 0 0 0\nfeed 5 0 0 0 0\nfeed 5 50 0 0 0\n"
	 "arc 0 55 0 0 0 centre 0 50 0 normal 0 0 -1 sweep -90\nfeed -50 55 0 0 0\nfeed -50 -20 0 0 0\n"},
	/* At M30 and END PGM the tool stays where it is. */
	{START "L X+0 Y+0 RL F100\nL Y+50\nL X+50 M30\n",
	 STARTED "feed -5 0 0 0 0\nfeed -5 50 0 0 0\narc 0 55 0 0 0 centre 0 50 0 normal 0 0 1 sweep -90\n"
	 "feed 50 55 0 0 0\n"},
	/* R0 with Z alone: to the programmed point now or with the next move of X and Y. */
	{START "L X+0 Y+0 RL F100\nL Y+50\nL Z-10 R0 FMAX\nL X+70 FMAX\nL X+80 Y+90 FMAX\nL X+90 FMAX\n",
	 STARTED "feed -5 0 0 0 0\nfeed -5 50 0 0 0\nfeed 0 50 0 0 0 spread 5 5 0\nrapid 0 50 90 0 0 spread 5 5 0\n"
	 "rapid 70 50 90 0 0 spread 5 5 0\nrapid 80 90 90 0 0 spread 5 5 0\nrapid 90 90 90 0 0\n"},
	/* A subprogram under compensation; a block in Z between. */
	{START "L X+0 Y+0 RL F100\nCALL LBL 1\nL IZ-1\nL X+50\nL X+50 Y-20 R0\nL M30\nLBL 1\nL Y+50\nLBL 0\n",
	 STARTED "feed -5 0 0 0 0\nfeed -5 50 0 0 0\nfeed -5 50 -1 0 0 spread 7.07106781 7.07106781 0\n"
	 "arc 0 55 -1 0 0 centre 0 50 -1 normal 0 0 1 sweep -90 spread 0 0 1\n"
	 "feed 50 55 -1 0 0\nfeed 50 -20 -1 0 0\n"},
	/* A radius of 0 means no compensation. */
	{"TOOL CALL 1 Z DR-5\nL X+0 Y+0 RL F100\nL Y+50 RL\nL X+50 R0\n",
	 "tool 1\nfeed 0 0 0 0 0\nfeed 0 50 0 0 0\nfeed 50 50 0 0 0\n"},
};

/* RND beside circles, without compensation: its centre is as far from both as its radius. */
static const struct klartext_program corners[] = {
	{"F100\nL X+10\nRND R2\nCC X+10 Y+10\nC X+20 Y+10 DR+\n",
	 "feed 10 0 0 0 0\narc 20 10 0 0 0 centre 10 10 0 normal 0 0 1 sweep 90\n"},
	{"F100\nL X+20\nRND R2\nCC X+10 Y+0\nC X+10 Y+10 DR+\n",
	 "feed 17.7459667 0 0 0 0\narc 19.6824584 2.5 0 0 0 centre 17.7459667 2 0 normal 0 0 1 sweep 104.477512\n"
	 "arc 10 10 0 0 0 centre 10 0 0 normal 0 0 1 sweep 75.5224878\n"},
	{"L X+20 F100\nCC X+10 Y+0\nC X+0 Y+0 DR+\nRND R2\nL X+20\n",
	 "feed 20 0 0 0 0\narc 0.317541634 2.5 0 0 0 centre 10 0 0 normal 0 0 1 sweep 165.522488\n"
	 "arc 2.25403331 0 0 0 0 centre 2.25403331 2 0 normal 0 0 1 sweep 104.477512\nfeed 20 0 0 0 0\n"},
};

#define OUTSIDE "TOOL CALL 1 Z\nL X-40 Y-20 R0 FMAX\n"
#define THERE "tool 1\nrapid -40 -20 0 0 0\n"
#define CONTOUR "L Y+50\nL X+50\n"
#define ROUND "feed -5 50 0 0 0\narc 0 55 0 0 0 centre 0 50 0 normal 0 0 1 sweep -90\nfeed 50 55 0 0 0\n"

/* APPR and DEP, and PLANE with MB: the points by hand, the circle of LCT touches the straight line from PS. */
static const struct klartext_program approaches[] = {
	{OUTSIDE "APPR LT X+0 Y+0 LEN15 RL F100\n" CONTOUR "DEP LT LEN15\nL X+90 Y+90 FMAX\n",
	 THERE "rapid -5 -15 0 0 0\nfeed -5 0 0 0 0\n" ROUND
	 "feed 65 55 0 0 0\nrapid 90 90 0 0 0\n"},
	/* M-functions that take effect at the end of the block, as in the manual's examples. */
	{OUTSIDE "APPR LT X+0 Y+0 LEN15 RL F100 M8\n" CONTOUR "DEP LT LEN15 F100 M2\nL X+90 Y+90 FMAX\n",
	 THERE "rapid -5 -15 0 0 0\nfeed -5 0 0 0 0\n" ROUND
	 "feed 65 55 0 0 0\n"},
	{OUTSIDE "APPR LT X+0 Y+0 LEN15 RL F100 M3\n" CONTOUR "DEP LT LEN15 M5 M9\nL X+90 Y+90 FMAX\n",
	 THERE "rapid -5 -15 0 0 0\nfeed -5 0 0 0 0\n" ROUND
	 "feed 65 55 0 0 0\nrapid 90 90 0 0 0\n"},
	{OUTSIDE "L Y-21 F100\nAPPR LN X+0 Y+0 LEN15 RL F100\n" CONTOUR "DEP LN LEN15\n",
	 THERE "feed -40 -21 0 0 0\nfeed -20 0 0 0 0\nfeed -5 0 0 0 0\n" ROUND "feed 50 70 0 0 0\n"},
	{OUTSIDE "APPR CT X+0 Y+0 CCA90 R+10 RL F100\n" CONTOUR "DEP CT CCA90 R+10\n",
	 THERE "rapid -15 -10 0 0 0\narc -5 0 0 0 0 centre -15 0 0 normal 0 0 1 sweep 90\n" ROUND
	 "arc 60 65 0 0 0 centre 50 65 0 normal 0 0 1 sweep 90\n"},
	/* From the side of the workpiece. */
	{OUTSIDE "APPR CT X+0 Y+0 CCA90 R-10 RL F100\n" CONTOUR "DEP LN LEN15\n",
	 THERE "rapid 5 -10 0 0 0\narc -5 0 0 0 0 centre 5 0 0 normal 0 0 1 sweep -90\n" ROUND "feed 50 70 0 0 0\n"},
	{OUTSIDE "APPR LCT X+0 Y+0 R10 RL F100\n" CONTOUR "DEP LCT X-30 Y+60 R10\n",
	 THERE "rapid -11.5046219 -9.3692226 0 0 0\narc -5 0 0 0 0 centre -15 0 0 normal 0 0 1 sweep 69.540952\n" ROUND
	 "arc 48.1359543 74.8247307 0 0 0 centre 50 65 0 normal 0 0 1 sweep 190.743033\nfeed -30 60 0 0 0\n"},
	/* With a height: to PH in the plane, then down; from PN up. */
	{OUTSIDE "APPR LT X+0 Y+0 Z-10 LEN15 RL F100\n" CONTOUR "DEP LT LEN15 Z+50\n",
	 "tool 1\nrapid -40 -20 0 0 0\nrapid -5 -15 0 0 0\nrapid -5 -15 90 0 0\nfeed -5 0 90 0 0\n"
	 "feed -5 50 90 0 0\narc 0 55 90 0 0 centre 0 50 90 normal 0 0 1 sweep -90\nfeed 50 55 90 0 0\n"
	 "feed 65 55 90 0 0\nfeed 65 55 150 0 0\n"},
	{OUTSIDE "L Y-21 F100\nAPPR LN X+0 Y+0 Z-10 LEN15 RL F100\n" CONTOUR "DEP LN LEN15\n",
	 "tool 1\nrapid -40 -20 0 0 0\nfeed -40 -21 0 0 0\nfeed -20 0 0 0 0\nfeed -20 0 90 0 0\n"
	 "feed -5 0 90 0 0\nfeed -5 50 90 0 0\narc 0 55 90 0 0 centre 0 50 90 normal 0 0 1 sweep -90\n"
	 "feed 50 55 90 0 0\nfeed 50 70 90 0 0\n"},
	/* LCT also straight to the point with all axes at once, and back. */
	{OUTSIDE "APPR LCT X+0 Y+0 Z-10 R10 RL F100\n" CONTOUR "DEP LCT X-30 Y+60 Z+50 R10\n",
	 "tool 1\nrapid -40 -20 0 0 0\n"
	 "rapid -11.5046219 -9.3692226 90 0 0\nrapid -40 -20 0 0 0\nrapid -11.5046219 -9.3692226 0 0 0\n"
	 "rapid -11.5046219 -9.3692226 90 0 0\narc -5 0 90 0 0 centre -15 0 90 normal 0 0 1 sweep 69.540952\n"
	 "feed -5 50 90 0 0\narc 0 55 90 0 0 centre 0 50 90 normal 0 0 1 sweep -90\nfeed 50 55 90 0 0\n"
	 "arc 48.1359543 74.8247307 90 0 0 centre 50 65 90 normal 0 0 1 sweep 190.743033\n"
	 "feed -30 60 90 0 0\nfeed -30 60 150 0 0\nfeed 48.1359543 74.8247307 90 0 0\nfeed -30 60 150 0 0\n"},
	/* R may be less than the tool's radius of 5 mm, because it is the radius of the path of the tool's centre. */
	{OUTSIDE "APPR CT X+0 Y+0 CCA90 R+3 RL F100\n" CONTOUR "DEP CT CCA90 R+3\nL X+90 Y+90 FMAX\n",
	 THERE "rapid -8 -3 0 0 0\narc -5 0 0 0 0 centre -8 0 0 normal 0 0 1 sweep 90\n" ROUND
	 "arc 53 58 0 0 0 centre 50 58 0 normal 0 0 1 sweep 90\nrapid 90 90 0 0 0\n"},
	/*
	 * A whole circle stays a whole circle although the arc of APPR meets it tangentially with a tool of 2.495 mm.
	 */
	{"TOOL CALL 1 Z DR-2.505\nCC X+50 Y+50\nL X-40 Y+50 FMAX\nAPPR LCT X+0 Y+50 R5 RL F100\nC X+0 DR-\n"
	 "DEP LCT X-40 Y+50 R5\n",
	 "tool 1\nrapid -40 50 0 0 0\nrapid -8.26411244 45.0595075 0 0 0\n"
	 "arc -2.495 49.9999999 0 0 0 centre -7.495 50 0 normal 0 0 1 sweep 98.8485093\n"
	 "arc -2.495 50 0 0 0 centre 50 50 0 normal 0 0 1 sweep -360\n"
	 "arc -8.26411244 54.9404925 0 0 0 centre -7.495 50 0 normal 0 0 1 sweep 98.8485109\nfeed -40 50 0 0 0\n"},
	/* A move along one axis after DEP starts from the position of the tool's centre. */
	{OUTSIDE "APPR LT X+0 Y+0 LEN15 RL F100\n" CONTOUR "DEP LT LEN15\nL Z+20 R0 FMAX\nL IX+5 FMAX\n",
	 THERE "rapid -5 -15 0 0 0\nfeed -5 0 0 0 0\n" ROUND
	 "feed 65 55 0 0 0\nrapid 65 55 120 0 0\nrapid 70 55 120 0 0\n"},
	/* The contour may rise; a label, computations and a corner may follow APPR. */
	{OUTSIDE "APPR LT X+0 Y+0 LEN15 RL F100\nLBL 7\nQ1 = 5 * 10\nL Y+Q1 Z+10\nDEP LT LEN15\n",
	 THERE "rapid -5 -15 0 0 0\nfeed -5 0 0 0 0\nfeed -5 50 110 0 0\nfeed -5 65 110 0 0\n"},
	{OUTSIDE "APPR LT X+0 Y+0 LEN15 RL F100\nL Y+50\nRND R10\nFN 0: Q1 = +50\nL X+Q1\nDEP LT LEN15\n",
	 THERE "rapid -5 -15 0 0 0\nfeed -5 0 0 0 0\nfeed -5 40 0 0 0\n"
	 "arc 10 55 0 0 0 centre 10 40 0 normal 0 0 1 sweep -90\nfeed 50 55 0 0 0\nfeed 65 55 0 0 0\n"},
	/* MB: along the tool before the rotary axes turn. */
	{"PLANE SPATIAL SPA+30 SPB+0 SPC+0 TURN MB20 FMAX\n",
	 "orient 0 -0.5 0.866025404\nrapid 0 0 20 0 0\nrapid 0 0 20 -30 0\ntcp on length 0 zero A0 C0\n"},
	{"PLANE SPATIAL SPA+30 SPB+0 SPC+0 TURN MB MAX FMAX\n",
	 "orient 0 -0.5 0.866025404\nrapid 0 0 500 0 0\nrapid 0 0 500 -30 0\ntcp on length 0 zero A0 C0\n"},
	/* In polar coordinates, to a circle. */
	{OUTSIDE "CC X+0 Y+0\nAPPR PLT PR+30 PA+0 LEN10 RR F100\nC X+0 Y+30 DR+\nDEP LN LEN15\n",
	 THERE "rapid 35 -10 0 0 0\nfeed 35 0 0 0 0\narc 0 35 0 0 0 centre 0 0 0 normal 0 0 1 sweep 90\n"
	 "feed 0 50 0 0 0\n"},
};

#define HOLE(plunge, back)                                                                                            \
	"CYCL DEF 203 DRILLING Q200=2 Q201=-4 Q206=" plunge " Q202=4 Q210=0 Q203=+0 Q204=9 Q212=0 Q213=0 Q205=0 Q211=0 "  \
	"Q208=" back " Q256=0.2\n"

/* Feeds, datum shifts, planes: each block and a block with the same meaning. */
static const struct {
	const char *blocks, *same;
} equal[] = {
	{"TOOL CALL 1 Z S1000\nL X+10 FU0.2\n", "TOOL CALL 1 Z S1000\nL X+10 F200\n"},
	/* AUTO is the feed of TOOL CALL, MAX a rapid. */
	{"TOOL CALL 1 Z F300\n" HOLE("AUTO", "MAX") "L X+5 FMAX M99\n",
	 "TOOL CALL 1 Z F300\n" HOLE("300", "99999") "L X+5 FMAX M99\n"},
	{"TOOL CALL 1 Z F300\n" HOLE(" FAUTO", " FMAX") "L X+5 FMAX M99\n",
	 "TOOL CALL 1 Z F300\n" HOLE("+300", "+99999") "L X+5 FMAX M99\n"},
	/* F of TOOL CALL is in force until another F. */
	{"TOOL CALL 1 Z F250\nL X+10\nL X+20 FMAX\nL X+30 F100\nTOOL CALL 2 Z F70\nL X+40\n",
	 "TOOL CALL 1 Z\nL X+10 F250\nL X+20 FMAX\nL X+30 F100\nTOOL CALL 2 Z\nL X+40 F70\n"},
	{"TOOL CALL 1 Z S1000\nL M136\nL X+10 F0.2\nL M137\nL X+20 F300\n",
	 "TOOL CALL 1 Z S1000\nL\nL X+10 F200\nL\nL X+20 F300\n"},
	{"TRANS DATUM AXIS X+10 Y-20 Z+5\nL X+1 Y+2 FMAX\nTRANS DATUM RESET\nL X+1 FMAX\n",
	 "CYCL DEF 7.0\nCYCL DEF 7.1 X+10\nCYCL DEF 7.2 Y-20\nCYCL DEF 7.3 Z+5\nL X+1 Y+2 FMAX\nCYCL DEF 7.0\n"
	 "CYCL DEF 7.1 X+0\nCYCL DEF 7.2 Y+0\nCYCL DEF 7.3 Z+0\nL X+1 FMAX\n"},
	{"TRANS DATUM AXIS X+10\nTRANS DATUM AXIS IX+5\nL X+1 FMAX\n", "CYCL DEF 7.0\nCYCL DEF 7.1 X+15\nL X+1 FMAX\n"},
	/* RL again in every block, as older posts write it. */
	{"TOOL CALL 1 Z\nL X-20 Y-20 R0 FMAX\nL X+0 Y+0 RL F100\nL Y+50 RL\nRND R8\nL X+50 RL\nL X+90 Y+80 R0\n",
	 "TOOL CALL 1 Z\nL X-20 Y-20 R0 FMAX\nL X+0 Y+0 RL F100\nL Y+50\nRND R8\nL X+50\nL X+90 Y+80 R0\n"},
	/* Cycle 19 with F and a clearance turns the rotary axes as PLANE ... MOVE does. */
	{"CYCL DEF 19.0 PLANE\nCYCL DEF 19.1 A-30 B+0 C+0 F2000 ABST50\nL X+1 FMAX\nCYCL DEF 19.0\nCYCL DEF 19.1 A+0 F2000 ABST50\n",
	 "PLANE SPATIAL SPA-30 SPB+0 SPC+0 MOVE ABST50 F2000\nL X+1 FMAX\nPLANE RESET MOVE ABST50 F2000\n"},
	{"CYCL DEF 19.0 PLANE\nCYCL DEF 19.1 A-30 B+0 C+0 FMAX ABST50\nL X+1 FMAX\n",
	 "PLANE SPATIAL SPA-30 SPB+0 SPC+0 MOVE ABST50 FMAX\nL X+1 FMAX\n"},
	{"CYCL DEF 19.0 PLANE\nCYCL DEF 19.1 A-30 B+0 C+0 FMAX\nL X+1 FMAX\n",
	 "PLANE SPATIAL SPA-30 SPB+0 SPC+0 MOVE FMAX\nL X+1 FMAX\n"},
	{"/81 L X+5 FMAX\n/ L X+6 FMAX\n", "L X+5 FMAX\nL X+6 FMAX\n"},
	{"CYCL DEF 392 ATC~\n   Q240=0 ;TUNING MODE~\n   Q241=1 ;WEIGHT MODE\nL X+5 FMAX\n", "L X+5 FMAX\n"},
};

START_TEST(paths_table)
{
	klartext_expect(&paths[_i], true);
}
END_TEST

START_TEST(corners_table)
{
	klartext_expect(&corners[_i], true);
}
END_TEST

START_TEST(approaches_table)
{
	klartext_expect(&approaches[_i], true);
}
END_TEST

START_TEST(equal_table)
{
	static const struct builder_macro macro = {392, 0, MACRO_NONE, {0}, NULL};
	struct gcode_case c[2];

	for (int i = 0; i < 2; i++) {
		const char *blocks = i ? equal[_i].same : equal[_i].blocks;

		klartext_case(&c[i]);
		c[i].show_feed = true;
		c[i].config.controller.macros = &macro;
		c[i].config.controller.macro_count = 1;
		ck_assert_msg(klartext_run(&c[i], blocks), "%s%s", blocks, strbuf_text(&c[i].messages));
	}
	ck_assert_uint_gt(c[0].moves.length, 0);
	ck_assert_str_eq(strbuf_text(&c[0].moves), strbuf_text(&c[1].moves));
	case_release(&c[0]);
	case_release(&c[1]);
}
END_TEST

/* Any angle of C suits the plane: PLANE turns C to 0 or leaves it. */
START_TEST(free_axis)
{
	static const char *const moves[] = {"", "rapid 0 0 0 0 5\norient 0 0 1\nrapid 0 0 0 0 0\n",
					    "rapid 0 0 0 0 5\norient 0 0 1\nrapid 0 0 0 0 5\n"};

	for (int way = SWIVEL_POLE_ZERO; way <= SWIVEL_POLE_STAYS; way++) {
		struct gcode_case c;

		klartext_case(&c);
		c.config.controller.swivel_pole = (enum swivel_pole)way;
		ck_assert(klartext_run(&c, "L C+5 FMAX\nPLANE SPATIAL SPA+0 SPB+0 SPC+0 TURN FMAX\n"));
		ck_assert_int_eq(strncmp(strbuf_text(&c.moves), moves[way], strlen(moves[way])), 0);
		case_release(&c);
	}
}
END_TEST

/*
 * Without COORD ROT and TABLE ROT the machine file says whether the table turns by the angle or only the coordinates.
 */
#define PLANE_OF_C "PLANE SPATIAL SPA+0 SPB+0 SPC+30 TURN FMAX\nL X+10 Y+0 Z+0 FMAX\n"
#define CYCLE_OF_C "CYCL DEF 19.0\nCYCL DEF 19.1 A+0 B+0 C+30\nL A+Q120 C+Q122 FMAX\nL X+10 Y+0 Z+0 FMAX\n"
#define FREE_TCP "tcp on length 0 zero A0 C0\n"

START_TEST(plane_rotation)
{
	static const struct {
		enum plane_rotation rotation;
		enum swivel_pole pole;
		const char *program, *moves;
	} told[] = {
		{PLANE_ROTATION_COORDINATES, SWIVEL_POLE_UNKNOWN, PLANE_OF_C,
		 "rapid 0 0 0 0 0\n" FREE_TCP "rapid 8.66025404 5 0 0 0 tcp\n"},
		{PLANE_ROTATION_UNKNOWN, SWIVEL_POLE_ZERO, PLANE_OF_C,
		 "rapid 0 0 0 0 0\n" FREE_TCP "rapid 8.66025404 5 0 0 0 tcp\n"},
		{PLANE_ROTATION_TABLE, SWIVEL_POLE_ZERO, PLANE_OF_C,
		 "rapid 0 0 0 0 -30\n" FREE_TCP "rapid 8.66025404 5 0 0 -30 tcp\n"},
		{PLANE_ROTATION_COORDINATES, SWIVEL_POLE_UNKNOWN, CYCLE_OF_C,
		 FREE_TCP "rapid 0 0 0 0 0 tcp\nrapid 8.66025404 5 0 0 0 tcp\n"},
		{PLANE_ROTATION_TABLE, SWIVEL_POLE_UNKNOWN, CYCLE_OF_C,
		 "rapid 0 0 0 0 -30\n" FREE_TCP "rapid 8.66025404 5 0 0 -30 tcp\n"},
	};

	for (size_t i = 0; i < sizeof(told) / sizeof(told[0]); i++) {
		struct gcode_case c;

		klartext_case(&c);
		c.config.controller.plane_rotation = told[i].rotation;
		c.config.controller.swivel_pole = told[i].pole;
		ck_assert_msg(klartext_run(&c, told[i].program), "%s", strbuf_text(&c.messages));
		ck_assert_int_eq(strncmp(strbuf_text(&c.moves), "orient 0 0 1\n", 13), 0);
		ck_assert_str_eq(strbuf_text(&c.moves) + 13, told[i].moves);
		case_release(&c);
	}
}
END_TEST

/* TABLE ROT by half a turn: half_turn of the machine file says in which direction; Q122 has the position. */
START_TEST(table_half_turn)
{
	for (int way = -1; way <= 1; way += 2) {
		struct gcode_case c;
		char moves[160];

		klartext_case(&c);
		c.config.wrap[SLOT_C] = WRAP_SHORTEST;
		c.config.half_turn[SLOT_C] = way;
		ck_assert_msg(klartext_run(&c, "PLANE SPATIAL SPA+0 SPB+0 SPC+180 STAY TABLE ROT\nL C+Q122 FMAX M126\n"
					       "L X+10 Y+5 Z+0 FMAX\n"),
			      "%s", strbuf_text(&c.messages));
		snprintf(moves, sizeof(moves),
			 "orient 0 0 1\nrapid 0 0 0 0 %d\ntcp on length 0 zero A0 C0\nrapid -10 -5 0 0 %d tcp\n", 180 * way,
			 180 * way);
		ck_assert_str_eq(strbuf_text(&c.moves), moves);
		case_release(&c);
	}
}
END_TEST

/*
 * Posts cancel the shift while the plane is still tilted, and then the plane: behind it the first shift counts, or not.
 */
START_TEST(shift_behind_plane)
{
	static const char *const moves[] = {"", "rapid 11 2 0 0 0\n", "rapid 1 2 0 0 0\n"};

	for (int way = SHIFT_BEHIND_PLANE_KEEPS; way <= SHIFT_BEHIND_PLANE_CANCELLED; way++) {
		struct gcode_case c;

		klartext_case(&c);
		c.config.controller.shift_behind_plane = (enum shift_behind_plane)way;
		ck_assert_msg(klartext_run(&c, "CYCL DEF 7.0\nCYCL DEF 7.1 X+10\n"
					       "PLANE SPATIAL SPA-90 SPB+0 SPC+0 STAY\n"
					       "CYCL DEF 7.0\nCYCL DEF 7.1 X+0\nCYCL DEF 7.2 Y+0\nPLANE RESET STAY\n"
					       "L X+1 Y+2 FMAX\n"),
			      "%s", strbuf_text(&c.messages));
		ck_assert_int_eq(strncmp(strbuf_text(&c.moves), "orient 0 1 0\n", 13), 0);
		ck_assert_str_eq(strbuf_text(&c.moves) + 13, moves[way]);
		case_release(&c);
	}
}
END_TEST

/* With a reduced display whole turns count as 0: PLANE RESET stays there or goes to the nearest whole turn. */
START_TEST(whole_turns)
{
	struct gcode_case c;

	klartext_case(&c);
	c.config.wrap[SLOT_C] = WRAP_SHORTEST;
	ck_assert_msg(klartext_run(&c, "L IC+720 A+10 FMAX\nPLANE RESET TURN FMAX\nL IC-20 FMAX\nPLANE RESET TURN FMAX\n"),
		      "%s", strbuf_text(&c.messages));
	ck_assert_str_eq(strbuf_text(&c.moves),
			 "rapid 0 0 0 10 720\nrapid 0 0 0 0 720\nrapid 0 0 0 0 700\nrapid 0 0 0 0 720\n");
	case_release(&c);
	klartext_case(&c);
	ck_assert(!klartext_run(&c, "L IC+720 FMAX\nPLANE RESET TURN FMAX\n"));
	ck_assert_ptr_nonnull(strstr(strbuf_text(&c.messages), "whether PLANE RESET turns C to 0 or to a whole turn"));
	case_release(&c);
}
END_TEST

/* MB of PLANE if no rotary axis has to turn: the tool retracts up to the end of Z, or does not move. */
START_TEST(retract_standing)
{
	static const char *const moves[] = {"", "rapid 0 0 500 0 0\nrapid 0 0 500 0 0\n", ""};

	for (int way = PLANE_RETRACT_ALWAYS; way <= PLANE_RETRACT_TURNING; way++) {
		struct gcode_case c;

		klartext_case(&c);
		c.config.controller.plane_retract = (enum plane_retract)way;
		ck_assert(klartext_run(&c, "PLANE RESET TURN MB MAX FMAX\n"));
		ck_assert_str_eq(strbuf_text(&c.moves), moves[way]);
		case_release(&c);
	}
}
END_TEST

/* With an active tool table L and R of TOOL DEF do not count. */
START_TEST(tool_table_counts)
{
	struct gcode_case c;

	klartext_case(&c);
	c.config.controller.tool_def = TOOL_DEF_IGNORED;
	ck_assert(klartext_run(&c, "TOOL DEF 1 L0 R0\nTOOL CALL 1 Z\nL X+Q108 Z+0 FMAX\n"));
	ck_assert_str_eq(strbuf_text(&c.moves), "tool 1\nrapid 5 0 100 0 0\n");
	case_release(&c);
}
END_TEST

/* Every block is reported once, in order, with its own moves. */
START_TEST(blocks_in_order)
{
	struct gcode_case c;

	klartext_case(&c);
	ck_assert(klartext_run(&c, "F100\nL X+10\nRND R2\nL Y+10\nL X+0\n"));
	ck_assert_str_eq(strbuf_text(&c.blocks), "2:0:F100\n3:1:L X+10\n4:0:RND R2\n5:2:L Y+10\n6:1:L X+0\n");
	case_release(&c);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("gcode_klartext_comp");

	tcase_add_loop_test(tcase, paths_table, 0, COUNT(paths));
	tcase_add_loop_test(tcase, corners_table, 0, COUNT(corners));
	tcase_add_loop_test(tcase, approaches_table, 0, COUNT(approaches));
	tcase_add_loop_test(tcase, equal_table, 0, COUNT(equal));
	tcase_add_test(tcase, free_axis);
	tcase_add_test(tcase, plane_rotation);
	tcase_add_test(tcase, table_half_turn);
	tcase_add_test(tcase, shift_behind_plane);
	tcase_add_test(tcase, whole_turns);
	tcase_add_test(tcase, retract_standing);
	tcase_add_test(tcase, tool_table_counts);
	tcase_add_test(tcase, blocks_in_order);
	return run_suite("gcode_klartext_comp", tcase);
}
