/*
 * test_cell_part.c - the part of a cell near an obstacle, and whether a cut removes it, against the definitions: random
 * points of the cell, and the cutter at many instants.
 */
#include <math.h>

#include "machine/tool_solid.h"
#include "random.h"
#include "stock/cut_log.h"
#include "stock/obstacle.h"
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

enum { SOLIDS = COUNT(solids), POINTS = 40 };

static vec3 some_half(struct random *random)
{
	return (vec3){random_in(random, 0.01, 2), random_in(random, 0.01, 2), random_in(random, 0.01, 2)};
}

static vec3 point_in(struct random *random, vec3 centre, vec3 half)
{
	const vec3 off = {random_in(random, -half.x, half.x), random_in(random, -half.y, half.y),
			  random_in(random, -half.z, half.z)};

	return vec3_add(centre, off);
}

static vec3 some_unit(struct random *random)
{
	return vec3_unit(vec3_add(random_point(random, 1), (vec3){0, 0, 1e-3}));
}

/* No point of the box in the half-space lies beyond the part's points in any direction; and those are such points. */
START_TEST(part_is_what_the_half_space_leaves)
{
	struct random random = random_case(1, _i);
	int cut = 0;

	for (int n = 0; n < 300; n++) {
		const vec3 centre = random_point(&random, 10), half = some_half(&random);
		const struct half_space space = {some_unit(&random), random_in(&random, -2, 2)};
		struct cell_part part;

		cell_part_init(&part, centre, half, &space);
		cut += part.count && part.count != 8;
		for (int i = 0; i < part.count; i++) {
			const vec3 off = vec3_sub(part.points[i], centre);

			require(vec3_dot(space.normal, off) <= space.offset + 1e-9, "beyond the plane");
			require(fabs(off.x) <= half.x + 1e-9 && fabs(off.y) <= half.y + 1e-9 &&
				fabs(off.z) <= half.z + 1e-9, "beyond the box");
		}
		for (int k = 0; k < POINTS; k++) {
			const vec3 point = point_in(&random, centre, half), along = some_unit(&random);
			double most = -INFINITY;

			if (vec3_dot(space.normal, vec3_sub(point, centre)) > space.offset)
				continue;
			for (int i = 0; i < part.count; i++)
				most = fmax(most, vec3_dot(along, part.points[i]));
			require(vec3_dot(along, point) <= most + 1e-9, "the part does not hold a point");
		}
	}
	ck_assert_int_gt(cut, 50);
}
END_TEST

/* Each point of a box that is near the obstacle is in a half-space. Those that are far are mostly in none. */
START_TEST(half_spaces_hold_what_is_near)
{
	struct random random = random_case(2, _i);
	struct revolved revolved;
	int near = 0, left_out = 0;

	revolved_init(&revolved, &solids[_i]);
	for (int n = 0; n < 2000; n++) {
		const struct obstacle obstacle = {
			.revolved = &revolved, .way_x = n % 3 ? 0 : 3, .way_y = n % 3 ? 0 : -1,
			.inset = n % 5 ? 0 : 0.25,
		};
		const xform to = {mat3_turn(some_unit(&random), random_in(&random, -1, 1)), {0, 0, -10}};
		const vec3 centre = random_point(&random, 9), half = some_half(&random);
		const double within = random_in(&random, 0, 0.3);
		struct half_space spaces[OBSTACLE_HALF_SPACES];
		const int count = obstacle_half_spaces(&obstacle, &to, centre, half, within, spaces);

		/* The core of a solid that is not convex. */
		ck_assert(count >= 0 || (obstacle.inset > 0 && solids[_i].count == 3));
		for (int k = 0; k < POINTS && count >= 0; k++) {
			const vec3 point = point_in(&random, centre, half);
			bool held = false;

			for (int i = 0; i < count; i++)
				held = held || vec3_dot(spaces[i].normal, vec3_sub(point, centre)) <= spaces[i].offset;
			if (obstacle_distance(&obstacle, xform_apply(&to, point)) <= within) {
				require(held, "a near point is left out");
				near++;
			}
			left_out += !held;
		}
	}
	ck_assert_int_gt(near, 500);
	ck_assert_int_gt(left_out, 500);
	revolved_release(&revolved);
}
END_TEST

static struct cutter_place some_place(struct random *random, bool upright)
{
	const vec3 tilt = random_point(random, upright ? 0 : 0.3);

	return (struct cutter_place){vec3_add(random_point(random, 8), (vec3){0, 0, 16}),
				     vec3_unit(vec3_add(tilt, (vec3){0, 0, 1}))};
}

/* How deep the point is in the cutter at some instant of its way up to the share `end`. */
static double deepest(const struct cutter *cutter, const struct cutter_way *way, vec3 point, double end)
{
	double least = INFINITY;

	for (int i = 0; i <= 200; i++) {
		const struct cutter_place place = cutter_place_between(&way->from, &way->to, end * i / 200);
		const vec3 off = vec3_sub(point, place.origin);
		const double z = vec3_dot(off, place.up);

		least = fmin(least, revolved_distance(&cutter->whole, sqrt(fmax(vec3_norm2(off) - z * z, 0)), z));
	}
	return least;
}

/* What is told to be removed by then is inside the cutter at an instant before; the place to look first tells nothing. */
START_TEST(removed_parts_were_in_the_cutter)
{
	enum { WAYS = 60 };
	struct random random = random_case(3, _i);
	struct cutter_way ways[WAYS];
	struct cutter cutter;
	struct cut_log log;
	int removed = 0;

	cutter_init(&cutter, &solids[_i]);
	cut_log_init(&log, &cutter);
	for (int i = 0; i < WAYS; i++) {
		ways[i] = (struct cutter_way){some_place(&random, i % 2), some_place(&random, i % 2)};
		cut_log_add(&log, &(struct cut){.from = i, .to = i + 1, .way = ways[i], .error = 0.05});
	}
	for (int n = 0; n < 400; n++) {
		const vec3 centre = random_point(&random, 9), half = vec3_scale(0.3, some_half(&random));
		const struct half_space space = {some_unit(&random), random_in(&random, -0.3, 0.3)};
		const double time = random_in(&random, 0, WAYS);
		const uint64_t end = cut_log_end(&log, time);
		size_t chunk = 0, other = 3;
		struct cell_part part;
		bool answer;

		cell_part_init(&part, centre, half, &space);
		if (!part.count)
			continue;
		answer = cut_log_removes_part(&log, &part, time, end, &chunk);
		ck_assert(cut_log_removes_part(&log, &part, time, end, &other) == answer);
		if (!answer)
			continue;
		removed++;
		for (int k = 0; k < part.count; k++) {
			const vec3 point = vec3_lerp(part.points[k], part.middle, random_in(&random, 0, 1));
			double least = INFINITY;

			for (int i = 0; i < WAYS && i < time; i++)
				least = fmin(least, deepest(&cutter, &ways[i], point, fmin(time - i, 1)));
			/* A sample is less than 0.1 mm from the next one. */
			require(least <= 0.05, "a point was never in the cutter: %g mm", least);
		}
	}
	ck_assert_int_gt(removed, 20);
	cut_log_release(&log);
	cutter_release(&cutter);
}
END_TEST

int main(void)
{
	TCase *cases = tcase_create("all");

	tcase_add_loop_test(cases, part_is_what_the_half_space_leaves, 0, 4);
	tcase_add_loop_test(cases, half_spaces_hold_what_is_near, 0, SOLIDS);
	tcase_add_loop_test(cases, removed_parts_were_in_the_cutter, 0, SOLIDS);
	return run_suite("cell_part", cases);
}
