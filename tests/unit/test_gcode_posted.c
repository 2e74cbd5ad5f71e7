/*
 * test_gcode_posted.c - what posts write and manuals leave to a parameter, to the builder, or to an alarm: feeds that are
 * missing, arcs whose radii differ, R and Z of a cycle the wrong way round, M6 beside a move, ';' and ':'.
 */
#include "gcode_case.h"

static void init(struct gcode_case *c, const struct dialect *dialect)
{
	case_init(c);
	c->config.dialect = dialect;
	c->show_spread = true;
}

static void run(const struct dialect *dialect, const char *program, const char *moves)
{
	struct gcode_case c;

	init(&c, dialect);
	case_expect(&c, program, moves);
}

/* The program runs to its end, makes these moves, and has this caution. */
static void expect_caution(struct gcode_case *c, const char *program, const char *moves, const char *caution)
{
	bool good = case_run(c, program);

	ck_assert_msg(good, "%s", strbuf_text(&c->messages));
	ck_assert_str_eq(strbuf_text(&c->moves), moves);
	ck_assert_msg(strstr(strbuf_text(&c->messages), caution), "%s", strbuf_text(&c->messages));
	ck_assert_ptr_null(strstr(strbuf_text(&c->messages), "error"));
	case_release(c);
}

static void expect_fault(struct gcode_case *c, const char *program, const char *message)
{
	ck_assert(!case_run(c, program));
	ck_assert_msg(strstr(strbuf_text(&c->messages), message), "%s", strbuf_text(&c->messages));
	case_release(c);
}

/* Posts for PathPilot and Mach3 cancel scaling and rotation at the start; these controls are run as LinuxCNC here. */
START_TEST(nothing_to_cancel)
{
	struct gcode_case c;

	run(&dialect_linuxcnc, "G90 G54 G64 G50 G17 G40 G80 G94 G91.1 G49\nG69 G21\nG0 X5\nM30\n", "rapid 5 0 0 0 0\n");
	init(&c, &dialect_linuxcnc);
	expect_fault(&c, "G51 X2\nM30\n",
		     "p.nc:1:1: error: G51: scaling (PathPilot, Mach3) is not supported");
}
END_TEST

/*
 * Fanuc B-64484EN, "Cutting Feed", alarm PS0011; Haas, feed in G01: without any F an alarm, or the F of a program that ran
 * before. The path is the same; LinuxCNC refuses it.
 */
START_TEST(feed_missing)
{
	static const struct dialect *const dialects[] = {&dialect_fanuc, &dialect_haas};
	struct gcode_case c;

	for (size_t i = 0; i < COUNT(dialects); i++) {
		init(&c, dialects[i]);
		expect_caution(&c, "G1 X5.\nG2 X6. I.5\nM30\n",
			       "feed 5 0 0 0 0\narc 6 0 0 0 0 centre 5.5 0 0 normal 0 0 1 sweep -180\n",
			       "p.nc:1:1: warning: G1 without a feed rate (F): the control uses an earlier feed rate "
			       "or stops with an alarm; the path is checked at the largest speeds of the axes, here "
			       "and further on");
	}
	for (size_t i = 0; i < COUNT(dialects); i++) {
		init(&c, dialects[i]);
		expect_caution(&c, "G95 F.1 G1 X5.\nX6.\nM30\n", "feed 5 0 0 0 0\nfeed 6 0 0 0 0\n",
			       "p.nc:1:9: warning: a thread or a feed per revolution without a spindle speed (S), or "
			       "without a pitch, where the control stops or waits; the path is checked at the largest "
			       "speeds of the axes, here and further on");
	}
	init(&c, &dialect_linuxcnc);
	expect_fault(&c, "G1 X5\nM30\n", "p.nc:1:1: error: G1 without a feed rate (F)");
	/* Inverse time has an F in each block. */
	init(&c, &dialect_fanuc);
	expect_fault(&c, "G93 G1 X5.\nM30\n", "p.nc:1:5: error: G1 without F in inverse time mode (G93)");
}
END_TEST

/*
 * Fanuc B-63324EN and B-64484EN, "Circular Interpolation": the radius changes linearly with the angle where the end does
 * not lie on the arc, up to the difference of parameter 3410; R takes precedence over I, J and K.
 */
START_TEST(arcs)
{
	struct gcode_case c;
	static const char spiral[] = "F9 G0 X10. Y0.\nG3 X0. Y12. I-10. J0.\nM30\n";

	init(&c, &dialect_fanuc);
	c.config.controller.arc_radius_tolerance = 2;
	case_expect(&c, spiral, "rapid 10 0 0 0 0\narc 0 12 0 0 0 centre 0 0 0 normal 0 0 1 sweep 90\n");
	init(&c, &dialect_fanuc);
	c.config.controller.arc_radius_tolerance = 1.9;
	expect_fault(&c, spiral,
		     "p.nc:2:1: error: the radius of the arc is 10 mm at its start and 12 mm at its end; "
		     "arc_radius_tolerance in the machine file allows less");
	init(&c, &dialect_fanuc);
	expect_fault(&c, spiral, "set arc_radius_tolerance=\"\" (largest difference) in the machine file's <controller>");
	init(&c, &dialect_haas);
	c.config.controller.arc_radius_tolerance = 2;
	expect_fault(&c, spiral, "the radius of the arc is 10 mm at its start and 12 mm at its end\n");
	/* X20 counts 0.02 mm here. */
	init(&c, &dialect_haas);
	c.config.controller.least_input = 0.001;
	expect_fault(&c, "F9 G0 X10. Y0.\nG3 X20 Y0. I5.\nM30\n",
		     "the radius of the arc is 5 mm at its start and 14.98 mm at its end; X has no decimal point and "
		     "means 0.02 (least_input)\n");
	/* Cutter compensation does not support a spiral. */
	init(&c, &dialect_fanuc);
	c.config.controller.arc_radius_tolerance = 2;
	c.config.radii = &(struct radius_offset){1, 2};
	c.config.radius_count = 1;
	expect_fault(&c, "F9 G0 X20. Y0.\nG1 G41 D1 X10.\nG3 X0. Y12. I-10. J0.\nM30\n",
		     "a spiral is not supported under cutter compensation");
	run(&dialect_fanuc, "F9 G0 X10. Y0.\nG3 X0. Y10. R10. I-3. J2.\nM30\n",
	    "rapid 10 0 0 0 0\narc 0 10 0 0 0 centre 0 0 0 normal 0 0 1 sweep 90\n");
	init(&c, &dialect_haas);
	expect_fault(&c, "F9 G2 X5. R5. I3.\n", "an arc has either a radius (R) or a centre (I, J, K), not both");
	/* A centre of 0 across the plane says nothing. */
	run(&dialect_haas, "F9 G0 X10. Y0.\nG3 X0. Y10. I-10. K0.\nM30\n",
	    "rapid 10 0 0 0 0\narc 0 10 0 0 0 centre 0 0 0 normal 0 0 1 sweep 90\n");
	init(&c, &dialect_fanuc);
	expect_fault(&c, "F9 G3 X0. Y10. I-10. K1.\n", "K does not belong to the centre of an arc in the plane of G17");
	init(&c, &dialect_linuxcnc);
	expect_fault(&c, "F9 G3 X0 Y10 I-10 K0\n", "K does not belong to the centre of an arc in the plane of G17");
}
END_TEST

/* B-64484EN, "Canned Cycle for Drilling", Haas, "Canned Cycles": neither says that R lies above Z. */
START_TEST(wrong_way_round)
{
	struct gcode_case c;

	init(&c, &dialect_fanuc);
	expect_caution(&c, "F9 G0 Z5.\nG99 G81 X1. Z8. R2.\nG80\nM30\n",
		       "rapid 0 0 5 0 0\nrapid 1 0 5 0 0\nrapid 1 0 2 0 0\nrapid 1 0 2 0 0\nfeed 1 0 8 0 0\nrapid 1 0 2 0 0\n",
		       "p.nc:2:5: warning: R of G81, 2 mm, is below Z, 8 mm: the control moves to R and then to Z, or "
		       "stops with an alarm; both cases are checked, here and further on");
	/* A peck may go down from R. */
	init(&c, &dialect_haas);
	expect_caution(&c, "F9 G0 Z5.\nG98 G83 X1. Z8. R2. Q3.\nG80\nM30\n",
		       "rapid 0 0 5 0 0\nrapid 1 0 5 0 0\nrapid 1 0 2 0 0\nrapid 1 0 2 0 0\nfeed 1 0 -1 0 0\nfeed 1 0 8 0 0\n"
		       "rapid 1 0 5 0 0\n",
		       "R of G83, 2 mm, is below Z, 8 mm");
	init(&c, &dialect_fanuc);
	expect_caution(&c, "F9 G0 Z5.\nG99 G87 X1. Z-3. R2. Q.5\nG80\nM30\n",
		       "rapid 0 0 5 0 0\nrapid 1 0 5 0 0\nrapid 1 0 2 0 0 spread 0.5 0.5 0\nfeed 1 0 -3 0 0 spread 0.5 0.5 0\n"
		       "rapid 1 0 5 0 0 spread 0.5 0.5 0\n",
		       "R of G87, 2 mm, is above Z, -3 mm");
	init(&c, &dialect_haas);
	expect_caution(&c, "F9 G0 Z5.\nG77 X1. Z-3. R-6.\nG80\nM30\n",
		       "rapid 0 0 5 0 0\nrapid 1 0 5 0 0\nrapid 1 0 -6 0 0\nfeed 1 0 -3 0 0\nrapid 1 0 5 0 0\n",
		       "p.nc:2:1: warning: G77 without Q: it is assumed that the tool enters and leaves the bore without a shift");
}
END_TEST

/* B-64484EN, "Peck Rigid Tapping Cycle (G84 or G74)"; Haas, "G84 Tapping Canned Cycle": J. */
START_TEST(taps)
{
	static const char moves[] = "rapid 0 0 5 0 0\nrapid 1 0 5 0 0\nrapid 1 0 2 0 0\nfeed 1 0 -4 0 0\nfeed 1 0 2 0 0\n"
				    "rapid 1 0 5 0 0\n";
	struct gcode_case c;

	run(&dialect_fanuc, "F9 G0 Z5.\nM29 S100\nG98 G84 X1. Z-4. R2. Q1.\nG80\nM30\n", moves);
	run(&dialect_haas, "F9 G0 Z5.\nG98 G84 X1. Z-4. R2. J2.\nG80\nM30\n", moves);
	run(&dialect_fanuc, "F9 G0 Z5.\nG98 G84.2 X1. Z-4. R2.\nG80\nM30\n", moves);
	run(&dialect_fanuc, "F9 G0 Z5.\nG98 G84.3 X1. Z-4. R2.\nG80\nM30\n", moves);
	init(&c, &dialect_haas);
	expect_fault(&c, "F9 G84 X1. Z-4. R2. Q1.\n", "no code in the block uses the word Q");
}
END_TEST

/* B-64484EN, parameters 3402#0 (G01) and 0001#1 (FCV): the motion at power-on, and L in place of K. */
START_TEST(parameters)
{
	struct gcode_case c;

	init(&c, &dialect_fanuc);
	expect_fault(&c, "X1.\nM30\n",
		     "p.nc:1:1: error: axis words without an active motion code (G0, G1, G2, G3); set "
		     "power_on_motion=\"rapid\" or \"feed\" (the motion code at power-on) in the machine file's "
		     "<controller>");
	init(&c, &dialect_haas);
	c.config.controller.power_on_motion = POWER_ON_RAPID;
	case_expect(&c, "X1.\nF9 G81 X2. Z-1. R0.\nG80 X3.\nM30\n",
		    "rapid 1 0 0 0 0\nrapid 2 0 0 0 0\nrapid 2 0 0 0 0\nfeed 2 0 -1 0 0\nrapid 2 0 0 0 0\nrapid 3 0 0 0 0\n");
	init(&c, &dialect_fanuc);
	c.config.controller.power_on_motion = POWER_ON_FEED;
	case_expect(&c, "F9 X1.\nM30\n", "feed 1 0 0 0 0\n");
	init(&c, &dialect_fanuc);
	c.config.controller.cycle_repeats = CYCLE_REPEATS_L;
	case_expect(&c, "F9 G81 Z-1. R0. L0\nX2.\nG80\nM30\n",
		    "rapid 2 0 0 0 0\nrapid 2 0 0 0 0\nfeed 2 0 -1 0 0\nrapid 2 0 0 0 0\n");
	init(&c, &dialect_fanuc);
	c.config.controller.cycle_repeats = CYCLE_REPEATS_L;
	expect_fault(&c, "F9 G81 X1. Z-1. R0. K2\n", "no code in the block uses the word K");
	/* The L of M98 is its own. */
	run(&dialect_fanuc, "F9 G81 X1. Z-1. R0.\nM98 P5 L2\nG80\nM30\nO5\nM99\n",
	    "rapid 1 0 0 0 0\nrapid 1 0 0 0 0\nfeed 1 0 -1 0 0\nrapid 1 0 0 0 0\n");
}
END_TEST

/* B-64484EN, "Auxiliary Function (M Function)": with the move, or behind it, as the builder of the machine has it. */
START_TEST(tool_change_beside_move)
{
	static const char program[] = "G0 X1.\nT2 M6 X5.\nM30\n";
	struct gcode_case c;

	init(&c, &dialect_fanuc);
	c.config.controller.tool_change.given = true;
	c.config.controller.m6_with_move = M6_AFTER_MOVE;
	case_expect(&c, program, "rapid 1 0 0 0 0\nrapid 5 0 0 0 0\ntool 2\n");
	init(&c, &dialect_fanuc);
	c.config.controller.tool_change.given = true;
	c.config.controller.m6_with_move = M6_BEFORE_MOVE;
	case_expect(&c, program, "rapid 1 0 0 0 0\ntool 2\nrapid 5 0 0 0 0\n");
	/* One of the commonest lines of all. */
	init(&c, &dialect_fanuc);
	c.config.controller.tool_change.given = true;
	c.config.controller.m6_with_move = M6_AFTER_MOVE;
	case_expect(&c, "G0 Z-9.\nT3\nG91 G28 Z0 M6\nT4 M1\nM30\n",
		    "rapid 0 0 -9 0 0\nrapid 0 0 -9 0 0\nrapid 0 0 0 0 0\ntool 3\n");
}
END_TEST

/* Mazak's geometry compensation and Mitsubishi's high-accuracy control leave the path by what a parameter allows. */
START_TEST(high_accuracy)
{
	struct gcode_case c;

	init(&c, &dialect_fanuc);
	c.show_blend = true;
	case_expect(&c, "G61\nG0 X1.\nG61.1\nX2.\nG64\nX3.\nM30\n",
		    "rapid 1 0 0 0 0 exact\nrapid 2 0 0 0 0 blend 0\nrapid 3 0 0 0 0 blend 0\n");
}
END_TEST

/* A ';' ends a block, unless the machine file says that comments start with it. */
START_TEST(semicolon)
{
	struct gcode_case c;

	init(&c, &dialect_fanuc);
	expect_fault(&c, "G0 X1.; X2.\nM30\n", "set semicolon=\"comment\" in the machine file's <controller>");
	init(&c, &dialect_fanuc);
	c.config.controller.semicolon = SEMICOLON_STARTS_COMMENT;
	case_expect(&c, "G0 X1.; X2. to here\n#1=3.; of three\nG0 X#1; [\nG65 P100 A1.; too\nM30\nO100\nG0 X[#1+9.];\nM99\n",
		    "rapid 1 0 0 0 0\nrapid 3 0 0 0 0\nrapid 10 0 0 0 0\n");
}
END_TEST

/* B-64484EN, "Program Number": ':' stands for O; ISO 6983-1 has it as a block to align to, in place of N. */
START_TEST(colon)
{
	static const char program[] = "O1\nG0 X1.\n:20 X2.\nIF [#1 EQ 5] GOTO 40\n#1=5\nGOTO 20\n:40 X4.\nM30\n";
	struct gcode_case c;

	init(&c, &dialect_fanuc);
	expect_fault(&c, program,
		     "p.nc:3:1: error: another program begins here before M2, M30 or M99; if ':' means N on this "
		     "control, set colon=\"block\" in the machine file's <controller>");
	init(&c, &dialect_fanuc);
	c.config.controller.colon = COLON_BLOCK;
	case_expect(&c, program, "rapid 1 0 0 0 0\nrapid 2 0 0 0 0\nrapid 2 0 0 0 0\nrapid 4 0 0 0 0\n");
}
END_TEST

/*
 * B-64484EN, "Program Components Other Than Program Sections": the title of a file stands behind its first '%'. Where it
 * looks like a move, somebody may mean one.
 */
START_TEST(title)
{
	struct gcode_case c;

	run(&dialect_fanuc, "%1 PART-7\nG0 X5.\nM30\n%\n", "rapid 5 0 0 0 0\n");
	run(&dialect_haas, "% (X1 OF 2)\nG0 X5.\nM30\n%\n", "rapid 5 0 0 0 0\n");
	init(&c, &dialect_fanuc);
	expect_fault(&c, "% G0 X4.\nG0 X5.\nM30\n%\n", "p.nc:1:1: error: '%' must be alone on its line");
	init(&c, &dialect_fanuc);
	expect_fault(&c, "%\nG0 X5.\n% PART\n", "p.nc:3:1: error: '%' must be alone on its line");
	init(&c, &dialect_linuxcnc);
	expect_fault(&c, "%1\nG0 X5.\nM30\n", "p.nc:1:1: error: '%' must be alone on its line");
}
END_TEST

/* B-64484EN, "Local Coordinate System (G52)": whether it counts increments in G91 is not said; zeros tell nothing else. */
START_TEST(local_zero_in_g91)
{
	struct gcode_case c;

	run(&dialect_fanuc, "G91 G52 X0. Y0.\nG90 G0 X5.\nM30\n", "rapid 5 0 0 0 0\n");
	init(&c, &dialect_fanuc);
	expect_fault(&c, "G91 G52 X1.\n", "G52 in incremental mode (G91) is not supported");
	init(&c, &dialect_haas);
	expect_fault(&c, "G52 X1.\nG91 G52 X0.\n", "G52 in incremental mode (G91) is not supported");
}
END_TEST

/*
 * B-64484EN, "Tool Function": what a T beside M6 does is the builder's. Only where another tool waits does it matter;
 * Haas, "M06 Tool Change": M06 loads the T of its block.
 */
START_TEST(t_beside_m6)
{
	static const char waits[] = "T1\nM6 T2\nM6 T3\nM30\n";
	struct gcode_case c;

	run(&dialect_linuxcnc, waits, "tool 2\ntool 3\n");
	init(&c, &dialect_haas);
	c.config.controller.tool_change.given = true;
	case_expect(&c, waits, "tool 2\ntool 3\n");
	init(&c, &dialect_fanuc);
	c.config.controller.tool_change.given = true;
	case_expect(&c, "T1 M6\nT2\nT2 M6\nT3 M6\nM30\n", "tool 1\ntool 2\ntool 3\n");
	init(&c, &dialect_fanuc);
	c.config.controller.tool_change.given = true;
	expect_caution(&c, waits, "tool 2\ntool 3\n",
		       "p.nc:2:4: warning: T2 beside M6 while T1 is preselected: it is assumed that M6 loads T2, but "
		       "the builder may have it load T1; set m6_with_t=\"own\" or \"before\" in the machine file's "
		       "<controller>; here and further on");
	init(&c, &dialect_fanuc);
	c.config.controller.m6_with_t = M6_LOADS_OWN_T;
	c.config.controller.tool_change.given = true;
	case_expect(&c, waits, "tool 2\ntool 3\n");
	init(&c, &dialect_fanuc);
	c.config.controller.m6_with_t = M6_LOADS_T_BEFORE;
	c.config.controller.tool_change.given = true;
	case_expect(&c, "T1\nM6 T2\nM6 T3\nM6\nM30\n", "tool 1\ntool 2\ntool 3\n");
	init(&c, &dialect_fanuc);
	c.config.controller.m6_with_t = M6_LOADS_T_BEFORE;
	expect_fault(&c, "M6 T2\n", "M6 without a tool: write T first");
	init(&c, &dialect_fanuc);
	c.config.controller.m6_with_t = M6_LOADS_FIRST_T;
	c.config.controller.tool_change.given = true;
	case_expect(&c, "T1 T2 M6\nM6\nT3\nM6 T1\nT2 T3 M6\nM6\nM30\n",
		    "tool 1\ntool 2\ntool 1\ntool 2\ntool 3\n");
	init(&c, &dialect_fanuc);
	c.config.controller.m6_with_t = M6_LOADS_FIRST_T;
	expect_fault(&c, "T1 T2\n", "two T in a block without M6");
	init(&c, &dialect_fanuc);
	c.config.controller.m6_with_t = M6_LOADS_FIRST_T;
	expect_fault(&c, "T1 T2 T3 M6\n", "the word T occurs twice in the block, at columns 1 and 7");
}
END_TEST

/* Brother Speedio's programming manual, "High Accuracy Mode": M298 has L. So do others of a builder. */
START_TEST(words_of_builder_codes)
{
	static const struct mcode mcodes[] = {{298, MCODE_IGNORE}};
	struct gcode_case c;

	init(&c, &dialect_fanuc);
	c.config.controller.mcodes = mcodes;
	c.config.controller.mcode_count = 1;
	case_expect(&c, "M298 L1\nM298 R2. E1.\nG0 X1. M298 P3\nM30\n", "rapid 1 0 0 0 0\n");
	init(&c, &dialect_fanuc);
	c.config.controller.mcodes = mcodes;
	c.config.controller.mcode_count = 1;
	expect_fault(&c, "G0\nX1. R2. M298\n", "no code in the block uses the word R");
	/* The P is the call's. */
	init(&c, &dialect_fanuc);
	c.config.controller.mcodes = mcodes;
	c.config.controller.mcode_count = 1;
	case_expect(&c, "M298 M98 P5\nM30\nO5\nG0 X1.\nM99\n", "rapid 1 0 0 0 0\n");
}
END_TEST

/* Haas mill operator's manual, M-codes: they move no axis, and some have words. */
START_TEST(haas_outputs)
{
	struct gcode_case c;

	init(&c, &dialect_haas);
	case_expect(&c,
		    "M138 P500 Q10\nM49 P1 Q3\nM161 P100\nM163 P50\nM160\nM36 M48\nM80\nM95 (05:30)\nM158\n"
		    "G0 X1. M130\nM30\n",
		    "rapid 1 0 0 0 0\n");
	init(&c, &dialect_haas);
	expect_fault(&c, "M104\n", "p.nc:1:1: error: M104: motion of the probe arm is not supported; "
	 "post the program without it or, if it moves no axis, set <mcode number=\"104\" "
	 "action=\"ignore\"/> in the machine file's <controller>");
	init(&c, &dialect_haas);
	expect_fault(&c, "M48 P1\n", "no code in the block uses the word P");
}
END_TEST

/* B-64484EN, "Changing Workpiece Coordinate System"; Haas, "G10 Set Offsets": P0 is the shift of all work offsets. */
START_TEST(common_shift_cleared)
{
	static const struct dialect *const dialects[] = {&dialect_fanuc, &dialect_haas};

	for (int i = 0; i < 2; i++) {
		struct gcode_case c;

		init(&c, dialects[i]);
		expect_caution(&c, "G10 L2 P1 X5.\nG90 G10 L2 P0 X0 Y0. Z0 C0\nG0 X1.\nM30\n", "rapid 6 0 0 0 0\n",
			       "p.nc:2:12: warning: G10 L2 P0 clears the shift of all work offsets: the setup's work "
			       "offsets are assumed not to contain it");
	}
}
END_TEST

int main(void)
{
	const TTest *const tests[] = {nothing_to_cancel, common_shift_cleared, t_beside_m6, words_of_builder_codes, haas_outputs, title, local_zero_in_g91, feed_missing, arcs, wrong_way_round, taps, parameters, tool_change_beside_move, high_accuracy, semicolon, colon};

	return RUN_TESTS("gcode_posted", tests);
}
