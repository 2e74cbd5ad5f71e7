/*
 * test_stock_cells.c - the material that cutters remove, against the definition: single points inside the solid of
 * revolution, at many instants.
 */
#include <math.h>

#include "geom/topology.h"
#include "machine/tool_solid.h"
#include "random.h"
#include "solids.h"
#include "stock/cut_log.h"
#include "stock/passage.h"
#include "stock/stock_cells.h"
#include "suite.h"

static const struct tool_section flat[] = {{20, 10, 10}};
static const struct tool_section stepped[] = {{8, 4, 4}, {3, 9, 9}, {5, 9, 3}};

static const struct tool_solid solids[] = {
    {.sections = flat, .count = 1, .tip = TIP_FLAT},
    {.sections = flat, .count = 1, .tip = TIP_BALL},
    {.sections = flat, .count = 1, .tip = TIP_BULL, .corner = 2},
    {.sections = flat, .count = 1, .tip = TIP_CONE, .angle = 1.8},
    {.sections = stepped, .count = 3, .tip = TIP_FLAT},
};

enum { SOLIDS = COUNT(solids) };

/* The radius at a height, by the definition of the sections; negative above and below the solid. */
static double radius_at(const struct tool_solid *solid, double z)
{
	const double bottom = solid->count == 1 ? -20 : -16;

	if (z > 0 || z < bottom)
		return -1;
	if (solid->count == 3)
		return z > -8 ? 2 : z > -11 ? 4.5 : 4.5 - 3 * (-11 - z) / 5;
	switch (solid->tip) {
	case TIP_BALL:
		return z < -15 ? sqrt(fmax(25 - (z + 15) * (z + 15), 0)) : 5;
	case TIP_BULL:
		return z < -18 ? 3 + sqrt(fmax(4 - (z + 18) * (z + 18), 0)) : 5;
	case TIP_CONE:
		return fmin(5, (z + 20) * tan(0.9));
	case TIP_FLAT:
		break;
	}
	return 5;
}

START_TEST(distance_is_that_to_the_outline)
{
	const struct tool_solid *solid = &solids[_i];
	const double bottom = solid->count == 1 ? -20 : -16;
	struct revolved revolved;
	struct random random = random_case(1, _i);

	revolved_init(&revolved, solid);
	for (int n = 0; n < 300; n++) {
		const double r = random_in(&random, 0, 9), z = random_in(&random, bottom - 4, 4);
		const double here = radius_at(solid, z), distance = revolved_distance(&revolved, r, z);
		double nearest = INFINITY;

		/* The solid is represented by a disc of points at each of many heights. */
		for (int i = 0; i <= 4000; i++) {
			const double at = bottom * i / 4000, most = radius_at(solid, at);
			const double beside = here >= 0 && r <= here ? fabs(most - r) : fmax(r - most, 0);

			if (here >= 0 && r <= here && most > r)
				continue;
			nearest = fmin(nearest, sqrt(beside * beside + (at - z) * (at - z)));
		}
		if (here >= 0 && r <= here) {
			nearest = fmin(nearest, fmin(-z, z - bottom));
			/* The step of the last solid is horizontal. */
			if (solid->count == 3 && z < -8)
				nearest = fmin(nearest, hypot(fmax(2 - r, 0), z + 8));
			for (int i = 0; i <= 4000; i++) {
				const double at = bottom * i / 4000, most = radius_at(solid, at);

				nearest = fmin(nearest, sqrt((most - r) * (most - r) + (at - z) * (at - z)));
			}
		}
		ck_assert_double_le(fabs(fabs(distance) - nearest), 0.02);
		ck_assert(distance < 0 ? here >= r - 1e-9 : here <= r + 1e-9);
	}
	revolved_release(&revolved);
}
END_TEST

static struct cutter_place some_place(struct random *random)
{
	const vec3 up = vec3_add(random_point(random, 0.3), (vec3){0, 0, 1}), off = random_point(random, 8);

	return (struct cutter_place){vec3_add(off, (vec3){0, 0, 16}), vec3_unit(up)};
}

static bool is_inside(const struct tool_solid *solid, const struct cutter_place *place, vec3 point)
{
	const vec3 off = vec3_sub(point, place->origin);
	const double z = vec3_dot(off, place->up);

	return sqrt(fmax(vec3_norm2(off) - z * z, 0)) <= radius_at(solid, z) + 1e-9;
}

/* At the reported time each corner and many inner points of the cube are inside; and a cube deep inside is removed. */
START_TEST(removes_what_is_inside_at_one_time)
{
	const struct tool_solid *solid = &solids[_i];
	struct random random = random_case(2, _i);
	struct cutter cutter;
	int removed = 0;

	cutter_init(&cutter, solid);
	for (int n = 0; n < 2000; n++) {
		const struct cutter_place from = some_place(&random);
		struct cutter_way way = {from, some_place(&random)};
		struct cube cube = {.centre = random_point(&random, 8)};
		struct cutter_place at;
		double s;

		cube.half = random_in(&random, 0.02, 1);
		if (n % 2)
			way.to.up = way.from.up;
		s = cutter_removes(&cutter, &way, &cube, 0);
		if (isinf(s))
			continue;
		removed++;
		at = (struct cutter_place){vec3_lerp(way.from.origin, way.to.origin, s),
					   vec3_unit(vec3_lerp(way.from.up, way.to.up, s))};
		for (int i = 0; i < 64; i++) {
			const vec3 off = {(i % 4) / 1.5 - 1, (i / 4 % 4) / 1.5 - 1, (i / 16) / 1.5 - 1};

			ck_assert(is_inside(solid, &at, vec3_mad(cube.centre, cube.half, off)));
		}
	}
	ck_assert_int_gt(removed, 40);
	cutter_release(&cutter);
}
END_TEST

/* A cube across the seam of two pieces, on the axis of the cutter, is inside the cutter. */
START_TEST(removes_across_seams)
{
	const struct cutter_way way = {{{-30, 0, 20}, {0, 0, 1}}, {{30, 0, 20}, {0, 0, 1}}};
	const struct cube inside = {{0, 0, 20 - 8}, 0.2}, outside = {{0, 4, 20 - 8}, 0.2};
	struct cutter cutter;

	cutter_init(&cutter, &solids[4]);
	ck_assert_uint_gt(cutter.piece_count, 1);
	ck_assert_double_le(cutter_removes(&cutter, &way, &inside, 0), 0.5);
	ck_assert(isinf(cutter_removes(&cutter, &way, &outside, 0)));
	cutter_release(&cutter);
}
END_TEST

/* Logs some random paths, one after the other in time, all in different directions. */
static void log_ways(struct random *random, struct cut_log *log, struct cutter_way *ways, int count)
{
	for (int i = 0; i < count; i++) {
		ways[i] = (struct cutter_way){some_place(random), some_place(random)};
		cut_log_add(log, &(struct cut){.from = i, .to = i + 1, .way = ways[i], .error = 0.1});
	}
}

/* mm: the distance of the point from the cutter on its path up to the share `end`, by samples. */
static double least_distance(const struct cutter *cutter, const struct cutter_way *way, vec3 point, double end)
{
	double least = INFINITY;

	for (int i = 0; i <= 400; i++) {
		const double s = end * i / 400;
		const vec3 up = vec3_unit(vec3_lerp(way->from.up, way->to.up, s));
		const vec3 off = vec3_sub(point, vec3_lerp(way->from.origin, way->to.origin, s));
		const double z = vec3_dot(off, up);

		least = fmin(least, revolved_distance(&cutter->whole, sqrt(fmax(vec3_norm2(off) - z * z, 0)), z));
	}
	return least;
}

/* Material that no cutter has reached is certain: compared with the distance at many instants. */
START_TEST(reaches_what_a_cutter_has_touched)
{
	enum { WAYS = 40 };
	struct random random = random_case(5, _i);
	struct cutter_way ways[WAYS];
	struct cutter cutter;
	struct cut_log log;
	int clear = 0;

	cutter_init(&cutter, &solids[_i]);
	cut_log_init(&log, &cutter);
	log_ways(&random, &log, ways, WAYS);
	for (int n = 0; n < 400; n++) {
		const vec3 point = random_point(&random, 40);
		const double radius = random_in(&random, 0, 3), time = random_in(&random, 0, n % 2 ? 2 : WAYS);
		const bool reaches = cut_log_reaches(&log, point, radius, time);
		double least = INFINITY;

		for (int i = 0; i < WAYS && i < time; i++)
			least = fmin(least, least_distance(&cutter, &ways[i], point, fmin(time - i, 1)));
		if (least <= radius + 0.1)
			ck_assert(reaches);
		/* Two samples are at most some tenths of a millimetre apart. */
		if (least > radius + 0.1 + 0.5)
			ck_assert(!reaches);
		clear += !reaches;
	}
	ck_assert_int_gt(clear, 20);
	cut_log_release(&log);
	cutter_release(&cutter);
}
END_TEST

/* A region removes nothing, and from its time on everything in its box is uncertain. */
START_TEST(regions_are_doubt_alone)
{
	const struct cut_region region = {.from = 1, .to = 2, .low = {0, 0, 0}, .high = {10, 10, 10}};
	const struct cube cube = {{5, 5, 5}, 0.1};
	struct cutter cutter;
	struct cut_log log;
	uint64_t place = 0;

	cutter_init(&cutter, &solids[0]);
	cut_log_init(&log, &cutter);
	cut_log_add_region(&log, &region);
	ck_assert(isinf(cut_log_search(&log, &cube, &place, cut_log_end(&log, 3))));
	ck_assert(cut_log_reaches(&log, cube.centre, 0, 3));
	ck_assert(!cut_log_reaches(&log, cube.centre, 0, 1));
	ck_assert(!cut_log_reaches(&log, (vec3){5, 5, 11}, 0.5, 3));
	cut_log_release(&log);
	cutter_release(&cutter);
}
END_TEST

/*
 * The slot of a flat cutter has a known shape: none of its cells is there, and all cells beside it are, also if only a
 * few are kept.
 */
START_TEST(slot_is_exact_to_a_cell)
{
	struct mesh mesh = {0};
	struct topology topology;
	struct cutter cutter;
	struct cut_log log;
	struct stock_cells cells;
	struct bvh *bvh;
	struct blank blank;
	const struct tool_section ball[] = {{0.02, 0.02, 0.02}};
	const struct tool_solid probe = {.sections = ball, .count = 1, .tip = TIP_FLAT, .top = 0.01};
	struct revolved revolved;
	struct obstacle obstacle = {.revolved = &revolved};
	struct random random = random_case(3, 0);
	const struct cut cut = {.from = 0, .to = 1, .way = {{{-30, 0, 25}, {0, 0, 1}}, {{5, 0, 25}, {0, 0, 1}}}};
	const xform up = {mat3_identity(), {0, 0, 5}};
	const struct distance_query query = {.enough = 1e3, .share = 1};

	solid_box(&mesh, (vec3){20, 15, 5});
	solid_place(&mesh, &up);
	bvh = bvh_new(&mesh);
	topology_init(&topology, &bvh->mesh);
	cutter_init(&cutter, &solids[0]);
	cut_log_init(&log, &cutter);
	cut_log_add(&log, &cut);
	blank = (struct blank){bvh, &topology, 0, 0};
	stock_cells_init(&cells, &blank, &log, 0.05);
	ck_assert_uint_eq(cells.group_count, 1);
	if (_i)
		cells.most_groups = 20;
	revolved_init(&revolved, &probe);
	for (int n = 0; n < 3000; n++) {
		const vec3 off = random_point(&random, 1), p = {22 * off.x, 16 * off.y, 5 + 6 * off.z};
		const struct placed_obstacle placed = {&obstacle, {mat3_identity(), vec3_scale(-1, p)}};
		/*
		 * The distance from the stock: the blank without the slot, which has a round end at x = 5 and its floor
		 * at z = 5.
		 */
		const double past = p.x > 5 ? sqrt((p.x - 5) * (p.x - 5) + p.y * p.y) : fabs(p.y);
		const double out = fmax(fmax(fabs(p.x) - 20, fabs(p.y) - 15), fmax(-p.z, p.z - 10));
		const double clear = fmin(5 - past, p.z - 5);
		const double margin = 0.05 * sqrt(3) + 0.03;
		const double distance = stock_cells_distance(&cells, &placed, 2, &query);

		if (out < -0.02 && clear < -0.02)
			ck_assert_double_le(distance, 0);
		if (out > margin || clear > margin)
			ck_assert_double_gt(distance, 0);
		/* Before the cut the whole blank is there. */
		if (out < -0.02)
			ck_assert_double_le(stock_cells_distance(&cells, &placed, -1, &query), 0);
	}
	revolved_release(&revolved);
	if (_i)
		ck_assert_uint_lt(cells.group_capacity, 2000);
	stock_cells_release(&cells);
	cut_log_release(&log);
	cutter_release(&cutter);
	topology_release(&topology);
	bvh_free(bvh);
}
END_TEST

/* The passage of a piece on a straight path, for single points at many places of the path. */
START_TEST(passage_holds_all_places_of_the_way)
{
	const struct tool_solid *solid = &solids[_i];
	struct random random = random_case(4, _i);
	struct revolved revolved;
	const struct obstacle obstacle = {.revolved = &revolved};

	revolved_init(&revolved, solid);
	for (int n = 0; n < 400; n++) {
		const xform from = {mat3_turn((vec3){1, 0, 0}, random_in(&random, -1, 1)), {1, 2, 3}};
		const double length = random_in(&random, -20, 20);
		xform to = from;
		struct passage passage;
		vec3 point = random_point(&random, 20), local;
		double passed, nearest = INFINITY;
		xform back;

		to.translation = vec3_mad(from.translation, length, n % 2 ? from.rotation.z : from.rotation.x);
		if (!passage_init(&passage, &obstacle, &from, &to, 1e-9)) {
			/* Only the solid that is wider below its step cannot be followed along its axis. */
			ck_assert(n % 2 && solid->count == 3);
			continue;
		}
		back = xform_inverse(&passage.pose);
		local = xform_apply(&back, point);
		passed = obstacle_distance(&passage.obstacle, local);
		for (int i = 0; i <= 500; i++) {
			xform at = from;

			at.translation = vec3_lerp(from.translation, to.translation, i / 500.0);
			at = xform_inverse(&at);
			nearest = fmin(nearest, obstacle_distance(&obstacle, xform_apply(&at, point)));
		}
		ck_assert_double_le(passed, nearest + 1e-9);
		if (nearest > 0)
			ck_assert_double_ge(passed, nearest - 0.05);
		passage_release(&passage);
	}
	revolved_release(&revolved);
}
END_TEST

int main(void)
{
	TCase *cases = tcase_create("all");

	tcase_add_loop_test(cases, distance_is_that_to_the_outline, 0, SOLIDS);
	tcase_add_loop_test(cases, removes_what_is_inside_at_one_time, 0, SOLIDS);
	tcase_add_test(cases, removes_across_seams);
	tcase_add_loop_test(cases, reaches_what_a_cutter_has_touched, 0, SOLIDS);
	tcase_add_test(cases, regions_are_doubt_alone);
	tcase_add_loop_test(cases, slot_is_exact_to_a_cell, 0, 2);
	tcase_add_loop_test(cases, passage_holds_all_places_of_the_way, 0, SOLIDS);
	return run_suite("stock_cells", cases);
}
