#include <stdlib.h>

#include "check/certified/strategy.h"
#include "motion/path.h"
#include "motion_rig.h"
#include "solids.h"
#include "suite.h"

enum { INSTANTS = 400 };

/* A curved move of a machine with one solid on the table side and one on the head side, in its way or near it. */
struct curve {
	struct random random;
	uint64_t rig;
	struct machine machine;
	struct tcp tcp;
	struct path path;
	struct duo duo;
	double clearance, tolerance;
};

static axis_values random_position(struct random *random, const struct machine *machine, double linear, double rotary)
{
	axis_values q = {{0}};

	for (size_t i = 0; i < machine->axis_count; i++)
		q.v[machine->axes[i].slot] = random_in(random, -1, 1) * (machine->axes[i].rotary ? rotary : linear);
	return q;
}

/* The end of the arc follows from its start, centre, sweep and rise. */
static void make_circular(struct curve *c, double radius)
{
	struct path *path = &c->path;
	vec3 start = {path->start.v[SLOT_X], path->start.v[SLOT_Y], path->start.v[SLOT_Z]}, end, arm;
	struct canon_arc *arc = &path->arc;
	xform turn;

	path->circular = true;
	arc->normal = random_below(&c->random, 2) ? (vec3){0, 0, 1} : random_unit(&c->random);
	arc->sweep = random_sign(&c->random) * random_size(&c->random, 0.05, 8);
	arm = vec3_cross(arc->normal, random_unit(&c->random));
	arc->centre = vec3_mad(start, radius / vec3_norm(arm), arm);
	turn = xform_turn(arc->centre, arc->normal, arc->sweep);
	end = vec3_mad(xform_apply(&turn, start), random_in(&c->random, -10, 10), arc->normal);
	path->end.v[SLOT_X] = end.x;
	path->end.v[SLOT_Y] = end.y;
	path->end.v[SLOT_Z] = end.z;
}

static void curve_init(struct curve *c, uint64_t test, long number, bool tcp)
{
	struct random *random = &c->random;
	struct chain chain;
	struct mesh a, b;
	xform place_a = xform_identity(), place_b;
	axis_values near;
	double size;

	*c = (struct curve){.random = random_case(test, number)};
	c->rig = random_bits(random) | 1;
	c->machine = rig_random_machine(&c->rig, (enum rig_family)(number % RIG_FAMILIES));
	c->path.start = random_position(random, &c->machine, 100, 1);
	c->path.end = random_position(random, &c->machine, 100, 1);
	c->path.kind = tcp ? PATH_TCP : PATH_ARC;
	c->path.seconds = 1;
	if (!tcp || random_below(random, 3) == 0)
		make_circular(c, random_size(random, 1, 100));
	if (tcp) {
		struct kinematics_tcp state = {.on = true, .length = random_in(random, 0, 100)};
		struct rig_messages messages;

		rig_listen(&messages);
		require(tcp_init(&c->tcp, &c->machine, &state, (struct srcloc){0}, &messages.diag), "%s",
			messages.text);
		c->path.tcp = &c->tcp;
	}
	chain_init(&chain, &c->machine, c->machine.workholding.link, c->machine.spindle.link);
	near = path_position(&c->path, random_in(random, 0, 1));
	size = random_size(random, 2, 50);
	a = random_solid(random, size);
	b = random_solid(random, size);
	place_a = random_place(random, 100);
	place_b = place_near(random, &chain, &near, &place_a,
			     vec3_scale(size * random_in(random, 0.3, 4), random_unit(random)));
	duo_init(&c->duo, &chain, &a, &b, &place_a, &place_b);
	c->tolerance = random_below(random, 3) ? 1e-3 : random_size(random, 1e-4, 0.1);
	c->clearance = random_below(random, 2) ? 0 : random_size(random, 1e-2, 5);
}

static xform true_place(const struct curve *c, double u)
{
	axis_values q = path_position(&c->path, u);

	return duo_pose(&c->duo, &q, &q, 0, NULL);
}

static double moved_between(const struct curve *c, double u, double v)
{
	xform p = true_place(c, u), q = true_place(c, v);
	double most[2] = {0, 0};

	for (int view = 0; view < 2; view++) {
		const struct mesh *mesh = view ? &c->duo.a->mesh : &c->duo.b->mesh;

		for (size_t i = 0; i < mesh->count; i++) {
			for (int k = 0; k < 3; k++) {
				vec3 x = mesh_corner(&mesh->triangles[i], k);

				most[view] =
				    fmax(most[view], vec3_norm(vec3_sub(xform_apply(&p, x), xform_apply(&q, x))));
			}
		}
		p = xform_inverse(&p);
		q = xform_inverse(&q);
	}
	return fmin(most[0], most[1]);
}

/* Compares the result for each stretch of the curve with true positions. 1: contact. */
static int follow_curve(struct curve *c, struct sweep *sweep, long number)
{
	struct strategy strategy;
	struct span_walk walk;
	struct batch_step *steps = NULL;
	size_t capacity = 0, count = 0, leaped, next = 0;
	struct motion_step step = {.line = 1, .move = 1};
	struct contact contact = {0};
	struct span whole;
	enum query_answer answer = QUERY_CLEAR;
	double until = 1;

	span_init(&whole, &c->path);
	span_walk_init(&walk, &whole, 16 * c->tolerance);
	strategy_init(&strategy, &c->duo.pair, c->clearance, c->tolerance, number % 4 == 0);
	/* Pretends that many sweeps came before, so that planes are searched from the first step on. */
	strategy.planes.credit = number % 2 ? 1e6 : 0;
	while (span_walk_next(&walk, &step.span)) {
		steps = mem_grow(steps, &capacity, count + 1, sizeof(*steps));
		steps[count++] = (struct batch_step){.motion = step};
	}
	for (; answer == QUERY_CLEAR && next < count; next += leaped ? leaped : 1) {
		leaped = strategy_advance_chord(&strategy, sweep, &steps[next], count - next);
		if (!leaped)
			answer = strategy_advance_step(&strategy, sweep, &steps[next].motion, &contact);
	}
	if (answer != QUERY_CLEAR)
		step = steps[next - 1].motion;
	free(steps);
	strategy_release(&strategy);
	require(answer != QUERY_UNDECIDED, "case %ld: undecided", number);
	if (answer == QUERY_CONTACT) {
		xform pose;
		double d;

		until = step.span.u0 + contact.s * (step.span.u1 - step.span.u0);
		pose = true_place(c, until);
		d = brute_distance(c->duo.a, c->duo.b, &pose, INFINITY);
		require(d <= c->clearance + c->tolerance + 1e-9, "case %ld: false alarm at %g: %g, clearance %g",
			number, until, d, c->clearance);
	}
	for (int i = 0; i <= INSTANTS; i++) {
		double u = until * i / INSTANTS, d;
		xform pose = true_place(c, u);

		d = brute_distance(c->duo.a, c->duo.b, &pose, c->clearance + 1);
		if (d > c->clearance)
			continue;
		require(answer == QUERY_CONTACT, "case %ld: called clear, %g apart at %.9g", number, d, u);
		require(moved_between(c, u, until) <= c->tolerance + 1e-9,
			"case %ld: contact at %.9g, but %g apart at %.9g", number, until, d, u);
	}
	return answer == QUERY_CONTACT;
}

START_TEST(arcs)
{
	struct sweep sweep = {0};
	long touched = 0, cases = random_cases(150);

	for (long n = 0; n < cases; n++) {
		struct curve c;

		curve_init(&c, 1, n, false);
		touched += follow_curve(&c, &sweep, n);
		duo_release(&c.duo);
	}
	sweep_release(&sweep);
	require(touched > cases / 10 && touched < cases, "%ld of %ld touch", touched, cases);
}
END_TEST

START_TEST(guided_moves)
{
	struct sweep sweep = {0};
	long touched = 0, cases = random_cases(150);

	for (long n = 0; n < cases; n++) {
		struct curve c;

		curve_init(&c, 2, n, true);
		touched += follow_curve(&c, &sweep, n);
		duo_release(&c.duo);
	}
	sweep_release(&sweep);
	require(touched > cases / 10 && touched < cases, "%ld of %ld touch", touched, cases);
}
END_TEST

/* How far the control may leave the path in each axis, mm. */
#define ALLOWED 0.02

/* The largest movement of a point along the unit vector n within the tolerance. */
static double leap_along(vec3 n)
{
	return ALLOWED * (fabs(n.x) + fabs(n.y) + fabs(n.z));
}

/* A half circle in XY of a needle's tip, the origin at zero pose, whose top lies towards n. */
static struct path half_circle(vec3 n, double radius)
{
	double x = radius * n.y / hypot(n.x, n.y), y = -radius * n.x / hypot(n.x, n.y);
	struct path path = {.kind = PATH_ARC, .circular = true, .seconds = 1, .arc = {{0, 0, 0}, {0, 0, 1}, PI}};

	path.start.v[SLOT_X] = x;
	path.start.v[SLOT_Y] = y;
	path.end.v[SLOT_X] = -x;
	path.end.v[SLOT_Y] = -y;
	return path;
}

/* The needle, and a wall across n that is `gap` from its tip at the top of the half circle. */
static void needle_and_wall(struct duo *duo, const struct chain *chain, vec3 n, double radius, double gap)
{
	double flat = hypot(n.x, n.y);
	vec3 along = {-50 * n.y / flat, 50 * n.x / flat, 0}, up = vec3_cross(n, along);
	vec3 at = vec3_mad((vec3){radius * n.x / flat, radius * n.y / flat, 0}, gap, n);
	struct mesh wall = {0}, needle = {0};
	xform identity = xform_identity();

	solid_add(&needle, (vec3){0, 0, 0}, vec3_mad(along, -1, n), vec3_mad(vec3_scale(-1, along), -1, n));
	solid_add(&wall, vec3_sub(vec3_sub(at, along), up), vec3_sub(vec3_add(at, along), up), vec3_add(at, up));
	duo_init(duo, chain, &wall, &needle, &identity, &identity);
}

START_TEST(arcs_with_a_path_tolerance)
{
	struct machine machine = rig_three_axes();
	struct sweep sweep = {0};
	struct chain chain;

	chain_init(&chain, &machine, 0, machine.spindle.link);
	for (long n = 0; n < random_cases(400); n++) {
		struct random random = random_case(3, n);
		vec3 normal = n % 2 ? random_unit(&random) : vec3_scale(1 / sqrt(3), (vec3){1, 1, 1});
		double radius = random_size(&random, 5, 500);
		/* 1e-4 is for what storage in floats may do to the wall. */
		double gap = leap_along(normal) * random_in(&random, 0.9, 0.999) - 1e-4;
		struct path path = half_circle(normal, radius);
		struct motion_step step = {.line = 1, .move = 1};
		enum query_answer answer = QUERY_CLEAR;
		struct strategy strategy;
		struct span_walk walk;
		struct contact contact;
		struct span whole;
		struct duo duo;

		if (hypot(normal.x, normal.y) < 0.1)
			continue;
		needle_and_wall(&duo, &chain, normal, radius, gap);
		strategy_init(&strategy, &duo.pair, 0, 1e-3, false);
		strategy.planes.credit = 1e6;
		span_init(&whole, &path);
		span_walk_init(&walk, &whole, 16e-3);
		for (int k = 0; k < SLOT_COUNT; k++)
			step.tolerance.v[k] = ALLOWED;
		while (answer == QUERY_CLEAR && span_walk_next(&walk, &step.span))
			answer = strategy_advance_step(&strategy, &sweep, &step, &contact);
		require(answer == QUERY_CONTACT, "case %ld: a gap of %g is called clear, the control can cross %g",
			n, gap, leap_along(normal));
		strategy_release(&strategy);
		duo_release(&duo);
	}
	sweep_release(&sweep);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("true motion");

	tcase_add_test(tcase, arcs);
	tcase_add_test(tcase, guided_moves);
	tcase_add_test(tcase, arcs_with_a_path_tolerance);
	return run_suite("curved_sweep", tcase);
}
