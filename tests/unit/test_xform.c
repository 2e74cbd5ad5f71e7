/* test_xform.c - vectors and rigid motions against closed forms and round trips. */
#include "geom/xform.h"

#include <stdint.h>

#include "base/units.h"
#include "suite.h"

#define NEAR 1e-13	/* some roundings of numbers up to 10 */

static double random_within(uint64_t *state, double limit)
{
	*state ^= *state << 13;
	*state ^= *state >> 7;
	*state ^= *state << 17;
	return limit * ((double)(*state >> 11) * 0x1p-52 - 1);
}

static vec3 random_vec3(uint64_t *state, double limit)
{
	double x = random_within(state, limit), y = random_within(state, limit);

	return (vec3){x, y, random_within(state, limit)};
}

static vec3 random_direction(uint64_t *state)
{
	for (;;) {
		vec3 v = random_vec3(state, 1);
		double norm = vec3_norm(v);

		if (norm > 0.1)
			return vec3_scale(1 / norm, v);
	}
}

static xform random_xform(uint64_t *state)
{
	vec3 axis = random_direction(state), point = random_vec3(state, 5);
	xform t = xform_turn(point, axis, random_within(state, 7));

	t.translation = vec3_add(t.translation, random_vec3(state, 5));
	return t;
}

static void expect_vec3(vec3 a, vec3 b)
{
	ck_assert_double_eq_tol(a.x, b.x, NEAR);
	ck_assert_double_eq_tol(a.y, b.y, NEAR);
	ck_assert_double_eq_tol(a.z, b.z, NEAR);
}

START_TEST(vectors)
{
	vec3 a = {1, 2, 3}, b = {-4, 5, 6};

	expect_vec3(vec3_add(a, b), (vec3){-3, 7, 9});
	expect_vec3(vec3_sub(a, b), (vec3){5, -3, -3});
	expect_vec3(vec3_scale(-2, a), (vec3){-2, -4, -6});
	expect_vec3(vec3_mad(a, 2, b), (vec3){-7, 12, 15});
	ck_assert_double_eq(vec3_dot(a, b), 24);
	expect_vec3(vec3_cross(a, b), (vec3){-3, -18, 13});
	expect_vec3(vec3_cross((vec3){1, 0, 0}, (vec3){0, 1, 0}), (vec3){0, 0, 1});
	ck_assert_double_eq(vec3_norm2(a), 14);
	ck_assert_double_eq(vec3_norm((vec3){2, -3, 6}), 7);
	expect_vec3(vec3_lerp(a, b, 0), a);
	expect_vec3(vec3_lerp(a, b, 1), b);
	expect_vec3(vec3_lerp(a, b, 0.25), (vec3){-0.25, 2.75, 3.75});
	expect_vec3(vec3_min(a, b), (vec3){-4, 2, 3});
	expect_vec3(vec3_max(a, b), (vec3){1, 5, 6});
}
END_TEST

START_TEST(quarter_turns)
{
	static const vec3 unit[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

	/* Right-handed: about each axis, the next axis turns to the one after it. */
	for (int k = 0; k < 3; k++) {
		mat3 turn = mat3_turn(unit[k], PI / 2);

		expect_vec3(mat3_apply(&turn, unit[k]), unit[k]);
		expect_vec3(mat3_apply(&turn, unit[(k + 1) % 3]), unit[(k + 2) % 3]);
		expect_vec3(mat3_apply(&turn, unit[(k + 2) % 3]), vec3_scale(-1, unit[(k + 1) % 3]));
	}
}
END_TEST

/* The parts along and across the axis; the third direction turns in its plane. */
START_TEST(turns_in_closed_form)
{
	uint64_t state = 1;

	for (int turn = 0; turn < 10000; turn++) {
		vec3 axis = random_direction(&state), p = random_vec3(&state, 5), centre = random_vec3(&state, 5);
		double angle = random_within(&state, 7);
		xform t = xform_turn(centre, axis, angle);
		vec3 r = vec3_sub(p, centre), along = vec3_scale(vec3_dot(r, axis), axis);
		vec3 across = vec3_sub(r, along), third = vec3_cross(axis, r);
		vec3 turned = vec3_mad(vec3_mad(along, cos(angle), across), sin(angle), third);

		expect_vec3(xform_apply(&t, p), vec3_add(centre, turned));
		expect_vec3(xform_apply(&t, vec3_mad(centre, 3, axis)), vec3_mad(centre, 3, axis));
	}
}
END_TEST

START_TEST(motions_are_rigid_and_compose)
{
	uint64_t state = 2;

	for (int turn = 0; turn < 10000; turn++) {
		xform a = random_xform(&state), b = random_xform(&state), product = xform_mul(&a, &b);
		xform inverse = xform_inverse(&a), unit = xform_mul(&a, &inverse), same = xform_identity();
		vec3 p = random_vec3(&state, 5), q = random_vec3(&state, 5), pa = xform_apply(&a, p);
		const mat3 *r = &a.rotation;

		expect_vec3(xform_apply(&product, p), xform_apply(&a, xform_apply(&b, p)));
		expect_vec3(xform_apply(&inverse, pa), p);
		expect_vec3(xform_apply(&unit, p), p);
		expect_vec3(xform_apply(&same, p), p);
		expect_vec3(mat3_apply_transposed(r, mat3_apply(r, p)), p);
		ck_assert_double_eq_tol(vec3_norm(vec3_sub(pa, xform_apply(&a, q))), vec3_norm(vec3_sub(p, q)), NEAR);
		/* A rotation, not a reflection. */
		expect_vec3(vec3_cross(r->x, r->y), r->z);
	}
}
END_TEST

START_TEST(turns_about_one_axis_add)
{
	uint64_t state = 3;

	for (int turn = 0; turn < 10000; turn++) {
		vec3 axis = random_direction(&state), p = random_vec3(&state, 5);
		double alpha = random_within(&state, 4), beta = random_within(&state, 4);
		mat3 a = mat3_turn(axis, alpha), b = mat3_turn(axis, beta), both = mat3_turn(axis, alpha + beta);
		mat3 product = mat3_mul(&a, &b);

		expect_vec3(mat3_apply(&product, p), mat3_apply(&both, p));
	}
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("core");

	tcase_add_test(tcase, vectors);
	tcase_add_test(tcase, quarter_turns);
	tcase_add_test(tcase, turns_in_closed_form);
	tcase_add_test(tcase, motions_are_rigid_and_compose);
	tcase_add_test(tcase, turns_about_one_axis_add);
	return run_suite("xform", tcase);
}
