#include "scene/profile.h"

#include "scene/convex.h"
#include "solids.h"
#include "suite.h"

/* A solid of few or many triangles, or triangles without order, anywhere in space. */
static struct bvh *random_tree(struct random *random)
{
	const double size = random_size(random, 1, 1e3);
	const xform place = random_place(random, 10 * size);
	struct mesh mesh = {0};

	switch (random_below(random, 8)) {
	case 0:
		solid_sphere(&mesh, size, 100 + random_below(random, 100), 50 + random_below(random, 50));
		break;
	case 1:
		solid_prism(&mesh, 100 + random_below(random, 100), size, size * random_size(random, 0.01, 3), 60);
		break;
	case 2:
		for (int i = 1 + random_below(random, 300); i > 0; i--)
			solid_add(&mesh, random_point(random, size), random_point(random, size),
				  random_point(random, size));
		break;
	default:
		mesh = random_solid(random, size);
	}
	solid_place(&mesh, &place);
	return bvh_new(&mesh);
}

/* The root, a branch or a leaf of the tree. */
static struct leaf random_part(struct random *random, const struct bvh *bvh)
{
	const uint32_t at = (uint32_t)random_below(random, (int)bvh->node_count);
	const struct bvh_node *node = &bvh->nodes[at];
	const int child = random_below(random, node->used);

	switch (random_below(random, 3)) {
	case 0:
		return (struct leaf){0, 0};
	case 1:
		return (struct leaf){at, 0};
	default:
		return (struct leaf){node->first[child], node->count[child]};
	}
}

/* The largest distance along m that the corners of the part reach when they turn about the axis. */
static double true_reach(const struct bvh *bvh, struct leaf part, const xform *place, vec3 location, vec3 axis, vec3 m)
{
	const struct bvh_node *node = part.count ? NULL : &bvh->nodes[part.first];
	const size_t first = node ? node->begin : part.first, count = node ? node->total : part.count;
	const double along = vec3_dot(m, axis), across = vec3_norm(vec3_mad(m, -along, axis));
	double most = -INFINITY;

	for (size_t i = 3 * first; i < 3 * (first + count); i++) {
		vec3 p = xform_apply(place, mesh_corner(&bvh->mesh.triangles[i / 3], (int)(i % 3)));
		vec3 to = vec3_sub(p, location);
		double u = vec3_dot(axis, to);

		most = fmax(most, along * u + across * vec3_norm(vec3_mad(to, -u, axis)));
	}
	return vec3_dot(m, location) + most;
}

/*
 * The bound may be too large by the length of a ring (its two ends and its width may come from different points), and,
 * for a box that is not opened, by twice its half diagonal along the axis and across it.
 */
START_TEST(the_rings_hold_the_part_however_it_is_turned)
{
	long coarse = 0;

	for (long n = 0; n < random_cases(600); n++) {
		struct random random = random_case(1, n);
		struct bvh *bvh = random_tree(&random);
		const double size = bvh->radius;
		const xform place = random_place(&random, size);
		const struct leaf part = random_part(&random, bvh);
		const vec3 axis = random_unit(&random), far = random_point(&random, 3 * size);
		const vec3 location = random_below(&random, 2) ? xform_apply(&place, vec3_add(bvh->origin, far))
							       : xform_apply(&place, bvh->origin);
		vec3 centre, half;
		struct profile profile;
		struct convex rings;
		long visits = 0;

		leaf_box(bvh, part, &centre, &half);
		profile_init(&profile, bvh, part, &place, location, axis, &visits);
		rings = convex_of_profile(&profile, location, axis);
		for (int i = 0; i < 20; i++) {
			const vec3 m = i ? random_unit(&random) : axis;
			double want = true_reach(bvh, part, &place, location, axis, m);
			double got = convex_support(&rings, m, 0, NULL, &visits);
			double rounding = 1e-12 * (size + vec3_norm(bvh->origin) + vec3_norm(location));

			require(got >= want - rounding && got <= want + 0.1 * vec3_norm(half) + rounding,
				"case %ld: the rings reach %.17g, the part %.17g", n, got, want);
			coarse += got > want + 0.01 * vec3_norm(half);
		}
		bvh_free(bvh);
	}
	ck_assert_int_gt(coarse, random_cases(600) / 6);
}
END_TEST

static long nodes_of_ball(int n)
{
	const xform place = xform_identity();
	struct mesh mesh = {0};
	struct profile profile;
	struct bvh *bvh;
	long visits = 0;

	solid_sphere(&mesh, 60, n, n / 2);
	bvh = bvh_new(&mesh);
	profile_init(&profile, bvh, (struct leaf){0, 0}, &place, (vec3){0, 0, 0}, (vec3){0, 0, 1}, &visits);
	bvh_free(bvh);
	return visits;
}

/* 60,000 and 240,000 triangles. */
START_TEST(what_is_looked_at_does_not_grow_with_the_triangles)
{
	const long few = nodes_of_ball(250), many = nodes_of_ball(500);

	require(many < few + few / 4, "%ld nodes, with four times the triangles %ld", few, many);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("profile");

	tcase_add_test(tcase, the_rings_hold_the_part_however_it_is_turned);
	tcase_add_test(tcase, what_is_looked_at_does_not_grow_with_the_triangles);
	return run_suite("profile", tcase);
}
