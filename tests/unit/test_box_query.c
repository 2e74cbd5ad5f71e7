/* test_box_query.c - two bodies' boxes at rest, against all triangles of one and the faces of the other's box. */
#include "scene/box_query.h"

#include "solids.h"
#include "suite.h"

/* The box around a body as a mesh of twelve triangles, at its pose. */
static struct mesh box_mesh(const struct bvh *bvh, const xform *pose)
{
	struct mesh mesh = {0};

	solid_box(&mesh, bvh->half);
	for (size_t t = 0; t < mesh.count; t++) {
		tri moved = tri_of(&mesh, t);
		mesh_triangle *out = &mesh.triangles[t];

		for (int k = 0; k < 3; k++) {
			const vec3 p = xform_apply(pose, vec3_add(moved.p[k], bvh->origin));

			out->v[k][0] = (float)p.x;
			out->v[k][1] = (float)p.y;
			out->v[k][2] = (float)p.z;
		}
	}
	return mesh;
}

/* mm: 0 if a corner of the surface is in the box, which needs its own coordinates: `back`. */
static double true_gap(const struct mesh *surface, const struct bvh *other, const xform *pose)
{
	const xform back = xform_inverse(pose);
	struct mesh box = box_mesh(other, pose);
	double least = INFINITY;

	for (size_t i = 0; i < surface->count; i++) {
		const tri t = tri_of(surface, i);
		const vec3 off = vec3_sub(xform_apply(&back, t.p[0]), other->origin);

		if (fabs(off.x) <= other->half.x && fabs(off.y) <= other->half.y && fabs(off.z) <= other->half.z)
			least = 0;
		for (size_t k = 0; k < box.count && least > 0; k++) {
			const tri face = tri_of(&box, k);

			least = fmin(least, true_distance(&t, &face));
		}
	}
	mesh_release(&box);
	return least;
}

/* A result "apart" is true; bodies whose gap is a good share of their size give this result. */
START_TEST(random_bodies)
{
	const long cases = random_cases(400);
	long parted[2] = {0, 0};

	for (long n = 0; n < cases; n++) {
		struct random random = random_case(1, n);
		struct mesh meshes[2] = {random_solid(&random, 20), random_solid(&random, 20)};
		struct bvh *bodies[2] = {bvh_new(&meshes[0]), bvh_new(&meshes[1])};
		const xform pose = random_place(&random, 60), back = xform_inverse(&pose);
		const xform *poses[2] = {&pose, &back};
		struct box_query query;

		box_query_init(&query, bodies[0], bodies[1], &pose);
		for (int side = 0; side < 2; side++) {
			const double gap = true_gap(&bodies[side]->mesh, bodies[1 - side], poses[side]);

			require(!box_query_parts_surface(&query, side) || gap > 0, "case %ld: the surface meets", n);
			require(!box_query_parts_boxes(&query) || gap > 0, "case %ld: the boxes meet", n);
			parted[0] += box_query_parts_surface(&query, side);
			parted[1] += box_query_parts_boxes(&query);
		}
		bvh_free(bodies[0]);
		bvh_free(bodies[1]);
	}
	require(parted[1] > cases / 10 && parted[0] >= parted[1], "%ld surfaces, %ld boxes", parted[0], parted[1]);
}
END_TEST

/* A ring around a small body: the boxes overlap, but the ring's surface is apart from the small body's box. */
START_TEST(within_a_ring)
{
	enum { N = 48 };
	struct mesh ring = {0}, block = {0};
	struct bvh *bodies[2];
	struct box_query query;
	const xform pose = xform_identity();

	for (int i = 0; i < N; i++) {
		const double a = 2 * PI * i / N, b = 2 * PI * (i + 1) / N;
		const vec3 p = {50 * cos(a), 50 * sin(a), -5}, q = {50 * cos(b), 50 * sin(b), -5}, up = {0, 0, 10};

		solid_quad(&ring, p, q, vec3_add(q, up), vec3_add(p, up));
	}
	solid_box(&block, (vec3){20, 20, 20});
	bodies[0] = bvh_new(&ring);
	bodies[1] = bvh_new(&block);
	box_query_init(&query, bodies[0], bodies[1], &pose);
	ck_assert(!box_query_parts_boxes(&query));
	ck_assert(box_query_parts_surface(&query, 0));
	ck_assert(!box_query_parts_surface(&query, 1));
	bvh_free(bodies[0]);
	bvh_free(bodies[1]);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("core");

	tcase_add_test(tcase, random_bodies);
	tcase_add_test(tcase, within_a_ring);
	return run_suite("box_query", tcase);
}
