#include "check/certified/strategy.h"

#include "first_contact.h"
#include "step_program.h"
#include "suite.h"

static const struct position_errors exact = {.any = false};

/*
 * Offers the next few steps at once. The value is the number that the strategy took; all of them must be truly clear.
 */
static int skip_some(struct program *p, struct strategy *strategy, int first, long number)
{
	int count = 1 + random_below(&p->random, 6);
	axis_values low = p->corners[first], high = low;
	struct contact contact = {0};

	count = first + count > STEPS ? STEPS - first : count;
	for (int i = first; i <= first + count; i++) {
		for (int k = 0; k < SLOT_COUNT; k++) {
			low.v[k] = fmin(low.v[k], p->corners[i].v[k]);
			high.v[k] = fmax(high.v[k], p->corners[i].v[k]);
		}
	}
	if (!strategy_advance_box(strategy, &low, &high, &exact, &p->corners[first + count], (size_t)count,
				  random_below(&p->random, 2)))
		return 0;
	for (int i = first; i < first + count; i++)
		oracle_judge(&p->duo, &p->corners[i], &p->corners[i + 1], p->clearance, p->tolerance, SWEEP_APART,
			     &contact, "skipped step", number);
	return count;
}

/*
 * Offers all steps from the given one on to be swept together. The value is the number of those swept; all of them must
 * be truly clear.
 */
static int leap_over(struct program *p, struct strategy *strategy, struct sweep *sweep, const struct batch_step *steps,
		     int first, long number)
{
	struct contact contact = {0};
	int count = (int)strategy_advance_chord(strategy, sweep, &steps[first], (size_t)(STEPS - first));

	for (int i = first; i < first + count; i++)
		oracle_judge(&p->duo, &p->corners[i], &p->corners[i + 1], p->clearance, p->tolerance, SWEEP_APART,
			     &contact, "leaped step", number);
	return count;
}

/*
 * Runs the program up to its first contact, and checks every answer. *leaped counts the steps that were swept together.
 */
static bool follow(struct program *p, struct sweep *sweep, bool measure, long number, long *leaped)
{
	struct path paths[STEPS];
	struct batch_step steps[STEPS];
	struct strategy strategy;
	double proven;

	for (int i = 0; i < STEPS; i++) {
		paths[i] = path_between(&p->corners[i], &p->corners[i + 1], PATH_STRAIGHT);
		steps[i] = (struct batch_step){.motion = step_on(&paths[i])};
	}
	strategy_init(&strategy, &p->duo.pair, p->clearance, p->tolerance, measure);
	/* As if many sweeps had preceded: planes are searched from the first step on. */
	strategy.planes.credit = number % 2 ? 1e6 : 0;
	for (int i = 0; i < STEPS; i++) {
		const axis_values *q0 = &p->corners[i], *q1 = &p->corners[i + 1];
		struct contact contact = {0};
		enum query_answer answer;
		int skipped = random_below(&p->random, 3) ? 0 : skip_some(p, &strategy, i, number);

		if (!skipped) {
			skipped = leap_over(p, &strategy, sweep, steps, i, number);
			*leaped += skipped;
		}
		if (skipped) {
			i += skipped - 1;
			continue;
		}
		if (i && !random_below(&p->random, 10)) {
			strategy_forget_position(&strategy);
			continue;
		}
		answer = strategy_advance_step(&strategy, sweep, &steps[i].motion, &contact);
		require(answer != QUERY_UNDECIDED, "case %ld, step %d: undecided", number, i);
		oracle_judge(&p->duo, q0, q1, p->clearance, p->tolerance,
			     answer == QUERY_CONTACT ? SWEEP_CONTACT : SWEEP_APART, &contact, "step", number);
		if (answer == QUERY_CONTACT) {
			strategy_release(&strategy);
			return true;
		}
		proven = strategy_proven(&strategy);
		if (measure && proven > p->clearance)
			require(!(oracle_first(&p->duo, q0, q1, proven * (1 - 1e-9), p->tolerance) < INFINITY),
				"case %ld, step %d: clearance of %g measured, it is less", number, i, proven);
	}
	strategy_release(&strategy);
	return false;
}

START_TEST(first_contact_of_many_steps)
{
	struct sweep sweep = {0};
	long touched = 0, leaped = 0, cases = random_cases(150);

	for (long n = 0; n < cases; n++) {
		struct program p;

		program_init(&p, 1, n);
		touched += follow(&p, &sweep, n % 3 == 0, n, &leaped);
		duo_release(&p.duo);
	}
	sweep_release(&sweep);
	require(touched > cases / 20 && touched < cases, "%ld of %ld touch", touched, cases);
	require(leaped > cases / 2, "only %ld steps were leaped over", leaped);
}
END_TEST

/* Bodies that move together, or that do not move relative to each other, cost one query. */
START_TEST(standing_still_costs_nothing)
{
	struct sweep sweep = {0};
	struct program p;
	struct strategy strategy;
	struct contact contact;

	do {
		static long number;

		program_init(&p, 2, number++);
		strategy_init(&strategy, &p.duo.pair, p.clearance, p.tolerance, false);
		for (int i = 0; i < 100; i++) {
			struct path path = path_between(&p.corners[0], &p.corners[0], PATH_STRAIGHT);
			struct motion_step step = step_on(&path);

			if (strategy_advance_step(&strategy, &sweep, &step, &contact) != QUERY_CLEAR)
				break;
		}
		strategy_release(&strategy);
		duo_release(&p.duo);
	} while (!strategy.proof.clear_at_end);
	ck_assert_int_eq(strategy.queries, 1);
	sweep_release(&sweep);
}
END_TEST

static axis_values random_off(struct random *random, const axis_values *amount)
{
	axis_values off;

	for (int k = 0; k < SLOT_COUNT; k++)
		off.v[k] = amount->v[k] * (random_below(random, 2) ? random_sign(random) : random_in(random, -1, 1));
	return off;
}

/* Where the control may leave the path, and where a rapid takes any path, a clear step is clear everywhere. */
START_TEST(clear_wherever_the_control_may_go)
{
	/*
	 * Some rapids whose path is not known take ten times as long as all others together; an undecided one proves
	 * nothing.
	 */
	struct sweep sweep = {.effort = 20000};
	long clear = 0, boxes = 0, cases = random_cases(150);

	for (long n = 0; n < cases; n++) {
		struct program p;
		struct strategy strategy;
		axis_values tolerance = {{0}};
		double allowed;

		program_init(&p, 3, n);
		allowed = random_size(&p.random, 1e-3, 1);
		for (size_t k = 0; k < p.duo.chain.count; k++)
			tolerance.v[p.duo.chain.joints[k].slot] = allowed * (p.duo.chain.joints[k].rotary ? 0.017 : 1);
		strategy_init(&strategy, &p.duo.pair, p.clearance, fmax(p.tolerance, 0.01), n % 3 == 0);
		strategy.planes.credit = n % 2 ? 1e6 : 0;
		for (int i = 0; i < STEPS; i++) {
			const axis_values *q0 = &p.corners[i], *q1 = &p.corners[i + 1];
			enum path_kind kind = random_below(&p.random, 3) ? PATH_STRAIGHT : PATH_BOX;
			struct path path = path_between(q0, q1, kind);
			struct motion_step step = step_on(&path);
			struct contact contact;

			if (random_below(&p.random, 3))
				step.tolerance = tolerance;
			if (strategy_advance_step(&strategy, &sweep, &step, &contact) != QUERY_CLEAR)
				break;
			clear++;
			boxes += kind == PATH_BOX;
			for (int k = 0; k < 10; k++) {
				axis_values off = random_off(&p.random, &step.tolerance), at = *q0;
				double s = random_in(&p.random, 0, 1), d;
				xform pose;

				for (int j = 0; j < SLOT_COUNT; j++)
					at.v[j] +=
					    (q1->v[j] - q0->v[j]) * (kind == PATH_BOX ? random_in(&p.random, 0, 1) : s);
				pose = duo_pose(&p.duo, &at, &at, 0, &off);
				/*
				 * Only whether the distance is less than the clearance matters, so no larger distance
				 * is measured.
				 */
				d = brute_distance(p.duo.a, p.duo.b, &pose, p.clearance + 1e-3);
				require(d > 0 && d > p.clearance - 1e-9, "case %ld, step %d: %g apart", n, i, d);
			}
		}
		strategy_release(&strategy);
		duo_release(&p.duo);
	}
	sweep_release(&sweep);
	require(clear > 10 * cases && boxes > 2 * cases, "%ld clear, %ld boxes", clear, boxes);
}
END_TEST

/* A cube that moves along X and Y and turns about X, and a wall 10 mm from it on one side in x. */
static void stand_by_wall(struct duo *duo, double side)
{
	const struct chain chain = {.count = 3, .joints = {{SLOT_X, false, {1, 0, 0}, {0, 0, 0}},
							   {SLOT_Y, false, {0, 1, 0}, {0, 0, 0}},
							   {SLOT_A, true, {1, 0, 0}, {0, 0, 0}}}};
	struct mesh wall = {0}, cube = {0};
	xform identity = xform_identity(), beside = identity;

	beside.translation.x = 16 * side;
	solid_box(&wall, (vec3){1, 500, 500});
	solid_place(&wall, &beside);
	solid_box(&cube, (vec3){5, 5, 5});
	duo_init(duo, &chain, &wall, &cube, &identity, &identity);
}

static enum query_answer go(struct strategy *strategy, struct sweep *sweep, double x0, double y0, double x1, double y1,
		       enum path_kind kind, double tolerance)
{
	axis_values from = {{x0, y0}}, to = {{x1, y1}};
	struct path path = path_between(&from, &to, kind);
	struct motion_step step = step_on(&path);
	struct contact contact;

	step.tolerance.v[SLOT_X] = step.tolerance.v[SLOT_Y] = tolerance;
	return strategy_advance_step(strategy, sweep, &step, &contact);
}

START_TEST(what_happened_before)
{
	struct sweep sweep = {0};
	struct strategy strategy;
	struct duo duo;

	stand_by_wall(&duo, 1);
	strategy_init(&strategy, &duo.pair, 0, 1e-3, false);
	/* The axes leave this place without a proof, through the wall, to a place with more room. */
	ck_assert_int_eq(go(&strategy, &sweep, 0, 0, 0.1, 0, PATH_STRAIGHT, 0), QUERY_CLEAR);
	strategy_forget_position(&strategy);
	ck_assert_int_eq(go(&strategy, &sweep, 40, 0, 0.2, 0, PATH_STRAIGHT, 0), QUERY_CONTACT);
	strategy_forget_position(&strategy);
	ck_assert_int_eq(go(&strategy, &sweep, 0.2, 0, 0.1, 0, PATH_STRAIGHT, 0), QUERY_CLEAR);
	/* Into the wall, and then no motion: still in contact, whether it was a finding or not. */
	ck_assert_int_eq(go(&strategy, &sweep, 0.1, 0, 11, 0, PATH_STRAIGHT, 0), QUERY_CONTACT);
	ck_assert_int_eq(go(&strategy, &sweep, 11, 0, 11, 0, PATH_STRAIGHT, 0), QUERY_CONTACT);
	strategy_forget_position(&strategy);
	ck_assert_int_eq(go(&strategy, &sweep, 11, 0, 11, 0, PATH_STRAIGHT, 0), QUERY_CONTACT);
	ck_assert_int_eq(go(&strategy, &sweep, 11, 0, 0, 0, PATH_STRAIGHT, 0), QUERY_CONTACT);
	ck_assert_int_eq(go(&strategy, &sweep, 0, 0, 0, 5, PATH_STRAIGHT, 0), QUERY_CLEAR);
	sweep_release(&sweep);
	strategy_release(&strategy);
	duo_release(&duo);
}
END_TEST

START_TEST(as_far_as_the_control_may_go)
{
	for (int k = 0; k < 8; k++) {
		const double side = k & 1 ? -1 : 1;
		const enum path_kind kind = k & 2 ? PATH_BOX : PATH_STRAIGHT;
		struct sweep sweep = {0};
		struct strategy strategy;
		struct duo duo;

		stand_by_wall(&duo, side);
		strategy_init(&strategy, &duo.pair, 0, 1e-3, k & 4);
		strategy.planes.credit = 1e6;
		/* Along the wall at a distance of 0.02 mm. */
		ck_assert_int_eq(go(&strategy, &sweep, side * 9.5, 0, side * 9.98, 50, kind, 0), QUERY_CLEAR);
		ck_assert_int_eq(go(&strategy, &sweep, side * 9.98, 50, side * 9.98, 99, kind, 0.01), QUERY_CLEAR);
		ck_assert_int_eq(go(&strategy, &sweep, side * 9.98, 99, side * 9.5, 150, kind, 0.03), QUERY_CONTACT);
		strategy_forget_position(&strategy);
		ck_assert_int_eq(go(&strategy, &sweep, side * 9.98, 99, side * 9.98, 99, kind, 0.03), QUERY_CONTACT);
		sweep_release(&sweep);
		strategy_release(&strategy);
		duo_release(&duo);
	}
}
END_TEST

/* The cube turns beside the wall while it moves from x0 to x1. */
static enum query_answer turn(struct strategy *strategy, struct sweep *sweep, double x0, double x1, enum path_kind kind)
{
	const axis_values from = {.v[SLOT_X] = x0}, to = {.v = {[SLOT_X] = x1, [SLOT_A] = 1.5}};
	const struct path path = path_between(&from, &to, kind);
	const struct motion_step step = step_on(&path);
	struct contact contact;

	return strategy_advance_step(strategy, sweep, &step, &contact);
}

/* Planes are tried before a step is given up, even if no sweep before has earned a search. */
START_TEST(planes_before_giving_up)
{
	for (int k = 0; k < 4; k++) {
		const enum path_kind kind = k & 1 ? PATH_BOX : PATH_STRAIGHT;
		struct sweep sweep = {.effort = 1};
		struct strategy strategy;
		struct duo duo;

		stand_by_wall(&duo, 1);
		strategy_init(&strategy, &duo.pair, 0, 1e-3, k & 2);
		ck_assert_int_eq(turn(&strategy, &sweep, 9.5, 9.98, kind), QUERY_CLEAR);
		/* Within the tolerance, and through the wall, planes prove nothing. */
		ck_assert_int_eq(turn(&strategy, &sweep, 9.98, 9.9995, kind), QUERY_UNDECIDED);
		ck_assert_int_eq(turn(&strategy, &sweep, 9.98, 11, kind), QUERY_UNDECIDED);
		sweep_release(&sweep);
		strategy_release(&strategy);
		duo_release(&duo);
	}
}
END_TEST

/*
 * A square rod with a half diagonal of 5 sqrt(2) mm, 7.0715 mm from a wall, is turned about its axis by three joints.
 * It never touches the wall, but a proof needs millions of parts of the box.
 */
static void stand_rod_by_wall(struct duo *duo)
{
	const struct chain chain = {.count = 3, .joints = {{SLOT_A, true, {0, 0, 1}, {0, 0, 0}},
							   {SLOT_B, true, {0, 0, 1}, {0, 0, 0}},
							   {SLOT_C, true, {0, 0, 1}, {0, 0, 0}}}};
	struct mesh wall = {0}, rod = {0};
	xform identity = xform_identity(), beside = identity;

	beside.translation.x = 1 + 7.0715;
	solid_box(&wall, (vec3){1, 50, 50});
	solid_place(&wall, &beside);
	solid_box(&rod, (vec3){5, 5, 5});
	duo_init(duo, &chain, &wall, &rod, &identity, &identity);
}

/* Every undecided rapid whose path is not known halves the effort for the next one (struct open_boxes). */
START_TEST(half_the_effort)
{
	const long most = 50000000, spent_besides = 20000;
	const axis_values from = {{0}}, to = {.v = {[SLOT_A] = 1.5, [SLOT_B] = 1.5, [SLOT_C] = 1.5}};
	const struct path path = path_between(&from, &to, PATH_BOX);
	const struct motion_step step = step_on(&path);

	for (int halvings = 6; halvings <= 16; halvings++) {
		struct sweep sweep = {0};
		struct strategy strategy;
		struct contact contact;
		struct duo duo;

		stand_rod_by_wall(&duo);
		strategy_init(&strategy, &duo.pair, 0, 1e-6, false);
		strategy_limit_boxes(&strategy, halvings);
		ck_assert_int_eq(strategy_advance_step(&strategy, &sweep, &step, &contact), QUERY_UNDECIDED);
		ck_assert(sweep.exhausted);
		ck_assert_int_gt(sweep.visits, most >> halvings);
		ck_assert_int_lt(sweep.visits, (most >> halvings) + spent_besides);
		sweep_release(&sweep);
		strategy_release(&strategy);
		duo_release(&duo);
	}
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("programs");

	tcase_add_test(tcase, first_contact_of_many_steps);
	tcase_add_test(tcase, standing_still_costs_nothing);
	tcase_add_test(tcase, clear_wherever_the_control_may_go);
	tcase_add_test(tcase, what_happened_before);
	tcase_add_test(tcase, as_far_as_the_control_may_go);
	tcase_add_test(tcase, planes_before_giving_up);
	tcase_add_test(tcase, half_the_effort);
	return run_suite("strategy", tcase);
}
