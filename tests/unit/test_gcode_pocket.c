/* test_gcode_pocket.c - pocket milling of Haas (G150, G12, G13): random places of the pocket against the moves; faults. */
#include "gcode_refusal.h"

#define MOVES_MAX 4000

static const struct radius_offset radius = {1, 3};

static void init(struct gcode_case *c)
{
	case_init(c);
	c->config.dialect = &dialect_haas;
	c->config.controller.length_moves = ANSWER_NO;
	c->config.controller.comp_start = COMP_START_A;
	c->config.radii = &radius;
	c->config.radius_count = 1;
	c->show_spread = true;
}

/* The ends of the moves, with how far the tool may be beside them. */
struct way {
	double end[3], spread[3];
};

static size_t read_ways(const char *text, struct way *ways)
{
	size_t count = 0;

	for (const char *row = text; *row; row = strchr(row, '\n') + 1) {
		struct way *way = &ways[count++];
		const char *at = strchr(row, ' '), *spread = strstr(row, "spread "), *end = strchr(row, '\n');
		char *next = (char *)at;

		ck_assert_uint_lt(count, MOVES_MAX);
		*way = (struct way){.end = {0}};
		for (int i = 0; i < 3; i++)
			way->end[i] = strtod(next, &next);
		if (!spread || spread > end)
			continue;
		next = (char *)spread + strlen("spread ");
		for (int i = 0; i < 3; i++)
			way->spread[i] = strtod(next, &next);
	}
	return count;
}

/* Is the point beside a place of one of the ways? */
static bool is_covered(const struct way *ways, size_t count, const double point[3])
{
	for (size_t k = 1; k < count; k++) {
		double low = 0, high = 1;

		for (int i = 0; i < 3 && low <= high; i++) {
			const double from = ways[k - 1].end[i], way = ways[k].end[i] - from, beside = ways[k].spread[i] + 1e-6;
			const double a = (point[i] - beside - from) / way, b = (point[i] + beside - from) / way;

			if (fabs(way) < 1e-12) {
				high = fabs(point[i] - from) <= beside ? high : -1;
			} else {
				low = fmax(low, fmin(a, b));
				high = fmin(high, fmax(a, b));
			}
		}
		if (low <= high)
			return true;
	}
	return false;
}

/* The same numbers on every machine. */
static double between(uint32_t *state, double low, double high)
{
	*state = *state * 1664525 + 1013904223;
	return low + (high - low) * (*state >> 8) / (1 << 24);
}

/*
 * Haas mill operator's manual, "G150 General Purpose Pocket Milling". The outline reaches from X -30 to 20 (an arc) and
 * from Y -20 to 20, and the pocket from R 1 to Z -5; before, the tool stands at Z 4.
 */
static void expect_pocket(const char *program)
{
	static struct way ways[MOVES_MAX];
	uint32_t state = 15;
	struct gcode_case c;
	size_t count;

	init(&c);
	ck_assert_msg(case_run(&c, program), "%s", strbuf_text(&c.messages));
	count = read_ways(strbuf_text(&c.moves), ways);
	for (int i = 0; i < 3000; i++) {
		const double point[3] = {between(&state, -30, 20), between(&state, -20, 20), between(&state, -5, 4)};
		const double leaving[3] = {point[0] * 0.5, 15 + (point[1] - 15) * 0.5, point[2]};

		ck_assert(is_covered(ways, count, point));
		/* From anywhere to (0, 15), in a line: half of the way. */
		ck_assert(is_covered(ways, count, leaving));
	}
	for (size_t k = 0; k < count; k++) {
		ck_assert_double_ge(ways[k].end[0] - ways[k].spread[0], -25 * 2 - 1);
		ck_assert_double_ge(ways[k].end[2] - ways[k].spread[2], -5 - 0.7);
	}
	ck_assert_double_eq(ways[count - 1].end[2], 25);
	ck_assert_double_eq(ways[count - 1].spread[0] + ways[count - 1].spread[1], 0);
	case_release(&c);
}

/* The position is on a circle of the moves, or no farther beside it than the moves say. */
static bool is_on_circle(const char *moves, const double point[3])
{
	const double r = hypot(point[0] - 1, point[1] - 2);

	for (const char *row = strstr(moves, "arc "); row; row = strstr(row + 1, "arc ")) {
		const char *spread = strstr(row, "spread ");
		double end[3], beside[3];
		char *next = (char *)row + strlen("arc ");

		ck_assert_ptr_nonnull(spread);
		for (int i = 0; i < 3; i++)
			end[i] = strtod(next, &next);
		next = (char *)spread + strlen("spread ");
		for (int i = 0; i < 3; i++)
			beside[i] = strtod(next, &next);
		if (fabs(r - hypot(end[0] - 1, end[1] - 2)) <= beside[0] + 1e-6 &&
		    fabs(point[2] - end[2]) <= beside[2] + 1e-6)
			return true;
	}
	return false;
}

/*
 * Haas mill operator's manual, "G12 Circular Pocket Milling CW / G13 Circular Pocket Milling CCW": from where the tool
 * stands, (1, 2), up to the radius less its own, from Z 4 down to the depth.
 */
static void expect_circles(const char *block, double outer, double depth)
{
	struct strbuf program = {0};
	uint32_t state = 12;
	struct gcode_case c;

	init(&c);
	strbuf_addf(&program, "G0 X1. Y2. Z4. F99.\n%s\nM30\n", block);
	ck_assert_msg(case_run(&c, program.text), "%s", strbuf_text(&c.messages));
	for (int i = 0; i < 2000; i++) {
		const double r = between(&state, 0, outer), angle = between(&state, 0, 2 * PI);
		const double point[3] = {1 + r * cos(angle), 2 + r * sin(angle), between(&state, depth, 4)};
		const double outside[3] = {1 + (outer + 0.01) * cos(angle), 2 + (outer + 0.01) * sin(angle), point[2]};
		const double below[3] = {point[0], point[1], depth - 0.01};

		ck_assert(is_on_circle(strbuf_text(&c.moves), point));
		ck_assert(!is_on_circle(strbuf_text(&c.moves), outside));
		ck_assert(!is_on_circle(strbuf_text(&c.moves), below));
	}
	strbuf_release(&program);
	case_release(&c);
}

START_TEST(circles)
{
	expect_circles("G12 I10. Z-2. D1", 7, -2);
	expect_circles("G13 I5. K10. Q2. Z-2. D1", 7, -2);
	expect_circles("G13 I5. K10. Q2. Z-2.", 10, -2);
	expect_circles("G91 G13 I8. Z-2. L3 D1", 5, -2);
}
END_TEST

#define BEFORE "G0 X0. Y15. Z4. F99.\n"
#define AFTER "G40 G1 X0. Y15.\nG0 Z25.\nG0 Z25. X0.\nM30\n"
#define OUTLINE "G1 Y20.\nX-20.\nG3 X-30. Y10. R10.\nG1 Y-20.\nX20.\nY20.\nX0.\nM99\n"

START_TEST(covered)
{
	/* The outline is a block N of the program, or a program; without G41 the tool is on it or inside. */
	expect_pocket(BEFORE "G150 P1001 X0. Y15. Z-5. R1. Q2. J2. K.1 G41 D1 F300.\n" AFTER "N1001 " OUTLINE);
	expect_pocket(BEFORE "G150 P1001 Z-5. R1. Q2. I2. F300.\n" AFTER "O1001\n" OUTLINE);
	expect_pocket("G0 Z20.\n" BEFORE "G150 P7 Z-5. R1. Q2. I2. F300.\n" AFTER "O7\n" OUTLINE);
}
END_TEST

#define G150_BLOCK "G150 P7 Z-5. R1. Q2. J2. F300. "

static const struct bad {
	const char *block, *outline, *message;
} bads[] = {
    {"G150 Z-5. R1. Q2. J2.", OUTLINE, "G150 needs P (program of the outline)"},
    {"G150 P7 Z-5. R1. J2.", OUTLINE, "G150 needs P (program of the outline)"},
    {"G150 P7 Z-5. R1. Q2.", OUTLINE, "G150 needs either I or J"},
    {"G150 P7 Z-5. R1. Q2. J2. I2.", OUTLINE, "G150 needs either I or J"},
    {"G150 P7 Z-5. R1. Q-2. J2.", OUTLINE, "G150 needs Q and I or J greater than 0"},
    {"G150 P7 Z-5. R-6. Q2. J2.", OUTLINE, "G150 needs R above Z"},
    {G150_BLOCK "\nG0 Z20.\nG68 X0. Y0. R90.", OUTLINE, "before the coordinates change"},
    {"G91 " G150_BLOCK, OUTLINE, "G150 needs the plane of G17 and G90"},
    {"G18 " G150_BLOCK, OUTLINE, "G150 needs the plane of G17 and G90"},
    {"G68 X0 Y0 R9.\n" G150_BLOCK, OUTLINE, "G150 is not supported in changed coordinates"},
    {G150_BLOCK "L2", OUTLINE, "L of G150 is not supported"},
    {G150_BLOCK "G42 D1", OUTLINE, "G42 leads the tool along the outside of this G150 outline"},
    {G150_BLOCK, "G1 Y20.\nX-20.\nY0.\nX5.\nM99\n", "the outline of the G150 pocket is not closed"},
    {G150_BLOCK, "G1 Y20.\nG0 X-20.\nM99\n", "the outline of a G150 pocket must consist of moves of X and Y"},
    {G150_BLOCK, "G1 Y20. Z-3.\nM99\n", "the outline of a G150 pocket must consist of moves of X and Y"},
    {G150_BLOCK, "G1 Y20. M8\nM99\n", "the outline of a G150 pocket must consist of moves of X and Y"},
    {G150_BLOCK, "G1 Y20.\nM98 P8\nM99\n", "the outline of a G150 pocket must consist of moves of X and Y"},
    {G150_BLOCK, "G55 G1 Y20.\nM99\n", "G55 in the outline of a G150 pocket"},
    {G150_BLOCK "G41 D1\nX0.", OUTLINE, "the cutter compensation of G150 is still on; write G40 first"},
    {G150_BLOCK "\nG91 G28 Z0.", OUTLINE, "the position of the tool in the G150 pocket is not known"},
    {G150_BLOCK "\nG91 G0 Z5.", OUTLINE, "the position of the tool in the G150 pocket is not known"},
    {G150_BLOCK "\nT1 M6", OUTLINE, "the position of the tool in the G150 pocket is not known"},
    {G150_BLOCK "\n#1=#5002", OUTLINE, "the position of Y in the G150 pocket is not known"},
    {"G12 I10. Z-2. L2", OUTLINE, "L of G12 needs G91"},
    {"G13 Z-2.", OUTLINE, "G13 needs I or K (radius of the pocket)"},
    {"G13 I2. Z-2. D1", OUTLINE, "the tool is too large for the pocket"},
    {"G18 G13 I9. Z-2.", OUTLINE, "G13 needs the plane of G17"},
    {"G150 P8 Z-5. R1. Q2. J2. F300.", OUTLINE, "O8"},
};

START_TEST(refused)
{
	struct gcode_case c;

	init(&c);
	case_refuses(&c, bads[_i].message, BEFORE "%s\nM30\nN7 %s", bads[_i].block, bads[_i].outline);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("gcode_pocket");

	tcase_add_test(tcase, covered);
	tcase_add_test(tcase, circles);
	tcase_add_loop_test(tcase, refused, 0, COUNT(bads));
	return run_suite("gcode_pocket", tcase);
}
