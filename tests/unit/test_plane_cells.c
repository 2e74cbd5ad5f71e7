#include "check/certified/plane_cells.h"

#include "scene_of_two.h"
#include "suite.h"

enum { SAMPLES = 12 };

/* At every position of the motion, by the distances of all pairs of triangles. */
static void require_apart(struct scene_of_two *s, const struct plane_motion *motion, double needed, long n)
{
	for (int i = 0; i < SAMPLES; i++) {
		axis_values at = random_position(s, motion);
		xform pose = duo_pose(&s->duo, &at, &at, 0, NULL);
		double d = brute_distance(s->duo.a, s->duo.b, &pose, needed + 1);

		require(d > needed - 1e-12, "case %ld: %.15g proved, %.15g is", n, needed, d);
	}
}

/* What the planes of cells prove is true at every position. */
START_TEST(what_cells_cover_is_apart)
{
	long covered = 0, divided = 0, copies = 0, cases = random_cases(80);

	for (long n = 0; n < cases; n++) {
		struct scene_of_two s;
		struct plane_cells cells, copy;
		double needed;

		scene_init(&s, 2, n);
		needed = random_below(&s.random, 2) ? 1e-3 : random_size(&s.random, 1e-3, 5);
		plane_cells_init(&cells, &s.duo.pair);
		for (int m = 0; m < 12; m++) {
			struct plane_motion motion = random_motion(&s);
			axis_values q = random_position(&s, &motion);

			if (!plane_cells_cover(&cells, &motion, needed) &&
			    !plane_cells_search(&cells, &q, &motion, needed))
				continue;
			covered++;
			divided += cells.cell_count > 1;
			require_apart(&s, &motion, needed, n);
			plane_cells_copy(&copy, &cells);
			copies += plane_cells_cover(&copy, &motion, needed) ==
				  plane_cells_cover(&cells, &motion, needed);
			plane_cells_release(&copy);
		}
		plane_cells_release(&cells);
		duo_release(&s.duo);
	}
	require(copies == covered, "of %ld motions that were covered, copies cover %ld as well", covered, copies);
	/* Cells are divided in few cases: a tenth of the usual number of cases may have none. */
	require(covered > 2 * cases && (divided > 0 || cases < 80), "covered %ld, divided %ld", covered, divided);
}
END_TEST

/* Along a path a plane is measured again at both ends of a step; then the gaps at both ends also prove the step. */
START_TEST(what_the_ends_of_steps_prove_is_apart)
{
	long proved = 0, by_ends = 0, cases = random_cases(40);

	for (long n = 0; n < cases; n++) {
		struct scene_of_two s;
		struct plane_cells cells;

		scene_init(&s, 5, n);
		plane_cells_init(&cells, &s.duo.pair);
		for (int m = 0; m < 12; m++) {
			const xform pose = duo_pose(&s.duo, &s.at, &s.at, 0, NULL);
			const double needed = 0.99 * brute_distance(s.duo.a, s.duo.b, &pose, INFINITY);
			struct plane_motion motion = random_motion(&s);

			motion.straight = true;
			motion.q0 = s.at;
			for (int k = 0; k < SLOT_COUNT; k++)
				motion.q1.v[k] = 0.5 * s.at.v[k] + 0.5 * motion.q1.v[k];
			s.at = motion.q1;
			if (!(needed > 0) || !plane_cells_search(&cells, &motion.q1, &motion, needed))
				continue;
			proved++;
			by_ends += !plane_cells_cover(&cells, &motion, needed);
			require_apart(&s, &motion, needed, n);
		}
		plane_cells_release(&cells);
		duo_release(&s.duo);
	}
	require(proved > 2 * cases && (by_ends > cases / 16 || cases < 20), "proved %ld, by the ends %ld", proved, by_ends);
}
END_TEST

/* The distance (mm) that planes prove for the rest of the motion, with their own normals or other ones. */
static double carry(struct scene_of_two *s, struct plane_cells *cells, const struct plane_motion *motion, double needed)
{
	const vec3 along = random_unit(&s->random);

	if (random_below(&s->random, 2))
		return plane_cells_carry_parts(cells, &motion->q1, motion, needed);
	return plane_cells_carry_whole(cells, &motion->q1, motion, needed, random_below(&s->random, 4) ? NULL : &along);
}

/*
 * Along a path planes are carried from the end of one step to the next: no pair of triangles is nearer than the
 * distance that they leave.
 */
START_TEST(what_carried_planes_leave_is_apart)
{
	long proved = 0, lost = 0, cases = random_cases(80);

	for (long n = 0; n < cases; n++) {
		struct scene_of_two s;
		struct plane_cells cells;

		scene_init(&s, 6, n);
		plane_cells_init(&cells, &s.duo.pair);
		for (int m = 0; m < 12; m++) {
			struct plane_motion motion = random_motion(&s);
			double rest;

			motion.straight = true;
			motion.q0 = s.at;
			for (int k = 0; k < SLOT_COUNT; k++)
				motion.q1.v[k] = 0.8 * s.at.v[k] + 0.2 * motion.q1.v[k];
			s.at = motion.q1;
			rest = carry(&s, &cells, &motion, random_size(&s.random, 1e-3, 50));
			lost += !(rest > 0);
			proved += rest > 0;
			if (rest > 0)
				require_apart(&s, &motion, rest, n);
			else
				plane_cells_search(&cells, &motion.q1, &motion, random_size(&s.random, 1e-3, 5));
		}
		plane_cells_release(&cells);
		duo_release(&s.duo);
	}
	require(proved > cases && lost > cases, "proved %ld, lost %ld", proved, lost);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("cells");

	tcase_add_test(tcase, what_cells_cover_is_apart);
	tcase_add_test(tcase, what_the_ends_of_steps_prove_is_apart);
	tcase_add_test(tcase, what_carried_planes_leave_is_apart);
	return run_suite("plane_cells", tcase);
}
