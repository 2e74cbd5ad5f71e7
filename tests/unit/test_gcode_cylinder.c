/* test_gcode_cylinder.c - cylindrical interpolation (G7.1) against arcs of the developed surface; its faults. */
#include "gcode_refusal.h"

#include "base/same_double.h"

static void init(struct gcode_case *c)
{
	case_init(c);
	c->config.dialect = &dialect_fanuc;
	c->config.controller.length_moves = ANSWER_NO;
}

/*
 * Fanuc B-64484EN, "Cylindrical Interpolation": the angle is a way along the surface, radius times radians. Points of each
 * piece lie on the arc of the developed surface; the chord is as close as is said.
 */
static void expect_arc(const char *program, double radius, double cz, double cs, double r, double end_z, double end_c)
{
	struct gcode_case c;
	double z = 0, angle = 0;
	int moves = 0;
	bool good;

	init(&c);
	c.show_spread = true;
	good = case_run(&c, program);
	ck_assert_msg(good, "%s", strbuf_text(&c.messages));
	for (const char *line = strbuf_text(&c.moves); *line; line = strchr(line, '\n') + 1) {
		double x, y, a, z0 = z, s0 = radians(angle) * radius, middle[2], beside[3] = {0}, s;

		ck_assert_int_ge(sscanf(line, "feed %lf %lf %lf %lf %lf spread %lf %lf %lf", &x, &y, &z, &a, &angle, &beside[0],
					&beside[1], &beside[2]), 5);
		s = radians(angle) * radius;
		ck_assert_double_eq_tol(hypot(z - cz, s - cs), r, 1e-6);
		middle[0] = (z + z0) / 2 - cz, middle[1] = (s + s0) / 2 - cs;
		ck_assert(r - hypot(middle[0], middle[1]) <= beside[2] + 1e-7);
		ck_assert(beside[2] <= 0.002 + 1e-9);
		moves++;
	}
	ck_assert_int_ge(moves, 20);
	ck_assert_double_eq_tol(z, end_z, 1e-7);
	ck_assert_double_eq_tol(angle, end_c, 1e-7);
	case_release(&c);
}

START_TEST(arcs)
{
	const double turn = degrees(30.0 / 20);	/* 30 mm along a cylinder of radius 20 */
	char text[256];

	/* In Z-X of G18, C stands for X: G3 from (Z 0, C 0) to (Z 30, 30 mm) about (0, 30), counter-clockwise. */
	snprintf(text, sizeof(text), "G18 F99 G7.1 C20.\nG3 Z30. C%.9f R30.\nG7.1 C0\nM30\n", turn);
	expect_arc(text, 20, 0, 30, 30, 30, turn);
	/* Clockwise about (30, 0). */
	snprintf(text, sizeof(text), "G18 F99 G107 C20.\nG2 Z30. C%.9f R30.\nG107 C0\nM30\n", turn);
	expect_arc(text, 20, 30, 0, 30, 30, turn);
	/* In Y-Z of G19, C stands for Y: C comes first, so that the sense is the other one. */
	snprintf(text, sizeof(text), "G19 F99 G7.1 C20.\nG2 Z30. C%.9f R30.\nG7.1 C0\nM30\n", turn);
	expect_arc(text, 20, 0, 30, 30, 30, turn);
}
END_TEST

/* Lines are lines of the axes, and F counts along the surface. */
START_TEST(lines)
{
	struct gcode_case c;

	init(&c);
	c.show_feed = true;
	case_expect(&c, "F60. G7.1 C20.\nG1 C90.\nZ5. C45.\nG7.1 C0\nG0 C0.\nM30\n",
		    "feed 0 0 0 0 90 at 1 2.86478898\nfeed 0 0 5 0 45 at 1 2.86478898\nrapid 0 0 5 0 0\n");
}
END_TEST

/* A control that rounds corners leaves the path on the surface: 0.1 mm are 0.573 degrees about a radius of 10. */
START_TEST(rounded)
{
	static const char beside[] = "turned by 0.0000 0.0000 ";
	struct gcode_case c;
	const char *row;

	init(&c);
	c.config.controller.path_tolerance = 0.1;
	c.show_turn_spread = true;
	ck_assert_msg(case_run(&c, "F60. G7.1 C10.\nG1 C90.\nG7.1 C0\nG1 C0.\nM30\n"), "%s", strbuf_text(&c.messages));
	row = strstr(strbuf_text(&c.moves), beside);
	ck_assert_ptr_nonnull(row);
	ck_assert_double_eq_tol(strtod(row + strlen(beside), NULL), degrees(0.1 / 10), 1e-4);
	row = strstr(row + 1, beside);
	ck_assert_ptr_nonnull(row);
	ck_assert(same_double(strtod(row + strlen(beside), NULL), 0));
	case_release(&c);
}
END_TEST

static const struct bad {
	const char *block, *message;
} bads[] = {
    {"G0 C5.", "p.nc:2:1: error: G0 under cylindrical interpolation (G7.1), which allows only feed moves"},
    {"G81 Z-1. R1.", "G81 under cylindrical interpolation (G7.1), which allows only feed moves"},
    {"G28 Z0.", "G28 under cylindrical interpolation (G7.1); cancel G7.1 first"},
    {"G41 D1", "G41 under cylindrical interpolation (G7.1) is not supported"},
    {"G55", "G55 under cylindrical interpolation (G7.1) is not supported"},
    {"G18 G2 Z5. C5. K1.", "needs C, one linear axis of its plane and a radius (R)"},
    {"G18 G2 Z5. R5.", "needs C, one linear axis of its plane and a radius (R)"},
    {"G18 G2 Z5. C5. R1.", "the radius is too small to reach the end of the arc on the surface"},
    {"G7.1 C30.", "G7.1 inside another G7.1; cancel the first one before"},
    {"G7.1 X0.", "G7.1 needs one rotary axis, with the radius of the cylinder, or 0 to cancel"},
};

START_TEST(refused)
{
	struct gcode_case c;

	init(&c);
	case_refuses(&c, bads[_i].message, "F9. G7.1 C20.\n%s\nM30\n", bads[_i].block);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("gcode_cylinder");

	tcase_add_test(tcase, arcs);
	tcase_add_test(tcase, lines);
	tcase_add_test(tcase, rounded);
	tcase_add_loop_test(tcase, refused, 0, COUNT(bads));
	return run_suite("gcode_cylinder", tcase);
}
