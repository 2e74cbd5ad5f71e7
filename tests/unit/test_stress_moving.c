/*
 * test_stress_moving.c - small random bodies that move, against brute force; and a million triangles that interleave
 * without contact.
 */
#include <sys/resource.h>

#include "stress_case.h"
#include "suite.h"

/* One to four triangles of a solid, on a chain of up to three joints. */
static struct stress_case random_pair(struct random *random)
{
	struct stress_case c = stress_case(random_below(random, 3) ? 1e-3 : random_size(random, 1e-6, 1));
	double size_a = random_size(random, 1, 50), size_b = random_size(random, 1, 50), s = random_in(random, 0, 1);
	axis_values near = {{0}};

	c.chain = random_chain(random, 1 + random_below(random, 3), 100);
	random_move(random, &c.chain, random_size(random, 0.1, 100), &c.chord.q0, &c.chord.q1);
	for (size_t i = 0; i < c.chain.count; i++) {
		int slot = c.chain.joints[i].slot;

		near.v[slot] = (1 - s) * c.chord.q0.v[slot] + s * c.chord.q1.v[slot];
	}
	if (random_below(random, 2)) {
		solid_add(&c.a, random_point(random, size_a), random_point(random, size_a),
			  random_point(random, size_a));
		solid_add(&c.b, random_point(random, size_b), random_point(random, size_b),
			  random_point(random, size_b));
	} else {
		solid_tetrahedron(&c.a, random, size_a);
		solid_tetrahedron(&c.b, random, size_b);
	}
	c.place_a = random_place(random, 100);
	c.place_b = place_near(random, &c.chain, &near, &c.place_a,
			       vec3_scale((size_a + size_b) * random_in(random, 0, 1.2), random_unit(random)));
	c.clearance = random_below(random, 2) ? 0 : random_size(random, 1e-3, 5);
	return c;
}

START_TEST(moving_pairs_agree_with_brute_force)
{
	struct sweep sweep = {0};
	long cases = random_cases(5000), touched = 0, apart = 0;

	for (long n = 0; n < cases; n++) {
		struct random random = random_case(21, n);
		struct stress_case c = random_pair(&random);
		struct contact contact = {0};
		enum sweep_answer answer;
		struct duo duo;

		duo_init(&duo, &c.chain, &c.a, &c.b, &c.place_a, &c.place_b);
		answer = sweep_chord(&sweep, &duo.pair, &c.chord, c.clearance, c.tolerance, &contact);
		oracle_judge(&duo, &c.chord.q0, &c.chord.q1, c.clearance, c.tolerance, answer, &contact, "pair", n);
		touched += answer == SWEEP_CONTACT;
		apart += answer == SWEEP_APART;
		duo_release(&duo);
	}
	sweep_release(&sweep);
	require(touched > cases / 8 && apart > cases / 8, "%ld touched, %ld apart", touched, apart);
}
END_TEST

/* With time reversed the verdict is the same, except for distances between the clearance and e beyond it. */
START_TEST(time_reversed)
{
	struct sweep sweep = {0};

	for (long n = 0; n < random_cases(2000); n++) {
		struct random random = random_case(22, n);
		struct stress_case c = random_pair(&random);
		struct chord back = {.q0 = c.chord.q1, .q1 = c.chord.q0};
		struct contact one = {0}, two = {0};
		enum sweep_answer first, second;
		struct duo duo;

		duo_init(&duo, &c.chain, &c.a, &c.b, &c.place_a, &c.place_b);
		first = sweep_chord(&sweep, &duo.pair, &c.chord, c.clearance, c.tolerance, &one);
		second = sweep_chord(&sweep, &duo.pair, &back, c.clearance, c.tolerance, &two);
		if (first != second) {
			oracle_judge(&duo, &c.chord.q0, &c.chord.q1, c.clearance, c.tolerance, first, &one, "on", n);
			oracle_judge(&duo, &back.q0, &back.q1, c.clearance, c.tolerance, second, &two, "back", n);
		} else if (first == SWEEP_CONTACT) {
			double last = 1 - two.s;

			/* The first contact on the way back is the last contact on the way there. */
			require(one.s <= last ||
				    oracle_motion(&duo, &c.chord.q0, &c.chord.q1, last, one.s) <= 2 * c.tolerance,
				"case %ld: first at %.12g, last at %.12g", n, one.s, last);
		}
		duo_release(&duo);
	}
	sweep_release(&sweep);
}
END_TEST

/* `count` strips per body, of 12 triangles each; those of b are halfway between those of a. */
static void comb(struct mesh *mesh, int count, double shift)
{
	for (int i = 0; i < count; i++) {
		double z = i + shift;
		struct mesh box = {0};
		xform place = xform_identity();

		place.translation.z = z;
		solid_box(&box, (vec3){100, 10, 0.125});
		solid_place(&box, &place);
		for (size_t k = 0; k < box.count; k++)
			solid_add(mesh, mesh_corner(&box.triangles[k], 0), mesh_corner(&box.triangles[k], 1),
				  mesh_corner(&box.triangles[k], 2));
		mesh_release(&box);
	}
}

START_TEST(interleaved_combs)
{
	/* Each tooth has twelve triangles in each of the two bodies: the long form has a million. */
	int teeth = random_cases(1) > 1 ? 41667 : 4000;
	struct stress_case c = stress_case(1e-3);
	struct sweep sweep = {0};
	struct contact contact = {0};
	struct rusage usage;
	struct duo duo;

	comb(&c.a, teeth, 0);
	comb(&c.b, teeth, 0.5);
	c.chain = (struct chain){.count = 1, .joints = {{SLOT_X, false, {1, 0, 0}, {0, 0, 0}}}};
	c.chord.q0.v[SLOT_X] = -50;
	c.chord.q1.v[SLOT_X] = 50;
	duo_init(&duo, &c.chain, &c.a, &c.b, &c.place_a, &c.place_b);
	ck_assert_int_eq(sweep_chord(&sweep, &duo.pair, &c.chord, 0, 1e-3, &contact), SWEEP_APART);
	ck_assert_int_eq(sweep_chord(&sweep, &duo.pair, &c.chord, 0.2, 1e-3, &contact), SWEEP_APART);
	ck_assert_int_eq(sweep_chord(&sweep, &duo.pair, &c.chord, 0.26, 1e-3, &contact), SWEEP_CONTACT);
	ck_assert_int_eq(getrusage(RUSAGE_SELF, &usage), 0);
	/*
	 * kB: the meshes double their memory while they grow here; the check needs 150 bytes per triangle, and 50 MB
	 * for everything else.
	 */
	require(usage.ru_maxrss < 51200 + (long)teeth * 24 * (150 + 72) / 1024, "%ld kB", usage.ru_maxrss);
	sweep_release(&sweep);
	duo_release(&duo);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("core");

	tcase_add_test(tcase, moving_pairs_agree_with_brute_force);
	tcase_add_test(tcase, time_reversed);
	tcase_add_test(tcase, interleaved_combs);
	return run_suite("stress_moving", tcase);
}
