/* test_gcode_conversion.c - three-dimensional coordinate conversion (G68 with I, J, K) against closed forms. */
#include "gcode_refusal.h"

static const struct length_offset lengths[] = {{1, 100}};

static void init(struct gcode_case *c, const struct dialect *dialect, enum length_under_g68 way)
{
	case_init(c);
	c->config.dialect = dialect;
	c->config.controller.length_moves = ANSWER_NO;
	c->config.controller.length_under_g68 = way;
	c->config.lengths = lengths;
	c->config.length_count = 1;
}

static void run(enum length_under_g68 way, const char *program, const char *moves)
{
	struct gcode_case c;

	init(&c, &dialect_fanuc, way);
	case_expect(&c, program, moves);
}

/* Fanuc 16-C operator's manual (B-62764EN), "Three-dimensional coordinate conversion". */
START_TEST(shifted_and_turned)
{
	/* By 90 degrees about Y, X' = -Z and Z' = X: (1, 2, 3) is (10 + 3, 20 + 2, 30 - 1). */
	run(LENGTH_UNDER_G68_UNKNOWN,
	    "G68 X10. Y20. Z30. I0 J1 K0 R90.\nG0 X1. Y2. Z3.\nG91 Z1.\nG90 X5.\nG69\nX0. Y0. Z0.\nM30\n",
	    "rapid 13 22 29 0 0\nrapid 14 22 29 0 0\nrapid 14 22 25 0 0\nrapid 0 0 0 0 0\n");
	/* The direction need not have length 1, and its sign reverses the angle. The work offset stays where it is. */
	run(LENGTH_UNDER_G68_UNKNOWN, "G10 L2 P1 X100. Y0. Z0.\nG54 G68 X10. Y20. Z30. I0. J-5. K0. R-90.\nG0 X1. Y2. Z3.\nM30\n",
	    "rapid 113 22 29 0 0\n");
	/* About (1, 1, 1) by a third of a turn: X goes to Y, Y to Z, Z to X. */
	run(LENGTH_UNDER_G68_UNKNOWN, "G68 X0. Y0. Z0. I2. J2. K2. R120.\nG0 X1. Y2. Z3.\nM30\n", "rapid 3 1 2 0 0\n");
}
END_TEST

/* The example of the same manual: about Z, and then about the new X, through the same centre or another one. */
START_TEST(twice)
{
	run(LENGTH_UNDER_G68_UNKNOWN, "G68 X10. Y20. Z30. I0 J0 K1 R90.\nG68 I1 J0 K0 R90.\nG0 X1. Y2. Z3.\nM30\n",
	    "rapid 13 21 32 0 0\n");
	/* (1, 0, 5) of the first is (10 - 0, 20 + 1, 30 + 5). */
	run(LENGTH_UNDER_G68_UNKNOWN,
	    "G68 X10. Y20. Z30. I0 J0 K1 R90.\nG68 X1. Y0. Z5. I1 J0 K0 R90.\nG0 X1. Y2. Z3.\nM30\n",
	    "rapid 13 22 37 0 0\n");
}
END_TEST

/* Parameters of the builder decide: the tool's length acts along the turned Z, or along Z. */
START_TEST(length)
{
	const char *program = "G68 X10. Y20. Z30. I0 J1 K0 R90.\nG0 G43 H1 X1. Y2. Z3.\nZ4.\nG69\nG90 X0. Y0. Z0.\nM30\n";

	run(LENGTH_UNDER_G68_TURNED, program, "rapid 113 22 29 0 0\nrapid 114 22 29 0 0\nrapid 0 0 100 0 0\n");
	run(LENGTH_UNDER_G68_STRAIGHT, program, "rapid 13 22 129 0 0\nrapid 14 22 129 0 0\nrapid 0 0 100 0 0\n");
	run(LENGTH_UNDER_G68_TURNED, "G43 H1 G0 Z5.\nG68 X0. Y0. Z0. I1 J0 K0 R-90.\nX1. Y2. Z3.\nG49 Z3. X1. Y2.\nM30\n",
	    "rapid 0 0 105 0 0\nrapid 1 103 -2 0 0\nrapid 1 3 -2 0 0\n");
}
END_TEST

/* Arcs turn with their plane, and holes are drilled along the turned Z. */
START_TEST(arcs_and_cycles)
{
	run(LENGTH_UNDER_G68_UNKNOWN,
	    "F9 G68 X0. Y0. Z0. I0 J1 K0 R90.\nG0 X0. Y0. Z9.\nG2 X10. Y10. I10. J0.\nG81 G99 X5. Y5. R5. Z-2.\nM30\n",
	    "rapid 9 0 0 0 0\narc 9 10 -10 0 0 centre 9 0 -10 normal 1 0 0 sweep -90\n"
	    "rapid 9 5 -5 0 0\nrapid 5 5 -5 0 0\nfeed -2 5 -5 0 0\nrapid 5 5 -5 0 0\n");
}
END_TEST

#define TURN "G68 X0. Y0. Z0. I0 J1 K0 R90."

static const struct bad {
	const char *before, *block, *message;
} bads[] = {
    {"", "G68 X0. Y0. Z0. I0 J1 R90.", "G68 with I, J or K needs all three of them, and R (angle)"},
    {"", "G68 X0. Y0. Z0. I0 J1 K0", "G68 with I, J or K needs all three of them, and R (angle)"},
    {"", "G68 X0. Y0. Z0. I0 J0 K0 R90.", "I, J and K of G68 are all 0"},
    {"", "G68 X0. Y0. I0 J1 K0 R90.", "G68 with I, J and K needs X, Y and Z (centre)"},
    {"", "G68 I0 J1 K0 R90.", "G68 with I, J and K needs X, Y and Z (centre)"},
    {"", "G68 X0. Y0. Z0. C0. I0 J1 K0 R90.", "C does not belong to G68 with I, J and K"},
    {"G0 X1. Y1. Z2.\n" TURN, "G0 X0. Y0.", "controls differ in where Z stays"},
    {"G0 X1. Y1. Z1.\n" TURN, "G91 G0 X1.", "needs X, Y and Z as absolute coordinates"},
    {TURN "\n" TURN, TURN, "the coordinates are already rotated; cancel this by G69 first"},
    {TURN, "G68 R5.", "the coordinates are already rotated; cancel this by G69 first"},
    {"G68 R5.", TURN, "the coordinates are already rotated; cancel this by G69 first"},
    {TURN, "G91 G28 Z0.", "G28 while G68 is active; write G69 first"},
    {TURN, "G0 G43 H1 X0. Y0. Z0.", "controls differ in the direction in which the tool length acts"},
    {"G43 H1 G0 Z0.", TURN, "controls differ in the direction in which the tool length acts"},
    {TURN, "G43.4 H1", "G43.4 (tool centre point control) while G68 is active is not supported; write G69 first"},
};

START_TEST(refused)
{
	struct gcode_case c;

	init(&c, &dialect_fanuc, LENGTH_UNDER_G68_UNKNOWN);
	case_refuses(&c, bads[_i].message, "%s\n%s\nM30\n", bads[_i].before, bads[_i].block);
}
END_TEST

/* Haas mill operator's manual, "G68 Rotation": in a plane only. */
START_TEST(haas)
{
	struct gcode_case c;

	init(&c, &dialect_haas, LENGTH_UNDER_G68_TURNED);
	ck_assert(!case_run(&c, TURN "\nM30\n"));
	ck_assert(strstr(strbuf_text(&c.messages), "this control has no three-dimensional coordinate conversion"));
	case_release(&c);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("programs");

	tcase_add_test(tcase, shifted_and_turned);
	tcase_add_test(tcase, twice);
	tcase_add_test(tcase, length);
	tcase_add_test(tcase, arcs_and_cycles);
	tcase_add_test(tcase, haas);
	tcase_add_loop_test(tcase, refused, 0, COUNT(bads));
	return run_suite("gcode_conversion", tcase);
}
