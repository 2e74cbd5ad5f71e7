/* test_gcode_polar.c - polar coordinate interpolation (G12.1) against points of its plane; its faults. */
#include "gcode_refusal.h"

static const struct builder_macro around = {9810, 0, MACRO_AROUND, {5, 5, 5}, NULL};

static void init(struct gcode_case *c)
{
	case_init(c);
	c->config.controller.macros = &around;
	c->config.controller.macro_count = 1;
	c->config.dialect = &dialect_fanuc;
	c->config.controller.length_moves = ANSWER_NO;
	c->config.controller.polar_axis = SLOT_C;
	c->config.controller.comp_start = COMP_START_A;
	c->config.controller.comp_corner = COMP_CORNER_CIRCULAR;
}

/* A curve of the plane, by its part from 0 to 1. */
typedef void (*plane_curve)(double t, double *x, double *y);

static void line(double t, double *x, double *y)
{
	*x = 20 - 35 * t;
	*y = 10 * t;
}

/* Counter-clockwise about (10, 0) from (20, 0) to (10, 10). */
static void arc(double t, double *x, double *y)
{
	*x = 10 + 10 * cos(PI / 2 * t);
	*y = 10 * sin(PI / 2 * t);
}

/* The part of the curve at which its angle about the centre of the plane is this one. */
static double part_of(plane_curve curve, double angle)
{
	double low = 0, high = 1, x, y;

	for (int i = 0; i < 60; i++) {
		double middle = (low + high) / 2;

		curve(middle, &x, &y);
		if (atan2(y, x) < angle)
			low = middle;
		else
			high = middle;
	}
	return (low + high) / 2;
}

/* One piece, from X and C to X and C: no point of the curve is farther beside the axes than is said. */
static void expect_piece(plane_curve curve, const double from[2], const double to[2], double beside, double turn)
{
	const double first = part_of(curve, from[1]), last = part_of(curve, to[1]);

	for (int i = 0; i <= 20; i++) {
		const double s = i / 20.0;
		double x, y;

		curve(first + s * (last - first), &x, &y);
		ck_assert_double_le(fabs(hypot(x, y) - from[0] - s * (to[0] - from[0])), beside + 1e-7);
		ck_assert_double_le(fabs(atan2(y, x) - from[1] - s * (to[1] - from[1])), turn + 2e-6);
	}
}

static void expect_curve(const char *block, plane_curve curve, double end_x, double end_y)
{
	char text[256];
	struct gcode_case c;
	double at[2] = {20, 0}, to[2], y, z, a, beside[3], turns[3], seconds, time = 0;
	int pieces = 0;

	init(&c);
	c.show_spread = c.show_turn_spread = c.show_feed = true;
	snprintf(text, sizeof(text), "G0 X20. F60.\nG12.1\n%s\nG13.1\nG0 Z9.\nM30\n", block);
	ck_assert_msg(case_run(&c, text), "%s", strbuf_text(&c.messages));
	for (const char *row = strbuf_text(&c.moves); *row; row = strchr(row, '\n') + 1) {
		if (sscanf(row, "feed %lf %lf %lf %lf %lf in %lf s spread %lf %lf %lf turned by %lf %lf %lf", &to[0], &y, &z, &a,
			   &to[1], &seconds, &beside[0], &beside[1], &beside[2], &turns[0], &turns[1], &turns[2]) != 12)
			continue;
		to[1] = radians(to[1]);
		ck_assert_double_le(beside[0], 0.002 + 1e-9);
		expect_piece(curve, at, to, beside[0], radians(turns[2]));
		at[0] = to[0], at[1] = to[1];
		time += seconds;
		pieces++;
	}
	ck_assert_int_ge(pieces, 20);
	ck_assert_double_eq_tol(at[0], hypot(end_x, end_y), 1e-7);
	ck_assert_double_eq_tol(at[1], atan2(end_y, end_x), 1e-7);
	/* F60 is a millimetre a second along the curve. */
	ck_assert_double_eq_tol(time, curve == line ? hypot(35, 10) : 5 * PI, 1e-6);
	case_release(&c);
}

START_TEST(curves)
{
	expect_curve("G1 X-15. C10.", line, -15, 10);
	expect_curve("G91 G1 X-35. C10.\nG90", line, -15, 10);
	expect_curve("G3 X10. C10. I-10. J0.", arc, 10, 10);
	expect_curve("G3 X10. C10. R10.", arc, 10, 10);
}
END_TEST

/* A control that rounds corners leaves the path in the plane: at 10 mm from the centre 0.1 mm are 0.573 degrees. */
START_TEST(rounded)
{
	static const char beside[] = "turned by 0.0000 0.0000 ";
	struct gcode_case c;
	const char *row;
	double turn;

	init(&c);
	c.config.controller.path_tolerance = 0.1;
	c.show_turn_spread = true;
	ck_assert_msg(case_run(&c, "G0 X10. F60.\nG12.1\nG1 X10. C0.1\nG13.1\nM30\n"), "%s", strbuf_text(&c.messages));
	row = strstr(strstr(strbuf_text(&c.moves), "feed"), beside);
	ck_assert_ptr_nonnull(row);
	turn = strtod(row + strlen(beside), NULL);
	ck_assert_double_ge(turn, 0.573);
	ck_assert_double_le(turn, 0.58);
	case_release(&c);
	init(&c);
	c.config.controller.path_tolerance = 0.1;
	ck_assert(!case_run(&c, "G0 X10. F60.\nG12.1\nG1 X0.05\nG13.1\nM30\n"));
	ck_assert(strstr(strbuf_text(&c.messages), "passes so near to the centre of the rotary axis that the control"));
	case_release(&c);
}
END_TEST

/* The last line of the moves. */
static void expect_end(const char *program, const char *last)
{
	struct gcode_case c;
	char *end;

	init(&c);
	c.config.radii = &(const struct radius_offset){1, 5};
	c.config.radius_count = 1;
	ck_assert_msg(case_run(&c, program), "%s", strbuf_text(&c.messages));
	end = c.moves.text + strlen(c.moves.text) - 1;
	*end = '\0';
	ck_assert_str_eq(strrchr(c.moves.text, '\n') + 1, last);
	case_release(&c);
}

/*
 * Fanuc 15i operator's manual (B-63324EN), "Polar Coordinate Interpolation": the angle counts from where the rotary axis
 * stands; the other axes go on as ever; the example of the manual, with X as a radius.
 */
START_TEST(ends)
{
	expect_end("G0 X20. Y3. C30.\nG12.1\nG1 C20. Z5. F9.\nG13.1\nG0 Z7.\nM30\n", "rapid 28.2842712 3 7 0 75");
	expect_end("G0 X-20.\nG112\nG1 C20. F9.\nG113\nG0 Z7.\nM30\n", "rapid -28.2842712 0 7 0 -45");
	expect_end("G0 X60. C0.\nG12.1\nG42 D1 G1 X20. F100.\nC10.\nG3 X10. C20. R10.\nG1 X-20.\nC-10.\nG3 X-10. C-20. I10. J0.\n"
		   "G1 X20.\nC0.\nG40 X60.\nG13.1\nG0 Z50.\nM30\n",
		   "rapid 60 0 50 0 360");
	/* The plane from before is in force again: an arc of Z and X. */
	expect_end("G18 G0 X20.\nG12.1\nG1 X21. F9.\nG13.1\nG2 X23. R5.\nM30\n",
		   "arc 23 0 0 0 0 centre 22 0 4.89897949 normal 0 1 0 sweep -23.0739181");
}
END_TEST

static const struct bad {
	const char *block, *message;
} bads[] = {
    {"G0 C5.", "p.nc:3:1: error: G0 under polar coordinate interpolation (G12.1), which allows only feed moves"},
    {"M98 P9810", "p.nc:3:1: error: a rapid (perhaps of a builder's macro) under polar coordinate interpolation"},
    {"G81 Z-1. R1.", "G81 under polar coordinate interpolation (G12.1), which allows only feed moves"},
    {"G28 Z0.", "G28 under polar coordinate interpolation (G12.1); write G13.1 first"},
    {"G55", "G55 under polar coordinate interpolation (G12.1); write G13.1 first"},
    {"G18", "G18 under polar coordinate interpolation (G12.1); write G13.1 first"},
    {"G43 H1", "G43 under polar coordinate interpolation (G12.1); write G13.1 first"},
    {"G1 Y5.", "Y under polar coordinate interpolation (G12.1) is not supported: C is the second axis"},
    {"G1 X-20.", "moves to the centre of the rotary axis"},
    {"G12.1", "G12.1 inside another G12.1"},
    {"#1=#5001", "the position under polar coordinate interpolation cannot be read"},
    {"G13.1 X5.", "G12.1 and G13.1 with axis words"},
    {"G41 D1 G1 X30.\nG13.1",
     "a code that moves or shifts the machine's axes while cutter compensation is on; write G40 first"},
    {"G13.1\nG0 X0.\nG12.1", "G12.1 must start with X away from 0"},
};

START_TEST(refused)
{
	struct gcode_case c;

	init(&c);
	c.config.radii = &(const struct radius_offset){1, 5};
	c.config.radius_count = 1;
	case_refuses(&c, bads[_i].message, "F9. G0 X20.\nG12.1\n%s\nM30\n", bads[_i].block);
}
END_TEST

/* The machine file says which axes it takes and how compensation rounds corners. */
START_TEST(asked)
{
	static const char compensated[] = "G0 X20.\nG12.1\nG41 D1 G1 X30. F9.\nC20.\nX-20.\nG40 X-30.\nG13.1\nM30\n";
	struct gcode_case c;

	init(&c);
	c.config.controller.polar_axis = 0;
	ck_assert(!case_run(&c, "G0 X20.\nG12.1\nM30\n"));
	ck_assert(strstr(strbuf_text(&c.messages), "polar_axes=\"XC\""));
	case_release(&c);
	init(&c);
	c.config.controller.comp_corner = COMP_CORNER_UNKNOWN;
	c.config.controller.comp_start = COMP_START_UNKNOWN;
	c.config.radii = &(const struct radius_offset){1, 5};
	c.config.radius_count = 1;
	ck_assert(!case_run(&c, compensated));
	ck_assert(strstr(strbuf_text(&c.messages), "cutter_comp_start and cutter_comp_corner"));
	case_release(&c);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("gcode_polar");

	tcase_add_test(tcase, curves);
	tcase_add_test(tcase, rounded);
	tcase_add_test(tcase, ends);
	tcase_add_loop_test(tcase, refused, 0, COUNT(bads));
	tcase_add_test(tcase, asked);
	return run_suite("gcode_polar", tcase);
}
