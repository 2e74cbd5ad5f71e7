/* test_gcode_pocket.c - pocket milling of Haas (G150): random places of the pocket against the moves; its faults. */
#include "gcode_case.h"

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
    {"G150 Z-5. R1. Q2. J2.", OUTLINE, "G150 needs P, Q, R and Z"},
    {"G150 P7 Z-5. R1. J2.", OUTLINE, "G150 needs P, Q, R and Z"},
    {"G150 P7 Z-5. R1. Q2.", OUTLINE, "G150 needs I or J"},
    {"G150 P7 Z-5. R1. Q2. J2. I2.", OUTLINE, "G150 needs I or J"},
    {"G150 P7 Z-5. R1. Q-2. J2.", OUTLINE, "G150 needs a Q"},
    {"G150 P7 Z-5. R-6. Q2. J2.", OUTLINE, "G150 needs an R above Z"},
    {"G91 " G150_BLOCK, OUTLINE, "G150 needs the plane of G17 and G90"},
    {"G18 " G150_BLOCK, OUTLINE, "G150 needs the plane of G17 and G90"},
    {"G68 X0 Y0 R9.\n" G150_BLOCK, OUTLINE, "G150 in changed coordinates"},
    {G150_BLOCK "L2", OUTLINE, "L of G150 is not supported"},
    {G150_BLOCK "G42 D1", OUTLINE, "G42 leads the tool round the outside of this outline"},
    {G150_BLOCK, "G1 Y20.\nX-20.\nY0.\nX5.\nM99\n", "the outline of the pocket of G150 is not closed"},
    {G150_BLOCK, "G1 Y20.\nG0 X-20.\nM99\n", "the outline of a pocket of G150 is made of moves of X and Y"},
    {G150_BLOCK, "G1 Y20. Z-3.\nM99\n", "the outline of a pocket of G150 is made of moves of X and Y"},
    {G150_BLOCK, "G1 Y20. M8\nM99\n", "the outline of a pocket of G150 is made of moves of X and Y"},
    {G150_BLOCK, "G1 Y20.\nM98 P8\nM99\n", "the outline of a pocket of G150 is made of moves of X and Y"},
    {G150_BLOCK, "G55 G1 Y20.\nM99\n", "G55 in the outline of a pocket of G150"},
    {G150_BLOCK "G41 D1\nX0.", OUTLINE, "the cutter compensation of G150 is still on: G40 first"},
    {G150_BLOCK "\nG91 G28 Z0.", OUTLINE, "where the tool stands in the pocket of G150 is not known"},
    {G150_BLOCK "\nG91 G0 Z5.", OUTLINE, "where the tool stands in the pocket of G150 is not known"},
    {G150_BLOCK "\nT1 M6", OUTLINE, "where the tool stands in the pocket of G150 is not known"},
    {G150_BLOCK "\n#1=#5002", OUTLINE, "where Y stands in the pocket of G150 is not known"},
    {"G150 P8 Z-5. R1. Q2. J2. F300.", OUTLINE, "O8"},
};

START_TEST(refused)
{
	struct strbuf program = {0};
	struct gcode_case c;

	init(&c);
	strbuf_addf(&program, BEFORE "%s\nM30\nN7 %s", bads[_i].block, bads[_i].outline);
	ck_assert_msg(!case_run(&c, program.text), "accepted: %s", bads[_i].block);
	ck_assert_msg(strstr(strbuf_text(&c.messages), bads[_i].message), "%s", strbuf_text(&c.messages));
	strbuf_release(&program);
	case_release(&c);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("gcode_pocket");
	TCase *tcase = tcase_create("gcode_pocket");
	SRunner *runner;
	int failed;

	tcase_add_test(tcase, covered);
	tcase_add_loop_test(tcase, refused, 0, (int)(sizeof(bads) / sizeof(bads[0])));
	suite_add_tcase(suite, tcase);
	runner = srunner_create(suite);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
