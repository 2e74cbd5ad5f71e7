/* test_gcode_klartext_flow.c - Klartext: Q parameters and program flow, against moves worked out by hand. */
#include "klartext_case.h"

/* Q parameters, FN 0 to 8 and 13, formulas. */
static const struct klartext_program parameters[] = {
	{"Q1 = 5\nL X+Q1 Y-Q1 FMAX\n",
	 "rapid 5 -5 0 0 0\n"},
	{"Q1=+2.5\n",
	 ""},
	{"FN 0: Q5 = +60\nFN 1: Q1 = -Q5 + +5\nFN 2: Q2 = +10 - +5\nFN 3: Q3 = +3 * +3\n"
	 "FN 4: Q4 = +8 DIV +Q2\nL X+Q1 Y+Q2 Z+Q3 FMAX\nL X+Q4 FMAX\n",
	 "rapid -55 5 9 0 0\nrapid 1.6 5 9 0 0\n"},
	{"FN 5: Q20 = SQRT 4\nFN 6: Q21 = SIN 30\nFN 7: Q22 = COS 60\nFN 8: Q23 = +3 LEN +4\n"
	 "FN 13: Q24 = +10 ANG +10\nL X+Q20 Y+Q21 Z+Q22 FMAX\nL X+Q23 Y+Q24 FMAX\n",
	 "rapid 2 0.5 0.5 0 0\nrapid 5 45 0.5 0 0\n"},
	{"FN0:Q1=4\nL X+Q1 FMAX\n",
	 "rapid 4 0 0 0 0\n"},
	{"Q1 = 5 - 2 ^ 2\nQ2 = (-3) ^ 2\nQ4 = -2\nQ3 = Q4^2 - -2^3\nL X+Q1 Y+Q2 Z+Q3 FMAX\n",
	 "rapid 1 9 12 0 0\n"},
	{"Q1 = 5 * 3 + 2 * 10\nQ2 = SQ 10 - 3^3\nL X+Q1 Y+Q2 FMAX\n",
	 "rapid 35 73 0 0 0\n"},
	{"Q1 = ( 1 + 2 ) * 3 - 8 / 4\nQ2 = 2 ^ 3 * 2\nQ3 = 10 % 4\nL X+Q1 Y+Q2 Z+Q3 FMAX\n",
	 "rapid 7 16 2 0 0\n"},
	{"Q1 = SIN 30 + COS 60 + TAN 45\nQ2 = ASIN 0.5\nQ3 = ACOS (0,5)\nL X+Q1 Y+Q2 Z+Q3 FMAX\n",
	 "rapid 2 30 60 0 0\n"},
	{"Q1 = ATAN 1\nQ2 = SQRT 16\nQ3 = ABS -3\nL X+Q1 Y+Q2 Z+Q3 FMAX\n",
	 "rapid 45 4 3 0 0\n"},
	{"Q1 = NEG 2\nQ2 = INT 2.7\nQ3 = FRAC -2.25\nL X+Q1 Y+Q2 Z+Q3 FMAX\n",
	 "rapid -2 2 -0.25 0 0\n"},
	{"Q1 = PI\nQ2 = COS (180 * PI / PI)\nL X+Q1 Y+Q2 FMAX\n",
	 "rapid 3.14159265 -1 0 0 0\n"},
	{"QL5 = 3\nQR7 = 4\nL X+QL5 Y+QR7 FMAX\n",
	 "rapid 3 4 0 0 0\n"},
	{"Q1 = -5\nL X-Q1 Y+Q1 FMAX\n",
	 "rapid 5 -5 0 0 0\n"},
	{"Q10 = 100\nL X+1 FQ10\nL X+2 F Q10\n",
	 "feed 1 0 0 0 0\nfeed 2 0 0 0 0\n"},
	{"TOOL CALL 1 Z\nQ1 = Q108\nQ2 = Q114\nL X+Q1 Y+Q2 FMAX\n",
	 "tool 1\nrapid 5 100 0 0 0\n"},
	{"TOOL CALL 1 Z DR+0.5 DL-1\nL X+Q108 Y+Q114 Z+Q109 FMAX\n",
	 "tool 1\nrapid 5.5 99 101 0 0\n"},
	/*
	 * FN 18: data that the program and the setup give. An unknown value may be assigned, and it does no harm if it
	 * is not used.
	 */
	{"TOOL CALL 2 Z S500\nM4\nFN 18: SYSREAD Q1 = ID20 NR1\nFN18 : SYSREAD Q2=ID50 NR2 IDX1\n"
	 "FN 18: SYSREAD Q3 = ID50 NR1 IDXQ1\nL X+Q1 Y+Q2 Z+Q3 FMAX\nFN 18: SYSREAD Q1 = ID20 NR4\n"
	 "FN 18: SYSREAD Q2 = ID20 NR5\nFN 18: SYSREAD Q3 = ID10 NR1\nL X+Q1 Y+Q2 Z+Q3 FMAX\n",
	 "tool 2\nrapid 2 5 80 0 0\nrapid 500 1 40 0 0\n"},
	{"CYCL DEF 7.0\nCYCL DEF 7.1 X+5\nCYCL DEF 7.2 Z-3\nFN 18: SYSREAD Q1 = ID220 NR2 IDX1\n"
	 "FN 18: SYSREAD Q3 = ID220 NR2 IDX3\nFN 18: SYSREAD Q2 = ID210 NR6\nL X+Q1 Y+Q2 Z+Q3 FMAX\n",
	 "rapid 10 0 -6 0 0\n"},
	{"CYCL DEF 10.0\nCYCL DEF 10.1 ROT+90\nFN 18: SYSREAD Q1 = ID210 NR2\nFN 18: SYSREAD Q2 = ID280 NR1\n"
	 "FN 18: SYSREAD Q3 = ID210 NR3\nFN 18: SYSREAD Q4 = ID210 NR4 IDX2\nL X+Q4 Y+Q2 Z+Q1 FMAX\n",
	 "rapid 0 1 90 0 0\n"},
	/* The active tool compensation with the oversizes of TOOL CALL, and the preset that the program has selected. */
	{"TOOL CALL 1 Z DL+2 DR-0.5\nFN 18: SYSREAD Q1 = ID200 NR1 IDX3\nFN 18: SYSREAD Q2 = ID200 NR2\n"
	 "CYCL DEF 247 Q339=+1\nFN 18: SYSREAD Q3 = ID530 NR1\nL X+Q1 Y+Q2 FMAX\nL X+Q3 FMAX\n",
	 "tool 1\nrapid 4.5 102 0 0 0\nrapid 1 102 0 0 0\n"},
	/*
	 * Positions after the axes have reached them: in coordinates of the program (ID 270) and of the machine (ID
	 * 240).
	 */
	{"CYCL DEF 7.0\nCYCL DEF 7.1 X+100\nCYCL DEF 10.0\nCYCL DEF 10.1 ROT+90\nL X+3 Y-4 C+20 FMAX\n"
	 "FN 20: WAIT FOR SYNC\nFN 18: SYSREAD Q1 = ID270 NR1 IDX1\nFN 18: SYSREAD Q2 = ID270 NR1 IDX2\n"
	 "FN 18: SYSREAD Q6 = ID270 NR1 IDX6\nFN 18: SYSREAD Q7 = ID240 NR1 IDX1\n"
	 "L X+Q7 FMAX M91\nL X+Q1 Y+Q2 Z+Q6 FMAX\n",
	 "rapid 104 3 0 0 20\nrapid 104 3 0 0 20\nrapid 104 3 20 0 20\n"},
	{"FN 18: SYSREAD Q1 = ID270 NR1 IDX1\nFN 28: TABREAD Q2 = 5/\"X,Y\"\nFN 26: TABOPEN TNC:\\A.TAB\n"
	 "FN 27: TABWRITE 5/\"X\" = Q1\nFN 20: WAIT FOR SYNC\nFN 15: PRINT Q1\nFN 0: Q1 = +7\nL X+Q1 FMAX\n",
	 "rapid 7 0 0 0 0\n"},
	/* Blocks of several lines. */
	{"7 L X+1 ~\n  Y+2~\n Z+3 FMAX ; done\n8 L X+4 FMAX ; no more ~\nL Y+5 FMAX\nL X+6 FMAX~\n\n",
	 "rapid 1 2 3 0 0\nrapid 4 2 3 0 0\nrapid 4 5 3 0 0\nrapid 6 5 3 0 0\n"},
	{"/L X+1 ~\n Y+2 FMAX\nBLK FORM CYLINDER Z R50 ~\n L105 DIST+5\nL X+3 FMAX ; done ~\n7 Y+4 FMAX\n"
	 "LBL \"A~\" ~\n\nLBL 0\n",
	 "rapid 1 2 0 0 0\nrapid 3 2 0 0 0\nrapid 3 4 0 0 0\n"},
	{"Q1 = 5 * ~\n  ( 1 + ~ \n 1 ) ; twice\nL X+Q1 FMAX\n",
	 "rapid 10 0 0 0 0\n"},
	{"TOOL CALL 1 Z\nTOOL CALL DL-Q108 DR+1\nL Z+0 X+Q108 FMAX\nTOOL CALL DL+0 DR+0\nL X+Q108 Z+0 FMAX\n",
	 "tool 1\nrapid 6 0 95 0 0\nrapid 5 0 100 0 0\n"},
	{"Q1 = 2\nQ1 = Q1 * Q1\nQ1 = Q1 * Q1\nL X+Q1 FMAX\n",
	 "rapid 16 0 0 0 0\n"},
	{"Q1=1\nL XQ1 FMAX\n",
	 "rapid 1 0 0 0 0\n"},
};

/* Labels, subprograms, section repeats, jumps. */
static const struct klartext_program flow[] = {
	{"CALL LBL 1\nL X+9 FMAX\nM30\nLBL 1\nL IX+1 FMAX\nLBL 0\n",
	 "rapid 1 0 0 0 0\nrapid 9 0 0 0 0\n"},
	{"CALL LBL 1\nCALL LBL 1\nL M2\nLBL 1\nL IX+1 FMAX\nLBL 0\n",
	 "rapid 1 0 0 0 0\nrapid 2 0 0 0 0\n"},
	{"LBL 1\nL IX+1 FMAX\nCALL LBL 1 REP 3\nL Y+1 FMAX\n",
	 "rapid 1 0 0 0 0\nrapid 2 0 0 0 0\nrapid 3 0 0 0 0\nrapid 4 0 0 0 0\nrapid 4 1 0 0 0\n"},
	{"LBL 1\nL IX+1 FMAX\nCALL LBL 1 REP 2/2\nL Y+1 FMAX\n",
	 "rapid 1 0 0 0 0\nrapid 2 0 0 0 0\nrapid 3 0 0 0 0\nrapid 3 1 0 0 0\n"},
	{"LBL 1\nLBL 2\nL IX+1 FMAX\nCALL LBL 2 REP 1\nL IY+1 FMAX\nCALL LBL 1 REP 1\n",
	 "rapid 1 0 0 0 0\nrapid 2 0 0 0 0\nrapid 2 1 0 0 0\nrapid 3 1 0 0 0\nrapid 4 1 0 0 0\n"
	 "rapid 4 2 0 0 0\n"},
	{"CALL LBL \"UP\"\nM2\nLBL \"UP\"\nL IZ+5 FMAX\nLBL 0\n",
	 "rapid 0 0 5 0 0\n"},
	{"Q1=0\nLBL 5\nQ1 = Q1 + 1\nL X+Q1 FMAX\nFN 12: IF +Q1 LT +3 GOTO LBL 5\n",
	 "rapid 1 0 0 0 0\nrapid 2 0 0 0 0\nrapid 3 0 0 0 0\n"},
	{"Q1=3\nFN 9: IF +Q1 EQU +3 GOTO LBL 7\nL X+1 FMAX\nLBL 7\nL X+2 FMAX\n",
	 "rapid 2 0 0 0 0\n"},
	{"FN 10: IF 1 NE 1 GOTO LBL 7\nL X+1 FMAX\nLBL 7\nL X+2 FMAX\n",
	 "rapid 1 0 0 0 0\nrapid 2 0 0 0 0\n"},
	{"FN 11: IF 2 GT 1 GOTO LBL \"A B\"\nL X+1 FMAX\nLBL \"A B\"\nL X+2 FMAX\n",
	 "rapid 2 0 0 0 0\n"},
	{"CALL LBL 1\nM30\nLBL 1\nCALL LBL 2\nL IX+1 FMAX\nLBL 0\nLBL 2\nL IY+1 FMAX\nLBL 0\n",
	 "rapid 0 1 0 0 0\nrapid 1 1 0 0 0\n"},
	{"LBL 3\nL X+1 FMAX\nLBL 0\nL X+2 FMAX\n",
	 "rapid 1 0 0 0 0\nrapid 2 0 0 0 0\n"},
	{"L X+5 FMAX\nM30\nLBL 1\nL IX+1 FMAX\nLBL 0\n",
	 "rapid 5 0 0 0 0\n"},
	{"M30\nL X+1 FMAX\n",
	 ""},
	{"CALL LBL 01\nM2\nLBL 1\nL IX+1 FMAX\nLBL 0\n",
	 "rapid 1 0 0 0 0\n"},
	{"Q5=2\nCALL LBL Q5\nM2\nLBL 2\nL IX+1 FMAX\nLBL 0\n",
	 "rapid 1 0 0 0 0\n"},
	{"LBL 1\nL IX+1 FMAX\nCALL LBL 1 REP 0\nL Y+1 FMAX\n",
	 "rapid 1 0 0 0 0\nrapid 1 1 0 0 0\n"},
	{"CALL LBL 9\nCALL LBL 9\nM2\nLBL 9\nLBL 8\nL IX+1 FMAX\nCALL LBL 8 REP 1\nLBL 0\n",
	 "rapid 1 0 0 0 0\nrapid 2 0 0 0 0\nrapid 3 0 0 0 0\nrapid 4 0 0 0 0\n"},
	{"FN 16: F-PRINT X.A / Y\nL X+1 FMAX\n",
	 "rapid 1 0 0 0 0\n"},
	{"QS1=\"A\"\nCALL LBL QS1\nM30\nLBL \"A\"\nL X+1 FMAX\nLBL 0\n",
	 "rapid 1 0 0 0 0\n"},
	{"FN 0: Q1 SET UNDEFINED\nFN 9: IF Q1 IS UNDEFINED GOTO LBL 1\nL X+1 FMAX\nLBL 1\nQ1=5\n"
	 "FN 9: IF Q1 IS UNDEFINED GOTO LBL 2\nL X+2 FMAX\nLBL 2\nFN 9: IF Q1 IS DEFINED GOTO LBL 3\nL X+3 FMAX\nLBL 3\n",
	 "rapid 2 0 0 0 0\n"},
};

START_TEST(parameters_table)
{
	klartext_expect(&parameters[_i], false);
}
END_TEST

START_TEST(flow_table)
{
	klartext_expect(&flow[_i], false);
}
END_TEST

/* "/": a block of several lines is left out as a whole; a comment and a label may begin with it. */
START_TEST(block_skip)
{
	static const struct {
		const char *blocks, *all, *without;
	} programs[] = {
		{"L Z+9 FMAX M3\n"
		 "1 CYCL DEF 200 X ~\n Q200=2 ~\n Q201=-10 ~\n Q206=150 ~\n Q202=10 ~\n Q203=+0 ~\n Q204=20\n"
		 "/ 2 CYCL DEF 200 X ~\n ; deeper ~\n Q200=2 ~\n Q201=-20 ~\n Q206=150 ~\n Q202=20 ~\n Q203=+0 ~\n Q204=30\n"
		 "3 CYCL CALL\n",
		 "rapid 0 0 9 0 0\nrapid 0 0 2 0 0\nfeed 0 0 -20 0 0\nrapid 0 0 2 0 0\nrapid 0 0 30 0 0\n",
		 "rapid 0 0 9 0 0\nrapid 0 0 2 0 0\nfeed 0 0 -10 0 0\nrapid 0 0 2 0 0\nrapid 0 0 20 0 0\n"},
		/* Older programs have no '~' in such a block. */
		{"L Z+9 FMAX M3\n"
		 "1 CYCL DEF 200 X\n Q200=2\n Q201=-10\n Q206=150\n Q202=10\n Q203=+0\n Q204=20\n"
		 "/2 CYCL DEF 200 X\n Q200=2\n Q201=-20\n Q206=150\n Q202=20\n Q203=+0\n Q204=30\n"
		 "3 CYCL CALL\n",
		 "rapid 0 0 9 0 0\nrapid 0 0 2 0 0\nfeed 0 0 -20 0 0\nrapid 0 0 2 0 0\nrapid 0 0 30 0 0\n",
		 "rapid 0 0 9 0 0\nrapid 0 0 2 0 0\nfeed 0 0 -10 0 0\nrapid 0 0 2 0 0\nrapid 0 0 20 0 0\n"},
		{"/6 CYCL DEF 7.0\n/7 CYCL DEF 7.1 X+100\n8 L X+1 FMAX\n", "rapid 101 0 0 0 0\n", "rapid 1 0 0 0 0\n"},
		{"/L X+1 ~\n Y+2 FMAX\n/9 Q1 = 1 + ~\n 2\n9 /L X+3 FMAX\nL Z+4 FMAX\n",
		 "rapid 1 2 0 0 0\nrapid 3 2 0 0 0\nrapid 3 2 4 0 0\n", "rapid 0 0 4 0 0\n"},
		{"/ 1 ; text\n/2 * - part\n/\n/* - part\nL X+1 FMAX\n", "rapid 1 0 0 0 0\n", "rapid 1 0 0 0 0\n"},
		{"CALL LBL 2\n/M30\nL X+9 FMAX\nM30\nLBL 2\n/ L X+1 FMAX\nLBL 0\n", "rapid 1 0 0 0 0\n",
		 "rapid 9 0 0 0 0\n"},
		{"/CALL LBL 1\nL Z+1 FMAX\nM30\n/ 42 LBL 1\n/ 43 L X+1 FMAX\n/ 44 LBL 0\n",
		 "rapid 1 0 0 0 0\nrapid 1 0 1 0 0\n", "rapid 0 0 1 0 0\n"},
	};

	for (size_t i = 0; i < COUNT(programs); i++) {
		for (int skip = 0; skip < 2; skip++) {
			struct gcode_case c;

			klartext_case(&c);
			c.config.read.block_delete = skip;
			ck_assert_msg(klartext_run(&c, programs[i].blocks), "%s", strbuf_text(&c.messages));
			ck_assert_str_eq(strbuf_text(&c.moves), skip ? programs[i].without : programs[i].all);
			case_release(&c);
		}
	}
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("gcode_klartext_flow");

	tcase_add_loop_test(tcase, parameters_table, 0, COUNT(parameters));
	tcase_add_loop_test(tcase, flow_table, 0, COUNT(flow));
	tcase_add_test(tcase, block_skip);
	return run_suite("gcode_klartext_flow", tcase);
}
