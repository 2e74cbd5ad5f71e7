/* test_gcode_klartext_same.c - Klartext: patterns, approaches and others, and simpler blocks that make the same moves. */
#include "klartext_case.h"

#define START "TOOL CALL 1 Z S100\nL X+10 Y+20 Z+100 FMAX\n"
#define DRILL "CYCL DEF 200 DRILLING Q200=2 Q201=-10 Q206=150 Q202=10 Q203=+0 Q204=20\n"
#define AT(x, y) "L X" x " Y" y " FMAX M99\n"

/* Patterns, and the same holes written one by one. */
static const struct {
	const char *blocks, *same;
} equal[] = {
	/* An older cycle, which CYCL CALL may follow at once. */
	{START "L Z+2 FMAX\nCYCL DEF 1.0 PECKING\nCYCL DEF 1.1 SET UP 2\nCYCL DEF 1.2 DEPTH -10\nCYCL DEF 1.3 PECKG 5\n"
	 "CYCL DEF 1.4 DWELL 0\nCYCL DEF 1.5 F100\nCYCL CALL\nL X+30 FMAX\nCYCL CALL M8\n",
	 START "L Z+2 FMAX\nCYCL DEF 1.0 PECKING\nCYCL DEF 1.1 SET UP 2\nCYCL DEF 1.2 DEPTH -10\nCYCL DEF 1.3 PECKG 5\n"
	 "CYCL DEF 1.4 DWELL 0\nCYCL DEF 1.5 F100\nL M99\nL X+30 FMAX M99\n"},
	/* CONTOUR DEF names the contours, too. */
	{START "CONTOUR DEF P1 = LBL 1 I2 = LBL 2\nCYCL DEF 20 DATA Q1=-15 Q5=0 Q6=2 Q7=50\nCYCL DEF 22 ROUGH-OUT Q12=500\nM99\n"
	 "M30\nLBL 1\nL X+0 Y+0 RR\nL X+80\nL Y+60\nL X+0\nL Y+0\nLBL 0\nLBL 2\nL X+20 Y+20 RL\nL X+30 Y+30\nLBL 0\n",
	 START "CYCL DEF 14.0\nCYCL DEF 14.1 LABEL1 /2\nCYCL DEF 20 DATA Q1=-15 Q5=0 Q6=2 Q7=50\nCYCL DEF 22 ROUGH-OUT Q12=500\n"
	 "M99\nM30\nLBL 1\nL X+0 Y+0 RR\nL X+80\nL Y+60\nL X+0\nL Y+0\nLBL 0\nLBL 2\nL X+20 Y+20 RL\nL X+30 Y+30\nLBL 0\n"},
	{START DRILL "PATTERN DEF ~\n POS1 (X+1 Y+2 Z+0) ~\n POS2 (X+3 Y+4)\nCYCL CALL PAT FMAX M8\n",
	 START DRILL "L Z+100 FMAX\n" AT("+1", "+2") "L Z+100 FMAX\n" AT("+3", "+4")},
	/* IX and IY count from the point before. */
	{START DRILL "PATTERN DEF POS1 (X+1 Y+2 Z+0) POS2 (IX+3 Y+4)\nPOS3 (X+5 IY-1)\nPOS4 (IX+1 IY+1)\nCYCL CALL PAT\n",
	 START DRILL "PATTERN DEF POS1 (X+1 Y+2) POS2 (X+4 Y+4) POS3 (X+5 Y+3) POS4 (X+6 Y+4)\nCYCL CALL PAT\n"},
	{START "L Z+5 FMAX\n" DRILL "PATTERN DEF ROW1 (X+1 Y+2 D+8 NUM3 ROT+90)\nCYCL CALL PAT\n",
	 START "L Z+5 FMAX\n" DRILL "L Z+20 FMAX\n" AT("+1", "+2") "L Z+20 FMAX\n" AT("+1", "+10")
	 "L Z+20 FMAX\n" AT("+1", "+18")},
	{START DRILL "PATTERN DEF PAT1 (X+1 Y+2 DX+8 DY+9 NUMX2 NUMY2 ROT+0 Z+0)\nL Z+20 FMAX\nCYCL CALL PAT\n",
	 START DRILL "L Z+20 FMAX\nL Z+20 FMAX\n" AT("+1", "+2") "L Z+20 FMAX\n" AT("+9", "+2") "L Z+20 FMAX\n"
	 AT("+9", "+11") "L Z+20 FMAX\n" AT("+1", "+11")},
	/* ROTX turns the rows alone, ROTY the way from row to row, ROT both. */
	{START DRILL "PATTERN DEF PAT1 (X+1 Y+2 DX+8 DY+9 NUMX2 NUMY2 ROT-90 ROTX+90 ROTY+90)\nL Z+20 FMAX\nCYCL CALL PAT\n",
	 START DRILL "L Z+20 FMAX\nL Z+20 FMAX\n" AT("+1", "+2") "L Z+20 FMAX\n" AT("+9", "+2") "L Z+20 FMAX\n"
	 AT("+9", "+11") "L Z+20 FMAX\n" AT("+1", "+11")},
	/* F is the feed rate between the points. */
	{START DRILL "PATTERN DEF ROW1 (X+1 Y+2 D+8 NUM2)\nL Z+20 FMAX\nCYCL CALL PAT F500\n",
	 START DRILL "L Z+20 FMAX\nL Z+20 F500\nL X+1 Y+2 F500 M99\nL Z+20 F500\nL X+9 Y+2 F500 M99\n"},
	/* Without F the last programmed feed is in force, whatever feed a cycle has. */
	{START "L X+5 F700\nL Z+20 FMAX\n" DRILL "PATTERN DEF ROW1 (X+1 Y+2 D+8 NUM2)\nCYCL CALL PAT\n",
	 START "L X+5 F700\nL Z+20 FMAX\n" DRILL "PATTERN DEF ROW1 (X+1 Y+2 D+8 NUM2)\nCYCL CALL PAT F700\n"},
	/* Cycles that only give data are not called. */
	{START DRILL "CYCL DEF 271 OCM CONTOUR DATA Q203=+0 Q201=-20\nCYCL DEF 270 DATA Q390=1\nL X+1 Y+2 FMAX\n"
	 DRILL "M99\n",
	 START DRILL "L X+1 Y+2 FMAX M99\n"},
	{START DRILL "CYCL DEF 271 OCM CONTOUR DATA Q371=+0\nL X+1 Y+2 FMAX M99\n",
	 START DRILL "L X+1 Y+2 FMAX M99\n"},
	/* APPR goes to its helper point like the positioning block before it, also with a cycle between them. */
	{START "L X+1 Y+2 FMAX\n" DRILL "M99\nAPPR LT X+20 Y+0 LEN10 RR F100\nL X+50 Y+0\nDEP LN LEN5\n",
	 START "L X+1 Y+2 FMAX\n" DRILL "M99\nL X+10 Y-5 FMAX\nL X+20 Y+0 RR F100\nL X+50\nDEP LN LEN5\n"},
	{START DRILL "PATTERN DEF CIRC1 (X+1 Y+2 D+20 START+0 NUM4)\nL Z+20 FMAX\nCYCL CALL PAT\n",
	 START DRILL "L Z+20 FMAX\nL Z+20 FMAX\n" AT("+11", "+2") "L Z+20 FMAX\n" AT("+1", "+12") "L Z+20 FMAX\n"
	 AT("-9", "+2") "L Z+20 FMAX\n" AT("+1", "-8")},
	{START DRILL "PATTERN DEF PITCHCIRC1 (X+1 Y+2 D+20 START+90 STEP+90 NUM2)\nL Z+20 FMAX\nCYCL CALL PAT\n",
	 START DRILL "L Z+20 FMAX\nL Z+20 FMAX\n" AT("+1", "+12") "L Z+20 FMAX\n" AT("-9", "+2")},
	/* Approaches and departures in polar coordinates. */
	{START "CC X+50 Y+0\nAPPR PLT PR+30 PA+180 LEN10 RR F100\nLP PA+90 PR+30\nDEP PLCT PR+100 PA+90 R+8\n",
	 START "APPR LT X+20 Y+0 LEN10 RR F100\nL X+50 Y+30\nDEP LCT X+50 Y+100 R+8\n"},
	{START "CC X+50 Y+0\nAPPR PLN PR+30 PA+180 LEN10 RL F100\nLP PA+90 PR+30\nDEP LN LEN5\n",
	 START "APPR LN X+20 Y+0 LEN10 RL F100\nL X+50 Y+30\nDEP LN LEN5\n"},
	{START "CC X+50 Y+0\nAPPR PCT PR+30 PA+180 CCA90 R+10 RL F100\nLP PA+90 PR+30\nDEP LN LEN5\n",
	 START "APPR CT X+20 Y+0 CCA90 R+10 RL F100\nL X+50 Y+30\nDEP LN LEN5\n"},
	/* Tapping with chip breaking goes up and down on the line of a tap without. */
	{START "CYCL DEF 209 TAPPING Q200=2 Q201=-10 Q239=+1 Q203=0 Q204=20 Q257=5 Q256=0.2 Q336=0 Q403=1\n" AT("+1", "+2"),
	 START "CYCL DEF 207 TAPPING Q200=2 Q201=-10 Q239=+1 Q203=0 Q204=20\n" AT("+1", "+2")},
	/* Statements that move no axis. */
	{START "FUNCTION FEED DWELL D-TIME0.5 F-TIME5\nFUNCTION S-PULSE P-TIME10 SCALE5\nFUNCTION FEED RESET\nL X+1 F100\n",
	 START "L X+1 F100\n"},
	{START DRILL "CYCL DEF 220 POLAR PATTERN Q216=1 Q217=2 Q244=20 Q245=0 Q246=360 Q247=0 Q241=4 Q200=2 Q203=0 Q204=30 "
	 "Q301=1\nL X+0 FMAX\n",
	 START "CYCL DEF 200 DRILLING Q200=2 Q201=-10 Q206=150 Q202=10 Q203=+0 Q204=30\nL Z+30 FMAX\n" AT("+11", "+2")
	 "L Z+30 FMAX\n" AT("+1", "+12") "L Z+30 FMAX\n" AT("-9", "+2") "L Z+30 FMAX\n" AT("+1", "-8") "L X+0 FMAX\n"},
	{START DRILL "CYCL DEF 221 PATTERN Q225=1 Q226=2 Q237=8 Q238=9 Q242=2 Q243=2 Q224=0 Q200=2 Q203=0 Q204=30 Q301=0\n"
	 "L X+0 FMAX\n",
	 START "CYCL DEF 200 DRILLING Q200=2 Q201=-10 Q206=150 Q202=10 Q203=+0 Q204=2\nL Z+30 FMAX\n" AT("+1", "+2")
	 "L Z+2 FMAX\n" AT("+9", "+2") "L Z+2 FMAX\n" AT("+9", "+11") "L Z+2 FMAX\n" AT("+1", "+11") "L X+0 FMAX\n"},
};

START_TEST(equal_table)
{
	struct gcode_case c[2];

	for (int i = 0; i < 2; i++) {
		const char *blocks = i ? equal[_i].same : equal[_i].blocks;

		klartext_case(&c[i]);
		ck_assert_msg(klartext_run(&c[i], blocks), "%s%s", blocks, strbuf_text(&c[i].messages));
	}
	ck_assert_str_eq(strbuf_text(&c[0].moves), strbuf_text(&c[1].moves));
	case_release(&c[0]);
	case_release(&c[1]);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("gcode_klartext_same");

	tcase_add_loop_test(tcase, equal_table, 0, COUNT(equal));
	return run_suite("gcode_klartext_same", tcase);
}
