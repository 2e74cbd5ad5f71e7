/*
 * test_gcode_frames.c - mirror images, polar coordinates, G60, arcs without a centre, pecks of Haas, as Fanuc's and
 * Haas's manuals have them: closed forms and faults.
 */
#include "gcode_refusal.h"

static const struct radius_offset radii[] = {{1, 2}};

static void init(struct gcode_case *c, const struct dialect *dialect)
{
	case_init(c);
	c->config.dialect = dialect;
	c->config.radii = radii;
	c->config.radius_count = 1;
	c->config.controller.comp_start = COMP_START_A;
	c->config.controller.comp_corner = COMP_CORNER_LINEAR;
	c->show_spread = true;
}

static void run(const struct dialect *dialect, const char *program, const char *moves)
{
	struct gcode_case c;

	init(&c, dialect);
	case_expect(&c, program, moves);
}

/* The same with a caution. */
static void run_with(const struct dialect *dialect, const char *program, const char *moves, const char *caution)
{
	struct gcode_case c;

	init(&c, dialect);
	ck_assert(case_run(&c, program));
	ck_assert_str_eq(strbuf_text(&c.moves), moves);
	ck_assert_ptr_nonnull(strstr(strbuf_text(&c.messages), caution));
	case_release(&c);
}

/* Fanuc B-64484EN, "Programmable Mirror Image (G50.1, G51.1)"; Haas, "G100/G101 Disable/Enable Mirror Image". */
START_TEST(mirror)
{
	/* About X 10: 30 goes to -10; the other axes and axes without a word stay. */
	run(&dialect_fanuc, "G0 X30. Y5.\nG51.1 X10.\nX30.\nG91 X1.\nG90 Y6.\nG50.1\nX0.\nM30\n",
	    "rapid 30 5 0 0 0\nrapid -10 5 0 0 0\nrapid -11 5 0 0 0\nrapid -11 6 0 0 0\nrapid 0 6 0 0 0\n");
	/* Two mirrored axes, one of which is cancelled. */
	run(&dialect_fanuc, "G51.1 X0. Y0.\nG0 X1. Y2.\nG50.1 X0.\nX1. Y2.\nG50.1 Y0.\nX1. Y2.\nM30\n",
	    "rapid -1 -2 0 0 0\nrapid 1 -2 0 0 0\nrapid 1 2 0 0 0\n");
	/* Arcs turn the other way round; in the image of two axes they do not. */
	run(&dialect_fanuc, "F9 G51.1 X0.\nG0 X10. Y0.\nG3 X0. Y10. I-10. J0.\nM30\n",
	    "rapid -10 0 0 0 0\narc 0 10 0 0 0 centre 0 0 0 normal 0 0 -1 sweep 90\n");
	run(&dialect_haas, "F9 G101 X0. Y0.\nG0 X10. Y0.\nG3 X0. Y10. R10.\nG100\nG0 X1. Y1.\nM30\n",
	    "rapid -10 0 0 0 0\narc 0 -10 0 0 0 centre 0 0 0 normal 0 0 1 sweep 90\nrapid 1 1 0 0 0\n");
	/* G41 keeps to what is left in the program: 2 mm beside x = 10 is 2 mm beside its image. */
	run(&dialect_fanuc, "F9 G51.1 X0.\nG1 G41 D1 X10. Y0.\nY20.\nG2 X30. Y40. I20. J0.\nG40 G1 X50.\nM30\n",
	    "feed -8 0 0 0 0\nfeed -8 20 0 0 0\narc -30 42 0 0 0 centre -30 20 0 normal 0 0 -1 sweep -90\nfeed -50 40 0 0 0\n");
	/* Canned cycles; Z0 of G28 does not mind on Haas. */
	run(&dialect_haas, "F9 G101 X0.\nG81 G99 X5. Y1. R1. Z-2.\nG80\nG91 G28 Z0.\nG90 G100\nM30\n",
	    "rapid -5 1 0 0 0\nrapid -5 1 1 0 0\nfeed -5 1 -2 0 0\nrapid -5 1 1 0 0\nrapid -5 1 1 0 0\nrapid -5 1 0 0 0\n");
}
END_TEST

/*
 * Fanuc B-64484EN, "Scaling (G50, G51)"; Haas, "G51 Scaling": p = centre + P (p - centre), offsets, lengths of tools and
 * the speed as they are.
 */
START_TEST(scaling)
{
	static const struct dialect *const dialects[] = {&dialect_fanuc, &dialect_haas};

	for (size_t i = 0; i < 2; i++) {
		run(dialects[i], "G0 X4. Y4. Z1.\nG51 X10. Y0. Z0. P2.\nX20. Y5.\nG91 X1.\nG90 Z3.\nG50\nX20. Y5. Z3.\nM30\n",
		    "rapid 4 4 1 0 0\nrapid 30 10 1 0 0\nrapid 32 10 1 0 0\nrapid 32 10 6 0 0\nrapid 20 5 3 0 0\n");
		/* An axis without a word has its centre where it stands; arcs by centre and by radius. */
		run(dialects[i],
		    "F9 G0 X10. Y0. Z4.\nG51 X0. Y0. P.5\nX10. Y0.\nG3 X0. Y10. I-10. J0.\nG2 X10. Y0. R10.\nG0 Z6.\nM30\n",
		    "rapid 10 0 4 0 0\nrapid 5 0 4 0 0\narc 0 5 4 0 0 centre 0 0 4 normal 0 0 1 sweep 90\n"
		    "arc 5 0 4 0 0 centre 0 0 4 normal 0 0 1 sweep -90\nrapid 5 0 5 0 0\n");
		run(dialects[i], "F9 G0 X0. Y0. Z5.\nG51 X0. Y0. Z0. I2. J2. K2.\nG98 G81 X3. Y1. R1. Z-2.\nG80\nG50\nM30\n",
		    "rapid 0 0 5 0 0\nrapid 6 2 5 0 0\nrapid 6 2 2 0 0\nfeed 6 2 -4 0 0\nrapid 6 2 5 0 0\n");
	}
}
END_TEST

/* B-64484EN, "Workpiece Coordinate System Preset (G92.1)". */
START_TEST(preset)
{
	run(&dialect_fanuc, "G0 X1. Y1.\nG92 X11. Y21.\nX12.\nG92.1 X0\nX5. Y22.\nG92.1 Y0. Z0.\nY5.\nM30\n",
	    "rapid 1 1 0 0 0\nrapid 2 1 0 0 0\nrapid 5 2 0 0 0\nrapid 5 5 0 0 0\n");
	run(&dialect_fanuc, "G52 X10.\nG0 X1.\nG92.1 X0\nX1.\nM30\n", "rapid 11 0 0 0 0\nrapid 1 0 0 0 0\n");
}
END_TEST

static const struct {
	const char *program, *message;
} unscaled[] = {
	{"G92.1\n", "p.nc:1:1: error: G92.1 without an axis word"},
	{"G92.1 X5.\n", "p.nc:1:7: error: G92.1 presets an axis only to 0"},
	{"G51.1 X0.\nG92.1 X0\n", "p.nc:2:1: error: a change of offsets while a mirror image is active"},
	{"G51 P2\n", "p.nc:1:5: error: P of G51 without a decimal point: a parameter of the control decides whether it is in thousandths"},
	{"G51 X1.\n", "p.nc:1:1: error: G51 needs P (factor)"},
	{"G51 I1. J2. K1.\n", "p.nc:1:9: error: G51 with different factors for the axes is not supported"},
	{"G51 P-1.\n", "p.nc:1:5: error: the factor of G51 must be greater than 0"},
	{"G51 P2.\nG51 P2.\n", "p.nc:2:1: error: G51 is not supported in rotated, mirrored or scaled coordinates"},
	{"F9 G51 P2.\nG83 X1. Z-1. R1. Q1.\n", "p.nc:2:1: error: a cycle with pecks or a shift while coordinates are scaled (G51)"},
	{"F9 G51 P2.\nG1 G41 D1 X5.\n", "p.nc:2:4: error: cutter compensation while coordinates are scaled (G51)"},
	{"G51 P2.\nG28 Z0.\n", "p.nc:2:1: error: a change of offsets or a move to a machine position while"},
	{"G51 P2.\nG55\n",
	 "p.nc:2:1: error: a change of offsets while coordinates are scaled (G51) is not supported; write G50 first"},
	{"G51 X9. P2.\nG0 G91 X1.\n", "p.nc:2:8: error: increment in X after G51: the first move must be absolute"},
	{"G51.1 X0.\nG51 P2.\n", "p.nc:2:1: error: scaling while a mirror image is active is not supported"},
};

START_TEST(unscaled_faults)
{
	for (size_t i = 0; i < COUNT(unscaled); i++) {
		struct gcode_case c;

		init(&c, &dialect_fanuc);
		case_refuses(&c, unscaled[i].message, "%s", unscaled[i].program);
	}
}
END_TEST

/* The same book, "Polar Coordinate Command (G15, G16)": the example of a bolt hole circle. */
START_TEST(polar)
{
	static const char holes[] = "rapid 86.6025404 50 0 0 0\nrapid 86.6025404 50 -5 0 0\nfeed 86.6025404 50 -20 0 0\n"
				    "rapid 86.6025404 50 -5 0 0\nrapid -86.6025404 50 -5 0 0\n"
				    "rapid -86.6025404 50 -5 0 0\nfeed -86.6025404 50 -20 0 0\nrapid -86.6025404 50 -5 0 0\n"
				    "rapid 0 -100 -5 0 0\nrapid 0 -100 -5 0 0\nfeed 0 -100 -20 0 0\nrapid 0 -100 -5 0 0\n";

	run(&dialect_fanuc, "G17 G90 G16\nG99 G81 X100. Y30. Z-20. R-5. F200.\nY150.\nY270.\nG15 G80\nM30\n", holes);
	run(&dialect_fanuc, "G17 G90 G16\nG99 G81 X100. Y30. Z-20. R-5. F200.\nG91 Y120. Z-15. R-5. K2\nG15 G80\nM30\n", holes);
	/* In the plane of Z and X the radius is Z. */
	run(&dialect_fanuc, "G18 G16 G0 Z10. X90.\nX180. Y3.\nG15 X1.\nM30\n",
	    "rapid 10 0 0 0 0\nrapid 0 3 -10 0 0\nrapid 1 3 -10 0 0\n");
}
END_TEST

/* "Single Direction Positioning (G60)": everything within the overrun is proved; G1 is in force again after it. */
START_TEST(single_direction)
{
	struct gcode_case c;

	init(&c, &dialect_fanuc);
	c.config.controller.overrun = 0.5;
	case_expect(&c, "F9 G1 X1.\nG60 X10. Y5.\nX11.\nM30\n",
		    "feed 1 0 0 0 0\nrapid 10 5 0 0 0 spread 0.5 0.5 0\n"
		    "rapid 10 5 0 0 0 spread 0.5 0.5 0\nfeed 11 5 0 0 0\n");
	init(&c, &dialect_haas);
	ck_assert(!case_run(&c, "G60 X10.\n"));
	ck_assert_ptr_nonnull(strstr(strbuf_text(&c.messages), "set unidirectional_overrun=\"\" (in the unit of the file)"));
	case_release(&c);
}
END_TEST

/* Parameter 3403#5 (CIR) of Fanuc: a line, or an alarm. */
START_TEST(arc_without_centre)
{
	run_with(&dialect_fanuc, "F9 G2 X5. Y5.\nX6.\nM30\n", "feed 5 5 0 0 0\nfeed 6 5 0 0 0\n",
		 "p.nc:1:4: warning: an arc without centre (I, J, K) and radius (R): this control moves straight");
}
END_TEST

/* A unit holds for its whole block, whichever comes first in it. */
START_TEST(unit_of_feed)
{
	struct gcode_case c;

	init(&c, &dialect_fanuc);
	c.show_feed = true;
	case_expect(&c, "F60. G20 G1 X1.\nG21 F60. X1.\nM30\n",
		    "feed 25.4 0 0 0 0 at 25.4 1\nfeed 1 0 0 0 0 at 1 1\n");
}
END_TEST

/* G9 stops exactly for one block, whatever moves in it. */
START_TEST(exact_stop)
{
	run(&dialect_fanuc, "F9 G9 G1 X5.\nX6. G09\nM30\n", "feed 5 0 0 0 0\nfeed 6 0 0 0 0\n");
}
END_TEST

/* Haas, "G83", "G73": I is the first peck, J what each is less, K the least. Q0 or none: all pecks lie on one stroke. */
START_TEST(pecks)
{
	run(&dialect_haas, "F9 G73 G99 X1. Z-5. R0. I3. J1. K1.5\nM30\n",
	    "rapid 1 0 0 0 0\nrapid 1 0 0 0 0\nfeed 1 0 -3 0 0\nrapid 1 0 -2.746 0 0\nfeed 1 0 -5 0 0\nrapid 1 0 0 0 0\n");
	run(&dialect_haas, "F9 G73 G99 X1. Z-5. R0. I2. J1. K1.5\nM30\n",
	    "rapid 1 0 0 0 0\nrapid 1 0 0 0 0\nfeed 1 0 -2 0 0\nrapid 1 0 -1.746 0 0\nfeed 1 0 -3.5 0 0\n"
	    "rapid 1 0 -3.246 0 0\nfeed 1 0 -5 0 0\nrapid 1 0 0 0 0\n");
	run(&dialect_fanuc, "F9 G83 G99 X1. Z-5. R0. Q0.\nG73 X2.\nM30\n",
	    "rapid 1 0 0 0 0\nrapid 1 0 0 0 0\nfeed 1 0 -5 0 0\nrapid 1 0 0 0 0\n"
	    "rapid 2 0 0 0 0\nrapid 2 0 0 0 0\nfeed 2 0 -5 0 0\nrapid 2 0 0 0 0\n");
	run_with(&dialect_fanuc, "F9 G76 G99 X1. Z-5. R0.\nM30\n",
		 "rapid 1 0 0 0 0\nrapid 1 0 0 0 0\nfeed 1 0 -5 0 0\nrapid 1 0 -5 0 0\nrapid 1 0 0 0 0\nrapid 1 0 0 0 0\n",
		 "G76 without Q: it is assumed that the tool leaves the bore without a shift");
}
END_TEST

/* Fanuc B-64484EN, "Optional Chamfering and Corner R"; Haas, "Corner Rounding and Chamfering". */
START_TEST(corners)
{
	struct gcode_case c;

	run(&dialect_haas, "F9 G1 X20. ,C5.\nY20. ,R4.\nX0.\nM30\n",
	    "feed 15 0 0 0 0\nfeed 20 5 0 0 0\nfeed 20 16 0 0 0\narc 16 20 0 0 0 centre 16 16 0 normal 0 0 1 sweep 90\n"
	    "feed 0 20 0 0 0\n");
	/* Clockwise, in the plane of Z and X, in increments. */
	run(&dialect_fanuc, "F9 G18 G1 G91 X20. ,R4.\nZ-20.\nM30\n",
	    "feed 16 0 0 0 0\narc 20 0 -4 0 0 centre 16 0 -4 normal 0 1 0 sweep 90\nfeed 20 0 -20 0 0\n");
	/* A line that meets the arc x^2 + y^2 = 400 on X: the circle of radius 5 inside touches both (3-4-5: not the axis). */
	run(&dialect_fanuc, "F9 G0 X-5.\nG1 X20. ,R5.\nG3 X0. Y20. R20.\nM30\n",
	    "rapid -5 0 0 0 0\nfeed 14.1421356 0 0 0 0\narc 18.8561808 6.66666667 0 0 0 centre 14.1421356 5 0 normal 0 0 1 sweep "
	    "109.471221\narc 0 20 0 0 0 centre 0 0 0 normal 0 0 1 sweep 70.5287794\n");
	/* With compensation the rounding is part of the contour. */
	run(&dialect_fanuc, "F9 G1 G41 D1 X10. Y0.\nY20. ,R5.\nX40.\nG40 X50.\nM30\n",
	    "feed 8 0 0 0 0\nfeed 8 15 0 0 0\narc 15 22 0 0 0 centre 15 15 0 normal 0 0 1 sweep -90\nfeed 40 22 0 0 0\n"
	    "feed 50 20 0 0 0\n");
	/* Every block is told once, in order, with its moves. */
	init(&c, &dialect_haas);
	ck_assert(case_run(&c, "F9 G1 X20. ,C5.\n(between)\nY20.\nM30\n"));
	ck_assert_str_eq(strbuf_text(&c.blocks), "1:2:F9 G1 X20. ,C5.\n3:1:Y20.\n4:0:M30\n");
	case_release(&c);
}
END_TEST

/* Fanuc B-64484EN, "Entering Values from the Program (G10)", memory C; Haas, "G10 Set Offsets". */
START_TEST(registers)
{
	struct gcode_case c;

	init(&c, &dialect_haas);
	c.config.controller.length_moves = ANSWER_NO;
	c.config.controller.comp_d = COMP_D_DIAMETER;
	ck_assert(case_run(&c, "F9 G10 L10 P7 R100.\nG10 L11 P7 R0.5\nG91 G10 L11 P7 R-0.1\nG10 L10 P7 R10.\nG90 G43 H7 G0 Z1.\n"
			       "G10 L12 P9 R6.\nG10 L13 P9 R-1.\nG1 G41 D9 X9. Y0.\nX20.\nG40 Y9.\nM30\n"));
	ck_assert_str_eq(strbuf_text(&c.moves), "rapid 0 0 111.4 0 0\nfeed 9 2.5 111.4 0 0\nfeed 20 2.5 111.4 0 0\n"
						"feed 20 9 111.4 0 0\n");
	ck_assert_ptr_nonnull(strstr(strbuf_text(&c.messages), "1:8: warning: the wear of H7 is assumed to be 0 until the program sets it"));
	case_release(&c);
}
END_TEST

static const struct {
	const struct dialect *dialect;
	const char *program, *message;
} bads[] = {
	{&dialect_fanuc, "F9 G1 X5. ,A5.\n", ",A is not supported"},
	{&dialect_fanuc, "F9 G1 X5. ,R1. ,C1.\n", "a block can have only one word after a comma"},
	{&dialect_fanuc, "F9 G0 X5. ,R1.\n", ",R needs a block with G1, G2 or G3"},
	{&dialect_fanuc, "F9 G1 X5. ,R0.\n", ",R must be greater than 0"},
	{&dialect_fanuc, "F9 G1 X5. ,R1.\nZ5.\n", "must be moves with G1, G2 or G3 in the plane"},
	{&dialect_fanuc, "F9 G1 X5. Z1. ,R1.\n", "must be moves with G1, G2 or G3 in the plane"},
	{&dialect_fanuc, "F9 G1 X5. ,R1.\nM30\n", "must have a move in the plane and no other code"},
	{&dialect_fanuc, "F9 G1 X5. ,R1.\nF20\n", "must be a move with G1, G2 or G3 in the plane"},
	{&dialect_fanuc, "F9 G1 X5. ,R1.\nX9.\n", "the path has no corner at"},
	{&dialect_fanuc, "F9 G1 X5. ,R6.\nY9.\n", "is longer than one of its blocks"},
	{&dialect_fanuc, "F9 G1 X5. ,C1.\nG2 Y9. R9.\n", "a chamfer (,C or ,R) beside an arc"},
	{&dialect_haas, "F9 G1 X5. ,R1.\nG2 Y9. R9.\n", "this control does not support a chamfer or rounding"},
	{&dialect_fanuc, "F9 G1 X5. ,R1.\n", "must be a move with G1, G2 or G3 in the plane"},
	{&dialect_linuxcnc, "F9 G1 X5. ,R1.\n", "unexpected ','"},
	{&dialect_fanuc, "G10 L12 P1 R5.\n", "cutter_comp_d=\"radius\" or \"diameter\""},
	{&dialect_fanuc, "G10 L10 P1 Z5.\n", "G10 L10 needs R (value) and no axis words"},
	{&dialect_fanuc, "G10 L10 P1 R5.\nG43 H1 G0 Z9.\nG10 L11 P1 R1.\n", "G10 changes H1 while it is active"},
	{&dialect_fanuc, "G51.1\n", "G51.1 needs words for the axes to mirror"},
	{&dialect_fanuc, "G51.1 A0.\n", "a mirror image of A is not supported"},
	{&dialect_fanuc, "G91 G51.1 X0.\n", "G51.1 in incremental mode (G91) is not supported"},
	{&dialect_fanuc, "G51.1 X0. G0\n", "G51.1 with axis words needs a block without motion and offsets"},
	{&dialect_fanuc, "G51.1 X0.\nG54\n", "a change of offsets while a mirror image is active"},
	{&dialect_fanuc, "G51.1 X0.\nG91 G28 Z0.\n", "a move to a machine position while a mirror image"},
	{&dialect_haas, "G101 X0.\nG91 G28 X0.\n", "a move to a machine position while a mirror image"},
	{&dialect_haas, "G101 X1.\n", "G101 with a value other than 0 is not supported"},
	{&dialect_fanuc, "G51.1 X0.\nG68 X0. Y0. R9.\n", "a rotation while a mirror image is active"},
	{&dialect_fanuc, "G68 X0. Y0. R9.\nG51.1 X0.\n", "a mirror image of rotated coordinates"},
	{&dialect_fanuc, "F9 G51.1 Z0.\nG81 X1. Z-1. R1.\n", "a canned cycle along a mirrored axis"},
	{&dialect_fanuc, "G51.1 X0.\nG0 X1.\nG50.1\nG91 X1.\n", "increment in X after G50.1"},
	{&dialect_fanuc, "F9 G51.1 X0.\nG1 G41 D1 X5.\nG50.1\n", "a change of the coordinates while cutter compensation is on"},
	{&dialect_fanuc, "G16 G0 X5.\n", "the first move in polar coordinates (G16) needs X (radius) and Y (angle)"},
	{&dialect_fanuc, "G16 G0 X5. Y0.\nG91 X1.\n", "increment in X (G91) in polar coordinates (G16)"},
	{&dialect_fanuc, "G16 G0 X5. Y0.\nG91 X0 Y9.\n", "increment in X (G91) in polar coordinates (G16)"},
	{&dialect_fanuc, "F9 G16 G1 X5. Y0.\nG2 X5. Y90. R5.\n", "an arc in polar coordinates (G16)"},
	{&dialect_fanuc, "G60 G1 X5.\n", "G60 positions the axes itself"},
	{&dialect_haas, "F9 G2 X5. Y5.\n", "an arc needs a centre (I, J, K) or a radius (R)"},
	{&dialect_haas, "F9 G83 X1. Z-5. R0. I0. J0. K1.\n", "I and K of G83 must be greater than 0"},
};

START_TEST(faults)
{
	for (size_t i = 0; i < COUNT(bads); i++) {
		struct gcode_case c;

		init(&c, bads[i].dialect);
		if (case_run(&c, bads[i].program) || !strstr(strbuf_text(&c.messages), bads[i].message))
			ck_abort_msg("%s%s", bads[i].program, strbuf_text(&c.messages));
		case_release(&c);
	}
}
END_TEST

int main(void)
{
	const TTest *tests[] = {mirror, preset, scaling, unscaled_faults, polar, single_direction, arc_without_centre, registers, unit_of_feed, exact_stop, pecks, corners, faults};

	return RUN_TESTS("frames", tests);
}
