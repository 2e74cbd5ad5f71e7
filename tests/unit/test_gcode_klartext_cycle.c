/* test_gcode_klartext_cycle.c - Klartext: cycles that drill and tap, and their calls, by hand. */
#include "klartext_case.h"

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
	/* "String parameters": the first place is 0; a text that is not found gives the length. */
	{"QS1 = \"TOOL25.5\"\nQS2 = \"25\"\nQS3 = SUBSTR ( SRC_QS1 BEG4 LEN4 )\nQ1 = TONUMB ( SRC_QS3 )\n"
	 "Q2 = INSTR ( SRC_QS1 SEA_QS2 BEG0 )\nQ3 = INSTR ( SRC_QS1 SEA_QS2 BEG5 )\nL X+Q1 Y+Q2 Z+Q3 FMAX\n",
	 "rapid 25.5 4 8 0 0\n"},
	{"QS1 = TOCHAR ( DAT+0.5 DECIMALS3 ) || \"X\"\nQ1 = STRLEN ( SRC_QS1 )\nQS2 = \"0.600\"\n"
	 "Q2 = STRCOMP ( SRC_QS1 SEA_QS2 )\nQ3 = STRCOMP ( SRC_QS2 SEA_QS1 )\nL X+Q1 Y+Q2 Z+Q3 FMAX\n"
	 "Q1 = STRCOMP ( SRC_QS2 SEA_QS2 )\nQS1 = SYSSTR ( ID10321 NR0 )\nQS1 = \"5\"\nQ2 = TONUMB ( SRC_QS1 )\n"
	 "L X+Q1 Y+Q2 FMAX\n",
	 "rapid 6 -1 1 0 0\nrapid 0 5 1 0 0\n"},
	{"Q1 = -0.0000000001\nQS1 = TOCHAR ( DAT+Q1 DECIMALS2 )\nQS2 = TOCHAR ( DAT-1 DECIMALS0 )\nQ1 = STRLEN ( SRC_QS1 )\n"
	 "Q2 = STRLEN ( SRC_QS2 )\nL X+Q1 Y+Q2 FMAX\n",
	 "rapid 4 2 0 0 0\n"},
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

START_TEST(cycles_table)
{
	klartext_expect(&cycles[_i], false);
}
END_TEST

/* Taps without a speed or a pitch, as posts write them that have no data of the tool: one warning, and the path. */
START_TEST(taps_without_speed)
{
	static const char *const taps[] = {
		"S0\nCYCL DEF 207 RIGID TAPPING Q200=2 Q201=-9 Q239=1 Q203=+0 Q204=2\nL X+1 FMAX M99\nL X+2 FMAX M99\n",
		"S9\nCYCL DEF 207 RIGID TAPPING Q200=2 Q201=-9 Q239=0 Q203=+0 Q204=2\nL X+1 FMAX M99\nL X+2 FMAX M99\n",
		"L Z+2 FMAX\nCYCL DEF 17.0\nCYCL DEF 17.1 SET UP 2\nCYCL DEF 17.2 DEPTH -9\nCYCL DEF 17.3 PITCH 1\n"
		"L X+1 FMAX M99\nL X+2 FMAX M99\n",
	};
	struct gcode_case c;

	klartext_case(&c);
	ck_assert_msg(klartext_run(&c, taps[_i]), "%s", strbuf_text(&c.messages));
	ck_assert_ptr_nonnull(strstr(strbuf_text(&c.messages), "a thread or a feed per revolution without a "
			      "spindle speed (S), or without a pitch, where the control stops or waits; the path is checked at "
			      "the largest speeds of the axes"));
	ck_assert_uint_eq(c.diag.warnings, 1);
	ck_assert_ptr_nonnull(strstr(strbuf_text(&c.moves), "feed 1 0 -9 0 0\nfeed 1 0 2 0 0\n"));
	ck_assert_ptr_nonnull(strstr(strbuf_text(&c.moves), "feed 2 0 -9 0 0\nfeed 2 0 2 0 0\n"));
	case_release(&c);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("gcode_klartext_cycle");

	tcase_add_loop_test(tcase, cycles_table, 0, COUNT(cycles));
	tcase_add_loop_test(tcase, taps_without_speed, 0, 3);
	return run_suite("gcode_klartext_cycle", tcase);
}
