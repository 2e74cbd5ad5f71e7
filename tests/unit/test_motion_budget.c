#include "check/certified/kept_budgets.h"

#include <string.h>

#include "scene/sweep.h"
#include "solids.h"
#include "suite.h"

enum { SAMPLES = 6 };

static const struct position_errors exact = {.any = false};

/*
 * Two solids on a chain whose axes move in random short steps around a position at which the solids are near each
 * other.
 */
struct walk {
	struct random random;
	long number;
	struct duo duo;
	struct kept_budgets budgets;
	double clearance;
	axis_values centre, at;
	double step;	/* mm, and hundredths of a radian */
	long covered, boxes, recalled;
};

static void walk_init(struct walk *w, uint64_t test, long number)
{
	struct random *random = &w->random;
	struct chain chain;
	struct mesh a, b;
	xform place_a, place_b;
	double size;

	*w = (struct walk){.random = random_case(test, number), .number = number};
	chain = random_chain(random, 1 + random_below(random, 5), 200);
	random_move(random, &chain, 0.001, &w->centre, &w->at);
	size = random_size(random, 2, 60);
	a = random_solid(random, size);
	b = random_solid(random, size);
	place_a = random_place(random, 200);
	place_b = place_near(random, &chain, &w->centre, &place_a,
			     vec3_scale(size * random_in(random, 1, 4), random_unit(random)));
	duo_init(&w->duo, &chain, &a, &b, &place_a, &place_b);
	kept_budgets_init(&w->budgets, &w->duo.chain);
	w->at = w->centre;
	w->clearance = random_below(random, 2) ? 0 : random_size(random, 1e-3, 5);
	w->step = random_size(random, 1e-2, 20);
}

static axis_values next_place(struct walk *w)
{
	axis_values q = w->at;

	for (size_t i = 0; i < w->duo.chain.count; i++) {
		const struct joint *joint = &w->duo.chain.joints[i];
		double unit = joint->rotary ? 0.01 : 1;

		if (random_below(&w->random, 3))
			q.v[joint->slot] += w->step * unit * random_in(&w->random, -1, 1) -
					    0.02 * (q.v[joint->slot] - w->centre.v[joint->slot]);
	}
	return q;
}

static double distance_at(const struct walk *w, const axis_values *q0, const axis_values *q1, double s,
			  const axis_values *off, double most)
{
	xform pose = duo_pose(&w->duo, q0, q1, s, off);

	return brute_distance(w->duo.a, w->duo.b, &pose, most);
}

static axis_values random_off(struct random *random, const axis_values *amount)
{
	axis_values off;

	for (int k = 0; k < SLOT_COUNT; k++)
		off.v[k] = amount->v[k] * (random_below(random, 2) ? random_sign(random) : random_in(random, -1, 1));
	return off;
}

static void renew(struct walk *w, struct sweep *sweep, const axis_values *at, const axis_values *from)
{
	struct chain_state state;
	double distance = sweep_distance(sweep, &w->duo.pair, at, 0.7, 0, 0);

	chain_state_init(&state, &w->duo.chain, at, &w->duo.pair.ball_a, &w->duo.pair.ball_b);
	kept_budgets_set(&w->budgets, at, &state, distance - w->clearance);
	kept_budgets_resume(&w->budgets, from);
}

/* One part of the amount is chord error, the other part path tolerance. */
static struct position_errors random_errors(struct walk *w, const axis_values *amount)
{
	struct position_errors errors = {.any = false};
	double share = random_below(&w->random, 3) ? random_in(&w->random, 0, 1) : random_below(&w->random, 2);

	for (int k = 0; k < SLOT_COUNT; k++) {
		errors.chord.v[k] = share * amount->v[k];
		errors.path.v[k] = (1 - share) * amount->v[k];
		errors.any |= amount->v[k] > 0;
	}
	return errors;
}

static void move_straight(struct walk *w, struct sweep *sweep)
{
	axis_values q1 = next_place(w), amount = {{0}}, was = w->budgets.now.at;
	struct position_errors errors;
	bool strays = random_below(&w->random, 3) == 0;

	for (size_t i = 0; i < w->duo.chain.count && strays; i++)
		amount.v[w->duo.chain.joints[i].slot] =
			random_size(&w->random, 1e-3, 1) * (w->duo.chain.joints[i].rotary ? 0.01 : 1);
	errors = random_errors(w, &amount);
	if (kept_budgets_cover(&w->budgets, &w->at, &q1, &errors)) {
		w->covered++;
		w->recalled += memcmp(&was, &w->budgets.now.at, sizeof(was)) != 0;
		for (int i = 0; i < SAMPLES; i++) {
			axis_values off = random_off(&w->random, &amount);
			double d = distance_at(w, &w->at, &q1, i / (SAMPLES - 1.0), &off, w->clearance + 1);

			require(d > w->clearance - 1e-9, "case %ld: %.12g proved, %.12g is", w->number,
				w->clearance, d);
		}
	} else {
		renew(w, sweep, random_below(&w->random, 2) ? &q1 : &w->at, &q1);
	}
	w->at = q1;
}

static void move_in_box(struct walk *w, struct sweep *sweep)
{
	axis_values q1 = next_place(w), low, high, amount = {{0}};
	struct position_errors errors;
	bool strays = random_below(&w->random, 3) == 0;

	for (int k = 0; k < SLOT_COUNT; k++) {
		low.v[k] = fmin(w->at.v[k], q1.v[k]);
		high.v[k] = fmax(w->at.v[k], q1.v[k]);
		amount.v[k] = strays ? 1e-3 : 0;
	}
	errors = random_errors(w, &amount);
	if (kept_budgets_cover_box(&w->budgets, &low, &high, &q1, &errors, random_below(&w->random, 2))) {
		w->boxes++;
		for (int i = 0; i < SAMPLES; i++) {
			axis_values q, off = random_off(&w->random, &amount);
			double d;

			for (int k = 0; k < SLOT_COUNT; k++)
				q.v[k] =
				    random_below(&w->random, 2) ? low.v[k] : random_in(&w->random, low.v[k], high.v[k]);
			d = distance_at(w, &q, &q, 0, &off, w->clearance + 1);
			require(d > w->clearance - 1e-9, "case %ld: %.12g proved, %.12g is", w->number,
				w->clearance, d);
		}
	} else {
		renew(w, sweep, &q1, &q1);
	}
	w->at = q1;
}

START_TEST(what_is_covered_is_apart)
{
	struct sweep sweep = {0};
	long covered = 0, boxes = 0, recalled = 0, cases = random_cases(70);

	for (long n = 0; n < cases; n++) {
		struct walk w;

		walk_init(&w, 1, n);
		for (int i = 0; i < 200; i++) {
			if (random_below(&w.random, 5))
				move_straight(&w, &sweep);
			else
				move_in_box(&w, &sweep);
			/* Sometimes the axes go elsewhere, and the budget is not told. */
			if (!random_below(&w.random, 20)) {
				w.at = next_place(&w);
				kept_budgets_resume(&w.budgets, &w.at);
			}
		}
		covered += w.covered;
		boxes += w.boxes;
		recalled += w.recalled;
		duo_release(&w.duo);
	}
	sweep_release(&sweep);
	require(covered > 40 * cases && boxes > 5 * cases && recalled > cases, "covered %ld, boxes %ld, recalled %ld", covered,
		boxes, recalled);
}
END_TEST

/* Along a random direction, up to the end of the budget, points of the balls move by no more than the room. */
START_TEST(no_point_moves_farther_than_the_room)
{
	double tightest = 0;

	for (long n = 0; n < random_cases(20000); n++) {
		struct random random = random_case(2, n);
		struct chain chain = random_chain(&random, 1 + random_below(&random, 5), 200);
		const struct ball balls[2] = {{random_point(&random, 200), random_size(&random, 0.1, 100)},
					      {random_point(&random, 200), random_size(&random, 0.1, 100)}};
		double room = random_size(&random, 0.01, 300), low = 0, high = 10, moved[VIEWS] = {0, 0};
		struct turned poses[2];
		struct chain_state state;
		struct motion_budget budget;
		axis_values at, other, q;

		random_move(&random, &chain, 100, &at, &other);
		chain_state_init(&state, &chain, &at, &balls[0], &balls[1]);
		motion_budget_init(&budget, &chain);
		for (int i = 0; i < 60; i++) {
			double middle = 0.5 * (low + high);

			for (int k = 0; k < SLOT_COUNT; k++)
				q.v[k] = at.v[k] + middle * (other.v[k] - at.v[k]);
			motion_budget_set(&budget, &at, &state, room);
			*(motion_budget_covers(&budget, &q, &exact) ? &low : &high) = middle;
		}
		for (int k = 0; k < SLOT_COUNT; k++)
			q.v[k] = at.v[k] + low * (other.v[k] - at.v[k]);
		poses[0] = true_pose(&chain, &at, &at, 0, NULL);
		poses[1] = true_pose(&chain, &q, &q, 0, NULL);
		for (int view = 0; view < VIEWS; view++) {
			for (int i = 0; i < 30; i++) {
				const struct ball *ball = &balls[1 - view];
				real3 p = real3_of(vec3_mad(ball->centre, ball->radius, random_unit(&random)));
				real3 way = view ? real3_sub(turned_back(&poses[1], p), turned_back(&poses[0], p))
						 : real3_sub(turned_apply(&poses[1], p), turned_apply(&poses[0], p));

				moved[view] = fmax(moved[view], (double)real3_norm(way));
			}
		}
		/* The bound must hold in one of the two views. */
		require(fmin(moved[0], moved[1]) <= room * (1 + 1e-12), "case %ld: moved %g, room %g", n,
			fmin(moved[0], moved[1]), room);
		if (low < 9)
			tightest = fmax(tightest, fmin(moved[0], moved[1]) / room);
	}
	require(tightest > 0.99, "slack: %g", tightest);
}
END_TEST

/* Along one linear axis, straight toward the other body, the budget uses all of its room. */
START_TEST(budget_is_not_slack)
{
	const struct chain chain = {.count = 1, .joints = {{SLOT_X, false, {1, 0, 0}, {0, 0, 0}}}};
	struct ball ball = {{0, 0, 0}, 10};
	struct chain_state state;
	struct motion_budget budget;
	axis_values q = {{0}};

	chain_state_init(&state, &chain, &q, &ball, &ball);
	motion_budget_init(&budget, &chain);
	ck_assert(!motion_budget_covers(&budget, &q, &exact));
	motion_budget_set(&budget, &q, &state, 5);
	q.v[SLOT_X] = 4.999;
	ck_assert(motion_budget_covers(&budget, &q, &exact));
	q.v[SLOT_X] = 0;
	ck_assert(motion_budget_covers(&budget, &q, &exact));
	q.v[SLOT_X] = -4.999;
	ck_assert(motion_budget_covers(&budget, &q, &exact));
	q.v[SLOT_X] = -5;
	ck_assert(!motion_budget_covers(&budget, &q, &exact));
	motion_budget_set(&budget, &q, &state, 0);
	ck_assert(!motion_budget_covers(&budget, &q, &exact));
	motion_budget_set(&budget, &q, &state, -1);
	ck_assert(!motion_budget_covers(&budget, &q, &exact));
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("budgets");

	tcase_add_test(tcase, what_is_covered_is_apart);
	tcase_add_test(tcase, no_point_moves_farther_than_the_room);
	tcase_add_test(tcase, budget_is_not_slack);
	return run_suite("budget", tcase);
}
