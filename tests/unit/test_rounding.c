/*
 * test_rounding.c - the allowances for rounding in proofs, against long double. No error exceeds its allowance, and the
 * largest error is the share of it that its comment explains: such bounds add up the worst cases of all operations,
 * which never occur together.
 */
#include <stdio.h>

#include "geom/boxes.h"
#include "geom/tolerance.h"
#include "scene/motion_interval.h"
#include "solids.h"
#include "suite.h"

/* --------------------------------------------------------- POSE_ROUNDING */

/* The position of the corner of b's mesh in a's mesh coordinates. */
static real3 true_image(const struct duo *duo, const axis_values *q, vec3 corner)
{
	const xform *a = &duo->pair.place_a, *b = &duo->pair.place_b;
	struct turned pose = true_pose(&duo->chain, q, q, 0, NULL);
	real3 p = real3_of(b->translation);

	p = real3_add(p, real3_scale(corner.x, real3_of(b->rotation.x)));
	p = real3_add(p, real3_scale(corner.y, real3_of(b->rotation.y)));
	p = real3_add(p, real3_scale(corner.z, real3_of(b->rotation.z)));
	p = real3_sub(turned_apply(&pose, p), real3_of(a->translation));
	return (real3){real3_dot(real3_of(a->rotation.x), p), real3_dot(real3_of(a->rotation.y), p),
		       real3_dot(real3_of(a->rotation.z), p)};
}

START_TEST(poses_are_off_by_no_more_than_allowed)
{
	long cases = random_cases(20000);
	double most = 0;

	for (long n = 0; n < cases; n++) {
		struct random random = random_case(71, n);
		double size = random_size(&random, 0.1, 1000);
		struct mesh a = random_solid(&random, size), b = random_solid(&random, size);
		struct chain chain = random_chain(&random, 1 + random_below(&random, SLOT_COUNT), size);
		xform place_a = random_place(&random, size), place_b = random_place(&random, size), pose;
		axis_values q = {{0}};
		struct duo duo;
		double allowed;

		for (size_t i = 0; i < chain.count; i++)
			q.v[chain.joints[i].slot] = chain.joints[i].rotary
							    ? random_sign(&random) * random_size(&random, 1e-3, 1e4)
							    : random_in(&random, -size, size);
		duo_init(&duo, &chain, &a, &b, &place_a, &place_b);
		pose = body_pair_pose(&duo.pair, &q);
		allowed = body_pair_rounding(&duo.pair, &q, pose.translation);
		for (size_t i = 0; i < 3 * duo.b->mesh.count; i += 1 + duo.b->mesh.count / 16) {
			vec3 corner = mesh_corner(&duo.b->mesh.triangles[i / 3], (int)(i % 3));
			real3 off = real3_sub(real3_of(xform_apply(&pose, corner)), true_image(&duo, &q, corner));

			most = fmax(most, (double)real3_norm(off) / allowed);
		}
		require(most <= 1, "case %ld: off by %g of what is allowed", n, most);
		duo_release(&duo);
	}
	printf("poses: largest rounding / bound %.4f\n", most);
	/* Allowed are 256 units of the sum of all lengths; each error is of a single length, and errors cancel. */
	ck_assert_double_gt(most, 1e-3);
}
END_TEST

/* ---------------------------------------------------------- BOX_ROUNDING */

/*
 * The distance of two boxes along the three axes of a's frame; both boxes are relative to the origins of their trees.
 */
static real gap_in_a(const struct bvh *bodies[2], const xform *pose, const struct box *a, const struct box *b)
{
	const real3 columns[3] = {real3_of(pose->rotation.x), real3_of(pose->rotation.y), real3_of(pose->rotation.z)};
	real3 at = real3_sub(real3_of(pose->translation), real3_of(bodies[0]->origin));
	const vec3 o = bodies[1]->origin;
	const real middle_b[3] = {(real)o.x + b->centre[0], (real)o.y + b->centre[1], (real)o.z + b->centre[2]};
	real sum = 0, middle[3], half[3] = {0, 0, 0};

	for (int j = 0; j < 3; j++) {
		const real column[3] = {columns[j].x, columns[j].y, columns[j].z};

		at = real3_add(at, real3_scale(middle_b[j], columns[j]));
		for (int k = 0; k < 3; k++)
			half[k] += fabsl(column[k]) * b->half[j];
	}
	middle[0] = at.x;
	middle[1] = at.y;
	middle[2] = at.z;
	for (int k = 0; k < 3; k++) {
		real gap = fabsl(middle[k] - a->centre[k]) - a->half[k] - half[k];

		sum += gap > 0 ? gap * gap : 0;
	}
	return sqrtl(sum);
}

START_TEST(box_tests_are_off_by_no_more_than_allowed)
{
	long cases = random_cases(20000), apart_cases = 0;
	double most = 0;

	for (long n = 0; n < cases; n++) {
		struct random random = random_case(72, n);
		double size = random_size(&random, 0.01, 1e4);
		struct mesh a = random_solid(&random, size * random_size(&random, 0.01, 1));
		struct mesh b = random_solid(&random, size * random_size(&random, 0.01, 1));
		struct bvh *bodies[2] = {bvh_new(&a), bvh_new(&b)};
		const struct bvh *const_bodies[2] = {bodies[0], bodies[1]};
		xform pose = random_place(&random, size), poses[2] = {pose, pose};
		const vec3 still[2] = {{0, 0, 0}, {0, 0, 0}};
		const double exact[2] = {0, 0};
		struct box own = box_of(&bodies[0]->nodes[0], 0), other = box_of(&bodies[1]->nodes[0], 0);
		struct bvh_node node = bodies[0]->nodes[0];
		struct box_motion motion;
		float apart[BVH_WIDTH], loose[BVH_WIDTH];
		double allowed, gap;

		box_motion_init(&motion, bodies[0], bodies[1], poses, still, exact);
		allowed = motion.views[0].displacement;
		for (int l = 1; l < BVH_WIDTH; l++) {
			for (int k = 0; k < 3; k++) {
				node.centre[k][l] = node.centre[k][0];
				node.half[k][l] = node.half[k][0];
			}
		}
		/*
		 * With 0 as the required distance the first view is enough, so the result is that of the first view
		 * alone.
		 */
		boxes_apart(&motion, 0, &node, &other, 0, apart, loose);
		gap = (double)gap_in_a(const_bodies, &pose, &own, &other);
		if (gap > 2 * allowed) {
			apart_cases++;
			require(apart[0] <= gap, "case %ld: %.9g is claimed, %.9g is", n, apart[0], gap);
			most = fmax(most, fabs(gap - (apart[0] + allowed)) / allowed);
			require(most <= 1, "case %ld: off by %g of what is allowed", n, most);
		}
		bvh_free(bodies[0]);
		bvh_free(bodies[1]);
	}
	printf("boxes: largest rounding / bound %.4f\n", most);
	require(apart_cases > cases / 8, "%ld apart", apart_cases);
	/* The 32 roundings of the comment at BOX_ROUNDING are half of the allowance. */
	ck_assert_double_gt(most, 0.1);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("core");

	tcase_add_test(tcase, poses_are_off_by_no_more_than_allowed);
	tcase_add_test(tcase, box_tests_are_off_by_no_more_than_allowed);
	return run_suite("rounding", tcase);
}
