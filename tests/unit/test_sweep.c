#include "scene/sweep.h"

#include "first_contact.h"
#include "scene/coherence.h"
#include "suite.h"

/* Two random solids that are near each other at some instant of a random move. */
struct encounter {
	struct random random;
	struct duo duo;
	struct chord chord;
	double clearance, tolerance;
};

static void encounter_init(struct encounter *e, uint64_t test, long number)
{
	struct random *random = &e->random;
	struct chain chain;
	struct mesh a, b;
	xform place_a, place_b;
	axis_values near;
	double s, size_a, size_b;

	*e = (struct encounter){.random = random_case(test, number)};
	chain = random_chain(random, 1 + random_below(random, 5), 200);
	random_move(random, &chain, random_size(random, 1, 300), &e->chord.q0, &e->chord.q1);
	s = random_in(random, 0, 1);
	for (int k = 0; k < SLOT_COUNT; k++)
		near.v[k] = (1 - s) * e->chord.q0.v[k] + s * e->chord.q1.v[k];
	size_a = random_size(random, 2, 100);
	size_b = random_size(random, 2, 100);
	a = random_solid(random, size_a);
	b = random_solid(random, size_b);
	place_a = random_place(random, 200);
	place_b = place_near(random, &chain, &near, &place_a,
			     vec3_scale((size_a + size_b) * random_in(random, 0.3, 1.5), random_unit(random)));
	duo_init(&e->duo, &chain, &a, &b, &place_a, &place_b);
	e->tolerance = random_below(random, 3) ? 1e-3 : random_size(random, 1e-5, 1);
	e->clearance = random_below(random, 2) ? 0 : random_size(random, 1e-3, 20);
}

START_TEST(chords_agree_with_brute_force)
{
	struct sweep sweep = {0};
	long touched = 0, apart = 0, cases = random_cases(800);

	for (long n = 0; n < cases; n++) {
		struct encounter e;
		struct coherence coherence = {0};
		struct contact contact;
		enum sweep_answer answer;

		encounter_init(&e, 1, n);
		e.duo.pair.coherence = random_below(&e.random, 2) ? &coherence : NULL;
		answer = sweep_chord(&sweep, &e.duo.pair, &e.chord, e.clearance, e.tolerance, &contact);
		oracle_judge(&e.duo, &e.chord.q0, &e.chord.q1, e.clearance, e.tolerance, answer, &contact, "chord", n);
		touched += answer == SWEEP_CONTACT;
		apart += answer == SWEEP_APART;
		duo_release(&e.duo);
	}
	sweep_release(&sweep);
	require(touched > cases / 8 && apart > cases / 10, "%ld contacts, %ld apart", touched, apart);
}
END_TEST

/* The chain as seen from b: the same joints in reverse order. */
static struct chain reversed(const struct chain *chain)
{
	struct chain out = {.count = chain->count};

	for (size_t i = 0; i < chain->count; i++) {
		out.joints[i] = chain->joints[chain->count - 1 - i];
		out.joints[i].direction = vec3_scale(-1, out.joints[i].direction);
	}
	return out;
}

/* Both orders of the bodies give the same instant, to within the tolerance in motion. */
START_TEST(order_does_not_matter)
{
	struct sweep sweep = {0};

	for (long n = 0; n < random_cases(800); n++) {
		struct encounter e;
		struct chain chain;
		struct body_pair other;
		struct contact one, two;
		enum sweep_answer first, second;

		encounter_init(&e, 2, n);
		chain = reversed(&e.duo.chain);
		body_pair_init(&other, e.duo.b, e.duo.a, &e.duo.pair.place_b, &e.duo.pair.place_a, &chain);
		first = sweep_chord(&sweep, &e.duo.pair, &e.chord, e.clearance, e.tolerance, &one);
		second = sweep_chord(&sweep, &other, &e.chord, e.clearance, e.tolerance, &two);
		/* Between c and c + e both answers are right. */
		if (first == second && first == SWEEP_CONTACT) {
			double motion = oracle_motion(&e.duo, &e.chord.q0, &e.chord.q1, one.s, two.s);

			if (motion > e.tolerance) {
				oracle_judge(&e.duo, &e.chord.q0, &e.chord.q1, e.clearance, e.tolerance, first, &one,
					     "one", n);
				oracle_judge(&e.duo, &e.chord.q0, &e.chord.q1, e.clearance, e.tolerance, second, &two,
					     "two", n);
			}
		} else if (first != second) {
			oracle_judge(&e.duo, &e.chord.q0, &e.chord.q1, e.clearance, e.tolerance, first, &one, "one", n);
			oracle_judge(&e.duo, &e.chord.q0, &e.chord.q1, e.clearance, e.tolerance, second, &two, "two",
				     n);
		}
		duo_release(&e.duo);
	}
	sweep_release(&sweep);
}
END_TEST

/* The box between the ends of the move, axis by axis. */
static void positions_between(const struct encounter *e, axis_values *low, axis_values *high)
{
	for (int k = 0; k < SLOT_COUNT; k++) {
		low->v[k] = fmin(e->chord.q0.v[k], e->chord.q1.v[k]);
		high->v[k] = fmax(e->chord.q0.v[k], e->chord.q1.v[k]);
	}
}

START_TEST(boxes_of_positions)
{
	struct sweep sweep = {0};
	long touched = 0, apart = 0, undecided = 0, cases = random_cases(600);

	for (long n = 0; n < cases; n++) {
		struct encounter e;
		axis_values low, high;
		const struct swept_box box = {&low, &high, n % 2 ? 0.1 : 0.4, 200000};
		struct contact contact;
		enum sweep_answer answer;

		encounter_init(&e, 3, n);
		e.tolerance = fmax(e.tolerance, 0.01);
		positions_between(&e, &low, &high);
		sweep.exhausted = false;
		answer = sweep_box(&sweep, &e.duo.pair, &box, e.clearance, e.tolerance, &contact);
		/* For any number of joints, halving them in turn decides the box in the end. */
		require(answer != SWEEP_UNDECIDED || sweep.exhausted, "case %ld: undecided before the limit", n);
		touched += answer == SWEEP_CONTACT;
		apart += answer == SWEEP_APART;
		undecided += answer == SWEEP_UNDECIDED;
		for (int i = 0; i < 60 && answer == SWEEP_APART; i++) {
			axis_values q;
			xform pose;
			double distance;

			for (int k = 0; k < SLOT_COUNT; k++)
				q.v[k] = random_below(&e.random, 2) ? random_in(&e.random, low.v[k], high.v[k])
				       : random_below(&e.random, 2) ? low.v[k] : high.v[k];
			pose = duo_pose(&e.duo, &q, &q, 0, NULL);
			distance = brute_distance(e.duo.a, e.duo.b, &pose, e.clearance + 1);
			require(distance > e.clearance - 1e-9, "case %ld: apart, but %g", n, distance - e.clearance);
		}
		if (answer == SWEEP_CONTACT) {
			xform pose = duo_pose(&e.duo, &contact.q, &contact.q, 0, NULL);
			double distance = brute_distance(e.duo.a, e.duo.b, &pose, INFINITY);

			require(distance <= e.clearance + e.tolerance + 1e-9, "case %ld: false alarm, %g", n, distance);
			for (int k = 0; k < SLOT_COUNT; k++)
				require(contact.q.v[k] >= low.v[k] && contact.q.v[k] <= high.v[k], "case %ld: outside",
					n);
		}
		duo_release(&e.duo);
	}
	sweep_release(&sweep);
	require(touched > cases / 8 && apart > cases / 20 && undecided < cases / 10,
		"%ld contacts, %ld apart, %ld undecided", touched, apart, undecided);
}
END_TEST

START_TEST(distance_is_a_good_lower_bound)
{
	struct sweep sweep = {0};
	long counted = 0, cases = random_cases(3000);

	for (long n = 0; n < cases; n++) {
		struct encounter e;
		struct coherence coherence = {0};
		axis_values *q;
		double share, enough, bound, truth;
		xform pose;

		encounter_init(&e, 4, n);
		e.duo.pair.coherence = random_below(&e.random, 2) ? &coherence : NULL;
		for (int k = 0; k < 2; k++) {
			q = k ? &e.chord.q1 : &e.chord.q0;
			pose = duo_pose(&e.duo, q, q, 0, NULL);
			truth = brute_distance(e.duo.a, e.duo.b, &pose, INFINITY);
			enough = random_below(&e.random, 2) ? 0 : truth * random_in(&e.random, 0, 1.2);
			share = random_in(&e.random, 0.05, 0.95);
			bound = sweep_distance(&sweep, &e.duo.pair, q, share, enough, 0);
			require(bound >= 0 && bound <= truth, "case %ld: %.12g is no lower bound of %.12g", n, bound,
				truth);
			if (truth > enough + 1e-9) {
				require(bound >= share * truth - 1e-8, "case %ld: %.12g of %.12g", n, bound, truth);
				counted++;
			}
		}
		duo_release(&e.duo);
	}
	sweep_release(&sweep);
	require(counted > cases / 2, "%ld", counted);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("against brute force");

	tcase_add_test(tcase, chords_agree_with_brute_force);
	tcase_add_test(tcase, order_does_not_matter);
	tcase_add_test(tcase, boxes_of_positions);
	tcase_add_test(tcase, distance_is_a_good_lower_bound);
	return run_suite("sweep", tcase);
}
