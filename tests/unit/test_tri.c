/* test_tri.c - triangles against exact truth (exact_tri.h). */
#include "geom/tri.h"

#include <stdio.h>

#include "exact_tri.h"
#include "suite.h"

/* The distance of a computed point from an integer triangle, in long double. */
static long double point_off(vec3 p, const itri *t)
{
	ivec n = icross(iedge(t, 0), iedge(t, 1));
	long double nn = (long double)idot(n, n), best = HUGE_VALL, height = 0;
	bool inside = nn > 0;

	for (int k = 0; k < 3; k++) {
		ivec d = iedge(t, k), side = icross(n, d);
		long double rx = p.x - (long double)t->p[k].x, ry = p.y - (long double)t->p[k].y;
		long double rz = p.z - (long double)t->p[k].z;
		long double dx = (long double)d.x, dy = (long double)d.y, dz = (long double)d.z;
		long double dd = dx * dx + dy * dy + dz * dz, s = dd > 0 ? (rx * dx + ry * dy + rz * dz) / dd : 0, off;

		s = s < 0 ? 0 : s > 1 ? 1 : s;
		off = hypotl(hypotl(rx - s * dx, ry - s * dy), rz - s * dz);
		best = off < best ? off : best;
		inside &= (long double)side.x * rx + (long double)side.y * ry + (long double)side.z * rz >= 0;
		height = (long double)n.x * rx + (long double)n.y * ry + (long double)n.z * rz;
	}
	if (inside && fabsl(height) / sqrtl(nn) < best)
		best = fabsl(height) / sqrtl(nn);
	return best;
}

static tri real_tri(const itri *t, double scale, double shift)
{
	tri r;

	for (int k = 0; k < 3; k++) {
		vec3 p = {(double)t->p[k].x + shift, (double)t->p[k].y - shift, (double)t->p[k].z + shift};

		r.p[k] = vec3_scale(scale, p);
	}
	return r;
}

START_TEST(meet_is_exact_on_integers)
{
	static const int sizes[] = {8, 100, 10000};
	uint64_t state = 0x9e3779b97f4a7c15;
	int met = 0, cases = 300000;

	for (int turn = 0; turn < cases; turn++) {
		itri a, b;
		tri p, q;
		bool truth;

		random_pair(turn, &state, sizes[turn / KINDS % 3], &a, &b);
		p = real_tri(&a, 1, 0);
		q = real_tri(&b, 1, 0);
		truth = true_distance2(&a, &b) <= 0;
		met += truth;
		ck_assert_msg(tri_meet(&p, &q) == truth, "turn %d: the truth is %d", turn, truth);
	}
	ck_assert_int_gt(met, cases / 10);
	ck_assert_int_lt(met, cases / 2);
}
END_TEST

START_TEST(meet_never_calls_touching_triangles_apart)
{
	uint64_t state = 77;
	int met = 0;

	for (int turn = 0; turn < 100000; turn++) {
		itri a, b;
		tri p, q;

		random_pair(turn, &state, 1 << 17, &a, &b);
		p = real_tri(&a, 0x1p-17, 0);
		q = real_tri(&b, 0x1p-17, 0);
		if (true_distance2(&a, &b) > 0)
			continue;
		met++;
		ck_assert_msg(tri_meet(&p, &q), "turn %d", turn);
		/* Turned by an arbitrary angle, shared corners are still the same doubles. */
		for (int k = 0; k < 3; k++) {
			p.p[k] = (vec3){0.6 * p.p[k].x - 0.8 * p.p[k].y, 0.8 * p.p[k].x + 0.6 * p.p[k].y, p.p[k].z};
			q.p[k] = (vec3){0.6 * q.p[k].x - 0.8 * q.p[k].y, 0.8 * q.p[k].x + 0.6 * q.p[k].y, q.p[k].z};
		}
		if (turn % KINDS == SHARED_CORNER || turn % KINDS == SHARED_EDGE)
			ck_assert_msg(tri_meet(&p, &q), "turn %d, turned", turn);
	}
	ck_assert_int_gt(met, 10000);
}
END_TEST

START_TEST(distance_matches_exact_truth)
{
	static const int sizes[] = {8, 1000, 1 << 17};
	uint64_t state = 4711;
	double worst = 0, worst_point = 0, worst_pair = 0;

	for (int turn = 0; turn < 300000; turn++) {
		itri a, b;
		tri p, q;
		vec3 x, y;
		double truth, distance, unit, error, off;

		random_pair(turn, &state, sizes[turn / KINDS % 3], &a, &b);
		p = real_tri(&a, 1, 0);
		q = real_tri(&b, 1, 0);
		unit = TRI_DISTANCE_ERROR * tri_pair_size(&p, &q);
		truth = (double)sqrtl(true_distance2(&a, &b));
		distance = tri_distance(&p, &q, &x, &y);
		error = fabs(distance - truth);
		ck_assert_msg(error <= unit, "turn %d: %.17g, truth %.17g, %g of the error allowed", turn, distance,
			      truth, error / unit);
		ck_assert(truth > 0 || !(distance > 0));
		worst = fmax(worst, error / fmax(unit, DBL_MIN));
		off = (double)fmaxl(point_off(x, &a), point_off(y, &b));
		worst_point = fmax(worst_point, off / fmax(unit, DBL_MIN));
		worst_pair = fmax(worst_pair, fabs(vec3_norm(vec3_sub(y, x)) - distance) / fmax(unit, DBL_MIN));
	}
	printf("tri: largest error of a distance / bound %.4f\n", worst);
	/* The worst case that the header states, with some room for other compilers; and that it is of this order. */
	ck_assert_msg(worst <= 1 / 6.0 && worst > 1 / 30.0, "%g of the error allowed", worst);
	ck_assert_double_le(worst_point, 1);
	ck_assert_double_le(worst_pair, 1);
}
END_TEST

START_TEST(distance_scales_and_translates)
{
	static const double scales[] = {0x1p-17, 0x1p-3, 0x1p20};
	uint64_t state = 99;

	for (int turn = 0; turn < 50000; turn++) {
		itri a, b;
		tri p, q;
		vec3 x, y;
		double plain;

		random_pair(turn, &state, turn % 2 ? 1 << 17 : 50, &a, &b);
		p = real_tri(&a, 1, 0);
		q = real_tri(&b, 1, 0);
		plain = tri_distance(&p, &q, &x, &y);
		/* Powers of two and exact translations change not a single bit. */
		for (int k = 0; k < 3; k++) {
			p = real_tri(&a, scales[k], 0);
			q = real_tri(&b, scales[k], 0);
			ck_assert_double_eq(tri_distance(&p, &q, &x, &y), scales[k] * plain);
		}
		p = real_tri(&a, 1, 0x1p20);
		q = real_tri(&b, 1, 0x1p20);
		ck_assert_double_eq(tri_distance(&p, &q, &x, &y), plain);
	}
}
END_TEST

START_TEST(distance_survives_extremes)
{
	static const double scales[] = {0, 1e-300, 1e-100, 1e-70, 1e-45, 1e38, 1e69};
	uint64_t state = 5;

	for (int turn = 0; turn < 20000; turn++) {
		double scale = scales[turn % 7];
		itri a, b;
		tri p, q;
		vec3 x, y;
		double distance;

		random_pair(turn, &state, 7, &a, &b);
		p = real_tri(&a, scale / 16, 0);
		q = real_tri(&b, scale / 16, 0);
		distance = tri_distance(&p, &q, &x, &y);
		ck_assert(distance >= 0 && distance <= 4 * scale);
		ck_assert(isfinite(x.x + x.y + x.z + y.x + y.y + y.z));
	}
}
END_TEST

START_TEST(known_distances)
{
	tri flat = {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};
	tri above = {{{1, 1, 3}, {9, 1, 5}, {1, 9, 5}}};
	tri crossing = {{{1, 1, -1}, {1, 1, 1}, {9, 9, 0}}};
	tri beside = {{{4, 4, 0}, {8, 4, 0}, {4, 8, 0}}};
	vec3 x, y;

	ck_assert_double_eq(tri_distance(&flat, &above, &x, &y), 3);
	ck_assert_double_eq(x.z, 0);
	ck_assert_double_eq(y.z, 3);
	ck_assert_double_eq(tri_distance(&flat, &crossing, &x, &y), 0);
	ck_assert(tri_meet(&flat, &crossing));
	ck_assert_double_eq_tol(tri_distance(&flat, &beside, &x, &y), sqrt(8), 1e-15);
	ck_assert(!tri_meet(&flat, &beside));
}
END_TEST

START_TEST(axes_are_the_papers)
{
	tri flat = {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};
	tri skew = {{{1, 1, 3}, {9, 2, 5}, {1, 9, 6}}};
	tri coplanar = {{{5, 5, 0}, {9, 5, 0}, {5, 10, 0}}};
	tri parallel = {{{0, 0, 1}, {4, 0, 1}, {0, 4, 1}}};
	tri point = {{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}};
	vec3 axes[TRI_AXES_MAX];

	ck_assert_int_eq(tri_axes(&flat, &skew, axes), 11);
	ck_assert_int_eq(tri_axes(&flat, &coplanar, axes), 6);
	for (int k = 0; k < 6; k++)
		ck_assert_double_eq(axes[k].z, 0);
	/* Three of the nine pairs of edges are parallel. */
	ck_assert_int_eq(tri_axes(&flat, &parallel, axes), 8);
	ck_assert_int_eq(tri_axes(&flat, &point, axes), 1);
	ck_assert_int_eq(tri_axes(&point, &point, axes), 0);
	ck_assert(tri_meet(&point, &point));
}
END_TEST

START_TEST(gap_is_within_its_error)
{
	uint64_t state = 31;
	double worst = 0;

	for (int turn = 0; turn < 50000; turn++) {
		itri a, b;
		ivec n = random_ivec(&state, 1 << 29);
		vec3 axis = {(double)n.x, (double)n.y, (double)n.z};
		tri p, q;
		wide high = 0, low = 0;
		double off, allowed;

		random_pair(turn, &state, 1 << 28, &a, &b);
		p = real_tri(&a, 1, 0);
		q = real_tri(&b, 1, 0);
		for (int k = 0; k < 3; k++) {
			wide h = idot(n, a.p[k]), l = idot(n, b.p[k]);

			high = k == 0 || h > high ? h : high;
			low = k == 0 || l < low ? l : low;
		}
		off = (double)fabsl((long double)tri_gap(&p, &q, axis) - (long double)(low - high));
		allowed = tri_gap_error(tri_pair_size(&p, &q), axis);
		ck_assert_double_le(off, allowed);
		worst = fmax(worst, off / allowed);
	}
	printf("tri: largest error of a gap / bound %.4f\n", worst);
	ck_assert_double_gt(worst, 0.05);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("core");

	tcase_add_test(tcase, meet_is_exact_on_integers);
	tcase_add_test(tcase, meet_never_calls_touching_triangles_apart);
	tcase_add_test(tcase, distance_matches_exact_truth);
	tcase_add_test(tcase, distance_scales_and_translates);
	tcase_add_test(tcase, distance_survives_extremes);
	tcase_add_test(tcase, known_distances);
	tcase_add_test(tcase, axes_are_the_papers);
	tcase_add_test(tcase, gap_is_within_its_error);
	return run_suite("tri", tcase);
}
