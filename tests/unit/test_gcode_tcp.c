/* test_gcode_tcp.c - TCP on and off, against a table that turns with C: closed forms in gcode_case.h. */
#include "gcode_case.h"

static const struct length_offset lengths[] = {{1, 100}, {2, 40}};
static const struct mcode mcodes[] = {
    {428, MCODE_TCP_ON}, {429, MCODE_TCP_OFF}, {10, MCODE_IGNORE}, {11, MCODE_IGNORE}};

static void tcp_case(struct gcode_case *c)
{
	case_init(c);
	c->config.lengths = lengths;
	c->config.length_count = 2;
	c->config.controller.mcodes = mcodes;
	c->config.controller.mcode_count = COUNT(mcodes);
}

START_TEST(on_and_off)
{
	struct gcode_case c;

	tcp_case(&c);
	/* At C90 the machine's (10, 0) is (0, -10) on the table; the length leaves Z. */
	case_expect(&c, "G0 X10 Z200 C90\nG43.4 H1\nZ50\nX5\nG49\nZ200\nG91 X1\nM2\n",
		    "rapid 10 0 200 0 90\n"
		    "tcp on length 100 zero A0 C0\n"
		    "rapid 0 -10 50 0 90 tcp\nrapid 5 -10 50 0 90 tcp\n"
		    "tcp off length 0 zero A0 C0\n"
		    "rapid 10 5 200 0 90\nrapid 11 5 200 0 90\n");
}
END_TEST

START_TEST(motion_in_the_same_block)
{
	struct gcode_case c;

	tcp_case(&c);
	case_expect(&c, "G10 L2 P1 X1 Z10\nG0 G43.4 H1 X0 Z0\nM2\n",
		    "tcp on length 100 zero A0 C0\nrapid 1 0 10 0 0 tcp\n");
}
END_TEST

START_TEST(length_changes)
{
	struct gcode_case c;

	tcp_case(&c);
	/* The axes do not move: a tool that is 60 mm shorter raises the tool point by 60 mm. */
	case_expect(&c, "G43.4 H1\nG0 Z0\nG43.4 H2\nG91 Z0\nM2\n",
		    "tcp on length 100 zero A0 C0\nrapid 0 0 0 0 0 tcp\n"
		    "tcp on length 40 zero A0 C0\nrapid 0 0 60 0 0 tcp\n");
}
END_TEST

START_TEST(by_mcode)
{
	struct gcode_case c;

	tcp_case(&c);
	/* G49 cancels the length, but not the kinematics that the M-code has switched. */
	case_expect(&c, "G43 H1 G0 Z0\nM428\nX1 Z0 M428\nG49 Z0\nG43 H2\nZ0\nM429 X0\nM429 Z0\nM2\n",
		    "rapid 0 0 100 0 0\n"
		    "tcp on length 100 zero A0 C0\nrapid 1 0 0 0 0 tcp\n"
		    "tcp on length 0 zero A0 C0\nrapid 1 0 0 0 0 tcp\n"
		    "tcp on length 40 zero A0 C0\nrapid 1 0 0 0 0 tcp\n"
		    "tcp off length 40 zero A0 C0\nrapid 0 0 40 0 0\nrapid 0 0 40 0 0\n");
}
END_TEST

START_TEST(ignored_mcodes)
{
	struct gcode_case c;

	tcp_case(&c);
	case_expect(&c, "M10 M11 P5 Q2\nG0 X1 M10\nM2\n", "rapid 1 0 0 0 0\n");
}
END_TEST

START_TEST(machine_axes)
{
	struct gcode_case c;

	tcp_case(&c);
	/* At C90 tool point (20, 0) is machine (0, 20); G53 X5 leaves Y there: back on the table (20, -5). */
	case_expect(&c, "G43.4 H1\nG0 X20 Z0 C90\nG53 X5\nG91 X1\nG28 Z10\nG90 X0 Y0 Z0\nM2\n",
		    "tcp on length 100 zero A0 C0\nrapid 20 0 0 0 90 tcp\n"
		    "tcp off length 100 zero A0 C0\nrapid 5 20 100 0 90\ntcp on length 100 zero A0 C0\n"
		    "rapid 21 -5 0 0 90 tcp\n"
		    "rapid 21 -5 10 0 90 tcp\n"
		    "tcp off length 100 zero A0 C0\nrapid 5 21 0 0 90\ntcp on length 100 zero A0 C0\n"
		    "rapid 0 0 0 0 90 tcp\n");
	/* Haas mill operator's manual, "G53 Non-Modal Machine Coordinate Selection". */
	tcp_case(&c);
	c.config.dialect = &dialect_haas;
	case_expect(&c, "M428\nG0 X1. C90.\nG53 Y5.\nM30\n",
		    "tcp on length 0 zero A0 C0\nrapid 1 0 0 0 90 tcp\n"
		    "tcp off length 0 zero A0 C0\nrapid 0 5 0 0 90\ntcp on length 0 zero A0 C0\n");
}
END_TEST

START_TEST(remembered_reference)
{
	struct gcode_case c;

	tcp_case(&c);
	case_expect(&c, "G43.4 H1\nG0 X20 Z0 C90\nG28.1\nG49 G0 X0\nG28\nM2\n",
		    "tcp on length 100 zero A0 C0\nrapid 20 0 0 0 90 tcp\n"
		    "tcp off length 100 zero A0 C0\ntcp on length 100 zero A0 C0\n"
		    "tcp off length 0 zero A0 C0\nrapid 0 20 100 0 90\nrapid 0 20 100 0 90\n");
}
END_TEST

START_TEST(zero_at_the_offset)
{
	struct gcode_case c;

	tcp_case(&c);
	c.config.controller.tcp_zero_offset = true;
	/* With C's offset at 90 the table is not turned there: (10, 0) stays; at offset 0 it is (0, -10). */
	case_expect(
	    &c, "G10 L2 P1 C90\nG0 X10 C0\nG43.4 H1\nG91 X0\nG10 L2 P1 C0\nX0\nG55\nG10 L2 P1 A5\nG54\nG52 Y3\nM2\n",
	    "rapid 10 0 0 0 90\n"
	    "tcp on length 100 zero A0 C90\nrapid 10 0 -100 0 90 tcp\n"
	    "tcp on length 100 zero A0 C0\nrapid 0 -10 -100 0 90 tcp\n"
	    "tcp on length 100 zero A5 C0\n");
}
END_TEST

START_TEST(shift_of_rotary_and_linear_axes_at_once)
{
	struct gcode_case c;

	tcp_case(&c);
	c.config.controller.tcp_zero_offset = true;
	/*
	 * G92 C0 at C90 turns the meaning of X and Y by a quarter, from (0, -10) to
	 * (10, 0): X0 Y0 of the same block are of the point after that.
	 */
	case_expect(
	    &c, "G0 X10 C90\nG43.4 H0\nG92 X0 Y0 C0\nG0 X1 Y0\nM2\n",
	    "rapid 10 0 0 0 90\ntcp on length 0 zero A0 C0\ntcp on length 0 zero A0 C90\nrapid 11 0 0 0 90 tcp\n");
}
END_TEST

START_TEST(refused)
{
	struct gcode_case c;

	tcp_case(&c);
	c.refuse_tcp = true;
	ck_assert(!case_run(&c, "G0 X1\nX2 G43.4 H1\nM2\n"));
	ck_assert_str_eq(strbuf_text(&c.messages), "p.nc:2:4: error: no TCP here\n");
	ck_assert_str_eq(strbuf_text(&c.moves), "rapid 1 0 0 0 0\n");
	case_release(&c);
}
END_TEST

static void length_case(struct gcode_case *c, const struct dialect *dialect)
{
	tcp_case(c);
	c->config.dialect = dialect;
	c->config.controller.length_moves = ANSWER_NO;
}

/*
 * Haas mill operator's manual, "G28 Return to Machine Zero": by way of the point
 * with the length, which is cancelled from then on. With G54's Z at 50 and a tool
 * of 100, Z0. is at 150 before it and at 50 after it.
 */
START_TEST(haas_g28_cancels_the_length)
{
	struct gcode_case c;

	length_case(&c, &dialect_haas);
	case_expect(&c, "G10 L2 P1 Z50.\nG43 H1 G0 Z1.\nG28 Z0.\nG0 Z0.\nG43 H1 Z0.\nG53 Z0.\nZ0.\nM30\n",
		    "rapid 0 0 151 0 0\nrapid 0 0 150 0 0\nrapid 0 0 0 0 0\nrapid 0 0 50 0 0\nrapid 0 0 150 0 0\n"
		    "rapid 0 0 0 0 0\nrapid 0 0 150 0 0\n");
}
END_TEST

/* LinuxCNC keeps the length (the manual's "G28" says nothing about it; rs274 does). */
START_TEST(linuxcnc_g28_keeps_the_length)
{
	struct gcode_case c;

	length_case(&c, &dialect_linuxcnc);
	case_expect(&c, "G43 H1 G0 Z1\nG28 Z0\nZ0\nM2\n",
		    "rapid 0 0 101 0 0\nrapid 0 0 100 0 0\nrapid 0 0 0 0 0\nrapid 0 0 100 0 0\n");
}
END_TEST

/* Blocks without Z, with machine coordinates, with zero increments or with a new G43 do not depend on the length. */
START_TEST(fanuc_length_in_doubt_is_not_needed)
{
	struct gcode_case c;

	length_case(&c, &dialect_fanuc);
	case_expect(&c,
		    "G43 H1 G0 Z1.\nG91 G28 Z0.\nG28 X0. Y0. Z0.\nG90 X5. Y5.\nG53 Z-1.\nG43 H2 Z1.\n"
		    "G53 X0.\nZ2.\nG28 X7.\nZ3.\nG53 Z0.\nG49 Z4.\nM30\n",
		    "rapid 0 0 101 0 0\nrapid 0 0 101 0 0\nrapid 0 0 0 0 0\nrapid 0 0 0 0 0\nrapid 0 0 0 0 0\n"
		    "rapid 5 5 0 0 0\nrapid 5 5 -1 0 0\nrapid 5 5 41 0 0\n"
		    "rapid 0 5 41 0 0\nrapid 0 5 42 0 0\nrapid 7 5 42 0 0\nrapid 0 5 42 0 0\nrapid 0 5 43 0 0\n"
		    "rapid 0 5 0 0 0\nrapid 0 5 4 0 0\n");
}
END_TEST

/*
 * Fanuc 0i-MB operator's manual (B-63844EN), "G53, G28, and G30 commands in tool
 * length offset mode": parameter 5001#6 says whether the length comes back by
 * itself. Haas: G234 and G30 are not mentioned where G28 is.
 */
static const struct {
	const struct dialect *dialect;
	const char *before, *block;
	int column;
	const char *code;
} doubts[] = {
	{&dialect_fanuc, "G43 H1 G0 Z9.\nG28 Z10.\nX1.", "Z5.", 1, "G28"},
	{&dialect_fanuc, "G43 H1 G0 Z9.\nG30 Z10.\nG91", "X1. Z5.", 5, "G30"},
	{&dialect_fanuc, "G43 H1 G0 Z9.\nG53 Z0.", "G1 F9. Z5.", 8, "G53"},
	{&dialect_fanuc, "G43 H1 G0 Z9.\nG53 Z0.", "G28 Z5.", 5, "G53"},
	{&dialect_fanuc, "G43 H1 G0 Z9. F9.\nG81 Z0. R5.\nG53 G0 Z0.\nG81 Z0. R5.", "", 0, "G53"},
	{&dialect_fanuc, "G43.4 H1 G0 Z9.\nG53 X0.", "Y5.", 1, "G53"},
	{&dialect_fanuc, "G43.4 H1 G0 Z9.\nG28 X0.", "C5.", 1, "G28"},
	{&dialect_haas, "G234 H1 G0 Z9.\nG28 Z10.", "X5.", 1, "G28"},
	{&dialect_haas, "G43 H1 G0 Z9.\nG30 Z10.", "Z5.", 1, "G30"},
	{&dialect_haas, "G43 H1 G0 Z9.\nG28 X0.", "Z5.", 1, "G28"},
};

START_TEST(length_in_doubt)
{
	struct strbuf program = {0}, expected = {0};
	struct gcode_case c;

	length_case(&c, doubts[_i].dialect);
	c.config.controller.references[1].given = true;
	strbuf_addf(&program, "%s\n%s\n", doubts[_i].before, doubts[_i].block);
	strbuf_addf(&expected, "%s may have cancelled the tool length compensation", doubts[_i].code);
	ck_assert_msg(!case_run(&c, program.text), "accepted: %s", program.text);
	ck_assert_msg(strstr(strbuf_text(&c.messages), expected.text) != NULL, "%s", strbuf_text(&c.messages));
	if (doubts[_i].column) {
		strbuf_release(&expected);
		strbuf_addf(&expected, ":%d: error: ", doubts[_i].column);
		ck_assert_msg(strstr(strbuf_text(&c.messages), expected.text) != NULL, "%s", strbuf_text(&c.messages));
	}
	strbuf_release(&program);
	strbuf_release(&expected);
	case_release(&c);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("programs");

	tcase_add_test(tcase, on_and_off);
	tcase_add_test(tcase, motion_in_the_same_block);
	tcase_add_test(tcase, length_changes);
	tcase_add_test(tcase, by_mcode);
	tcase_add_test(tcase, ignored_mcodes);
	tcase_add_test(tcase, machine_axes);
	tcase_add_test(tcase, remembered_reference);
	tcase_add_test(tcase, zero_at_the_offset);
	tcase_add_test(tcase, shift_of_rotary_and_linear_axes_at_once);
	tcase_add_test(tcase, refused);
	tcase_add_test(tcase, haas_g28_cancels_the_length);
	tcase_add_test(tcase, linuxcnc_g28_keeps_the_length);
	tcase_add_test(tcase, fanuc_length_in_doubt_is_not_needed);
	tcase_add_loop_test(tcase, length_in_doubt, 0, COUNT(doubts));
	return run_suite("gcode_tcp", tcase);
}
