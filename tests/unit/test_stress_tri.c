/*
 * test_stress_tri.c - the awkward positions of two triangles, by closed form and in every disguise; then random ones on
 * an exact grid.
 */
#include "geom/tri.h"

#include <stdlib.h>

#include "exact_tri.h"
#include "stress_positions.h"
#include "suite.h"

static void judge(const struct position *position, const tri *a, const tri *b, double distance)
{
	double size = tri_pair_size(a, b), found;
	vec3 on_a, on_b;

	found = tri_distance(a, b, &on_a, &on_b);
	if (fabs(found - distance) > TRI_DISTANCE_ERROR * size)
		ck_abort_msg("%s: %.17g, not %.17g", position->name, found, distance);
	if (fabs(vec3_norm(vec3_sub(on_b, on_a)) - found) > TRI_DISTANCE_ERROR * size)
		ck_abort_msg("%s: the points are not that far apart", position->name);
	/* A distance that exceeds rounding must be reported, and a contact must never be called apart. */
	if (distance <= 0 && !tri_meet(a, b))
		ck_abort_msg("%s: called apart", position->name);
	if (distance > 64 * DBL_EPSILON * size && tri_meet(a, b))
		ck_abort_msg("%s: called meeting at %g", position->name, distance);
}

START_TEST(every_position_in_every_disguise)
{
	for (size_t i = 0; i < POSITIONS; i++) {
		for (int k = 0; k < DISGUISES; k++) {
			tri a, b;
			double distance = disguise_pair(&positions[i], k, &a, &b);

			judge(&positions[i], &a, &b, distance);
			judge(&positions[i], &b, &a, distance);
		}
	}
}
END_TEST

/* Moved by 2^20: if the corners are still exact, so is the distance. */
START_TEST(every_position_far_away)
{
	static const vec3 far = {0x1p20, -0x1p20, 0x1p20};
	int moved = 0;

	for (size_t i = 0; i < POSITIONS; i++) {
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

/*
 * No contact is missed and none is invented: the grid is fine enough for exact truth, and coarse enough for exact
 * answers.
 */
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
	TCase *tcase = tcase_create("core");

	tcase_add_test(tcase, every_position_in_every_disguise);
	tcase_add_test(tcase, every_position_far_away);
	tcase_add_test(tcase, random_pairs_on_an_exact_grid);
	return run_suite("stress_tri", tcase);
}
