/* test_path.c - arcs against closed forms, and the bound of their chord error against dense samples in long double. */

#include "motion/path.h"
#include "motion_rig.h"
#include "suite.h"

static void assert_xyz(axis_values q, double x, double y, double z)
{
	ck_assert_double_eq_tol(q.v[SLOT_X], x, 1e-12);
	ck_assert_double_eq_tol(q.v[SLOT_Y], y, 1e-12);
	ck_assert_double_eq_tol(q.v[SLOT_Z], z, 1e-12);
}

START_TEST(straight_is_linear)
{
	struct path path = {.kind = PATH_STRAIGHT, .start = {{1, 2, 3, 0.5}}, .end = {{5, -6, 3, 1.5}}};
	axis_values q = path_position(&path, 0.25), zero = path_chord_error(&path, 0, 1);

	assert_xyz(q, 2, 0, 3);
	ck_assert_double_eq_tol(q.v[SLOT_A], 0.75, 1e-15);
	for (int slot = 0; slot < SLOT_COUNT; slot++)
		ck_assert(!(zero.v[slot] > 0));
	ck_assert_double_eq_tol(path_length(&path), sqrt(16 + 64), 1e-14);
}
END_TEST

/* A quarter of a circle of radius 10 about (0, 0) that rises by 4, while A turns. */
START_TEST(helix_in_the_xy_plane)
{
	struct path path = {.kind = PATH_ARC, .circular = true, .start = {{10, 0, 1, 0}}, .end = {{0, 10, 5, 1}},
			    .arc = {{0, 0, 1}, {0, 0, 1}, PI / 2}};

	assert_xyz(path_position(&path, 0.5), 10 * sqrt(0.5), 10 * sqrt(0.5), 3);
	assert_xyz(path_position(&path, 1.0 / 3), 10 * cos(PI / 6), 5, 1 + 4 / 3.0);
	ck_assert_double_eq_tol(path_position(&path, 0.25).v[SLOT_A], 0.25, 1e-15);
	ck_assert_double_eq_tol(path_length(&path), sqrt(25 * PI * PI + 16), 1e-12);
	/* The rise is linear: its chord is exact except for rounding. */
	ck_assert_double_lt(path_chord_error(&path, 0, 1).v[SLOT_Z], 1e-12);
	/*
	 * The chord of a small arc differs by r (1 - cos(a/2)) on the axis toward which the middle of the arc points.
	 */
	ck_assert_double_ge(path_chord_error(&path, 0, 0.01).v[SLOT_X], 10 * (1 - cos(PI / 400)) * (1 - 1e-4));
	ck_assert_double_le(path_chord_error(&path, 0, 0.01).v[SLOT_X], 10 * (1 - cos(PI / 400)) * (1 + 1e-4));
}
END_TEST

/* Clockwise arcs in G18 and G19, and three turns in one move. */
START_TEST(other_planes_and_turns)
{
	struct path zx = {.kind = PATH_ARC, .circular = true, .start = {{0, 7, 20}}, .end = {{-20, 7, 0}},
			  .arc = {{0, 7, 0}, {0, 1, 0}, -PI / 2}};
	struct path yz = {.kind = PATH_ARC, .circular = true, .start = {{3, 1, 0}}, .end = {{3, 1, 0}},
			  .arc = {{3, 0, 0}, {1, 0, 0}, 2 * PI}};
	struct path three = {.kind = PATH_ARC, .circular = true, .start = {{1, 0, 0}}, .end = {{1, 0, 6}},
			     .arc = {{0, 0, 0}, {0, 0, 1}, 6 * PI}};

	assert_xyz(path_position(&zx, 0.5), -20 * sqrt(0.5), 7, 20 * sqrt(0.5));
	assert_xyz(path_position(&yz, 0.25), 3, 0, 1);
	assert_xyz(path_position(&yz, 0.5), 3, -1, 0);
	ck_assert_double_eq_tol(path_length(&yz), 2 * PI, 1e-14);
	assert_xyz(path_position(&three, 0.5), -1, 0, 3);
	assert_xyz(path_position(&three, 0.25), 0, -1, 1.5);
}
END_TEST

/* The radius grows from 10 to 20 over half a turn. */
START_TEST(spiral)
{
	struct path path = {.kind = PATH_ARC, .circular = true, .start = {{10, 0, 0}}, .end = {{-20, 0, 0}},
			    .arc = {{0, 0, 0}, {0, 0, 1}, PI}};
	struct path out = {.kind = PATH_ARC, .circular = true, .start = {{0, 0, 0}}, .end = {{0, 4, 0}},
			   .arc = {{0, 0, 0}, {0, 0, 1}, PI / 2}};
	double length = 0;

	assert_xyz(path_position(&path, 0.5), 0, 15, 0);
	for (int i = 0; i < 20000; i++) {
		axis_values a = path_position(&path, i / 20000.0), b = path_position(&path, (i + 1) / 20000.0);

		length += hypot(b.v[SLOT_X] - a.v[SLOT_X], b.v[SLOT_Y] - a.v[SLOT_Y]);
	}
	ck_assert_double_eq_tol(path_length(&path), length, 1e-3 * length);
	/* A spiral that starts at its centre: after half of its angle it has half of its radius. */
	assert_xyz(path_position(&out, 0.5), 2 * sqrt(0.5), 2 * sqrt(0.5), 0);
}
END_TEST

START_TEST(ends_are_the_given_bits)
{
	struct path path = {.kind = PATH_ARC, .circular = true, .start = {{0.1, 0.2, 0.3}}, .end = {{0.7, 0.2, 0.9}},
			    .arc = {{0.4, 0.2, 0.3}, {0, 0, 1}, PI}};
	axis_values first = path_position(&path, 0), last = path_position(&path, 1);

	ck_assert_mem_eq(&first, &path.start, sizeof(first));
	ck_assert_mem_eq(&last, &path.end, sizeof(last));
}
END_TEST

/* If the formula of the arc misses the programmed end, the bound of the last piece includes this. */
START_TEST(a_missed_end_is_accounted_for)
{
	struct path path = {.kind = PATH_ARC, .circular = true, .start = {{10, 0, 0}}, .end = {{0.001, 10, 0}},
			    .arc = {{0, 0, 0}, {0, 0, 1}, PI / 2}};

	ck_assert_double_gt(path_chord_error(&path, 0.999, 1).v[SLOT_X], 0.001);
	ck_assert_double_lt(path_chord_error(&path, 0.998, 0.999).v[SLOT_X], 0.0001);
}
END_TEST

/* ------------------------------------------ the bound of the chord error */

static struct path random_arc(uint64_t *random)
{
	static const vec3 planes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
	struct path path = {.kind = PATH_ARC, .circular = true};
	vec3 normal = rig_pick(random, 2) ? planes[rig_pick(random, 3)] : rig_unit(random);
	vec3 centre = rig_point(random, 300), e1, start, end;
	double r0 = exp(rig_random(random, -4, 7)), r1 = rig_pick(random, 2) ? r0 : r0 * rig_random(random, 0.5, 2);
	double sweep = rig_random(random, -14, 14), rise = rig_pick(random, 2) ? 0 : rig_random(random, -50, 50);
	mat3 turn = mat3_turn(normal, sweep);

	do
		e1 = vec3_cross(normal, rig_unit(random));
	while (vec3_norm(e1) < 0.1);
	e1 = rig_normalised(e1);
	start = vec3_mad(centre, r0, e1);
	end = vec3_mad(vec3_mad(centre, rise, normal), r1, mat3_apply(&turn, e1));
	path.start = (axis_values){{start.x, start.y, start.z, 0.5}};
	path.end = (axis_values){{end.x, end.y, end.z, -1}};
	path.arc = (struct canon_arc){centre, normal, sweep};
	return path;
}

/* The definition in canon.h, in long double. */
static void true_position(const struct path *path, long double u, long double out[3])
{
	const double *s = path->start.v, *e = path->end.v;
	const double n[3] = {path->arc.normal.x, path->arc.normal.y, path->arc.normal.z};
	const double c[3] = {path->arc.centre.x, path->arc.centre.y, path->arc.centre.z};
	long double from[3], to[3], rise = 0, height = 0, r0 = 0, r1 = 0, radius, angle = path->arc.sweep * u;

	for (int i = 0; i < 3; i++) {
		rise += ((long double)e[i] - s[i]) * n[i];
		height += ((long double)s[i] - c[i]) * n[i];
	}
	for (int i = 0; i < 3; i++) {
		from[i] = (long double)s[i] - c[i] - height * n[i];
		to[i] = (long double)e[i] - c[i] - (height + rise) * n[i];
		r0 += from[i] * from[i];
		r1 += to[i] * to[i];
	}
	r0 = sqrtl(r0);
	radius = (1 - u) + u * sqrtl(r1) / r0;
	for (int i = 0; i < 3; i++) {
		int j = (i + 1) % 3, k = (i + 2) % 3;
		long double side = n[j] * from[k] - n[k] * from[j];

		out[i] = s[i] - from[i] + radius * (cosl(angle) * from[i] + sinl(angle) * side) + u * rise * n[i];
	}
}

/* The largest ratio of |true - chord| to the bound over [u0, u1]. */
static double worst_ratio(const struct path *path, double u0, double u1, int samples)
{
	axis_values q0 = path_position(path, u0), q1 = path_position(path, u1);
	axis_values bound = path_chord_error(path, u0, u1);
	double worst = 0;

	for (int k = 0; k <= samples; k++) {
		long double s = (long double)k / samples, at[3];

		true_position(path, u0 + s * ((long double)u1 - u0), at);
		for (int slot = 0; slot < 3; slot++) {
			long double off = fabsl(at[slot] - ((1 - s) * q0.v[slot] + s * q1.v[slot]));

			worst = fmax(worst, (double)(off / bound.v[slot]));
		}
	}
	return worst;
}

START_TEST(chord_bound_holds_and_is_tight)
{
	uint64_t random = 20240607;
	double worst = 0;

	for (int i = 0; i < 30000; i++) {
		struct path path = random_arc(&random);
		double h = exp(rig_random(&random, -9, 0)), u0 = rig_random(&random, 0, 1 - h);
		double ratio = worst_ratio(&path, u0, i % 10 ? u0 + h : 1, 24);

		ck_assert_msg(ratio <= 1, "case %d: %.17g times the bound over %g", i, ratio, h);
		worst = fmax(worst, ratio);
	}
	printf("arcs: largest deviation / bound %.6f\n", worst);
	ck_assert_double_gt(worst, 0.99);
}
END_TEST

/* If the chord is so short that the bound is only for rounding, it must still hold, and not by chance. */
START_TEST(rounding_is_inside)
{
	uint64_t random = 77;
	double worst = 0;

	for (int i = 0; i < 20000; i++) {
		struct path path = random_arc(&random);
		double u0 = rig_random(&random, 0, 1), ratio = worst_ratio(&path, u0, u0 + 1e-12, 2);

		ck_assert_msg(ratio <= 1, "case %d: %.17g times the bound", i, ratio);
		worst = fmax(worst, ratio);
	}
	printf("arcs: largest rounding / bound %.6f\n", worst);
}
END_TEST

int main(void)
{
	TCase *tests = tcase_create("path");

	tcase_add_test(tests, straight_is_linear);
	tcase_add_test(tests, helix_in_the_xy_plane);
	tcase_add_test(tests, other_planes_and_turns);
	tcase_add_test(tests, spiral);
	tcase_add_test(tests, ends_are_the_given_bits);
	tcase_add_test(tests, a_missed_end_is_accounted_for);
	tcase_add_test(tests, chord_bound_holds_and_is_tight);
	tcase_add_test(tests, rounding_is_inside);
	return run_suite("path", tests);
}
