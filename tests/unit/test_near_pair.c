/*
 * test_near_pair.c - the triangle that is nearest to a point, and two triangles near each other, against all triangles.
 */
#include "scene/near_pair.h"

#include "geom/point_distance.h"
#include "geom/simd_level.h"
#include "scene/coherence.h"
#include "solids.h"
#include "suite.h"

static double to_triangle(const struct bvh *bvh, size_t i, vec3 point)
{
	tri t = tri_of(&bvh->mesh, i), at = {{point, point, point}};

	return true_distance(&t, &at);
}

START_TEST(nearest_to_a_point)
{
	const long cases = random_cases(300);
	long found = 0;

	for (long n = 0; n < cases; n++) {
		struct random random = random_case(1, n);
		struct mesh mesh = random_solid(&random, 20);
		struct bvh *bvh = bvh_new(&mesh);
		const vec3 point = random_place(&random, 60).translation;
		const double within = random_size(&random, 1, 200);
		struct nearest_triangle nearest = {.distance = -1};
		double least = INFINITY;
		long visits = 0;

		bvh->simd_level = (int)(n % (simd_level() + 1));
		for (size_t i = 0; i < bvh->mesh.count; i++)
			least = fmin(least, to_triangle(bvh, i, point));
		require(fabs(mesh_point_distance_above(bvh, point, 0.9 * least) - least) < 1e-9,
			"case %ld: not the nearest", n);
		require(mesh_point_distance_above(bvh, point, 1.5 * least) <= 1.5 * least + 1e-9,
			"case %ld: too far", n);
		if (mesh_nearest_triangle(bvh, point, within, 0, &nearest, &visits)) {
			struct nearest_triangle any;
			const double enough = random_size(&random, 1, 3) * least;

			found++;
			require(fabs(nearest.distance - least) < 1e-9, "case %ld: %.12g mm, not %.12g", n,
				nearest.distance, least);
			require(fabs(to_triangle(bvh, nearest.triangle, point) - least) < 1e-9,
				"case %ld: another triangle", n);
			require(fabs(vec3_norm(vec3_sub(nearest.at, point)) - least) < 1e-9 &&
					fabs(to_triangle(bvh, nearest.triangle, nearest.at)) < 1e-9,
				"case %ld: not the triangle's nearest point", n);
			require(mesh_nearest_triangle(bvh, point, within, enough, &any, &visits) &&
					any.distance <= fmax(enough, least) + 1e-9 &&
					fabs(to_triangle(bvh, any.triangle, point) - any.distance) < 1e-9,
				"case %ld: %.12g mm, %g are enough", n, any.distance, enough);
		} else {
			require(least > within - 1e-9, "case %ld: %g mm are within %g", n, least, within);
		}
		require(visits > 0, "case %ld: no visits", n);
		bvh_free(bvh);
	}
	require(found > cases / 10 && found < cases, "%ld found", found);
}
END_TEST

/* Above the middle of a triangle the nearest point is the foot of the perpendicular, for every rounding. */
START_TEST(nearest_above_a_triangle)
{
	const long cases = random_cases(2000);

	for (long n = 0; n < cases; n++) {
		struct random random = random_case(3, n);
		struct mesh mesh = random_solid(&random, 20);
		struct bvh *bvh = bvh_new(&mesh);
		const tri t = tri_of(&bvh->mesh, (size_t)random_below(&random, (int)bvh->mesh.count));
		const vec3 middle = vec3_scale(1.0 / 3, vec3_add(t.p[0], vec3_add(t.p[1], t.p[2])));
		const vec3 normal = vec3_cross(vec3_sub(t.p[1], t.p[0]), vec3_sub(t.p[2], t.p[0]));
		const vec3 point = vec3_mad(middle, random_size(&random, 0.001, 10), vec3_unit(normal));
		struct nearest_triangle nearest;
		long visits = 0;

		require(mesh_nearest_triangle(bvh, point, 100, 0, &nearest, &visits), "case %ld: none", n);
		require(fabs(vec3_norm(vec3_sub(nearest.at, point)) - nearest.distance) < 1e-9,
			"case %ld: a point %g mm away, not %g", n, vec3_norm(vec3_sub(nearest.at, point)),
			nearest.distance);
		bvh_free(bvh);
	}
}
END_TEST

/* A triangle whose corners are nearly or exactly on one line, so that its normal is only rounding. */
START_TEST(nearest_to_a_sliver)
{
	const long cases = random_cases(2000);

	for (long n = 0; n < cases; n++) {
		struct random random = random_case(4, n);
		const xform place = random_place(&random, 20);
		const double length = random_size(&random, 0.1, 100), along = random_in(&random, -0.5, 1.5) * length;
		const double width = n % 4 ? length * random_size(&random, 1e-9, 1e-2) : 0;
		const vec3 corners[3] = {{0, 0, 0}, {length, 0, 0}, {n % 5 ? along : 0, width, 0}};
		struct mesh mesh = {0};
		struct nearest_triangle nearest;
		struct bvh *bvh;
		double least;
		vec3 point;
		long visits = 0;

		solid_add(&mesh, xform_apply(&place, corners[0]), xform_apply(&place, corners[1]),
			  xform_apply(&place, corners[2]));
		bvh = bvh_new(&mesh);
		point = vec3_add(place.translation, random_place(&random, 100).translation);
		least = to_triangle(bvh, 0, point);
		require(mesh_nearest_triangle(bvh, point, 1e4, 0, &nearest, &visits), "case %ld: none", n);
		require(fabs(nearest.distance - least) < 1e-6 * (1 + length), "case %ld: %.12g mm, not %.12g", n,
			nearest.distance, least);
		require(nearest.distance > least - 1e-9, "case %ld: %.12g mm, but it is %.12g away", n,
			nearest.distance, least);
		require(fabs(vec3_norm(vec3_sub(nearest.at, point)) - nearest.distance) < 1e-9,
			"case %ld: another point", n);
		bvh_free(bvh);
	}
}
END_TEST

/* A body that stands still, and another one beside it that moves in x, y and z. */
static void duo_beside(struct duo *duo, struct random *random)
{
	const struct chain chain = {.count = 3, .joints = {{SLOT_X, false, {1, 0, 0}, {0, 0, 0}},
							   {SLOT_Y, false, {0, 1, 0}, {0, 0, 0}},
							   {SLOT_Z, false, {0, 0, 1}, {0, 0, 0}}}};
	struct mesh a = random_solid(random, 20), b = random_solid(random, 20);
	const xform place_a = random_place(random, 0), place_b = random_place(random, 0);

	duo_init(duo, &chain, &a, &b, &place_a, &place_b);
}

/*
 * The distance found is never less than that of the bodies, is that of the two triangles that are kept, and never
 * grows. How much more it may be than the true distance is not promised for a single case: the number of rounds is
 * limited, and for two solids that overlap, each point may be the nearest point of its surface to the other, although
 * the surfaces cross elsewhere. But all solids here are convex, so in nearly all cases nearly the nearest triangles are
 * found.
 */
START_TEST(near_each_other)
{
	const long cases = random_cases(300);
	long improved = 0, far = 0;

	for (long n = 0; n < cases; n++) {
		struct random random = random_case(2, n);
		struct coherence coherence = {0};
		struct duo duo;
		long visits = 0;

		duo_beside(&duo, &random);
		duo.pair.coherence = &coherence;
		for (int i = 0; i < 4; i++) {
			const axis_values q = {{random_in(&random, -60, 60), random_in(&random, -60, 60),
						random_in(&random, 20, 60)}};
			const xform pose = duo_pose(&duo, &q, &q, 0, NULL);
			const double truth = brute_distance(duo.a, duo.b, &pose, 1e9);
			const double before = near_pair_distance(&duo.pair, &pose);
			const double enough = i % 2 ? 1.5 * truth : 0;
			const double once = near_pair_improve_once(&duo.pair, &pose, enough, &visits);
			const double after = near_pair_improve(&duo.pair, &pose, enough, &visits);
			const double again = near_pair_distance(&duo.pair, &pose);

			require(once >= truth - 1e-9, "case %ld: %.12g mm, but they are %.12g apart", n, once, truth);
			require(once <= before + 1e-9 && after <= once + 1e-9, "case %ld: %g mm, then %g, then %g", n,
				before, once, after);
			require(after >= truth - 1e-9, "case %ld: %.12g mm, but they are %.12g apart", n, after, truth);
			require(again >= truth - 1e-9 && again <= after + 1e-9, "case %ld: forgotten", n);
			far += after > fmax(enough, 1.5 * truth + 1e-3);
			improved += after < 0.9 * before;
		}
		require(visits > 0, "case %ld: no visits", n);
		duo_release(&duo);
	}
	require(improved > cases / 2, "only %ld improved", improved);
	require(far <= 2 + cases / 50, "%ld of %ld are far from the nearest", far, 4 * cases);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("near_pair");

	tcase_add_test(tcase, nearest_to_a_point);
	tcase_add_test(tcase, nearest_above_a_triangle);
	tcase_add_test(tcase, nearest_to_a_sliver);
	tcase_add_test(tcase, near_each_other);
	return run_suite("near_pair", tcase);
}
