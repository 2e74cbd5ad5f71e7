/*
 * test_gcode_macro.c - macros of Fanuc and Haas: variables, branches, loops, calls; expressions are in test_gcode_macro_values.c.
 *
 * FM is the Fanuc Series 30i/31i/32i operator's manual (B-63944EN), custom macros; HM the Haas mill
 * operator's manual, chapter "Macros". Expected values are worked out by hand from the manuals' rules.
 */
#include "gcode_case.h"

#include <sys/wait.h>
#include <unistd.h>

enum { F = 1, H = 2, BOTH = F | H };

/* Programs and the X of their moves. */
static const struct {
	int dialects;
	const char *program, *ways;
} programs[] = {
	/* FM variable reference: behind any address; minus; brackets; indirect */
	{BOTH, "#1=0\n#2=5.\nG#1 X-#2\nX[#2+1.]\n#3=2\nX#[#3]\nX#[#3-1]\nM30\n", "-5 6 5 0"},
	/* FM undefined variable, HM address substitution: a vacant word is not there */
	{BOTH, "G0 X1. Y#5\nX#5 Y2.\n#6=#5\nX#6 Y3.\nM30\n", "1 1 1"},
	{F, "#6=#5*2\nG0 X1.\nX#6\n#7=#5+#5\nX2.\nX#7\nM30\n", "1 0 2 0"},
	/* FM types of variables: #100 to #199 are vacant at first; one set for all levels */
	{F, "G0 X1. Y#100\n#150=2.\nX#150\nM30\n", "1 2"},
	/* HM "Variable usage": #10100 is another name of #100 */
	{H, "#10100=3.\nG0 X#100\nM30\n", "3"},
	/* HM ROUND: the manual's own example, inches to four places, and its automatic rounding */
	{H, "G20\n#1=1.00333\nG0 X[#1+#1]\nX[ROUND[#1]+ROUND[#1]]\nM30\n", "50.97018 50.96764"},
	/* FM variable reference: 12.3456 in mm is 12.346 */
	{BOTH, "#1=12.3456\nG0 X#1\nM30\n", "12.346"},
	/* several statements of a line, the line's number, a comment */
	{BOTH, "N10 #1=1. #2=2. (done)\nG0 X[#1+#2];\nM30\n", "3"},
	/* what LinuxCNC obeys in comments is text here */
	{BOTH, "(PY, x)\nG0 X1. (ABORT, it is done)\nM30\n", "1"},
	/* FM branch: forward first, then from the start, so that the second N1 is found from the second line */
	{F, "N1 G0 X1.\nGOTO 1\nG0 X9.\nN1 X2.\nM30\n", "1 2"},
	{F, "#1=0\nN1 #1=#1+1\nG0 X#1\nIF [#1 LT 3] GOTO 1\nM30\n", "1 2 3"},
	{BOTH, "#9=20\nGOTO #9\nG0 X1.\nN20 G0 X2.\nM30\n", "2"},
	{BOTH, "#9=20\nGOTO [#9+1]\nG0 X1.\nN21 G0 X2.\nM30\n", "2"},
	/* in the program in hand, and in none besides */
	{BOTH, "M98 P7\nGOTO 5\nG0 X8.\nN5 M30\nO7\nGOTO 5\nG0 X9.\nN5 G0 X1.\nM99\n", "1"},
	/* FM conditional branch (IF); HM IF THEN */
	{BOTH, "#1=1\nIF [#1 EQ 1] THEN #2=5.\nIF [#1 EQ 2] THEN #2=6.\nG0 X#2\nM30\n", "5"},
	/* HM "Conditional Expressions": M99 P of a condition */
	{H, "#1=1\n[#1 LT 10] M99 P10\nG0 X1.\nN10 G0 X2.\nM30\n", "2"},
	/* FM repetition (WHILE); HM looping */
	{BOTH, "#1=0\nWHILE [#1 LT 3] DO1\n#1=#1+1\nG0 X#1\nEND1\nX9.\nM30\n", "1 2 3 9"},
	{BOTH, "WHILE [1 EQ 2] DO1\nG0 X1.\nEND1\nG0 X2.\nM30\n", "2"},
	{BOTH, "#1=0\nWHILE[#1LT2]DO1\n#1=#1+1\n#2=0\nWHILE[#2LT2]DO2\n#2=#2+1\nG0X[#1*10+#2]\nEND2\nEND1\nM30\n",
	 "11 12 21 22"},
	/* the same number twice, one after the other; out of a loop */
	{BOTH, "#1=0\nWHILE [#1 LT 1] DO1\n#1=#1+1\nG0 X1.\nEND1\nWHILE [#1 LT 2] DO1\n#1=#1+1\nX2.\nEND1\n"
	 "M30\n", "1 2"},
	/* What a condition leaves out is not computed. */
	{BOTH, "#1=1\nIF [#1 EQ 2] THEN #2=1/0 AND SIN[30] (x)\nIF [#1 EQ 2] GOTO #[1/0] ;\nG0 X#1\nM30\n", "1"},
	{BOTH, "#1=0\nDO1\n#1=#1+1\nG0 X#1\nIF [#1 EQ 2] GOTO 5\nEND1\nN5 X7.\nM30\n", "1 2 7"},
	/* out of two loops at once, and into them again by their DO */
	{BOTH,
	 "#3=0\nN1 #3=#3+1\nWHILE [1 EQ 1] DO1\nWHILE [1 EQ 1] DO2\nG0 X#3\nIF [#3 LT 3] GOTO 1\nGOTO 9\nEND2\nEND1\n"
	 "N9 M30\n",
	 "1 2 3"},
	/* a loop's number in a comment is none */
	{BOTH, "#1=0\nWHILE [#1 LT 1] DO1 (END1)\n(END1)\n#1=#1+1\nG0 X1.\nEND1\nM30\n", "1"},
	/* FM abbreviation */
	{F, "#1=0\nWH[#1LT2]DO1\n#1=#1+1\nG0X#1\nEN1\nGO5\nX9.\nN5M30\n", "1 2"},
	/* FM, subprogram call (M98): L, eight digits, after the move of its own block */
	{BOTH, "G0 X1. M98 P100 L2\nX5.\nM30\nO100\nG91 X1.\nG90\nM99\n", "1 2 3 5"},
	{F, "G91 G0 X1.\nM98 P00020100\nM30\nO0100\nX2.\nM99\n", "1 3 5"},
	{F, "G91 G0 X1.\nM98 P20100\nM30\nO0100\nX2.\nM99\n", "1 3 5"},
	{BOTH, "M98 P1\nM30\nO0001\nG0 X1.\nM98 P2\nX3.\nM99\nO2\nX2.\nM99\n", "1 2 3"},
	/* M99 of the program itself: it begins again behind the '%' that opens it */
	{BOTH, "%\nO1 (A)\nG91 G0 X1.\nIF[#5001GE3]GOTO9\nM99\nN9 M30\n%\n", "1 2 3"},
	{BOTH, "\n%TITLE\nO1\nG91 G0 X1.\nIF[#5001GE3]GOTO9\nM99\nN9 M30\n%\n", "1 2 3"},
	{BOTH, "M8 M98 P100\nM30\nO100\nG0 X2.\nM99\n", "2"},
	/* The P of G54 is one of an additional work offset, of which there are 48. */
	{F, "G10 L2 P1 X10.\nG90 G54 G0 X1. M98 P100 L2\nM30\nO100\nG0 X2.\nM99\n", "11 12 12"},
	{F, "G10 L2 P1 X10.\nG54 M98 P49\nM30\nO49\nG0 X2.\nM99\n", "12"},
	/* B-64484EN, M98 with a sequence number: a block of the program in hand, up to M99 */
	{F, "M98 Q7\nX5.\nM98 Q7 L2\nM30\nN7 G91 G0 X1.\nG90\nM99\n", "1 5 6 7"},
	{F, "M98 P9\nM30\nN7 G0 X8.\nM99\nO9\nM98 Q7\nM99\nN7 G0 X3.\nM99\n", "3"},
	/* M98 shares the caller's local variables, G65 does not (FM difference between G65 and M98) */
	{BOTH, "#1=4.\nM98 P7\nG0 X#1\nM30\nO7\nG0 X#1\n#1=5.\nM99\n", "4 5"},
	{BOTH, "#1=4.\nG65 P7 A2.\nG0 X#1\nM30\nO7\nG0 X#1\n#1=5.\nM99\n", "2 4"},
	/* FM argument specification I and II, mixture; HM G65 with its alternate addresses */
	{BOTH, "G65 P7 Z26. D7. E8. F9. H11. M13. Q17. R18. S19. T20. U21. V22. W23. X24. Y25.\nM30\nO7\n"
	 "G0 X[#26-#7-#8-#9]\nX[#11+#13]\nX[#17+#18+#19+#20]\nX[#21+#22+#23]\nX[#24+#25]\nM99\n",
	 "2 24 74 66 49"},
	{BOTH, "G65 P7 A1. B2. C3. I4. J5. K6. I7. J8. K9. I10. K12. I13.\nM30\nO7\nG0 X#1\nX#3\nX#5\nX#7\nX#9\nX#10\n"
	 "X#12\nX#13\nX#11\nM99\n",
	 "1 3 5 7 9 10 12 13"},
	{BOTH, "G65 P1000 A1.0 B2.0 I-3.0 I4.0 D5.0\nM30\nO1000\nG0 X#1\nX#2\nX#4\nX#7\nM99\n", "1 2 -3 5"},
	{BOTH, "#1=3.\nG65 P7 A#1 B[#1+1.] C#9\nM30\nO7\nG0 X#1\nX#2\nX#3\nM99\n", "3 4"},
	{BOTH, "G65 P7 A3.\nM30\nO7\nG0 X#1\nIF [#1 LE 1] GOTO 1\nG65 P7 A[#1-1.]\nX#1\nN1 M99\n", "3 2 1 2 3"},
	/* HM G65: the variables remain from one repetition to the next */
	{H, "G65 P7 L3 A1.\nM30\nO7\nG0 X#1\n#1=#1+1.\nM99\n", "1 2 3"},
	{F, "G65 P7 L2\nM30\nO7\nG91 G0 X1.\nM99\n", "1 2"},
	/* FM modal call (G66): after each move; not by its own block, the macro's moves, others' blocks */
	{F, "G0 X1.\nG66 P7 A5.\nX2.\nM8\n#1=1\nY3.\nG67\nX4.\nM30\nO7\nX[#1*10.]\nM99\n", "1 2 50 50 50 4"},
	/* HM M97: a part of the same program */
	{H, "M97 P100 L2\nG0 X5.\nM30\nN100 G91 G0 X1.\nG90\nM99\n", "1 2 5"},
	/* M99 P: FM subprogram, to a block of the caller; HM, to one of the subprogram */
	{F, "M98 P7\nG0 X1.\nN20 G0 X2.\nM30\nO7\nG0 X8.\nM99 P20\n", "8 2"},
	{H, "M98 P7\nG0 X1.\nM30\nO7\nG0 X8.\nM99 P20\nX9.\nN20 X10.\nM99\n", "8 10 1"},
	{BOTH, "G0 X1.\nM99 P5\nX2.\nN5 X3.\nM30\n", "1 3"},
	/* M99 of the program itself: anew, until a pass changes nothing */
	{BOTH, "G0 X1.\nX2.\nM99\n", "1 2 1 2"},
	{F, "#100=#100+1\nG0 X#100\nIF [#100 EQ 3] GOTO 9\nM99\nN9 M30\n", "1 2 3"},
	/* FM system variables: end of the block before, modes, work offsets */
	{BOTH, "G10 L2 P1 X10. Y0.\nG54 G0 X1. Y7.\nX[#5001+#5002]\nM30\n", "11 18"},
	{BOTH, "G10 L2 P2 X10. Y20.\nG0 X#5241\nX[#5242-1.]\n#5241=3.\nG55 X1.\nM30\n", "10 19 4"},
	{BOTH, "G0 X1.\n#5221=10.\nG54\nX1.\n#5221=20.\nG54 X2.\nM30\n", "1 11 22"},
	{BOTH, "G1 F5. X[#4003-80.]\nG91 X[#4003-90.]\nX[#4002+#4001-17.]\nX#4006\nX#4109\nM30\n", "10 10 11 32 37"},
	/* cutter compensation, tool length, cycle, return level, H */
	{BOTH, "G0 X#4007\nX#4008\nX#4009\nX#4010\nM30\n", "40 49 80 98"},
	{BOTH, "F9. G99 G81 X1. Z-1. R1.\n#1=#4009\n#2=#4010\nG80\nG0 X#1\nX#2\nX#4009\nM30\n",
	 "1 1 1 1 81 99 80"},
	{F, "G43 H0\nG0 X#4008\nX#4111\nM30\n", "43 0"},
	{F, "G55\nG0 X#4014\nM30\n", "55"},
	{H, "G55\nG0 X#4012\nM30\n", "55"},
	{F, "G10 L20 P3 X4.\nG0 X#7041\nM30\n", "4"},
	{H, "G10 L20 P3 X4.\nG0 X#14041\nX1.\nX#7041\nM30\n", "4 1 4"},
	/* FM macro call, stop with a message: a stop, as M0; clocks may be set */
	{BOTH, "#3006=1 (TURN THE PART)\n#3001=0\n#3003=1\n#3004=3\nG0 X1.\nM30\n", "1"},
	/* FM external output commands, HM DPRNT */
	{BOTH, "POPEN\nDPRNT[X#1[53]*Y]\nPCLOS\nG0 X1.\nM30\n", "1"},
	/* FM, names of common variables */
	{F, "SETVN 101[DEPTH,WIDTH]\nG0 X1.\nM30\n", "1"},
	/* what M-codes of these manuals move nothing */
	{F, "M29 S100\nG0 X1.\nM30\n", "1"},
	{H, "M10\nM11\nM12\nM13\nM31\nM33\nM8 P1\nM88\nM89\nG103 P1\nG0 X1.\nG103\nM30\n", "1"},
};

static void add_way(struct strbuf *ways, const char *moves)
{
	for (const char *at = moves; *at; at = strchr(at, '\n') + 1) {
		const char *x = strchr(at, ' ') + 1;

		strbuf_addf(ways, "%s%.*s", ways->length ? " " : "", (int)strcspn(x, " "), x);
	}
}

static void expect_ways(const struct dialect *dialect, const char *program, const char *expected)
{
	struct strbuf found = {0};
	struct gcode_case c;

	case_init(&c);
	c.config.dialect = dialect;
	ck_assert_msg(case_run(&c, program) && !c.messages.length, "%s: %s", program, strbuf_text(&c.messages));
	add_way(&found, strbuf_text(&c.moves));
	ck_assert_msg(!strcmp(strbuf_text(&found), expected), "%s goes %s", program, strbuf_text(&found));
	strbuf_release(&found);
	case_release(&c);
}

START_TEST(ways)
{
	for (size_t i = 0; i < COUNT(programs); i++) {
		if (programs[i].dialects & F)
			expect_ways(&dialect_fanuc, programs[i].program, programs[i].ways);
		if (programs[i].dialects & H)
			expect_ways(&dialect_haas, programs[i].program, programs[i].ways);
	}
}
END_TEST

/* FM, optional block skip: a skipped statement does nothing, and a loop does not end in a skipped line. */
START_TEST(skipped_blocks)
{
	struct gcode_case c;

	case_init(&c);
	c.config.dialect = &dialect_fanuc;
	c.config.read.block_delete = true;
	case_expect(&c,
		    "#1=1\n/#1=2\n/2 GOTO 9\nG0 X#1\nWHILE [#1 LT 2] DO1\n#1=#1+1\n/END1\nY#1\nEND1\n/G65 P5\n"
		    "/IF [1 EQ 1] GOTO 9\nX9.\nN9 M30\n",
		    "rapid 1 0 0 0 0\nrapid 1 2 0 0 0\nrapid 9 2 0 0 0\n");
	case_init(&c);
	c.config.dialect = &dialect_haas;
	case_expect(&c, "#1=1\n/#1=2\n/G0 X#1\n/2 GOTO 9\nX9.\nN9 M30\n", "rapid 2 0 0 0 0\n");
}
END_TEST

/* FM, macro calls, units of arguments: increments of the address; with a variable behind an address, never. */
START_TEST(increments)
{
	struct gcode_case c;

	case_init(&c);
	c.config.dialect = &dialect_fanuc;
	c.config.controller.least_input = 0.001;
	case_expect(&c, "#9=2\nG65 P7 A1500 B#9 T3 X7.\nM30\nO7\nG0 X#1 Y#2\nX#20 Y#24\nM99\n",
		    "rapid 1.5 2 0 0 0\nrapid 3 7 0 0 0\n");
	case_init(&c);
	c.config.dialect = &dialect_fanuc;
	c.config.controller.least_input = 0.001;
	ck_assert(!case_run(&c, "G20\nG65 P7 X10000 B1500\nM30\nO7\nM99\n"));
	ck_assert_str_eq(strbuf_text(&c.messages),
			 "p.nc:2:15: error: B1500: the unit of this argument without a decimal point is not known; "
			 "write the point\n    G65 P7 X10000 B1500\n                  ^\n");
	case_release(&c);
	/* The Q of M98 is the number of a block. */
	case_init(&c);
	c.config.dialect = &dialect_fanuc;
	c.config.controller.least_input = 0.001;
	case_expect(&c, "M98 Q7 L2\nM30\nN7 G91 G0 X1.\nM99\n", "rapid 1 0 0 0 0\nrapid 2 0 0 0 0\n");
	case_init(&c);
	c.config.dialect = &dialect_fanuc;
	c.config.controller.least_input = 0.0001;
	case_expect(&c, "#1=1.23456\nG0 X#1\nM30\n", "rapid 1.2346 0 0 0 0\n");
}
END_TEST

/* The P of an arc's block is the call's: these controls have no turns. */
START_TEST(arc_and_call)
{
	static const struct dialect *const dialects[] = {&dialect_fanuc, &dialect_haas};

	for (int i = 0; i < 2; i++) {
		struct gcode_case c;

		case_init(&c);
		c.config.dialect = dialects[i];
		case_expect(&c, "G17 G2 I5. F9. M98 P3\nM30\nO3\nG0 X1.\nM99\n",
			    "arc 0 0 0 0 0 centre 5 0 0 normal 0 0 1 sweep -360\nrapid 1 0 0 0 0\n");
	}
}
END_TEST

/* FM ATAN, ASIN: parameter NAT (6004#0) at 0 gives 0 to 360 and 270 to 90. */
START_TEST(angles)
{
	struct gcode_case c;

	case_init(&c);
	c.config.dialect = &dialect_fanuc;
	ck_assert(case_run(&c, "#1=ATAN[-1]/[1]\nG0 C#1\n#1=ASIN[-.5]\nC#1\nM30\n"));
	ck_assert_str_eq(strbuf_text(&c.moves), "rapid 0 0 0 0 315\nrapid 0 0 0 0 330\n");
	ck_assert_str_eq(strbuf_text(&c.messages),
			 "p.nc:1:4: warning: the control returns 315 degrees, or -45 if parameter 6004#0 (NAT) is 1; "
			 "NAT is assumed to be 0, here and further on\n    #1=ATAN[-1]/[1]\n       ^\n");
	case_release(&c);
	case_init(&c);
	c.config.dialect = &dialect_haas;
	case_expect(&c, "#1=ATAN[-1]\nG0 C#1\nM30\n", "rapid 0 0 0 0 -45\n");
}
END_TEST

/* FM, AI contour control; Haas, G187: what they leave of the path is what a G64 does. */
START_TEST(contour)
{
	struct gcode_case c;

	case_init(&c);
	c.config.dialect = &dialect_fanuc;
	c.show_blend = true;
	case_expect(&c, "G54.2 P0\nG54.4 P0\nG61\nG5.1 Q1 R5\nG0 X1.\nG5.1 Q0\nX2.\nG8 P1\nX3.\nG8 P0\nG64\nG5 P10000\nX4.\nG5 P0\nX5.\nM30\n",
		    "rapid 1 0 0 0 0 blend 0\nrapid 2 0 0 0 0 exact\nrapid 3 0 0 0 0 blend 0\n"
		    "rapid 4 0 0 0 0 blend 0\nrapid 5 0 0 0 0 blend 0\n");
	/* Mitsubishi M700 programming manual, "High-speed Machining Mode"; posts for Mazak write it, too. */
	case_init(&c);
	c.config.dialect = &dialect_fanuc;
	c.show_blend = true;
	case_expect(&c, "G61\nG5 P2\nG0 X1.\nG5 P0\nX2.\nM30\n", "rapid 1 0 0 0 0 blend 0\nrapid 2 0 0 0 0 exact\n");
	case_init(&c);
	c.config.dialect = &dialect_haas;
	c.show_blend = true;
	case_expect(&c, "G187 P3 E0.02\nG0 X1.\nG187 P1\nX2.\nG187\nX3.\nM30\n",
		    "rapid 1 0 0 0 0 blend 0.02\nrapid 2 0 0 0 0 blend 0\nrapid 3 0 0 0 0 blend 0\n");
}
END_TEST

/* Through a pipe: a loop and a call, and the program that no pipe can deliver. */
static bool run_pipe(struct gcode_case *c, const char *head, int filler, const char *tail)
{
	int ends[2], status;
	FILE *in;
	bool good;
	pid_t child;

	ck_assert_int_eq(pipe(ends), 0);
	child = fork();
	if (child == 0) {
		FILE *out = fdopen(ends[1], "w");

		close(ends[0]);
		fputs(head, out);
		for (int i = 0; i < filler; i++)
			fputs("(twenty bytes or so)\n", out);
		fputs(tail, out);
		fclose(out);
		_exit(0);
	}
	close(ends[1]);
	in = fdopen(ends[0], "r");
	good = case_run_stream(c, in);
	fclose(in);
	waitpid(child, &status, 0);
	return good;
}

START_TEST(pipes)
{
	struct gcode_case c;

	case_init(&c);
	c.config.dialect = &dialect_fanuc;
	ck_assert_msg(run_pipe(&c, "#1=0\nWHILE [#1 LT 2] DO1\n#1=#1+1\nG65 P7 A#1\n", 20000,
			       "END1\nGOTO 3\nG0 X9.\nN3 M30\nO7\nG0 X#1\nM99\n"),
		      "%s", strbuf_text(&c.messages));
	ck_assert_str_eq(strbuf_text(&c.moves), "rapid 1 0 0 0 0\nrapid 2 0 0 0 0\n");
	case_release(&c);
	case_init(&c);
	c.config.dialect = &dialect_fanuc;
	ck_assert(!run_pipe(&c, "G0 X1.\nGOTO 3\n", 250000, "N3 M30\n"));
	ck_assert_str_eq(strbuf_text(&c.messages),
			 "p.nc:2:6: error: N3 may be more than 4 MiB before or after this line of the pipe, where it "
			 "is not looked for; give the program as a file\n    GOTO 3\n         ^\n");
	case_release(&c);
	case_init(&c);
	c.config.dialect = &dialect_haas;
	ck_assert(!run_pipe(&c, "N3 G0 X1.\n", 600000, "GOTO 3\n"));
	ck_assert_str_eq(strbuf_text(&c.messages),
			 "p.nc:600002:6: error: N3 may be more than 4 MiB before or after this line of the pipe, where it "
			 "is not looked for; give the program as a file\n    GOTO 3\n         ^\n");
	case_release(&c);
}
END_TEST

int main(void)
{
	const TTest *const tests[] = {ways, skipped_blocks, increments, arc_and_call, angles, contour, pipes};

	return RUN_TESTS("gcode_macro", tests);
}
