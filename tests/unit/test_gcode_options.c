/*
 * test_gcode_options.c - what Fanuc's controls have as options: smoothing (G5.1 Q2 and Q3), the stored stroke check
 * (G22), more than 48 work offsets, work setting errors (G54.4), and programs with numbers of more than four digits.
 */
#include "gcode_case.h"

static void init(struct gcode_case *c)
{
	case_init(c);
	c->config.dialect = &dialect_fanuc;
}

static void expect_fault(struct gcode_case *c, const char *program, const char *message)
{
	ck_assert(!case_run(c, program));
	ck_assert_msg(strstr(strbuf_text(&c->messages), message), "%s", strbuf_text(&c->messages));
	case_release(c);
}

/* B-64484EN-2, "Smooth Interpolation" and "Nano Smoothing": the axis words name axes. */
START_TEST(smoothing)
{
	struct gcode_case c;

	init(&c);
	c.show_blend = true;
	c.config.controller.path_tolerance = 0.02;
	case_expect(&c, "G61 G0 X1.\nG5.1 Q3 X0 Y0 Z0 A0 C0\nG1 X2. F100\nX3.\nG5.1 Q0\nX4.\nM30\n",
		    "rapid 1 0 0 0 0 exact\nfeed 2 0 0 0 0 blend 0\nfeed 3 0 0 0 0 blend 0\nfeed 4 0 0 0 0 exact\n");
	init(&c);
	c.config.controller.path_tolerance = 0.02;
	case_expect(&c, "G0 X1.\nG5.1 Q2\nX2.\nM30\n", "rapid 1 0 0 0 0\nrapid 2 0 0 0 0\n");
	init(&c);
	expect_fault(&c, "G5.1 Q3 X0 Y0 Z0\nM30\n",
		     "G5.1 Q3 lets the control smooth the path: set path_tolerance=\"\" (largest deviation from the "
		     "programmed path) in the machine file's <controller>");
	init(&c);
	c.config.controller.path_tolerance = 0.02;
	expect_fault(&c, "G5.1 Q3 X1.\nM30\n",
		     "p.nc:1:9: error: X in G5.1 selects an axis to smooth; its value must be 0");
	init(&c);
	c.config.controller.path_tolerance = 0.02;
	expect_fault(&c, "G0 X1. G5.1 Q3\nM30\n", "G5.1 Q3 needs a block without motion");
	init(&c);
	expect_fault(&c, "G5.1 Q1 X0\nM30\n", "axis words in G5.1 Q1 are not supported; leave them out");
}
END_TEST

/* B-64484EN-2, "Stored Stroke Check": X, Y, Z and I, J, K are corners of the zone. */
START_TEST(stroke_check)
{
	struct gcode_case c;

	init(&c);
	case_expect(&c, "G0 X1.\nG22 X300. Y200. Z100. I-300. J-200. K-100.\nY2.\nG23\nX5.\nM30\n",
		    "rapid 1 0 0 0 0\nrapid 1 2 0 0 0\nrapid 5 2 0 0 0\n");
	init(&c);
	case_expect(&c, "G0 X1.\nG22\nX2.\nM30\n", "rapid 1 0 0 0 0\nrapid 2 0 0 0 0\n");
}
END_TEST

/* The option of 300 additional work offsets. */
START_TEST(many_work_offsets)
{
	static const struct work_offset offsets[] = {{.name = "G54.1 P60", .value.v = {7}}};
	struct gcode_case c;

	init(&c);
	c.config.has_setup = true;
	c.config.work_offsets = offsets;
	c.config.work_offset_count = COUNT(offsets);
	case_expect(&c, "G54.1 P60 G0 X1.\nG54 P60 X2.\nM30\n", "rapid 8 0 0 0 0\nrapid 9 0 0 0 0\n");
	init(&c);
	expect_fault(&c, "G54.1 P301 G0 X1.\nM30\n", "P301 must be a whole number from 1 to 300");
}
END_TEST

/* B-64484EN-2, "Workpiece Setting Error Compensation". */
START_TEST(setting_errors)
{
	static const struct work_offset offsets[] = {
	    {.name = "G54"}, {.name = "G54.4 P1"}, {.name = "G54.4 P2", .value.v = {0, 0, 1e-4}}};
	struct gcode_case c;

	init(&c);
	c.config.has_setup = true;
	c.config.work_offsets = offsets;
	c.config.work_offset_count = COUNT(offsets);
	case_expect(&c, "G54 G0 X1.\nG54.4 P1\nX2.\nG54.4 P0\nX3.\nM30\n",
		    "rapid 1 0 0 0 0\nrapid 2 0 0 0 0\nrapid 3 0 0 0 0\n");
	init(&c);
	c.config.work_offsets = offsets;
	c.config.work_offset_count = COUNT(offsets);
	expect_fault(&c, "G54.4 P2\nM30\n", "G54.4 P2: compensation of a work setting error other than 0 is not supported");
	init(&c);
	expect_fault(&c, "G54.4 P3\nM30\n",
		     "p.nc:1:1: error: G54.4 P3: the setup has no such work setting error; if the work offset already "
		     "contains the position of the workpiece, add <work_offset name=\"G54.4 P3\"/>, whose values are "
		     "0");
	init(&c);
	expect_fault(&c, "G54.4 P8\nM30\n", "P8 must be a whole number from 1 to 7");
	init(&c);
	expect_fault(&c, "G54.4\nM30\n", "G54.4 without P is not supported");
}
END_TEST

/* B-64484EN, "Subprogram (M98, M99)"; parameter 11304#3: program numbers of eight digits. */
START_TEST(long_program_numbers)
{
	static const char head[] = "G0 X0\nM98 P30002\nM30\n", two[] = "O2\nG91 X1.\nG90\nM99\n", whole[] = "O30002\nX9.\nM99\n";
	char program[200];
	struct gcode_case c;

	snprintf(program, sizeof(program), "%s%s", head, two);
	init(&c);
	case_expect(&c, program, "rapid 0 0 0 0 0\nrapid 1 0 0 0 0\nrapid 2 0 0 0 0\nrapid 3 0 0 0 0\n");
	snprintf(program, sizeof(program), "%s%s", head, whole);
	init(&c);
	case_expect(&c, program, "rapid 0 0 0 0 0\nrapid 9 0 0 0 0\n");
	snprintf(program, sizeof(program), "%s%s%s", head, two, whole);
	init(&c);
	expect_fault(&c, program,
		     "p.nc:2:5: error: P30002 is ambiguous: O30002 once or O2 3 times (both programs exist); write L1, "
		     "or P2 and L3");
	snprintf(program, sizeof(program), "G0 X0\nM98 P30002 L1\nM98 P2 L3\nM30\n%s%s", two, whole);
	init(&c);
	case_expect(&c, program, "rapid 0 0 0 0 0\nrapid 9 0 0 0 0\nrapid 10 0 0 0 0\nrapid 11 0 0 0 0\nrapid 12 0 0 0 0\n");
	init(&c);
	expect_fault(&c, "M98 P30000\nM30\n", "the program number (the last four digits of P) is 0");
}
END_TEST

int main(void)
{
	const TTest *const tests[] = {smoothing, stroke_check, many_work_offsets, setting_errors, long_program_numbers};

	return RUN_TESTS("gcode_options", tests);
}
