#include "scene/pose_clearance.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check/model.h"
#include "geom/moved_tri.h"
#include "machine_case.h"
#include "random.h"
#include "truth.h"

/* The distance of two bodies from all pairs of triangles, without a tree. */
static double brute_force(struct scene *scene, const struct scene_pair *pair, const axis_values *q)
{
	struct body_pair bodies;
	double least = INFINITY;
	xform pose;

	bodies = scene_pair_bodies(scene, pair);
	pose = body_pair_pose(&bodies, q);
	for (size_t i = 0; i < bodies.a->mesh.count; i++) {
		tri a = tri_of(&bodies.a->mesh, i);

		for (size_t j = 0; j < bodies.b->mesh.count; j++) {
			tri b = tri_of(&bodies.b->mesh, j);

			b = tri_transform(&b, &pose);
			least = fmin(least, true_distance(&a, &b));
		}
	}
	return least;
}

/* Writes a star-shaped solid around (0, 0, z), of about `radius` mm, with 64 triangles. */
static void write_star(const char *name, double z, double radius, struct random *random)
{
	enum { RINGS = 5, AROUND = 8 };
	vec3 points[RINGS + 1][AROUND];
	FILE *file = fopen(name, "w");

	for (int i = 0; i <= RINGS; i++) {
		for (int k = 0; k < AROUND; k++) {
			double r = i % RINGS ? radius * random_in(random, 0.6, 1.4) : radius;
			double polar = PI * i / RINGS, turn = 2 * PI * k / AROUND;

			/* Each pole is exactly one point. */
			points[i][k] = i % RINGS ? (vec3){r * sin(polar) * cos(turn), r * sin(polar) * sin(turn),
							  z + r * cos(polar)}
						 : (vec3){0, 0, i ? z - r : z + r};
		}
	}
	ck_assert_ptr_nonnull(file);
	fprintf(file, "solid star\n");
	for (int i = 0; i < RINGS; i++) {
		for (int k = 0; k < AROUND; k++) {
			int next = (k + 1) % AROUND;
			const vec3 faces[2][3] = {{points[i][k], points[i + 1][k], points[i + 1][next]},
						  {points[i][k], points[i + 1][next], points[i][next]}};

			for (int f = 0; f < 2; f++) {
				if (i == (f ? 0 : RINGS - 1))
					continue;
				fprintf(file, "facet normal 0 0 0\nouter loop\n");
				for (int c = 0; c < 3; c++)
					fprintf(file, "vertex %.9g %.9g %.9g\n", faces[f][c].x, faces[f][c].y,
						faces[f][c].z);
				fprintf(file, "endloop\nendfacet\n");
			}
		}
	}
	fprintf(file, "endsolid star\n");
	ck_assert_int_eq(fclose(file), 0);
}

static const char machine_text[] =
	"<machine version=\"1\"><base><body name=\"bed\" mesh=\"bed.stl\" location=\"0 0 -120\"/>\n"
	"<axis name=\"X\" type=\"linear\" direction=\"1 0 0\" limit_min=\"-80\" limit_max=\"80\" rate_max=\"1000\">\n"
	"<axis name=\"Z\" type=\"linear\" direction=\"0 0 1\" limit_min=\"-90\" limit_max=\"30\" rate_max=\"1000\">\n"
	"<body name=\"head\" mesh=\"head.stl\" rotation=\"10 20 30\"/></axis></axis>\n"
	"<axis name=\"A\" type=\"rotary\" direction=\"1 0 0\" location=\"0 0 -20\" rate_max=\"1000\">\n"
	"<axis name=\"C\" type=\"rotary\" direction=\"0 0 1\" location=\"0 0 0\" rate_max=\"1000\">\n"
	"<body name=\"table\" mesh=\"table.stl\" location=\"20 0 0\"/></axis></axis>\n"
	"</base></machine>\n";

static axis_values somewhere(struct random *random)
{
	axis_values q = {{0}};

	q.v[SLOT_X] = random_in(random, -80, 80);
	q.v[SLOT_Z] = random_in(random, -90, 30);
	q.v[SLOT_A] = random_in(random, -3, 3);
	q.v[SLOT_C] = random_in(random, -3, 3);
	return q;
}

static void check_pose(struct scene *scene, struct sweep *sweep, const axis_values *q, size_t seen[POSE_FAILED + 1])
{
	enum pose_state states[16];
	struct pose_clearance found;
	struct diag diag = {0};
	double nearest = INFINITY;

	ck_assert_uint_le(scene->pair_count, 16);
	pose_clearance_find(scene, sweep, q, 0, 0.001, &found, states, &diag);
	for (size_t i = 0; i < scene->pair_count; i++) {
		double distance;

		if (!pose_clearance_counts(scene, &scene->pairs[i], 0))
			continue;
		distance = brute_force(scene, &scene->pairs[i], q);
		seen[states[i]]++;
		/* No star is inside another one. */
		ck_assert_int_eq(states[i], distance <= 0.001 ? POSE_OVERLAP : POSE_CLEAR);
		if (states[i] == POSE_CLEAR)
			nearest = fmin(nearest, distance);
		if (states[i] == POSE_CLEAR && i == found.pair)
			ck_assert_double_eq_tol(vec3_norm(vec3_sub(found.on_a, found.on_b)), distance, 1e-6);
	}
	ck_assert(isinf(nearest) ? isinf(found.distance) : fabs(nearest - found.distance) < 1e-6);
	ck_assert_uint_eq(diag.errors, 0);
}

START_TEST(against_every_two_triangles)
{
	struct random random = random_case(14, _i);
	struct sweep sweep = {0};
	struct diag diag = {0};
	struct model *model;
	size_t seen[POSE_FAILED + 1] = {0};

	write_star("bed.stl", 0, 60, &random);
	write_star("head.stl", 80, 30, &random);
	write_star("table.stl", -20, 40, &random);
	write_text("m.xml", machine_text);
	model = model_load("m.xml", NULL, NULL, &diag);
	ck_assert(model && model_add_scene(model, 0, &diag));
	for (int i = 0; i < 12; i++) {
		axis_values q = somewhere(&random);

		check_pose(model->scene, &sweep, &q, seen);
	}
	ck_assert_uint_gt(seen[POSE_CLEAR], 0);
	ck_assert_uint_gt(seen[POSE_OVERLAP], 0);
	sweep_release(&sweep);
	model_free(model);
	unlink("bed.stl");
	unlink("head.stl");
	unlink("table.stl");
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("pose_clearance");

	tcase_add_loop_test(tcase, against_every_two_triangles, 0, 3);
	return run_in_folders("pose_clearance", tcase);
}
