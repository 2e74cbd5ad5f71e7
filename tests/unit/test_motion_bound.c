#include "machine/motion_bound.h"

#include "suite.h"
#include "truth.h"

enum { POINTS = 8, TIMES = 9 };

/* A random chain with a motion, and the bounds for it. */
struct scene_of_chain {
	struct random random;
	long number;
	struct chain chain;
	struct ball ball[2];	/* of the fixed and of the moved body */
	axis_values q0, q1, chord_error;
	struct chain_state start, end;
};

static void set_up(struct scene_of_chain *c, uint64_t test, long number)
{
	double way;

	c->random = random_case(test, number);
	c->number = number;
	c->chain = random_chain(&c->random, 1 + random_below(&c->random, 5), 300);
	way = random_size(&c->random, 0.01, 300);
	random_move(&c->random, &c->chain, way, &c->q0, &c->q1);
	c->chord_error = (axis_values){{0}};
	for (size_t i = 0; i < c->chain.count && random_below(&c->random, 3); i++)
		c->chord_error.v[c->chain.joints[i].slot] =
			random_size(&c->random, 1e-4, 1) * (c->chain.joints[i].rotary ? 0.1 : 10);
	for (int k = 0; k < 2; k++)
		c->ball[k] = (struct ball){random_point(&c->random, 300), random_size(&c->random, 0.1, 300)};
	/* For a ball near an axis, the joints that carry it away from that axis count most. */
	if (!random_below(&c->random, 4)) {
		c->ball[1] = (struct ball){c->chain.joints[0].location, random_size(&c->random, 0.01, 1)};
		for (size_t i = 1; i < c->chain.count; i++) {
			int slot = c->chain.joints[i].slot;

			c->q0.v[slot] = c->q1.v[slot] = 0;
			c->chord_error.v[slot] *= c->chain.joints[i].rotary ? 1 : 30;
		}
	}
	chain_state_init(&c->start, &c->chain, &c->q0, &c->ball[0], &c->ball[1]);
	chain_state_init(&c->end, &c->chain, &c->q1, &c->ball[0], &c->ball[1]);
}

/*
 * Points of the moving ball of this view, in the coordinates of its body: its centre, points straight away from the
 * axis of each joint, which move most, and random points.
 */
static void choose_points(struct scene_of_chain *c, int view, vec3 points[POINTS])
{
	const struct ball *ball = &c->ball[view == 0 ? 1 : 0];
	int n = 0;

	points[n++] = ball->centre;
	for (size_t i = 0; i < c->chain.count && n < POINTS - 2; i++) {
		const struct joint *joint = &c->chain.joints[i];
		vec3 to = vec3_sub(ball->centre, joint->location), out;
		double length;

		out = vec3_mad(to, -vec3_dot(to, joint->direction), joint->direction);
		length = vec3_norm(out);
		if (length > 1e-3)
			points[n++] = vec3_mad(ball->centre, ball->radius / length, out);
	}
	for (; n < POINTS; n++) {
		double share = random_below(&c->random, 2) ? 1 : random_in(&c->random, 0, 1);

		points[n] = vec3_mad(ball->centre, ball->radius * share, random_unit(&c->random));
	}
}

static real3 place_of(const struct turned *pose, int view, vec3 point)
{
	return view == 0 ? turned_apply(pose, real3_of(point)) : turned_back(pose, real3_of(point));
}

/* Records the greatest ratio of seen to bound; a ratio that rounding cannot explain fails the test. */
static void observe(const struct scene_of_chain *c, const char *what, double seen, double bound, double *ratio)
{
	require(seen <= bound * (1 + 1e-12) + 1e-10, "case %ld: %s %.17g exceeds its bound %.17g", c->number, what,
		      seen, bound);
	if (bound > 1e-6)
		*ratio = fmax(*ratio, seen / bound);
}

START_TEST(pose_is_the_product_of_exponentials)
{
	for (long n = 0; n < random_cases(30000); n++) {
		struct random random = random_case(1, n);
		struct chain chain = random_chain(&random, 1 + random_below(&random, 9), 1000);
		axis_values q0, q1;
		struct turned truth;
		xform pose;
		vec3 p = random_point(&random, 500);
		double off;

		random_move(&random, &chain, 300, &q0, &q1);
		pose = chain_pose(&chain, &q0);
		truth = true_pose(&chain, &q0, &q1, 0, NULL);
		off = (double)real3_norm(real3_sub(turned_apply(&truth, real3_of(p)), real3_of(xform_apply(&pose, p))));
		require(off < 1e-10, "case %ld: a point is off by %g mm", n, off);
	}
}
END_TEST

/*
 * rho of a joint: the distance of a point of the moving body from the axis, with all joints beyond it at their
 * positions.
 */
START_TEST(no_point_is_farther_from_an_axis)
{
	double tightest = 0;

	for (long n = 0; n < random_cases(20000); n++) {
		struct scene_of_chain c;

		set_up(&c, 2, n);
		for (int view = 0; view < VIEWS; view++) {
			vec3 points[POINTS];

			choose_points(&c, view, points);
			for (size_t i = 0; i < c.chain.count; i++) {
				const struct joint *joint = &c.chain.joints[i];
				struct chain beyond = {.count = view == 0 ? c.chain.count - i - 1 : i};
				struct turned pose;

				for (size_t k = 0; k < beyond.count; k++)
					beyond.joints[k] = c.chain.joints[view == 0 ? i + 1 + k : k];
				pose = true_pose(&beyond, &c.q0, &c.q0, 0, NULL);
				for (int p = 0; p < POINTS && joint->rotary; p++) {
					real3 to =
					    real3_sub(place_of(&pose, view, points[p]), real3_of(joint->location));
					real3 across = real3_cross(real3_of(joint->direction), to);

					observe(&c, "rho", (double)real3_norm(across), c.start.rho[view][i], &tightest);
				}
			}
		}
	}
	require(tightest > 0.99, "rho is slack: %g", tightest);
}
END_TEST

static axis_values random_off(struct random *random, const axis_values *chord_error)
{
	axis_values off;

	for (int k = 0; k < SLOT_COUNT; k++)
		off.v[k] =
		    chord_error->v[k] * (random_below(random, 2) ? random_sign(random) : random_in(random, -1, 1));
	return off;
}

struct chord_tightness {
	double length, chord_error, displacement;
};

static void watch_chord(struct scene_of_chain *c, struct chord_tightness *t)
{
	struct chord_bound bound;
	double lengths[VIEWS] = {0, 0};
	struct turned poses[TIMES], strayed[TIMES];

	chord_bound_init(&bound, &(struct joint_chord){
		.chain = &c->chain, .start = &c->start, .end = &c->end,
		.q0 = &c->q0, .q1 = &c->q1, .chord_error = &c->chord_error,
	});
	for (int i = 0; i < TIMES; i++) {
		axis_values off = random_off(&c->random, &c->chord_error);

		poses[i] = true_pose(&c->chain, &c->q0, &c->q1, (real)i / (TIMES - 1), NULL);
		strayed[i] = true_pose(&c->chain, &c->q0, &c->q1, (real)i / (TIMES - 1), &off);
	}
	for (int view = 0; view < VIEWS; view++) {
		vec3 points[POINTS];

		choose_points(c, view, points);
		for (int p = 0; p < POINTS; p++) {
			real3 first = place_of(&poses[0], view, points[p]),
			      last = place_of(&poses[TIMES - 1], view, points[p]);
			real3 before = first;
			double way = 0;

			for (int i = 0; i < TIMES; i++) {
				real s = (real)i / (TIMES - 1);
				real3 at = place_of(&poses[i], view, points[p]),
				      off = place_of(&strayed[i], view, points[p]);
				real3 chord = real3_add(real3_scale(1 - s, first), real3_scale(s, last));

				way += (double)real3_norm(real3_sub(at, before));
				before = at;
				observe(c, "chord_error", (double)real3_norm(real3_sub(at, chord)), bound.chord_error[view],
					&t->chord_error);
				observe(c, "displacement", (double)real3_norm(real3_sub(off, at)), bound.displacement[view],
					&t->displacement);
				observe(c, "stray", (double)real3_norm(real3_sub(off, chord)),
					bound.chord_error[view] + bound.displacement[view], &(double){0});
			}
			lengths[view] = fmax(lengths[view], way);
		}
	}
	/* In at least one of the two views no point moves farther than the better bound. */
	observe(c, "length", fmin(lengths[0], lengths[1]), bound.length, &t->length);
}

START_TEST(chord_bounds_hold_and_are_tight)
{
	struct chord_tightness t = {0, 0, 0};

	for (long n = 0; n < random_cases(30000); n++) {
		struct scene_of_chain c;

		set_up(&c, 3, n);
		watch_chord(&c, &t);
	}
	require(t.length > 0.9 && t.chord_error > 0.9 && t.displacement > 0.9, "slack: length %g, chord_error %g, displacement %g", t.length,
		      t.chord_error, t.displacement);
}
END_TEST

/* The path displacement of a point at an instant, against the bound over a motion for all points and instants. */
START_TEST(path_displacements)
{
	double tightest = 0;

	for (long n = 0; n < random_cases(20000); n++) {
		struct scene_of_chain c;
		struct chord_bound bound;
		axis_values tolerance;

		set_up(&c, 6, n);
		for (int k = 0; k < SLOT_COUNT; k++)
			tolerance.v[k] = c.chord_error.v[k] * random_in(&c.random, 0, 2);
		chord_bound_init(&bound, &(struct joint_chord){
			.chain = &c.chain, .start = &c.start, .end = &c.end,
			.q0 = &c.q0, .q1 = &c.q1, .chord_error = &c.chord_error, .tolerance = &tolerance,
		});
		for (int view = 0; view < VIEWS; view++) {
			vec3 points[POINTS];

			choose_points(&c, view, points);
			for (int i = 0; i < TIMES; i++) {
				axis_values off = random_off(&c.random, &c.chord_error),
					    more = random_off(&c.random, &tolerance), q;
				struct turned pose, strayed;
				struct chain_state state;
				real s = (real)i / (TIMES - 1);

				for (int k = 0; k < SLOT_COUNT; k++) {
					q.v[k] = (double)((1 - s) * c.q0.v[k] + s * c.q1.v[k]) + off.v[k];
					more.v[k] += off.v[k];
				}
				pose = true_pose(&c.chain, &c.q0, &c.q1, s, &off);
				strayed = true_pose(&c.chain, &c.q0, &c.q1, s, &more);
				chain_state_init(&state, &c.chain, &q, &c.ball[0], &c.ball[1]);
				for (int p = 0; p < POINTS; p++) {
					vec3 x = view ? points[p] : xform_apply(&state.pose, points[p]);
					double at = path_displacement(&c.chain, &state, x, &tolerance);
					double moved = (double)real3_norm(real3_sub(place_of(&strayed, view, points[p]),
										    place_of(&pose, view, points[p])));

					observe(&c, "a point's path displacement", moved, at, &tightest);
					require(at <= bound.path[view] * (1 + 1e-9) + 1e-12,
						"case %ld: path displacement %.12g, bound %.12g", n, at,
						bound.path[view]);
				}
			}
		}
	}
	require(tightest > 0.9, "slack: %g", tightest);
}
END_TEST

/* The same formula with the joints numbered from the moved body, for which the bound does not hold. */
static double bend_numbered_backwards(const struct scene_of_chain *c, int view)
{
	double turned = 0, acceleration = 0;

	for (size_t n = 0; n < c->chain.count; n++) {
		size_t i = view == 0 ? c->chain.count - 1 - n : n;
		const struct joint *joint = &c->chain.joints[i];
		double step = fabs(c->q1.v[joint->slot] - c->q0.v[joint->slot]);
		double rho = fmax(c->start.rho[view][i], c->end.rho[view][i]), way = joint->rotary ? step * rho : step;

		acceleration += 2 * turned * way + (joint->rotary ? step * way : 0);
		turned += joint->rotary ? step : 0;
	}
	return acceleration / 8;
}

START_TEST(numbering_matters)
{
	long violated = 0, cases = random_cases(20000);

	for (long n = 0; n < cases; n++) {
		struct scene_of_chain c;
		vec3 points[POINTS];
		struct turned poses[3];
		double bound;

		set_up(&c, 4, n);
		for (int i = 0; i < 3; i++)
			poses[i] = true_pose(&c.chain, &c.q0, &c.q1, 0.5L * i, NULL);
		choose_points(&c, 0, points);
		bound = bend_numbered_backwards(&c, 0);
		for (int p = 0; p < POINTS; p++) {
			real3 first = place_of(&poses[0], 0, points[p]), last = place_of(&poses[2], 0, points[p]);
			real3 chord = real3_scale(0.5L, real3_add(first, last));

			if ((double)real3_norm(real3_sub(place_of(&poses[1], 0, points[p]), chord)) > bound + 1e-6) {
				violated++;
				break;
			}
		}
	}
	require(violated > cases / 1000, "only %ld of %ld", violated, cases);
}
END_TEST

/*
 * The part of the linear joints: each moves by its own amount along its direction at this position, as seen in the
 * view.
 */
static real3 linear_share(const struct scene_of_chain *c, int view, const axis_values *off)
{
	real3 share = {0, 0, 0};

	for (size_t i = 0; i < c->chain.count; i++)
		if (!c->chain.joints[i].rotary)
			share = real3_add(
			    share, real3_scale(off->v[c->chain.joints[i].slot], real3_of(c->start.direction[i])));
	if (view == 1) {
		struct turned pose = true_pose(&c->chain, &c->q0, &c->q0, 0, NULL);

		pose.shift = (real3){0, 0, 0};
		share = real3_scale(-1, turned_back(&pose, share));
	}
	return share;
}

/* The directions of the joints at this position, as seen in the view. */
static void joint_directions(const struct scene_of_chain *c, int view, vec3 directions[SLOT_COUNT])
{
	struct turned pose = true_pose(&c->chain, &c->q0, &c->q0, 0, NULL);

	pose.shift = (real3){0, 0, 0};
	for (size_t i = 0; i < c->chain.count; i++) {
		real3 d = real3_of(c->start.direction[i]);

		directions[i] = real3_round(view == 0 ? d : turned_back(&pose, d));
	}
}

/* The largest distance by which the turns of the rotary joints can move a point along n. */
static double turns_along(const struct scene_of_chain *c, const struct box_bound *bound, int view,
			  const vec3 directions[SLOT_COUNT], vec3 n)
{
	double most = 0;

	for (size_t i = 0; i < c->chain.count; i++)
		most += bound->turn[view][i] * vec3_norm(vec3_cross(directions[i], n));
	return most;
}

struct box_tightness {
	double reach, turn;
};

static void watch_box(struct scene_of_chain *c, const axis_values *half, int view, struct box_tightness *t)
{
	struct turned middle = true_pose(&c->chain, &c->q0, &c->q0, 0, NULL);
	vec3 points[POINTS], directions[SLOT_COUNT];
	struct box_bound bound;

	box_bound_init(&bound, &c->chain, &c->start, half);
	choose_points(c, view, points);
	joint_directions(c, view, directions);
	for (int i = 0; i < TIMES; i++) {
		axis_values off = random_off(&c->random, half);
		struct turned pose = true_pose(&c->chain, &c->q0, &c->q0, 0, &off);
		real3 share = linear_share(c, view, &off);

		for (int p = 0; p < POINTS; p++) {
			real3 way = real3_sub(place_of(&pose, view, points[p]), place_of(&middle, view, points[p]));
			vec3 turn = real3_round(real3_sub(way, share));
			double length = vec3_norm(turn);
			vec3 along = length > 1e-6 ? vec3_scale(1 / length, turn) : random_unit(&c->random);
			vec3 n = random_below(&c->random, 2) ? along : random_unit(&c->random);

			observe(c, "reach", (double)real3_norm(way), bound.reach[view], &t->reach);
			observe(c, "turn", vec3_dot(turn, n), turns_along(c, &bound, view, directions, n), &t->turn);
		}
	}
}

START_TEST(box_bounds_hold_and_are_tight)
{
	struct box_tightness t = {0, 0};

	for (long n = 0; n < random_cases(30000); n++) {
		struct scene_of_chain c;
		axis_values half = {{0}};

		set_up(&c, 5, n);
		for (size_t i = 0; i < c.chain.count; i++)
			half.v[c.chain.joints[i].slot] =
				random_size(&c.random, 1e-3, 1) * (c.chain.joints[i].rotary ? 1.2 * PI : 300);
		watch_box(&c, &half, 0, &t);
		watch_box(&c, &half, 1, &t);
	}
	require(t.turn > 0.9 && t.reach > 0.9, "slack: turn %g, reach %g", t.turn, t.reach);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("bounds");

	tcase_add_test(tcase, pose_is_the_product_of_exponentials);
	tcase_add_test(tcase, no_point_is_farther_from_an_axis);
	tcase_add_test(tcase, chord_bounds_hold_and_are_tight);
	tcase_add_test(tcase, path_displacements);
	tcase_add_test(tcase, numbering_matters);
	tcase_add_test(tcase, box_bounds_hold_and_are_tight);
	return run_suite("motion_bound", tcase);
}
