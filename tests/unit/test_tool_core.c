/* test_tool_core.c - cores of tools against the erosion by a ball, which dense points decide. */
#include <math.h>
#include <stdbool.h>

#include "base/units.h"
#include "machine/tool_core.h"
#include "random.h"
#include "suite.h"

#define SECTIONS_MAX 5

/* The radius of the tool at height h; negative if there is none. Above its top the tool continues with `above`. */
static double tool_radius_at(const struct tool_solid *solid, double above, double h)
{
	double top = solid->top, bottom;

	if (h > top)
		return above;
	for (size_t i = 0; i < solid->count; i++, top = bottom) {
		const struct tool_section *s = &solid->sections[i];
		double r, up;

		bottom = top - s->length;
		if (h > top || h < bottom)
			continue;
		r = s->diameter_end / 2 + (h - bottom) / s->length * (s->diameter - s->diameter_end) / 2;
		up = h - bottom;
		if (i + 1 < solid->count || solid->tip == TIP_FLAT || up >= tool_solid_tip_height(solid))
			return r;
		if (solid->tip == TIP_CONE)
			return up * tan(solid->angle / 2);
		double c = solid->tip == TIP_BALL ? r : solid->corner;

		return r - c + sqrt(fmax(0, c * c - (c - up) * (c - up)));
	}
	return -1;
}

static double radius_at(const struct tool_solid *solid, double h)
{
	return tool_radius_at(solid, INFINITY, h);
}

/*
 * The least radius at h that the heights from low to high allow. Along one section it is convex, so the minimum is
 * found by ternary search.
 */
static double least_between(const struct tool_solid *solid, double above, double depth, double h, double low,
			    double high)
{
	double least = INFINITY;

	/* Just inside, because at a joint both radii count. */
	low += 1e-12 * (fabs(low) + 1);
	high -= 1e-12 * (fabs(high) + 1);
	for (int i = 0; i < 200 && low < high; i++) {
		double g[2] = {low + (high - low) / 3, high - (high - low) / 3}, r[2];

		for (int k = 0; k < 2; k++) {
			r[k] = tool_radius_at(solid, above, g[k]) -
			       sqrt(fmax(0, depth * depth - (h - g[k]) * (h - g[k])));
			least = fmin(least, r[k]);
		}
		if (r[0] < r[1])
			high = g[1];
		else
			low = g[0];
	}
	return least;
}

/* The radius of the erosion at h. Round tips are concave, too, so they are searched in short pieces. */
static double eroded(const struct tool_solid *solid, double above, double depth, double h)
{
	double least = INFINITY, top = solid->top, bottom;

	if (h + depth > top && above < INFINITY)
		least = least_between(solid, above, depth, h, top, h + depth);

	for (size_t i = 0; i < solid->count; i++, top = bottom) {
		bottom = top - solid->sections[i].length;
		for (int k = 0; k < 20; k++) {
			double high = fmin(h + depth, top - k * (top - bottom) / 20);
			double low = fmax(h - depth, top - (k + 1) * (top - bottom) / 20);

			if (low < high)
				least = fmin(least, least_between(solid, above, depth, h, low, high));
		}
	}
	return h - depth < top ? -1 : least;
}

/* The core contains the erosion, and exceeds its radius by at most `slack` mm. */
static void judge_below(const struct tool_solid *solid, double above, double depth, double slack)
{
	struct arena arena = {0};
	struct tool_solid core = tool_core(solid, depth, above, &arena);
	double length = 0;

	for (size_t i = 0; i < solid->count; i++)
		length += solid->sections[i].length;
	ck_assert_uint_gt(core.count, 0);
	for (int i = 0; i < 400; i++) {
		double h = solid->top - length * (i + 0.5) / 400;
		double exact = eroded(solid, above, depth, h), made = radius_at(&core, h);

		if (exact > 0)
			ck_assert_msg(made > exact - 1e-6, "at %g the core has %.9g, the erosion %.9g", h, made, exact);
		ck_assert_msg(made < fmax(exact, 0) + slack, "at %g the core has %.9g, the erosion %.9g", h, made, exact);
	}
	arena_release(&arena);
}

static void judge(const struct tool_solid *solid, double depth, double slack)
{
	judge_below(solid, INFINITY, depth, slack);
}

START_TEST(tips_are_exact)
{
	static const struct tool_section one = {40, 10, 10}, long_one = {60, 16, 16};
	static const struct tool_solid solids[] = {
		{&one, 1, 0, TIP_FLAT, 0, 0},
		{&one, 1, -90, TIP_BALL, 0, 0},
		{&long_one, 1, -20, TIP_BULL, 0, 3},
		{&long_one, 1, -20, TIP_BULL, 0, 0.05},
		{&long_one, 1, -20, TIP_BULL, 0, 8},
	};

	for (size_t i = 0; i < COUNT(solids); i++) {
		judge(&solids[i], 0.1, 0.012);
		judge(&solids[i], 0.02, 0.012);
	}
	/* Where cylinder and cone meet, the core continues the cylinder's offset a little too far down. */
	for (double angle = 20; angle < 179; angle += 39)
		judge(&(struct tool_solid){&long_one, 1, 0, TIP_CONE, radians(angle), 0}, 0.1, 0.2 / cos(radians(angle / 2)));
}
END_TEST

/* A ball of radius r about its centre becomes the ball of radius r - depth about the same centre. */
START_TEST(a_ball_stays_a_ball)
{
	static const struct tool_section section = {5, 10, 10};
	const struct tool_solid solid = {&section, 1, -125, TIP_BALL, 0, 0};
	struct arena arena = {0};
	struct tool_solid core = tool_core(&solid, tool_core_depth(&solid, 0.1), INFINITY, &arena);

	ck_assert_uint_eq(core.count, 1);
	ck_assert_double_eq_tol(core.sections[0].length, 4.9, 1e-12);
	ck_assert_double_eq_tol(core.sections[0].diameter, 9.8, 1e-12);
	ck_assert_int_eq(core.tip, TIP_BALL);
	arena_release(&arena);
}
END_TEST

/* The core of a point is a point, too: depth / sin(angle / 2) higher, and not a needle that is longer. */
START_TEST(a_point_stays_a_point)
{
	struct random random = random_case(7, _i);

	for (int i = 0; i < 50; i++) {
		const double half = radians(random_in(&random, 3, 85)), depth = random_in(&random, 0.02, 0.5);
		const double r = depth * random_in(&random, 2, 40), length = r / tan(half);
		const struct tool_section cone = {length + 1, 2 * r, 2 * r}, taper[] = {{1, 2 * r, 2 * r}, {length, 2 * r, 0}};
		const struct tool_solid points[] = {
			{.sections = &cone, .count = 1, .tip = TIP_CONE, .angle = 2 * half},
			{.sections = taper, .count = 2},
		};

		for (int k = 0; k < 2; k++) {
			struct arena arena = {0};
			struct tool_solid core = tool_core(&points[k], depth, INFINITY, &arena);
			const double end = tool_solid_bottom(&core) - tool_solid_bottom(&points[k]);

			ck_assert_double_eq_tol(end, depth / sin(half), TOOL_SECTION_MIN);
			arena_release(&arena);
		}
	}
}
END_TEST

START_TEST(no_depth_keeps_the_solid)
{
	static const struct tool_section section = {5, 10, 8};
	const struct tool_solid solid = {&section, 1, 0, TIP_FLAT, 0, 0};
	struct arena arena = {0};
	struct tool_solid core = tool_core(&solid, 0, INFINITY, &arena);

	ck_assert_ptr_eq(core.sections, &section);
	arena_release(&arena);
}
END_TEST

/* Thin and flat solids: the core is never empty, and it is inside. */
START_TEST(a_core_is_never_empty)
{
	static const struct tool_section thin = {5, 0.05, 0.05}, disc = {0.05, 80, 80}, plate = {0.02, 50, 0};
	const struct tool_section *const sections[] = {&thin, &disc, &plate};

	for (size_t i = 0; i < 3; i++) {
		const struct tool_solid solid = {sections[i], 1, 0, TIP_FLAT, 0, 0};
		struct arena arena = {0};
		struct tool_solid core = tool_core(&solid, tool_core_depth(&solid, 0.1), INFINITY, &arena);

		ck_assert_uint_gt(core.count, 0);
		for (double h = 0; h > -sections[i]->length; h -= sections[i]->length / 50)
			ck_assert_double_le(radius_at(&core, h), radius_at(&solid, h + TOOL_SECTION_MIN) + 1e-9);
		arena_release(&arena);
	}
}
END_TEST

/* The disc of a T-slot cutter below its neck: the upper face beside the neck is surface. */
START_TEST(the_end_beside_a_neck_is_surface)
{
	static const struct tool_section disc = {5, 16, 16}, ball = {8, 16, 16};
	const struct tool_solid slotter = {&disc, 1, -95, TIP_FLAT, 0, 0}, lollipop = {&ball, 1, -92, TIP_BALL, 0, 0};

	judge_below(&slotter, 3, 0.1, 0.11);
	judge_below(&slotter, 7.95, 0.1, 0.11);
	judge_below(&slotter, 8, 0.1, 0.012);
	judge_below(&slotter, 9, 0.1, 0.012);
	judge_below(&lollipop, 2, 0.1, INFINITY);
}
END_TEST

/* Whatever is thin has a core, and nothing else has a smaller depth than was asked for. */
START_TEST(the_depth_fits_the_thinnest_part)
{
	static const struct tool_section mill = {40, 10, 10}, drill = {5, 0.3, 0.3}, saw = {0.4, 60, 60};
	static const struct tool_section point[] = {{10, 3, 3}, {2, 0.4, 0.4}}, short_point[] = {{10, 3, 3}, {1.4, 0.4, 0.4}};
	static const struct tool_section disc[] = {{10, 8, 8}, {0.4, 60, 60}}, steps[] = {{0.1, 9.8, 10}, {0.1, 10, 9.8}};
	static const struct tool_section engraver = {8, 3, 0.1}, needle = {60, 3, 0};
	static const struct {
		const struct tool_section *sections;
		size_t count;
		double depth;
	} cases[] = {
		{&mill, 1, 0.25}, {&drill, 1, 0.125}, {&saw, 1, 0.125}, {point, 2, 0.125}, {short_point, 2, 0.25},
		{disc, 2, 0.125}, {steps, 2, 0.0625}, {&engraver, 1, 0.25}, {&needle, 1, 0.25},
	};

	for (size_t i = 0; i < COUNT(cases); i++) {
		const struct tool_solid solid = {cases[i].sections, cases[i].count, 0, TIP_FLAT, 0, 0};

		ck_assert_double_eq_tol(tool_core_depth(&solid, 0.25), cases[i].depth, 1e-12);
		ck_assert(!(tool_core_depth(&solid, 0) > 0));
	}
	/* A drill of 118 degrees whose section is all point. */
	ck_assert_double_eq_tol(tool_core_depth(&(struct tool_solid){&mill, 1, 0, TIP_CONE, radians(118), 0}, 0.25),
				0.25, 1e-12);
}
END_TEST

/* Random steps, grooves, tapers and undercuts: the core is never smaller than the erosion. */
START_TEST(random_profiles_are_enclosed)
{
	struct random random = random_case(71, _i);
	struct tool_section sections[SECTIONS_MAX];
	struct tool_solid solid = {sections, 1 + (size_t)random_below(&random, SECTIONS_MAX), 0, TIP_FLAT, 0, 0};

	for (size_t i = 0; i < solid.count; i++) {
		double length = random_size(&random, 0.02, 8), d = random_in(&random, 3, 23);
		double end = random_below(&random, 2) ? d : random_in(&random, 3, 23);

		sections[i] = (struct tool_section){length, d, end};
	}
	if (random_below(&random, 2)) {
		sections[solid.count - 1] = (struct tool_section){14, 11, 11};
		solid.tip = TIP_BALL;
	}
	judge(&solid, 0.1, INFINITY);
	judge_below(&solid, random_in(&random, 1, 12), 0.1, INFINITY);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("core");

	tcase_add_test(tcase, tips_are_exact);
	tcase_add_test(tcase, a_ball_stays_a_ball);
	tcase_add_loop_test(tcase, a_point_stays_a_point, 0, 20);
	tcase_add_test(tcase, no_depth_keeps_the_solid);
	tcase_add_test(tcase, a_core_is_never_empty);
	tcase_add_test(tcase, the_end_beside_a_neck_is_surface);
	tcase_add_test(tcase, the_depth_fits_the_thinnest_part);
	tcase_add_loop_test(tcase, random_profiles_are_enclosed, 0, 100);
	return run_suite("tool_core", tcase);
}
