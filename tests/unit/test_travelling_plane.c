#include "check/certified/travelling_plane.h"

#include "base/same_double.h"
#include "scene_of_two.h"
#include "suite.h"

enum { SAMPLES = 12 };

/* The least n.p over the corners of the mesh at the pose. */
static real least_along(const struct bvh *bvh, const xform *place, const struct turned *pose, real3 n)
{
	real least = INFINITY;

	for (size_t i = 0; i < bvh->mesh.count; i++) {
		for (int k = 0; k < 3; k++) {
			vec3 corner = mesh_corner(&bvh->mesh.triangles[i], k);
			real3 p = real3_of(place->translation);

			p = real3_add(p, real3_scale(corner.x, real3_of(place->rotation.x)));
			p = real3_add(p, real3_scale(corner.y, real3_of(place->rotation.y)));
			p = real3_add(p, real3_scale(corner.z, real3_of(place->rotation.z)));
			least = fminl(least, real3_dot(n, turned_apply(pose, p)));
		}
	}
	return least;
}

/* mm: the gap at q along the normal, which travels with the link; n is the normal at `at`. */
static double true_gap(const struct scene_of_two *s, size_t link, vec3 n, const axis_values *q)
{
	const struct duo *duo = &s->duo;
	struct turned still = turned_identity(), pose = true_pose(&duo->chain, q, q, 0, NULL), then, now, back;
	struct chain inner = duo->chain;
	real3 normal;

	inner.count = link;
	then = true_pose(&inner, &s->at, &s->at, 0, NULL);
	now = true_pose(&inner, q, q, 0, NULL);
	back = (struct turned){then.w, real3_scale(-1, then.v), {0, 0, 0}};
	normal = turned_direction(&now, turned_direction(&back, real3_of(n)));
	return (double)(least_along(duo->b, &duo->pair.place_b, &pose, normal) +
			least_along(duo->a, &duo->pair.place_a, &still, real3_scale(-1, normal)));
}

/* A plane with a random normal and link, for the bodies as they are or for all that their joints can make of them. */
struct made {
	struct travelling_plane plane;
	vec3 n;
	struct corner_runs *corners[2];
	struct mesh_part parts[2];
	struct profile profiles[2];
	bool rings[2];
};

/* Body A or B at the pose, in the form that the plane uses. */
static struct convex shape_at(const struct made *made, const struct plane_pose *pose, int body)
{
	const size_t joint = body ? pose->bodies->chain->count - 1 : 0;

	return made->rings[body] ? convex_of_profile(&made->profiles[body], pose->location[joint],
						     pose->direction[joint])
				 : convex_of_mesh(&made->parts[body], &pose->places[body], NULL);
}

static struct made make_plane(struct scene_of_two *s)
{
	const struct chain *chain = &s->duo.chain;
	const struct body_pair *pair = &s->duo.pair;
	const struct bvh *bvhs[2] = {pair->a, pair->b};
	struct random *random = &s->random;
	size_t link = (size_t)random_below(random, (int)chain->count + 1), next[2] = {0, chain->count - 1};
	struct made made = {.n = random_unit(random)};
	const struct leaf root = {0, 0};
	struct plane_pose pose;
	struct convex a, b;
	double gap;
	long visits = 0;

	plane_pose_init(&pose, pair, &s->at);
	for (int body = 0; body < 2; body++) {
		const struct joint *joint = &chain->joints[next[body]];

		made.corners[body] = corner_runs_new(bvhs[body]);
		made.parts[body] = mesh_part_of(bvhs[body], made.corners[body], root);
		made.rings[body] = (body ? link < chain->count : link > 0) && joint->rotary && random_below(random, 2);
		if (made.rings[body])
			profile_init(&made.profiles[body], bvhs[body], root, body ? &pair->place_b : &pair->place_a,
				     joint->location, joint->direction, &visits);
	}
	if (random_below(random, 3) == 0)
		made.n = pose.direction[random_below(random, (int)chain->count)];
	a = shape_at(&made, &pose, 0);
	b = shape_at(&made, &pose, 1);
	gap = travelling_plane_gap(&pose, &a, &b, made.n, 0, &visits);
	travelling_plane_init(&made.plane, &pose, &a, &b, made.n, link, gap, &visits);
	return made;
}

static void release_plane(struct made *made)
{
	corner_runs_free(made->corners[0]);
	corner_runs_free(made->corners[1]);
}

/* The bound may be wrong by the rounding of long double, and by no more. */
START_TEST(the_gap_is_never_smaller_than_the_bound)
{
	double tightest = 0;
	long rings = 0;

	for (long n = 0; n < random_cases(1500); n++) {
		struct scene_of_two s;
		struct made made;

		scene_init(&s, 1, n);
		made = make_plane(&s);
		rings += made.rings[0] || made.rings[1];
		for (int m = 0; m < 3; m++) {
			struct plane_motion motion = random_motion(&s);
			double rest = travelling_plane_rest(&made.plane, &s.duo.chain, &motion, -INFINITY);
			double start = true_gap(&s, made.plane.link, made.n, &s.at), most = 0;
			double beyond = rest + random_in(&s.random, -1, 1);
			double asked = travelling_plane_rest(&made.plane, &s.duo.chain, &motion, beyond);

			require(same_double(asked, rest) || (rest <= beyond && isinf(asked) && asked < 0),
				"case %ld: %.15g, beyond %.15g %.15g", n, rest, beyond, asked);
			for (int i = 0; i < SAMPLES; i++) {
				axis_values q = random_position(&s, &motion);
				double gap = true_gap(&s, made.plane.link, made.n, &q);

				require(gap >= rest - 1e-12, "case %ld: gap %.15g, bound %.15g", n, gap, rest);
				most = fmax(most, start - gap);
			}
			if (!made.rings[0] && !made.rings[1] && start - rest > 1e-2)
				tightest = fmax(tightest, most / (start - rest));
		}
		release_plane(&made);
		duo_release(&s.duo);
	}
	require(tightest > 0.99, "slack: %g", tightest);
	require(rings > random_cases(1500) / 10, "rings were used in %ld cases only", rings);
}
END_TEST

/* The gap at q along the normal that has travelled there, minus its rounding. */
static double gap_left_at(const struct scene_of_two *s, const struct made *made, const axis_values *q)
{
	struct plane_pose pose;
	struct convex a, b;
	long visits = 0;

	plane_pose_init(&pose, &s->duo.pair, q);
	a = shape_at(made, &pose, 0);
	b = shape_at(made, &pose, 1);
	return travelling_plane_gap(&pose, &a, &b, travelling_plane_normal(&made->plane, &pose), 0, &visits) -
	       pose.rounding;
}

/* Moves the motion away from the position where the plane was measured. */
static void carry_off(struct scene_of_two *s, struct plane_motion *motion)
{
	const double step = random_size(&s->random, 1e-3, 100);

	for (size_t i = 0; i < s->duo.chain.count; i++) {
		const struct joint *joint = &s->duo.chain.joints[i];
		const double off = step * (joint->rotary ? 0.01 : 1) * random_in(&s->random, -1, 1);

		motion->q0.v[joint->slot] += off;
		motion->q1.v[joint->slot] += off;
	}
}

/* Straight motions that begin near the position where the plane was measured, or far from it. */
START_TEST(the_gap_between_two_ends_is_never_smaller_than_the_bound)
{
	double tightest = 0;
	long bulging = 0;

	for (long n = 0; n < random_cases(1500); n++) {
		struct scene_of_two s;
		struct made made;

		scene_init(&s, 4, n);
		made = make_plane(&s);
		for (int m = 0; m < 3; m++) {
			struct plane_motion motion = random_motion(&s);
			double gap0, gap1, bound, least = INFINITY, ends;

			motion.straight = true;
			if (random_below(&s.random, 2))
				carry_off(&s, &motion);
			gap0 = gap_left_at(&s, &made, &motion.q0);
			gap1 = gap_left_at(&s, &made, &motion.q1);
			bound = travelling_plane_between(&made.plane, &s.duo.chain, &motion, gap0, gap1);
			ends = fmin(gap0, gap1);
			for (int i = 0; i < SAMPLES; i++) {
				axis_values q = random_position(&s, &motion);
				double gap = true_gap(&s, made.plane.link, made.n, &q);

				require(gap >= bound - 1e-12, "case %ld: gap %.15g, bound %.15g", n, gap, bound);
				least = fmin(least, gap);
			}
			if (ends - bound > 1e-2) {
				bulging++;
				tightest = fmax(tightest, (ends - least) / (ends - bound));
			}
		}
		release_plane(&made);
		duo_release(&s.duo);
	}
	require(tightest > 0.9, "slack: %g", tightest);
	require(bulging > random_cases(1500) / 10, "%ld motions were not as good as straight", bulging);
}
END_TEST

/* No position in a box has a larger path displacement than the bound for the box. */
START_TEST(the_path_displacement_is_bounded_over_a_box)
{
	double tightest = 0;

	for (long n = 0; n < random_cases(400); n++) {
		axis_values tolerance = {{0}}, half = {{0}};
		struct chain_state state;
		struct scene_of_two s;
		double most;

		scene_init(&s, 3, n);
		for (size_t i = 0; i < s.duo.chain.count; i++) {
			const struct joint *joint = &s.duo.chain.joints[i];
			double unit = joint->rotary ? 0.01 : 1;

			tolerance.v[joint->slot] = random_below(&s.random, 3) ? unit * random_size(&s.random, 1e-3, 1) : 0;
			half.v[joint->slot] = random_below(&s.random, 3) ? unit * random_size(&s.random, 1e-3, 50) : 0;
		}
		chain_state_init(&state, &s.duo.chain, &s.at, &s.duo.pair.ball_a, &s.duo.pair.ball_b);
		most = box_path_displacement(&s.duo.chain, &state, &half, &tolerance);
		for (int i = 0; i < SAMPLES; i++) {
			axis_values q = s.at;
			double w;

			for (int k = 0; k < SLOT_COUNT; k++)
				q.v[k] += half.v[k] * (random_below(&s.random, 2) ? random_sign(&s.random) : random_in(&s.random, -1, 1));
			w = body_pair_path_displacement(&s.duo.pair, &q, &tolerance);
			require(w <= most * (1 + 1e-12), "case %ld: displacement %.15g, bound %.15g", n, w, most);
			tightest = most > 0 ? fmax(tightest, w / most) : tightest;
		}
		duo_release(&s.duo);
	}
	require(tightest > 0.99, "slack: %g", tightest);
}
END_TEST

/* A motion up and down over a face does not reduce the gap sideways, and neither does a turn about the normal. */
START_TEST(motion_across_the_normal_is_free)
{
	const struct chain chain = {
		.count = 3,
		.joints = {{SLOT_C, true, {0, 0, 1}, {0, 0, 0}},
			   {SLOT_X, false, {1, 0, 0}, {0, 0, 0}},
			   {SLOT_Z, false, {0, 0, 1}, {0, 0, 0}}}};
	const struct leaf root = {0, 0};
	xform places[2] = {xform_identity(), xform_identity()};
	struct mesh meshes[2] = {{0}, {0}};
	struct travelling_plane plane;
	struct plane_motion motion = {.straight = true};
	struct plane_pose pose;
	struct corner_runs *corners[2];
	struct mesh_part parts[2];
	struct convex a, b;
	axis_values at = {{0}};
	struct duo duo;
	long visits = 0;

	solid_box(&meshes[0], (vec3){50, 40, 10});
	solid_box(&meshes[1], (vec3){5, 5, 10});
	duo_init(&duo, &chain, &meshes[0], &meshes[1], &places[0], &places[1]);
	at.v[SLOT_Z] = 21;
	plane_pose_init(&pose, &duo.pair, &at);
	places[1] = pose.places[1];
	corners[0] = corner_runs_new(duo.a);
	corners[1] = corner_runs_new(duo.b);
	parts[0] = mesh_part_of(duo.a, corners[0], root);
	parts[1] = mesh_part_of(duo.b, corners[1], root);
	a = convex_of_mesh(&parts[0], &places[0], NULL);
	b = convex_of_mesh(&parts[1], &places[1], NULL);
	travelling_plane_init(&plane, &pose, &a, &b, (vec3){0, 0, 1}, 1,
			      travelling_plane_gap(&pose, &a, &b, (vec3){0, 0, 1}, 0, &visits), &visits);
	motion.q0 = motion.q1 = at;
	ck_assert_double_eq_tol(travelling_plane_rest(&plane, &chain, &motion, -INFINITY), 1, 1e-3);
	motion.q1.v[SLOT_C] = 2;
	motion.q1.v[SLOT_X] = 30;
	ck_assert_double_eq_tol(travelling_plane_rest(&plane, &chain, &motion, -INFINITY), 1, 1e-3);
	motion.q1.v[SLOT_Z] = 22.5;
	ck_assert_double_eq_tol(travelling_plane_rest(&plane, &chain, &motion, -INFINITY), 1, 1e-3);
	motion.q1.v[SLOT_Z] = 20.25;
	ck_assert_double_eq_tol(travelling_plane_rest(&plane, &chain, &motion, -INFINITY), 0.25, 1e-3);
	motion.q0.v[SLOT_Z] = 30;
	motion.q1.v[SLOT_Z] = 20.5;
	ck_assert_double_eq_tol(travelling_plane_rest(&plane, &chain, &motion, -INFINITY), 0.5, 1e-3);
	corner_runs_free(corners[0]);
	corner_runs_free(corners[1]);
	duo_release(&duo);
}
END_TEST

/* A plane is measured again along the normal that its link has carried along. */
START_TEST(normal_goes_with_its_link)
{
	const struct chain chain = {
		.count = 3,
		.joints = {{SLOT_C, true, {0, 0, 1}, {7, 0, 0}},
			   {SLOT_X, false, {1, 0, 0}, {0, 0, 0}},
			   {SLOT_A, true, {1, 0, 0}, {0, 0, 0}}}};
	/* C turns by 30 degrees, A by 90: the normals for no link, and for the links of C, X and A. */
	const vec3 expected[] = {{0, 1, 0}, {-0.5, sqrt(0.75), 0}, {-0.5, sqrt(0.75), 0}, {0, 0, 1}};
	const struct leaf root = {0, 0};
	xform places[2] = {xform_identity(), xform_identity()};
	struct mesh meshes[2] = {{0}, {0}};
	axis_values at = {{0}}, turned = {{0}};
	struct travelling_plane plane;
	struct plane_pose pose;
	struct corner_runs *corners[2];
	struct mesh_part parts[2];
	struct convex a, b;
	struct duo duo;
	long visits = 0;

	solid_box(&meshes[0], (vec3){50, 40, 10});
	solid_box(&meshes[1], (vec3){5, 5, 10});
	duo_init(&duo, &chain, &meshes[0], &meshes[1], &places[0], &places[1]);
	turned.v[SLOT_C] = PI / 6;
	turned.v[SLOT_A] = PI / 2;
	for (size_t link = 0; link < 4; link++) {
		vec3 n;

		plane_pose_init(&pose, &duo.pair, &at);
		corners[0] = corner_runs_new(duo.a);
		corners[1] = corner_runs_new(duo.b);
		parts[0] = mesh_part_of(duo.a, corners[0], root);
		parts[1] = mesh_part_of(duo.b, corners[1], root);
		a = convex_of_mesh(&parts[0], &places[0], NULL);
		b = convex_of_mesh(&parts[1], &places[1], NULL);
		travelling_plane_init(&plane, &pose, &a, &b, (vec3){0, 1, 0}, link, 1, &visits);
		plane_pose_init(&pose, &duo.pair, &turned);
		n = travelling_plane_normal(&plane, &pose);
		ck_assert_double_lt(vec3_norm(vec3_sub(n, expected[link])), 1e-12);
		corner_runs_free(corners[0]);
		corner_runs_free(corners[1]);
	}
	duo_release(&duo);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("planes");

	tcase_add_test(tcase, the_gap_is_never_smaller_than_the_bound);
	tcase_add_test(tcase, the_gap_between_two_ends_is_never_smaller_than_the_bound);
	tcase_add_test(tcase, the_path_displacement_is_bounded_over_a_box);
	tcase_add_test(tcase, motion_across_the_normal_is_free);
	tcase_add_test(tcase, normal_goes_with_its_link);
	return run_suite("travelling_plane", tcase);
}
