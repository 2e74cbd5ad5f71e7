/* test_gcode_klartext_bad_cycle.c - what is wrong with cycles and patterns: the exact messages. */
#include "klartext_case.h"

static const struct klartext_fault faults[] = {
	{"CYCL DEF 32.0\nCYCL DEF 32.1 T-1\n",
	 "p.nc:3:10: error: a path tolerance cannot be negative"},
	{"CYCL DEF 200 DRILLING ~\n Q200=2 ~ ;SET-UP CLEARANCE\n",
	 "p.nc:3:9: error: '~' is the last sign of a line: write the comment before it"},
	{"M99\n",
	 "p.nc:2:1: error: no cycle has been defined that could be called"},
	{"L A+30 FMAX\nL M128\nCYCL DEF 200 DRILLING Q200=2 Q201=-4 Q206=150 Q202=4 Q203=+0 Q204=9\nM99\n",
	 "p.nc:5:1: error: a cycle while M128 is in force and the tool does not lie along Z is not supported; write PLANE in "
	 "place of M128"},
	{"CYCL DEF 200 DRILLING Q200=2 Q206=150 Q202=4 Q203=+0 Q204=9\nM99\n",
	 "p.nc:3:1: error: CYCL DEF 200 lacks Q201"},
	{"CYCL DEF 200 DRILLING Q200=2 Q201=4 Q206=150 Q202=4 Q203=+0 Q204=9\nM99\n",
	 "p.nc:3:1: error: Q201=4: what a depth above the surface does depends on a machine parameter"},
	{"CYCL DEF 200 DRILLING Q200=2 Q201=-4 Q206=150 Q202=4 Q203=+0 Q204=9\nQ201=-9\nM99\n",
	 "p.nc:4:1: error: Q201 has been changed since CYCL DEF 200: whether the call takes its new value is not known here; "
	 "define the cycle anew"},
	{"CYCL DEF 200 DRILLING Q200=2 Q201=-4 Q206=150 Q202=4 Q203=+0 Q204=9\nFN 18: SYSREAD Q203 = ID270 NR1 IDX3\nM99\n",
	 "p.nc:4:1: error: Q203 has been changed since CYCL DEF 200: whether the call takes its new value is not known here; "
	 "define the cycle anew"},
	{"CYCL DEF 200 DRILLING Q200=-2 Q201=-4 Q206=150 Q202=4 Q203=+0 Q204=9\nM99\n",
	 "p.nc:3:1: error: a set-up clearance (Q200, Q204) cannot be negative"},
	{"CYCL DEF 200 DRILLING Q200=2 Q201=-4 Q206=0 Q202=4 Q203=+0 Q204=9\nM99\n",
	 "p.nc:3:1: error: a cycle without a feed rate"},
	{"CYCL DEF 200 DRILLING Q200=2 Q201=-4 Q206=150 Q202=-4 Q203=+0 Q204=9\nM99\n",
	 "p.nc:3:1: error: Q202: a peck cannot be negative"},
	{"CYCL DEF 200 DRILLING Q200=2 Q201=-4 Q206=150 Q202=0.00001 Q203=+0 Q204=9\nM99\n",
	 "p.nc:3:1: error: Q202: more than 100000 pecks"},
	{"CYCL DEF 200 DRILLING Q200=2 Q201=-4 Q206=FZ Q202=4 Q203=+0 Q204=9\n",
	 "p.nc:2:38: error: Q206=FZ is not supported yet: give a number"},
	{"CYCL DEF 200 DRILLING Q200 2\n",
	 "p.nc:2:28: error: '=' is needed here"},
	{"CYCL DEF 200 DRILLING Q200=2 X+5\n",
	 "p.nc:2:33: error: '=' is needed here"},
	{"CYCL DEF 202 BORING Q200=2 Q201=-10 Q206=100 Q208=0 Q203=+0 Q204=20 Q214=7\nM99\n",
	 "p.nc:3:1: error: Q214 is a whole number from 0 to 4"},
	{"CYCL DEF 204 BACK BORING Q200=2 Q249=5\nM99\n",
	 "p.nc:3:1: error: CYCL DEF 204 lacks Q250"},
	{"CYCL DEF 204 BACK BORING Q200=2 Q249=5 Q250=20 Q251=3 Q252=15 Q203=0 Q204=20\nM99\n",
	 "p.nc:3:1: error: CYCL DEF 204 lacks Q253"},
	{"CYCL DEF 22 ROUGH-OUT Q10=-5 Q11=150 Q12=500\nM99\n",
	 "p.nc:3:1: error: CYCL DEF 22 without CYCL DEF 20"},
	{"CYCL DEF 20 DATA Q1=-15 Q5=0 Q6=2 Q7=50\nCYCL DEF 22 ROUGH-OUT Q12=500\nM99\n",
	 "p.nc:4:1: error: CYCL DEF 22, but no CYCL DEF 14 has named contours"},
	{"CYCL DEF 14.0\nCYCL DEF 14.1 LABEL1\nCYCL DEF 20 DATA Q1=-15 Q5=0 Q6=2 Q7=50\nCYCL DEF 22 ROUGH-OUT Q12=500\nM99\n",
	 "p.nc:6:1: error: the program has no LBL 1"},
	{"CYCL DEF 14.0\nCYCL DEF 14.1 LABEL1\nCYCL DEF 20 DATA Q1=-15 Q5=0 Q6=2 Q7=50\nCYCL DEF 22 ROUGH-OUT Q12=500\n"
	 "Q1=-20\nM99\n",
	 "p.nc:7:1: error: Q1 has been changed since CYCL DEF 20: whether the call takes its new value is not known here; "
	 "define the cycle anew"},
	{"CYCL DEF 14.0\nCYCL DEF 14.1 LABEL1\nCYCL DEF 20 DATA Q1=-15 Q5=0 Q6=2 Q7=50\nCYCL DEF 22 ROUGH-OUT Q12=500\n"
	 "M99\nM30\nLBL 1\nL X+0 Y+0 RR\nFL X+5\nLBL 0\n",
	 "p.nc:10:1: error: FL in a contour of CYCL DEF 14 is not supported yet"},
	{"CYCL DEF 14.0\nCYCL DEF 14.1 LABEL1\nCYCL DEF 20 DATA Q1=-15 Q5=0 Q6=2 Q7=50\nCYCL DEF 22 ROUGH-OUT Q12=500\n"
	 "M99\nM30\nLBL 1\nL X+0 RR\nLBL 0\n",
	 "p.nc:9:3: error: a contour begins with coordinates of X and Y"},
	{"CYCL DEF 14.0\nCYCL DEF 14.1 LABEL1\nCYCL DEF 20 DATA Q1=-15 Q5=0 Q6=2 Q7=50\nCYCL DEF 22 ROUGH-OUT Q12=500\n"
	 "M99\nM30\nLBL 1\nL X+0 Y+0 RR\n",
	 "p.nc:10:1: error: END in a contour of CYCL DEF 14 is not supported yet"},
	{"CYCL DEF 14.0\nCYCL DEF 14.1 \"A\"\n",
	 "p.nc:3:15: error: CYCL DEF 14.1 needs the numbers of labels, as in LABEL1 /2"},
	{"CYCL DEF 25 CONTOUR TRAIN\n",
	 "p.nc:2:10: error: CYCL DEF 25: contour train is not followed; if it stays near the place where it is called, <macro "
	 "program=\"25\" action=\"around\" X=\"\" Y=\"\" Z=\"\"/> in the machine's <controller> says how far it moves"},
	{"TOOL CALL 1 Z DL+0.1\nTOOL CALL S500\n",
	 "p.nc:3:11: error: TOOL CALL without the oversize (DL, DR) that the one before has given: whether it still counts is not "
	 "known here; write it, too"},
	{"CYCL DEF 200 DRILLING Q200=2 Q201=-4 Q206=150 Q202=4 Q203=+0 Q204=9 Q395=1\nM99\n",
	 "p.nc:3:1: error: Q395=1 needs the point angle of the tool: give the tool of the setup a <cutter> with "
	 "tip=\"cone\" and its angle, or write Q395=0 and the depth of the tip in Q201"},
	{"CYCL DEF 256 STUD Q200=2 Q201=-10 Q203=0 Q204=20 Q207=100 Q218=60 Q219=40 Q424=64 Q425=44\nM99\n",
	 "p.nc:3:1: error: CYCL DEF 256 needs the radius of the tool: give the tool of the setup a <cutter>, or diameter=\"\""},
	{"TOOL CALL 1 Z\nCYCL DEF 232 FACE MILLING Q225=0 Q226=0 Q227=1 Q218=50 Q219=40 Q200=2\nM99\n",
	 "p.nc:4:1: error: CYCL DEF 232 lacks Q386"},
	{"TOOL CALL 1 Z\nCYCL DEF 267 THREAD Q335=20 Q200=2 Q203=0 Q201=-20 Q204=50 Q207=500\nM99\n",
	 "p.nc:4:1: error: CYCL DEF 267 lacks Q239"},
	{"TOOL CALL 1 Z\nCYCL DEF 258 STUD Q571=60 Q222=64 Q572=2 Q200=2 Q203=0 Q201=-20 Q204=50 Q207=500\nM99\n",
	 "p.nc:4:1: error: Q572 of CYCL DEF 258 is a whole number from 3 to 30"},
	{"TOOL CALL 1 Z\nCYCL DEF 258 STUD Q571=60 Q222=64 Q572=6 Q573=2 Q200=2 Q203=0 Q201=-20 Q204=50 Q207=500\nM99\n",
	 "p.nc:4:1: error: Q573 of CYCL DEF 258 is 0 or 1"},
	{"CYCL DEF 4.0\nCYCL DEF 4.1 SET UP 2\nCYCL DEF 4.2 DEPTH -5\nCYCL DEF 4.4 X80\nCYCL DEF 4.6 F100\nM99\n",
	 "p.nc:7:1: error: CYCL DEF 4 needs its sides in X and Y"},
	{"CYCL DEF 5.0\nCYCL DEF 5.1 SET UP 2\nCYCL DEF 5.2 DEPTH 5\nM99\n",
	 "p.nc:5:1: error: the depth of CYCL DEF 5 is above the surface"},
	{"CYCL DEF 5.0\nCYCL DEF 5.1 SET UP 2\nCYCL DEF 5.2 DEPTH -5\nCYCL DEF 5.4 RADIUS 10\nM99\n",
	 "p.nc:6:1: error: a cycle without a feed rate"},
	{"CYCL DEF 207 RIGID TAPPING Q200=2 Q201=-9 Q239=1 Q203=+0 Q204=20\nM99\n",
	 "p.nc:3:1: error: CYCL DEF 207 without a spindle speed (S)"},
	{"CYCL DEF 240 CENTERING Q200=2 Q343=1 Q201=-2 Q344=-10 Q206=100 Q211=0 Q203=+0 Q204=20\nM99\n",
	 "p.nc:3:1: error: Q343=1 needs the point angle of the tool: give the tool of the setup a <cutter> with "
	 "tip=\"cone\" and its angle, or write Q343=0 and the depth of the tip in Q201"},
	{"CYCL DEF 240 CENTERING Q200=2 Q343=1 Q201=-2 Q344=+10 Q206=100 Q211=0 Q203=+0 Q204=20\nM99\n",
	 "p.nc:3:1: error: Q344=10: what a depth above the surface does depends on a machine parameter; a diameter below it "
	 "is negative"},
	{"CYCL DEF 208 BORE MILLING Q200=2 Q201=-10 Q206=100 Q203=0 Q204=20\nM99\n",
	 "p.nc:3:1: error: CYCL DEF 208 lacks Q335"},
	{"CYCL DEF 20 DATA Q1=-15 Q3=6 Q5=0 Q6=2 Q7=50\nCYCL DEF 24 SIDE Q10=-5 Q11=150 Q12=500 Q14=0.2\nM99\n",
	 "p.nc:4:1: error: CYCL DEF 24 with an allowance Q3 above Q14 and the radius of the tool mills outside of its "
	 "contours, too: how far is not known here; program the contour with RL or RR instead"},
	{"CYCL DEF 251 POCKET Q200=2 Q201=-10 Q207=100 Q203=0 Q204=20 Q218=-40 Q219=20\nM99\n",
	 "p.nc:3:1: error: Q218 of CYCL DEF 251 is a size and cannot be negative"},
	{"CYCL DEF 208 BORE Q200=2 Q201=-10 Q206=100 Q203=0 Q204=20 Q335=-40\nM99\n",
	 "p.nc:3:1: error: Q335 of CYCL DEF 208 is a size and cannot be negative"},
	{"CYCL DEF 251 POCKET Q200=2 Q201=-10 Q207=100 Q203=0 Q204=20 Q218=20 Q219=20 Q367=7\nM99\n",
	 "p.nc:3:1: error: Q367 of CYCL DEF 251 is a whole number from 0 to 4"},
	{"CYCL DEF 254 SLOT Q200=2 Q201=-10 Q207=100 Q203=0 Q204=20 Q375=20 Q219=2 Q216=0 Q217=0 Q367=1\nM99\n",
	 "p.nc:3:1: error: CYCL DEF 254 with Q367 other than 0 is not supported yet"},
	{"CYCL DEF 252 POCKET Q200=2 Q201=10 Q207=100 Q203=0 Q204=20 Q223=20\nM99\n",
	 "p.nc:3:1: error: Q201=10: what a depth above the surface does depends on a machine parameter"},
	{"CYCL DEF 26.0\nCYCL DEF 26.1 X2 Y2\nCYCL DEF 252 POCKET Q200=2 Q201=-10 Q207=100 Q203=0 Q204=20 Q223=20\nM99\n",
	 "p.nc:5:1: error: CYCL DEF 252 while a scaling is in force: the size of what it mills is then not known here; cancel "
	 "the scaling first"},
	{"CYCL DEF 252 POCKET Q200=2 Q201=-10 Q207=0 Q203=0 Q204=20 Q223=20\nM99\n",
	 "p.nc:3:1: error: a cycle without a feed rate"},
	{"CYCL DEF 220 POLAR PATTERN Q200=2\n",
	 "p.nc:2:10: error: CYCL DEF 220 lacks Q216"},
	{"CYCL DEF 259 FOO\n",
	 "p.nc:2:10: error: CYCL DEF 259 is not known: it may be a cycle of the machine's builder; if it moves no axis, "
	 "<macro program=\"259\" action=\"none\"/> in the machine's <controller> says so"},
	{"CYCL DEF 413 DATUM\n",
	 "p.nc:2:10: error: touch probe cycle 413: where the probe stops is not known before the program runs; if it stays near "
	 "its place, <macro program=\"413\" action=\"around\" X=\"\" Y=\"\" Z=\"\"/> in the machine's <controller> says how far it "
	 "moves"},
	{"CYCL DEF 385 OEM\n",
	 "p.nc:2:10: error: CYCL DEF 385 is not known: it may be a cycle of the machine's builder; if it moves no axis, "
	 "<macro program=\"385\" action=\"none\"/> in the machine's <controller> says so"},
	{"CYCL DEF X\n",
	 "p.nc:2:10: error: CYCL DEF needs the number of a cycle"},
	{"CYCL FOO\n",
	 "p.nc:2:6: error: CYCL needs DEF or CALL"},
	{"CYCL CALL PAT X+5\n",
	 "p.nc:2:15: error: CYCL CALL PAT has no coordinates"},
	{"CYCL CALL PAT FMAX\n",
	 "p.nc:2:11: error: CYCL CALL PAT, but neither PATTERN DEF nor SEL PATTERN has given points"},
	{"PATTERN DEF POS1 (X+0 Y+0)\nCYCL CALL PAT FMAX\n",
	 "p.nc:3:11: error: a pattern needs a cycle with Q203 that has been defined before it"},
	{"CYCL CALL X+5\n",
	 "p.nc:2:11: error: CYCL CALL with coordinates is written as CYCL CALL POS"},
	{"CYCL CALL POS X+5\n",
	 "p.nc:2:15: error: CYCL CALL POS needs absolute coordinates of X, Y and Z"},
	{"CYCL DEF 200 DRILLING Q200=2 Q201=-4 Q206=150 Q202=4 Q203=+0 Q204=9\nCYCL CALL POS X+5 Y+5 Z+5\n",
	 "p.nc:3:15: error: CYCL CALL POS from below the set-up clearance: how the tool gets there is not known here"},
	{"PATTERN DEF POS1\n",
	 "p.nc:2:17: error: '(' is needed here"},
	{"PATTERN DEF POS1 (X+1)\n",
	 "p.nc:2:16: error: a word of this pattern is missing"},
	{"PATTERN DEF POS1 (X+1 K+2)\n",
	 "p.nc:2:23: error: this is no word of a pattern"},
	{"PATTERN DEF ROW1 (X+1 Y+2 D+3 NUM1.5)\n",
	 "p.nc:2:16: error: a number of points is a whole number from 1 to 1000"},
	{"PATTERN DEF FRAME1 (X+1 Y+2 DX+3 DY+4 NUMX2)\n",
	 "p.nc:2:18: error: a word of this pattern is missing"},
	{"PATTERN DEF SQUARE1 (X+1 Y+2)\n",
	 "p.nc:2:13: error: PATTERN DEF reads POS, ROW, PAT, FRAME, CIRC and PITCHCIRC"},
	{"PATTERN DEF PAT1 (X+1 Y+2 DX+3 DY+4 NUMX500 NUMY500)\n",
	 "p.nc:2:16: error: a pattern has at most 1000 points"},
	{"POS1 (X+1 Y+2)\n",
	 "p.nc:2:1: error: points of a pattern belong behind PATTERN DEF"},
	{"PATTERN TAB\n",
	 "p.nc:2:9: error: PATTERN needs DEF"},
	{"SEL PATTERN \"X\"\n",
	 "p.nc:2:13: error: there is no file of the point table X"},
	{"SEL CONTOUR \"X\"\n",
	 "p.nc:2:1: error: SEL other than SEL PGM, SEL TABLE and SEL PATTERN is not supported yet"},
	{"SEL TABLE \"TNC:\\A.D\"\nSEL TABLE \"TNC:\\A.D\"\nSEL TABLE \"TNC:\\B.D\"\n",
	 "p.nc:4:11: error: a second datum table: the rows of the setup (<work_offset name=\"#1\"/>) are those of one table, "
	 "TNC:\\A.D"},
	{"TCH PROBE 413\n",
	 "p.nc:2:11: error: touch probe cycle 413: where the probe stops is not known before the program runs; if it stays near "
	 "its place, <macro program=\"413\" action=\"around\" X=\"\" Y=\"\" Z=\"\"/> in the machine's <controller> says how far it "
	 "moves"},
	{"TCH PROBE 0.0 REF. PLANE Q5 X-\n",
	 "p.nc:2:11: error: TCH PROBE 0: where the probe stops is not known before the program runs; to check the "
	 "program, leave it out, and assign what it measures by FN 0"},
	{"TCH PROBE 0.1 X+5 Y+0 Z-5\n",
	 "p.nc:2:11: error: TCH PROBE needs the number of a cycle, 0 to 9999"},
	{"TOOL CALL 1 Z F100\nCYCL DEF 200 DRILLING Q200=2 Q201=-4 Q206=MEX Q202=4 Q203=0 Q204=9\n",
	 "p.nc:3:38: error: Q206=MEX is not supported yet: give a number"},
	{"CYCL DEF 200 DRILLING Q200=2 Q201=-4 Q206=AUTO Q202=4 Q203=0 Q204=9\nM99\n",
	 "p.nc:3:1: error: a cycle without a feed rate"},
	{"CYCL DEF 220 PATTERN Q216=0 Q217=0\n",
	 "p.nc:2:10: error: CYCL DEF 220 lacks Q244"},
	{"PATTERN DEF POS1 (X+1 Y+2)\nCYCL CALL PAT\n",
	 "p.nc:3:11: error: a pattern needs a cycle with Q203 that has been defined before it"},
	{"CONTOUR DEF P1 = \"A.H\"\n",
	 "p.nc:2:18: error: CONTOUR DEF reads contours of labels with a number, as in P1 = LBL 1"},
	{"CONTOUR DEF P1 = LBL 1 DEPTH5\n",
	 "p.nc:2:24: error: CONTOUR DEF reads contours as P1 = LBL 1 and I2 = LBL 2"},
	{"CONTOUR P1\n",
	 "p.nc:2:9: error: CONTOUR needs DEF"},
	{"TCH 413\n",
	 "p.nc:2:5: error: TCH needs PROBE"},
	{"CYCL DEF 1.0 PECKING\nCYCL DEF 1.1 SET UP -2\nM99\n",
	 "p.nc:4:1: error: the set-up clearance of CYCL DEF 1 cannot be negative"},
	{"CYCL DEF 1.0 PECKING\nCYCL DEF 1.2 DEPTH 2\nM99\n",
	 "p.nc:4:1: error: the depth of CYCL DEF 1 is above the surface"},
};

START_TEST(fault_table)
{
	klartext_expect_fault(&faults[_i]);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("bad");

	tcase_add_loop_test(tcase, fault_table, 0, COUNT(faults));
	return run_suite("gcode_klartext_bad_cycle", tcase);
}
