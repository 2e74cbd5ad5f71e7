/* test_gcode_sinumerik_bad.c - programs of the sinumerik dialect that are refused, each with message and place. */
#include "sinumerik_case.h"

struct bad {
	const char *program;
	int line, column;	/* column 0: the line as a whole */
	const char *message;
};

static const struct bad programs[] = {
	{"G500 X1 X=5\n", 1, 9,
	 "the word X stands twice in the block, at columns 6 and 9"},
	{"G500 X1\n", 1, 6,
	 "G1 without a feed rate (F)"},
	{"G500 G2 X1\n", 1, 6,
	 "G2 without a feed rate (F)"},
	{"G500 F6 G2 X1 Y1\n", 1, 9,
	 "a circle needs a centre (I, J, K), a radius (CR=) or an opening angle (AR=)"},
	{"G500 F6 G2 X10 I5 CR=5\n", 1, 9,
	 "a circle has a centre (I, J, K), a radius (CR=), or an opening angle (AR=) with one of end and centre"},
	{"G500 F6 G2 X10 CR=4\n", 1, 16,
	 "a radius of 4 mm does not reach from the start of the circle to its end"},
	{"G500 F6 G2 CR=4\n", 1, 12,
	 "a circle by its radius (CR=) cannot end where it starts; a full circle has a centre (I, J, K)"},
	{"G500 F6 G2 X10 K5\n", 1, 16,
	 "K does not belong to the centre of a circle in the plane of G17"},
	{"G500 F6 G2 I0 J0\n", 1, 9,
	 "a circle of radius 0: 0 mm at its start, 0 mm at its end"},
	{"G500 F6 G3 X10 AR=360\n", 1, 16,
	 "the opening angle AR= must be greater than 0 and less than 360 degrees"},
	{"G500 F6 G3 AR=30\n", 1, 12,
	 "a circle by its opening angle (AR=) needs a centre (I, J, K), or an end that is not its start"},
	{"G500 F6 G3 X1 AR=30 CR=5\n", 1, 9,
	 "a circle has a centre (I, J, K), a radius (CR=), or an opening angle (AR=) with one of end and centre"},
	{"G500 F6 G3 X10 I5 TURN=1.5\n", 1, 19,
	 "TURN must be a whole number from 0 to 999, not 1.5"},
	{"G500 F6 G3 X10 I5 TURN=-1\n", 1, 19,
	 "TURN must be a whole number from 0 to 999, not -1"},
	{"G500 F6 CIP X10 I1=5\n", 1, 9,
	 "CIP needs three different points that do not lie on a line: start, I1= J1= K1=, end"},
	{"G500 F6 CIP X10\n", 1, 9,
	 "CIP needs three different points that do not lie on a line: start, I1= J1= K1=, end"},
	{"G500 G0 I5\n", 1, 9,
	 "I belongs to a circle (G2, G3)"},
	{"G500 G0 CR=5\n", 1, 9,
	 "this word belongs to a circle (G2, G3, CIP)"},
	{"G500 G0 A3=1\n", 1, 1,
	 "A3=, B3= and C3= need TRAORI, which turns the tool into their direction"},
	{"G500 SCALE X2\nG0 X1\nF6 G2 X10 I5\n", 3, 4,
	 "the radius of the circle is 5 mm at its start and 4 mm at its end"},
	{"G500 SCALE X0\n", 1, 6,
	 "a scale must be greater than 0"},
	{"G500 SCALE X=-1\n", 1, 6,
	 "a scale must be greater than 0"},
	{"G500 RPL=30\n", 1, 6,
	 "RPL belongs to ROT and AROT"},
	{"G500 TRANS RPL=30\n", 1, 12,
	 "RPL belongs to ROT and AROT"},
	{"G500 ROT X10 RPL=20\n", 1, 6,
	 "RPL stands alone in its ROT"},
	{"G500 MIRROR C0\n", 1, 6,
	 "only X, Y and Z can be turned, scaled and mirrored here, not C"},
	{"G1 G0 X1\n", 1, 4,
	 "this and the word at column 1 are of one group; a block can have only one of them"},
	{"G17 G18\n", 1, 5,
	 "this and the word at column 1 are of one group; a block can have only one of them"},
	{"G999\n", 1, 1,
	 "G999 is not known"},
	{"G5.5\n", 1, 1,
	 "5.5 is no G-code"},
	{"G34 X1\n", 1, 1,
	 "G34: thread cutting with a pitch that changes is not supported yet"},
	{"G291\n", 1, 1,
	 "G291: ISO mode, the language of Fanuc is not supported yet"},
	{"G58 X1\n", 1, 1,
	 "G58: axial shift of the programmable frame is not supported yet"},
	{"M77\n", 1, 1,
	 "M77 is not known; if it moves no axis, <mcode number=\"77\" action=\"ignore\"/> in the machine's "
	 "<controller> says so"},
	{"M1.5\n", 1, 1,
	 "1.5 is no M-code"},
	{"M3 M4 M5 M6 M7 M8 M9 M10 M11 M12 M0\n", 1, 34,
	 "a block can have at most 10 M-codes"},
	{"N10 N20 X1\n", 1, 5,
	 "N stands at the start of a block only"},
	{"X1 / Y2\n", 1, 4,
	 "'/' stands at the start of a block only"},
	{"B5\n", 1, 1,
	 "the machine has no B axis"},
	{"E5\n", 1, 1,
	 "E is neither an axis of the machine nor an address"},
	{"Q5=1\n", 1, 1,
	 "Q5 is neither an axis of the machine nor a variable of this program; DEF makes one, and those "
	 "that the machine's maker has defined are not known here"},
	{"W=5\n", 1, 1,
	 "the machine has no W axis"},
	{"H5\n", 1, 1,
	 "H5: an auxiliary function of the machine's maker; what it does is not known"},
	{"X1.2.3\n", 1, 5,
	 "unexpected '.'"},
	{"X1EX3\n", 1, 1,
	 "numbers with an exponent (EX) are not supported yet"},
	{"X=\n", 1, 3,
	 "a value is needed here"},
	{"X=1+\n", 1, 5,
	 "a value is needed here"},
	{"X=(1+2\n", 1, 7,
	 "this expression is not closed: ')' is missing"},
	{"X=1/0\n", 1, 4,
	 "division by zero"},
	{"X=7 MOD 0\n", 1, 5,
	 "division by zero"},
	{"X=SQRT(-1)\n", 1, 3,
	 "SQRT of -1: negative numbers have none"},
	{"X=ASIN(2)\n", 1, 3,
	 "ASIN of 2: only numbers from -1 to 1 have one"},
	{"X=LN(0)\n", 1, 3,
	 "LN of 0: only positive numbers have one"},
	{"X=FOO\n", 1, 3,
	 "FOO is no variable of this program; DEF makes one, and those that the machine's maker has defined "
	 "are not known here"},
	{"X=FOO(1)\n", 1, 3,
	 "the function FOO is not known here"},
	{"X=SIN 30\n", 1, 3,
	 "SIN is no variable of this program; DEF makes one, and those that the machine's maker has defined "
	 "are not known here"},
	{"X=R1000\n", 1, 8,
	 "R parameters have numbers up to 999"},
	{"X=R[1.5]\n", 1, 5,
	 "the number of an R parameter must be a whole number from 0 to 999, not 1.5"},
	{"R[1000]=5\n", 1, 3,
	 "the number of an R parameter must be a whole number from 0 to 999, not 1000"},
	{"X=\"A\"\n", 1, 6,
	 "text stands here for a number; compare it with ==, <> or the like"},
	{"X=ATAN2(1)\n", 1, 10,
	 "ATAN2 has 2 arguments, with ',' between them"},
	{"X=1 B_AND 1.5\n", 1, 5,
	 "B_AND, B_OR and B_XOR need whole numbers, not 1.5"},
	{"X=B_NOT 0.5\n", 1, 3,
	 "B_NOT needs a whole number, not 0.5"},
	{"X=\"A\"==\"B\n", 1, 8,
	 "this text is not closed: '\"' is missing"},
	{"X=$MN_SOMETHING\n", 1, 3,
	 "the value of $MN_SOMETHING is known to the control alone"},
	{"X=$AA_IW[Q]\n", 1, 10,
	 "an axis of the machine is needed here"},
	{"$MC_X=1\n", 1, 1,
	 "$MC_X: a program that writes data of the control is not supported yet"},
	{"FOO=1\n", 1, 1,
	 "FOO is neither an axis of the machine nor a variable of this program; DEF makes one, and those "
	 "that the machine's maker has defined are not known here"},
	{"FOO[1]=2\n", 1, 1,
	 "FOO is neither an axis of the machine nor a variable of this program; DEF makes one, and those "
	 "that the machine's maker has defined are not known here"},
	{"DEF FOO X\n", 1, 5,
	 "a type is needed here: INT, REAL, BOOL, CHAR, STRING or AXIS"},
	{"DEF REAL\n", 1, 9,
	 "the name of a variable is needed here, of at most 32 bytes"},
	{"DEF REAL X\n", 1, 10,
	 "X means something else and can be no variable"},
	{"DEF REAL SIN2[0]\n", 1, 15,
	 "the size of an array must be a whole number from 1 to 32767, not 0"},
	{"DEF REAL AB[2]=SET(1,2,3)\n", 1, 24,
	 "AB has no room for so many values"},
	{"DEF REAL AB[2,2,2,2]\n", 1, 19,
	 "an array has at most 3 dimensions"},
	{"DEF INT AB=3000000000\n", 1, 12,
	 "3000000000 does not fit into AB"},
	{"DEF CHAR AB=256\n", 1, 13,
	 "256 does not fit into AB"},
	{"DEF REAL AB=1 2\n", 1, 13,
	 "a blank inside a number"},
	{"DEF REAL AB\nDEF INT AB\n", 2, 9,
	 "AB has been made before, as something else"},
	{"DEF STRING[300] AB\n", 1, 12,
	 "the length of a text must be a whole number from 1 to 200, not 300"},
	{"DEF REAL AB[2]\nX=AB[2]\n", 2, 6,
	 "an index must be a whole number from 0 to 1, not 2"},
	{"DEF REAL AB[2]\nX=AB\n", 2, 5,
	 "'[' is needed behind AB"},
	{"DEF REAL TRAORI\n", 1, 10,
	 "TRAORI means something else and can be no variable"},
	{"DEF AXIS AB=Q\n", 1, 13,
	 "an axis of the machine is needed here"},
	{"IF 1==1\n", 1, 1,
	 "IF in line 1 has no ENDIF"},
	{"IF 1==1 X1\n", 1, 9,
	 "nothing can follow here"},
	{"WHILE 1==0\n", 1, 1,
	 "WHILE in line 1 has no ENDWHILE"},
	{"ENDWHILE\n", 1, 1,
	 "ENDWHILE closes no WHILE that has begun"},
	{"ENDFOR\n", 1, 1,
	 "ENDFOR closes no FOR that has begun"},
	{"ENDLOOP\n", 1, 1,
	 "ENDLOOP closes no LOOP that has begun"},
	{"UNTIL 1==1\n", 1, 1,
	 "UNTIL closes no REPEAT that has begun"},
	{"FOR X=1 TO 2\n", 1, 5,
	 "X is no variable of this program that FOR can count; DEF makes one"},
	{"FOR R1=1\n", 1, 9,
	 "TO is needed here"},
	{"FOR R1=1 TO 3\nR1=5\n", 2, 0,
	 "the loop of line 1 is not closed at the end of the file"},
	{"LOOP\n", 1, 0,
	 "the loop of line 1 is not closed at the end of the file"},
	{"GOTOF NOWHERE\n", 1, 7,
	 "there is no label NOWHERE from here on"},
	{"GOTOB NOWHERE\n", 1, 7,
	 "there is no label NOWHERE before this line"},
	{"GOTO NOWHERE\n", 1, 6,
	 "there is no label NOWHERE in this program"},
	{"GOTOF\n", 1, 6,
	 "the label or block number to jump to is needed here"},
	{"GOTO A1 X5\n", 1, 9,
	 "nothing can follow here"},
	{"CASE 1 GOTOF A\n", 1, 8,
	 "OF is needed here"},
	{"CASE 1 OF 1 X5\n", 1, 13,
	 "GOTOF, GOTOB, GOTO or GOTOC is needed here"},
	{"CASE 1 OF A GOTOF B\n", 1, 11,
	 "a number is needed here"},
	{"REPEAT NOWHERE P=2\n", 1, 8,
	 "there is no label NOWHERE in this program"},
	{"REPEATB NOWHERE\n", 1, 9,
	 "there is no label NOWHERE in this program"},
	{"AA: X=1 REPEAT\n", 1, 9,
	 "REPEAT stands at the start of its block"},
	{"ELSE\n", 1, 1,
	 "IF in line 1 has no ENDIF"},
	{"RET\n", 1, 1,
	 "this returns, but no subprogram is being carried out"},
};

/* The message is the only one, and the caret stands below the column of the line that it names. */
START_TEST(refused)
{
	const struct bad *bad = &programs[_i];
	struct strbuf expected = {0};
	const char *line = bad->program;
	struct gcode_case c;

	sinumerik_case_init(&c);
	ck_assert_msg(!case_run(&c, bad->program), "accepted: %s", bad->program);
	for (int i = 1; i < bad->line; i++)
		line = strchr(line, '\n') + 1;
	if (bad->column)
		strbuf_addf(&expected, "p.nc:%d:%d: error: %s\n    %.*s\n    %*s\n", bad->line, bad->column, bad->message,
			    (int)strcspn(line, "\n"), line, bad->column, "^");
	else
		strbuf_addf(&expected, "p.nc:%d: error: %s\n", bad->line, bad->message);
	ck_assert_str_eq(strbuf_text(&c.messages), strbuf_text(&expected));
	strbuf_release(&expected);
	case_release(&c);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("gcode_sinumerik_bad");
	TCase *tcase = tcase_create("programs");
	SRunner *runner;
	int failed;

	tcase_add_loop_test(tcase, refused, 0, sizeof(programs) / sizeof(programs[0]));
	suite_add_tcase(suite, tcase);
	runner = srunner_create(suite);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
