/* The awkward positions of two triangles, by closed form and in every disguise; then random ones on an exact grid. */
#include "geom/tri.h"

#include <check.h>
#include <stdlib.h>

#include "exact_tri.h"

#define MISS 0x1p-30	/* 1e-9 and a half */

struct position {
	const char *name;
	tri a, b;
	double distance;
};

static const struct position positions[] = {
	{"coplanar, overlapping", {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}, {{{1, 1, 0}, {5, 1, 0}, {1, 5, 0}}}, 0},
	{"coplanar, one in the other", {{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}}},
	 {{{1, 1, 0}, {2, 1, 0}, {1, 2, 0}}}, 0},
	{"coplanar, apart", {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}, {{{0, -2, 0}, {4, -2, 0}, {2, -6, 0}}}, 2},
	{"coplanar, a miss", {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}},
	 {{{0, -MISS, 0}, {4, -MISS, 0}, {2, -6, 0}}}, MISS},
	{"parallel faces, a miss", {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}},
	 {{{1, 1, MISS}, {2, 1, MISS}, {1, 2, MISS}}}, MISS},
	{"the same triangle", {{{0, 1, 2}, {4, 0, 3}, {0, 4, 5}}}, {{{0, 1, 2}, {4, 0, 3}, {0, 4, 5}}}, 0},
	{"shared edge", {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}, {{{0, 0, 0}, {4, 0, 0}, {1, -3, 7}}}, 0},
	{"shared corner", {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}, {{{0, 0, 0}, {-4, -1, 1}, {-1, -4, 1}}}, 0},
	{"corner on face", {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}, {{{1, 1, 0}, {5, 2, 3}, {0, 2, 4}}}, 0},
	{"corner over face, a miss", {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}},
	 {{{1, 1, MISS}, {5, 2, 3}, {0, 2, 4}}}, MISS},
	{"corner on edge", {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}, {{{2, 0, 0}, {2, -3, 1}, {3, -3, -1}}}, 0},
	{"edges that cross", {{{-1, 0, 0}, {1, 0, 0}, {0, 0, -1}}}, {{{0, -1, 0}, {0, 1, 0}, {0, 0, 1}}}, 0},
	{"edges that miss", {{{-1, 0, 0}, {1, 0, 0}, {0, 0, -1}}},
	 {{{0, -1, MISS}, {0, 1, MISS}, {0, 0, 1}}}, MISS},
	{"parallel edges, a miss", {{{-1, 0, 0}, {1, 0, 0}, {0, 0, -1}}},
	 {{{-2, 0, MISS}, {2, 0, MISS}, {0, 1, 1}}}, MISS},
	{"parallel edges that lie on each other", {{{-1, 0, 0}, {1, 0, 0}, {0, 0, -1}}},
	 {{{-2, 0, 0}, {0, 0, 0}, {0, 1, 1}}}, 0},
	{"edges at 1e-8 rad that cross", {{{-1, 0, 0}, {1, 0, 0}, {0, 0, -1}}},
	 {{{-1, -1e-8, 0}, {1, 1e-8, 0}, {0, 0, 1}}}, 0},
	{"edges at 1e-8 rad that miss", {{{-1, 0, 0}, {1, 0, 0}, {0, 0, -1}}},
	 {{{-1, -1e-8, MISS}, {1, 1e-8, MISS}, {0, 0, 1}}}, MISS},
	{"slivers of 1e8 that cross", {{{-1e4, 0, 0}, {1e4, 0, 0}, {0, 2e-4, 0}}},
	 {{{0, 1e-4, -1e4}, {0, 1e-4, 1e4}, {1e-4, 1e-4, 0}}}, 0},
	{"slivers of 1e8 side by side", {{{-1e4, 0, 0}, {1e4, 0, 0}, {0, 1e-4, 0}}},
	 {{{-1e4, 0, 1}, {1e4, 0, 1}, {0, -1e-4, 1}}}, 1},
	{"a segment over a face", {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}, {{{1, 1, 1}, {1, 1, 3}, {1, 1, 2}}}, 1},
	{"a segment through a face", {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}, {{{1, 1, -1}, {1, 1, 3}, {1, 1, 2}}}, 0},
	{"a point on a face", {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}, {{{1, 1, 0}, {1, 1, 0}, {1, 1, 0}}}, 0},
	{"a point beside a face", {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}},
	 {{{1, -MISS, 0}, {1, -MISS, 0}, {1, -MISS, 0}}}, MISS},
	{"two points", {{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}}, {{{1, 2, 4}, {1, 2, 4}, {1, 2, 4}}}, 1},
	{"the same point", {{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}}, {{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}}, 0},
	{"collinear segments, apart", {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}}, {{{5, 0, 0}, {4, 0, 0}, {7, 0, 0}}}, 2},
	{"collinear segments, overlapping", {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}},
	 {{{5, 0, 0}, {1, 0, 0}, {7, 0, 0}}}, 0},
	{"minus zero", {{{-0.0, -0.0, -0.0}, {4, -0.0, 0}, {0, 4, -0.0}}}, {{{0, 0, 1}, {4, 0, 1}, {0, 4, 1}}}, 1},
	{"denormals, on a face", {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}},
	 {{{5e-324, 5e-324, 0}, {5, 2, 3}, {0, 2, 4}}}, 0},
	{"denormals, a point", {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}},
	 {{{1, 1, 1}, {1, 1 + 0x1p-52, 1}, {1, 1, 1}}}, 1},
};

/* One of the 48 symmetries of a cube: lengths stay as they are, to the last bit. */
static vec3 turned(vec3 p, int symmetry)
{
	static const int orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
	const double c[3] = {p.x, p.y, p.z};
	const int *order = orders[symmetry / 8];

	return (vec3){symmetry & 1 ? -c[order[0]] : c[order[0]], symmetry & 2 ? -c[order[1]] : c[order[1]],
		      symmetry & 4 ? -c[order[2]] : c[order[2]]};
}

/* Corners in another order, another symmetry, another size. */
static tri disguise(const tri *t, int rotation, bool mirrored, int symmetry, double scale)
{
	tri out;

	for (int k = 0; k < 3; k++)
		out.p[k] = vec3_scale(scale, turned(t->p[(rotation + (mirrored ? 3 - k : k)) % 3], symmetry));
	return out;
}

static void judge(const struct position *position, const tri *a, const tri *b, double distance)
{
	double size = tri_pair_size(a, b), found;
	vec3 on_a, on_b;

	found = tri_distance(a, b, &on_a, &on_b);
	if (fabs(found - distance) > TRI_DISTANCE_ERROR * size)
		ck_abort_msg("%s: %.17g, not %.17g", position->name, found, distance);
	if (fabs(vec3_norm(vec3_sub(on_b, on_a)) - found) > TRI_DISTANCE_ERROR * size)
		ck_abort_msg("%s: the points are not that far apart", position->name);
	/* What is farther apart than rounding can say must be called so; what meets, never. */
	if (distance <= 0 && !tri_meet(a, b))
		ck_abort_msg("%s: called apart", position->name);
	if (distance > 64 * DBL_EPSILON * size && tri_meet(a, b))
		ck_abort_msg("%s: called meeting at %g", position->name, distance);
}

START_TEST(every_position_in_every_disguise)
{
	static const double scales[] = {1, 0x1p-17, 0x1p-3, 0x1p20};

	for (size_t i = 0; i < sizeof(positions) / sizeof(positions[0]); i++) {
		const struct position *position = &positions[i];

		for (int k = 0; k < 6 * 6 * 48 * 4; k++) {
			double scale = scales[k % 4];
			int of_a = k / 4 % 6, of_b = k / 24 % 6, symmetry = k / 144;
			tri a = disguise(&position->a, of_a % 3, of_a > 2, symmetry, scale);
			tri b = disguise(&position->b, of_b % 3, of_b > 2, symmetry, scale);

			judge(position, &a, &b, scale * position->distance);
			judge(position, &b, &a, scale * position->distance);
		}
	}
}
END_TEST

/* Moved by 2^20: where the corners stay the same numbers, so does the distance. */
START_TEST(every_position_far_away)
{
	static const vec3 far = {0x1p20, -0x1p20, 0x1p20};
	int moved = 0;

	for (size_t i = 0; i < sizeof(positions) / sizeof(positions[0]); i++) {
		const tri *from[2] = {&positions[i].a, &positions[i].b};
		bool same = true;
		tri to[2];

		for (int k = 0; k < 6; k++) {
			vec3 p = from[k / 3]->p[k % 3], q = vec3_add(p, far);

			to[k / 3].p[k % 3] = q;
			same &= vec3_norm(vec3_sub(vec3_sub(q, far), p)) <= 0;
		}
		if (!same)
			continue;
		moved++;
		judge(&positions[i], &to[0], &to[1], positions[i].distance);
	}
	ck_assert_int_gt(moved, 20);
}
END_TEST

static tri real_tri(const itri *t)
{
	tri r;

	for (int k = 0; k < 3; k++)
		r.p[k] = (vec3){(double)t->p[k].x, (double)t->p[k].y, (double)t->p[k].z};
	return r;
}

/* No miss and no false alarm: the grid is fine enough for exact truth, and coarse enough for exact answers. */
START_TEST(random_pairs_on_an_exact_grid)
{
	static const int sizes[] = {2, 8, 100, 13000};
	const char *factor = getenv("FIVECHECK_CASES"), *shift = getenv("FIVECHECK_SEED");
	double wanted = factor ? strtod(factor, NULL) : 1;
	long cases = (long)(200000 * (wanted > 0 ? wanted : 1)), met = 0;
	uint64_t state = 0x2545f4914f6cdd1d + (shift ? strtoull(shift, NULL, 0) : 0);

	for (long turn = 0; turn < cases; turn++) {
		long double truth2;
		double truth, distance;
		itri a, b;
		tri p, q;
		vec3 x, y;

		random_pair((int)(turn % (2 * KINDS)), &state, sizes[turn / KINDS % 4], &a, &b);
		p = real_tri(&a);
		q = real_tri(&b);
		truth2 = true_distance2(&a, &b);
		truth = (double)sqrtl(truth2);
		met += truth2 <= 0;
		if (tri_meet(&p, &q) != (truth2 <= 0) || tri_meet(&q, &p) != (truth2 <= 0))
			ck_abort_msg("turn %ld: the truth is %d", turn, truth2 <= 0);
		distance = tri_distance(&p, &q, &x, &y);
		if (fabs(distance - truth) > TRI_DISTANCE_ERROR * tri_pair_size(&p, &q))
			ck_abort_msg("turn %ld: %.17g, not %.17g", turn, distance, truth);
	}
	ck_assert_int_gt(met, cases / 10);
	ck_assert_int_lt(met, cases * 2 / 3);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("stress_tri");
	TCase *tcase = tcase_create("core");
	SRunner *runner = srunner_create(suite);
	int failed;

	tcase_set_timeout(tcase, 0);
	tcase_add_test(tcase, every_position_in_every_disguise);
	tcase_add_test(tcase, every_position_far_away);
	tcase_add_test(tcase, random_pairs_on_an_exact_grid);
	suite_add_tcase(suite, tcase);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
