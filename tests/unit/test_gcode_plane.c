/* test_gcode_plane.c - turned coordinates, tilted planes, additional offsets, least input increments: closed forms. */
#include "gcode_case.h"

static const struct gcode_length lengths[] = {{1, 100}};

static void plane_case(struct gcode_case *c, enum gcode_dialect dialect)
{
	case_init(c);
	c->config.dialect = dialect;
	c->config.lengths = lengths;
	c->config.length_count = 1;
}

static void run(enum gcode_dialect dialect, const char *program, const char *moves)
{
	struct gcode_case c;

	plane_case(&c, dialect);
	case_expect(&c, program, moves);
}

/* Fanuc B-64484EN, "Coordinate system rotation (G68, G69)"; Haas, "G68 Rotation (Group 16)". */
START_TEST(rotation)
{
	/* By 90 degrees about (10, 0): (11, 0) goes to (10, 1). */
	run(GCODE_FANUC, "G0 X1. Y1.\nG68 X10. Y0. R90.\nX11. Y0.\nG91 X1.\nG90 Y5.\nG69\nX0.\nM30\n",
	    "rapid 1 1 0 0 0\nrapid 10 1 0 0 0\nrapid 10 2 0 0 0\nrapid 5 2 0 0 0\nrapid 0 2 0 0 0\n");
	/* Without a centre the tool stands on it; work offsets stay where they are. */
	run(GCODE_HAAS, "G10 L2 P1 X100. Y0.\nG54 G0 X1. Y1.\nG68 R-90.\nX2. Y1.\nG69\nM30\n",
	    "rapid 101 1 0 0 0\nrapid 101 0 0 0 0\n");
	run(GCODE_FANUC, "G18 G68 X0. Z0. R90.\nG0 X1. Z0.\nG69\nG19 G68 Y0. Z0. R90.\nG0 Y1. Z0. X0.\nM30\n",
	    "rapid 0 0 -1 0 0\nrapid 0 0 1 0 0\n");
}
END_TEST

START_TEST(rotated_arcs_and_cycles)
{
	run(GCODE_FANUC, "F9 G68 X0. Y0. R90.\nG2 X10. Y10. I10. J0.\nG3 X0. Y0. R10.\nG81 G99 X5. Y0. R-1. Z-2.\nM30\n",
	    "arc -10 10 0 0 0 centre 0 10 0 normal 0 0 1 sweep -90\n"
	    "arc 0 0 0 0 0 centre 0 10 0 normal 0 0 1 sweep 90\n"
	    "rapid 0 5 0 0 0\nrapid 0 5 -1 0 0\nfeed 0 5 -2 0 0\nrapid 0 5 -1 0 0\n");
}
END_TEST

/*
 * Fanuc B-64484EN, "Tilted working plane indexing": Z-X'-Z'' by I, J, K. The
 * case's control has TCP on a table C; its G53.1 gives A = 20 here and leaves C.
 * With I 180: n = Rz(180) Rx(J) z = (0, sin J, cos J).
 */
START_TEST(tilted)
{
	struct gcode_case c;

	plane_case(&c, GCODE_FANUC);
	case_expect(&c,
		    "G0 Z50.\nG68.2 X10. Y20. Z30. I180. J90. K0.\nG53.1\nG43 H1\nG0 X1. Y2. Z3.\nG91 Z1.\nG90 G53 Z0.\n"
		    "X0. Y0. Z0.\nG28 Z5.\nG69\nG0 X0. Z0.\nM30\n",
		    "rapid 0 0 50 0 0\norient 0 1 0\nrapid 0 0 50 90 0\n"
		    "tcp on length 0 zero A0 C0\n"
		    "tcp on length 100 zero A0 C0\n"
		    /* X' = -X, Y' = Z, Z' = Y */
		    "rapid 9 23 32 90 0 tcp\nrapid 9 24 32 90 0 tcp\n"
		    "tcp off length 100 zero A0 C0\nrapid 9 24 0 90 0\ntcp on length 100 zero A0 C0\n"
		    "rapid 10 20 30 90 0 tcp\n"
		    "rapid 10 25 30 90 0 tcp\n"
		    "tcp off length 100 zero A0 C0\nrapid 10 25 0 90 0\ntcp on length 100 zero A0 C0\n"
		    "tcp off length 100 zero A0 C0\nrapid 0 25 100 90 0\n");
}
END_TEST

/* The same manual, "Additional workpiece coordinate systems"; Haas, "G110-G129", "G154", "G10 L20". */
START_TEST(additional_offsets)
{
	static const struct gcode_work_offset offsets[] = {{"G54.1 P2", {{7}}}, {"G154 P48", {{9}}}};
	struct gcode_case c;

	plane_case(&c, GCODE_FANUC);
	c.config.work_offsets = offsets;
	c.config.work_offset_count = 2;
	case_expect(&c, "G54.1 P2 G0 X1.\nG54.1 P48 X1.\nG10 L20 P3 X40.\nG54.1 P3 X1.\nG54 X1.\nM30\n",
		    "rapid 8 0 0 0 0\nrapid 10 0 0 0 0\nrapid 41 0 0 0 0\nrapid 1 0 0 0 0\n");
	plane_case(&c, GCODE_HAAS);
	c.config.work_offsets = offsets;
	c.config.work_offset_count = 2;
	case_expect(&c, "G111 G0 X1.\nG154 P48 X1.\nG154 P2 X2.\nG129 X3.\nM30\n",
		    "rapid 8 0 0 0 0\nrapid 10 0 0 0 0\nrapid 9 0 0 0 0\nrapid 3 0 0 0 0\n");
}
END_TEST

/* The same manual, "Decimal point programming"; increments of an inch are ten times as fine in their unit. */
START_TEST(least_input)
{
	struct gcode_case c;

	plane_case(&c, GCODE_FANUC);
	c.config.least_input = 0.001;
	case_expect(&c,
		    "G0 X1000 Y1. C90000\nG1 F9 X2000\nG2 X0 I-1000 J0\nG91 G99 G81 X1000 Z-1000 R-1000 K2 F100\n"
		    "G80\nG4 X500\nG90 G20 G0 X10000\nM30\n",
		    "rapid 1 1 0 0 90\nfeed 2 1 0 0 90\n"
		    "arc 0 1 0 0 90 centre 1 1 0 normal 0 0 1 sweep -180\n"
		    "rapid 1 1 0 0 90\nrapid 1 1 -1 0 90\nfeed 1 1 -2 0 90\nrapid 1 1 -1 0 90\n"
		    "rapid 2 1 -1 0 90\nrapid 2 1 -1 0 90\nfeed 2 1 -2 0 90\nrapid 2 1 -1 0 90\n"
		    "dwell 0.5\nrapid 25.4 1 -1 0 90\n");
}
END_TEST

/* Haas, "G234 Tool Center Point Control". */
START_TEST(haas_tool_centre)
{
	run(GCODE_HAAS, "G234 H1\nG0 X1.\nG49\nM30\n",
	    "tcp on length 100 zero A0 C0\nrapid 1 0 -100 0 0 tcp\ntcp off length 0 zero A0 C0\n");
}
END_TEST

struct bad {
	enum gcode_dialect dialect;
	const char *before, *block;
	int column;
	const char *message;
};

#define TILT "G68.2 X0. I180. J90."

static const struct bad bads[] = {
    {GCODE_LINUXCNC, "", "G68 R5", 1, "G68 is no G-code that is known in the linuxcnc dialect"},
    {GCODE_FANUC, "", "G68 X0. Y0.", 1, "G68 needs its angle in R"},
    {GCODE_FANUC, "", "G68 X0. Z0. R5.", 9, "Z does not belong to the centre of G68 in the plane of G17"},
    {GCODE_FANUC, "G91", "G68 X0. R5.", 1, "G68 in incremental distance mode (G91) is not supported yet"},
    {GCODE_FANUC, "G68 R5.", "G68 R5.", 1, "the coordinates are turned already; G69 turns them back first"},
    {GCODE_FANUC, "G68 R5.", "G18", 1, "a change of the plane while G68 is in force; G69 first"},
    {GCODE_FANUC, "G68 R5.", "G55", 1, "a change of offsets while G68 is in force is not supported; G69 first"},
    {GCODE_FANUC, "G68 R5.", "G92 X0.", 1, "a change of offsets while G68 is in force is not supported; G69 first"},
    {GCODE_FANUC, "G68 R5.", "G43.4 H1", 1, "tool centre point control while G68 is in force; G69 first"},
    {GCODE_FANUC, "", "G0 G68 X0. R5.", 1, "G68 needs a block without motion, offsets or a dwell"},
    {GCODE_FANUC, "", "G53.1", 1, "G53.1 needs a plane that G68.2 has just tilted"},
    {GCODE_FANUC, TILT, "G53.1 X1.", 7, "axis words, but no motion code is in force (G0, G1, G2, G3)"},
    {GCODE_FANUC, TILT, "G0 X1.", 1,
     "a move between G68.2 and G53.1, before the tool stands on the plane, is not supported"},
    {GCODE_FANUC, TILT "\nG53.1", "G53.1", 1, "G53.1 needs a plane that G68.2 has just tilted"},
    {GCODE_FANUC, TILT "\nG53.1", "G0 C5.", 4,
     "C while G68.2 is in force: the tool would leave the direction of its plane"},
    {GCODE_FANUC, TILT "\nG53.1", "G54", 1, "a change of offsets while G68.2 is in force is not supported; G69 first"},
    {GCODE_FANUC, TILT "\nG53.1", "G43.4 H1", 1, "tool centre point control while G68.2 is in force; G69 first"},
    {GCODE_FANUC, "", "G68.2 A5.", 7, "A does not belong to G68.2, whose origin is in X, Y and Z"},
    {GCODE_FANUC, "", "G68.2 P1 I5.", 7, "no code in the block uses the word P"},
    {GCODE_FANUC, "G43.4 H1", "G68.2 I5.", 1, "G68.2 under tool centre point control; cancel that first"},
    {GCODE_FANUC, "G68.2 I90. J90.", "G53.1", 1, "no such plane here"},
    {GCODE_HAAS, "", "G68.2 I5.", 1, "G68.2: tilted working plane is not supported yet"},
    {GCODE_HAAS, "", "G254", 1, 
     "G254: dynamic work offset, which carries the work origin along with the rotary table, is not supported yet"},
    {GCODE_FANUC, "", "G43.5 H1", 1, "G43.5: tool centre point control with tool vectors is not supported yet"},
    {GCODE_FANUC, "", "G54.1", 1, "G54.1 needs P"},
    {GCODE_FANUC, "", "G54.1 P49", 7, "P49: a whole number from 1 to 48 is needed"},
    {GCODE_HAAS, "", "G154 P100", 6, "P100: a whole number from 1 to 99 is needed"},
    {GCODE_FANUC, "", "G110", 1, "G110 is no G-code that is known in the fanuc dialect"},
    {GCODE_HAAS, "", "G234", 1, "G234 needs H"},
};

START_TEST(refused)
{
	const struct bad *bad = &bads[_i];
	struct strbuf program = {0}, expected = {0};
	struct gcode_case c;
	int line = *bad->before ? 2 : 1;

	for (const char *p = bad->before; *p; p++)
		line += *p == '\n';
	plane_case(&c, bad->dialect);
	strbuf_addf(&program, "%s%s%s\n", bad->before, *bad->before ? "\n" : "", bad->block);
	ck_assert_msg(!case_run(&c, program.text), "accepted: %s", bad->block);
	strbuf_addf(&expected, "p.nc:%d:%d: error: %s\n", line, bad->column, bad->message);
	ck_assert_msg(!strncmp(strbuf_text(&c.messages), strbuf_text(&expected), strlen(strbuf_text(&expected))),
		      "%snot %s", strbuf_text(&c.messages), strbuf_text(&expected));
	strbuf_release(&program);
	strbuf_release(&expected);
	case_release(&c);
}
END_TEST

int main(void)
{
	const TTest *const tests[] = {rotation, rotated_arcs_and_cycles, tilted, additional_offsets, least_input,
				      haas_tool_centre};
	Suite *suite = suite_create("gcode_plane");
	TCase *tcase = tcase_create("gcode_plane");
	SRunner *runner;
	int failed;

	for (size_t i = 0; i < sizeof(tests) / sizeof(tests[0]); i++)
		tcase_add_test(tcase, tests[i]);
	tcase_add_loop_test(tcase, refused, 0, (int)(sizeof(bads) / sizeof(bads[0])));
	suite_add_tcase(suite, tcase);
	runner = srunner_create(suite);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
