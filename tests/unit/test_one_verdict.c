#include "check/certified/strategy.h"

#include <string.h>

#include "base/units.h"
#include "check/step.h"
#include "first_contact.h"
#include "geom/moved_tri.h"
#include "step_program.h"
#include "suite.h"

/*
 * Programs near contact: where the first step begins, the distance of the bodies is the required one, plus or minus a
 * few tolerances. A quick method that proved a little less than the sweep needs would change the verdict there.
 */
struct near_program {
	struct program p;
	struct path paths[STEPS];
	struct batch_step steps[STEPS];
};

/*
 * The closed form: the sum over the joints of tolerance times lever, for the corner where the sum is largest, in the
 * better of both views; for linear joints the largest sum of their vectors.
 */
static double closed_form(const struct duo *duo, const axis_values *q, const axis_values *tolerance)
{
	const struct chain *chain = &duo->chain;
	const struct bvh *bodies[VIEWS] = {duo->b, duo->a};
	const xform *places[VIEWS] = {&duo->pair.place_b, &duo->pair.place_a};
	double most[VIEWS] = {0, 0};

	for (int view = 0; view < VIEWS; view++) {
		for (size_t t = 0; t < 3 * bodies[view]->mesh.count; t++) {
			vec3 corner = mesh_corner(&bodies[view]->mesh.triangles[t / 3], (int)(t % 3));
			vec3 p = xform_apply(places[view], corner);
			double sum = 0;

			for (size_t n = 0; n < chain->count; n++) {
				size_t i = view ? n : chain->count - 1 - n;
				const struct joint *joint = &chain->joints[i];
				struct chain one = {1, {*joint}};
				xform motion = chain_pose(&one, q), back = xform_inverse(&motion);

				if (joint->rotary)
					sum += tolerance->v[joint->slot] *
					       vec3_norm(vec3_cross(vec3_sub(p, joint->location), joint->direction));
				p = xform_apply(view ? &back : &motion, p);
			}
			most[view] = fmax(most[view], sum);
		}
		for (size_t i = 0; i < chain->count;) {
			size_t end = chain->joints[i].rotary ? i + 1 : linear_run_end(chain, i);

			most[view] += chain->joints[i].rotary ? 0 : linear_displacement(chain, i, end, tolerance);
			i = end;
		}
	}
	return fmin(most[0], most[1]);
}

/* The shortest vector (in a's mesh coordinates) from a to b at q. */
static vec3 way_between(const struct duo *duo, const axis_values *q)
{
	xform pose = body_pair_pose(&duo->pair, q);
	double least = INFINITY;
	vec3 way = {0, 0, 0};

	for (size_t i = 0; i < duo->a->mesh.count; i++) {
		tri a = tri_of(&duo->a->mesh, i);

		for (size_t j = 0; j < duo->b->mesh.count; j++) {
			tri b = tri_of(&duo->b->mesh, j);
			vec3 on_a, on_b;
			double distance;

			b = tri_transform(&b, &pose);
			distance = tri_distance(&a, &b, &on_a, &on_b);
			if (distance < least) {
				least = distance;
				way = vec3_sub(on_b, on_a);
			}
		}
	}
	return way;
}

/* Moves b toward a, until they are `wanted` mm apart at q. False: they meet. */
static bool bring_near(struct duo *duo, const axis_values *q, double wanted)
{
	for (int round = 0; round < 50; round++) {
		xform pose = body_pair_pose(&duo->pair, q), chain = chain_pose(&duo->chain, q), back = xform_inverse(&chain);
		vec3 way = way_between(duo, q);
		double distance = vec3_norm(way);
		xform place;

		if (!(distance > 0))
			return false;
		if (fabs(distance - wanted) < 1e-9)
			break;
		pose.translation = vec3_mad(pose.translation, (wanted - distance) / distance, way);
		place = xform_mul(&duo->pair.place_a, &pose);
		place = xform_mul(&back, &place);
		body_pair_init(&duo->pair, duo->a, duo->b, &duo->pair.place_a, &place, &duo->chain);
	}
	return true;
}

/*
 * Every second program slides within a few tolerances of contact, without a clearance: there even a coarse distance is
 * a budget for some of its steps.
 */
static bool slide_at_contact(struct program *p, const axis_values *allowed)
{
	double wanted = closed_form(&p->duo, &p->corners[0], allowed) + p->tolerance * random_in(&p->random, 0.05, 2);
	double most = 0;

	for (int k = 0; k < SLOT_COUNT; k++)
		most = fmax(most, fabs(p->corners[1].v[k] - p->corners[0].v[k]) * (slot_is_rotary(k) ? 100 : 1));
	for (int i = 1; i <= STEPS; i++)
		for (int k = 0; k < SLOT_COUNT; k++)
			p->corners[i].v[k] = p->corners[0].v[k] + (p->corners[i].v[k] - p->corners[0].v[k]) *
									   0.05 * p->tolerance / fmax(most, 1e-9);
	p->clearance = 0;
	return bring_near(&p->duo, &p->corners[0], wanted);
}

/* False: the bodies meet at the start of the program. */
static bool near_program_init(struct near_program *n, uint64_t test, long number)
{
	struct program *p = &n->p;
	struct random *random = &p->random;
	axis_values allowed = {{0}};
	double size, distance;
	xform pose;

	program_init(p, test, number);
	p->tolerance = random_size(random, 1e-3, 0.3);
	size = random_below(random, 5) ? random_size(random, 1e-3, 1) : 0;
	for (size_t k = 0; k < p->duo.chain.count; k++)
		allowed.v[p->duo.chain.joints[k].slot] = size * (p->duo.chain.joints[k].rotary ? 0.017 : 1);
	if (number % 2 && !slide_at_contact(p, &allowed))
		return false;
	for (int i = 0; i < STEPS; i++) {
		n->paths[i] = path_between(&p->corners[i], &p->corners[i + 1], PATH_STRAIGHT);
		n->steps[i] = (struct batch_step){.motion = step_on(&n->paths[i])};
		if (!i || random_below(random, 8))
			n->steps[i].motion.tolerance = allowed;
	}
	if (number % 2)
		return true;
	pose = duo_pose(&p->duo, &p->corners[0], &p->corners[0], 0, NULL);
	distance = brute_distance(p->duo.a, p->duo.b, &pose, INFINITY);
	p->clearance = distance - closed_form(&p->duo, &p->corners[0], &allowed) -
		       p->tolerance * random_in(random, -1, 4);
	return p->clearance >= 0;
}

/* The answer of the sweep alone for a step: nothing is remembered from other steps. */
static enum query_answer sweep_alone(struct near_program *n, struct sweep *sweep, int step, struct contact *contact)
{
	struct body_pair bodies = n->p.duo.pair;
	const struct clearance_query query = {.sweep = sweep, .bodies = &bodies, .clearance = n->p.clearance,
					.tolerance = n->p.tolerance};

	bodies.coherence = NULL;
	return clearance_query_step(&query, &n->steps[step].motion, contact);
}

static void require_apart(struct near_program *n, struct sweep *sweep, int first, int count, const char *what, long number)
{
	for (int i = first; i < first + count; i++) {
		struct contact contact;

		require(sweep_alone(n, sweep, i, &contact) == QUERY_CLEAR,
			"case %ld: %s passed step %d, the sweep reports it at %.12g: %.9g mm, required %.9g, tolerance %.9g",
			number, what, i, contact.s, contact.distance, n->p.clearance, n->p.tolerance);
	}
}

/* Offers the next few steps as one chunk. */
static int offer_chunk(struct near_program *n, struct strategy *strategy, int first)
{
	struct position_errors errors = {.any = false};
	axis_values low = n->p.corners[first], high = low;
	int count = 1 + random_below(&n->p.random, 6);

	count = first + count > STEPS ? STEPS - first : count;
	for (int i = first; i < first + count; i++) {
		for (int k = 0; k < SLOT_COUNT; k++) {
			low.v[k] = fmin(low.v[k], n->p.corners[i + 1].v[k]);
			high.v[k] = fmax(high.v[k], n->p.corners[i + 1].v[k]);
			errors.path.v[k] = fmax(errors.path.v[k], n->steps[i].motion.tolerance.v[k]);
			errors.any |= errors.path.v[k] > 0;
		}
	}
	return strategy_advance_box(strategy, &low, &high, &errors, &n->p.corners[first + count], (size_t)count,
				    random_below(&n->p.random, 2))
		       ? count
		       : 0;
}

struct counts {
	long chunks, merged, steps, contacts;
};

/* False: a contact, and the program ends. */
static bool take_step(struct near_program *n, struct strategy *strategy, struct sweep *sweep, struct sweep *alone, int i,
		      long number, struct counts *counts)
{
	struct contact contact, truth;

	if (strategy_advance_step(strategy, sweep, &n->steps[i].motion, &contact) == QUERY_CLEAR) {
		require_apart(n, alone, i, 1, "a step", number);
		counts->steps++;
		return true;
	}
	require(sweep_alone(n, alone, i, &truth) == QUERY_CONTACT, "case %ld: step %d is reported, the sweep does not", number,
		i);
	require(!memcmp(&contact.s, &truth.s, sizeof(double)) && !memcmp(&contact.q, &truth.q, sizeof(axis_values)) &&
			!memcmp(&contact.distance, &truth.distance, sizeof(double)) &&
			!memcmp(&contact.point, &truth.point, sizeof(vec3)),
		"case %ld: step %d is reported at %.17g, by the sweep at %.17g", number, i, contact.s, truth.s);
	counts->contacts++;
	return false;
}

/*
 * Every step that a strategy passes, by budgets, chunks, merged steps or memory, is one that the sweep alone finds
 * apart.
 */
START_TEST(quick_ways_pass_only_what_the_sweep_does)
{
	struct sweep sweep = {0}, alone = {0};
	struct counts counts = {0};
	long cases = random_cases(150);

	for (long number = 0; number < cases; number++) {
		struct near_program n;
		struct strategy strategy;
		bool usable = near_program_init(&n, 1, number);

		strategy_init(&strategy, &n.p.duo.pair, n.p.clearance, n.p.tolerance, number % 5 == 0);
		/* As if many sweeps had preceded: planes are searched from the first step on. */
		strategy.planes.credit = number % 2 ? 1e6 : 0;
		for (int i = 0; usable && i < STEPS;) {
			int passed = random_below(&n.p.random, 2) ? 0 : offer_chunk(&n, &strategy, i);

			require_apart(&n, &alone, i, passed, "a chunk", number);
			counts.chunks += passed;
			if (!passed) {
				passed = (int)strategy_advance_chord(&strategy, &sweep, &n.steps[i], (size_t)(STEPS - i));
				require_apart(&n, &alone, i, passed, "merging", number);
				counts.merged += passed;
			}
			i += passed;
			if (passed || i == STEPS)
				continue;
			if (!take_step(&n, &strategy, &sweep, &alone, i++, number, &counts))
				break;
			if (!random_below(&n.p.random, 10))
				strategy_forget_position(&strategy);
		}
		strategy_release(&strategy);
		duo_release(&n.p.duo);
	}
	sweep_release(&sweep);
	sweep_release(&alone);
	require(counts.chunks > cases / 4 && counts.merged > cases / 4 && counts.steps > cases && counts.contacts > cases / 8,
		"chunks %ld, merged %ld, steps %ld, contacts %ld", counts.chunks, counts.merged, counts.steps, counts.contacts);
}
END_TEST

/* A step is swept as a whole, or cut into pieces as in a program: each finding is within its closed form. */
START_TEST(findings_are_within_the_closed_form)
{
	struct sweep sweep = {0};
	long contacts = 0, pieces_found = 0, cases = random_cases(150);

	for (long number = 0; number < cases; number++) {
		struct near_program n;
		bool usable = near_program_init(&n, 2, number);

		for (int i = 0; usable && i < 6; i++) {
			const struct motion_step whole = n.steps[i].motion;
			int pieces = i % 2 ? 1 : 1 + random_below(&n.p.random, 50);

			for (int k = 0; k < pieces; k++) {
				struct path path = n.paths[i];
				struct contact contact;
				double most;

				for (int j = 0; j < SLOT_COUNT; j++) {
					double q0 = whole.span.q0.v[j], q1 = whole.span.q1.v[j];

					path.start.v[j] = q0 + (q1 - q0) * k / pieces;
					path.end.v[j] = q0 + (q1 - q0) * (k + 1) / pieces;
				}
				n.steps[i].motion = step_on(&path);
				n.steps[i].motion.tolerance = whole.tolerance;
				if (sweep_alone(&n, &sweep, i, &contact) != QUERY_CONTACT)
					continue;
				most = n.p.clearance + closed_form(&n.p.duo, &contact.q, &whole.tolerance) + n.p.tolerance;
				require(contact.distance <= most + 1e-9,
					"case %ld, step %d, piece %d of %d: false alarm at %.9g mm, at most %.9g", number, i, k,
					pieces, contact.distance, most);
				contacts++;
				pieces_found += pieces > 1;
				break;
			}
			n.steps[i].motion = whole;
		}
		duo_release(&n.p.duo);
	}
	sweep_release(&sweep);
	require(contacts > cases / 2 && pieces_found > cases / 8, "%ld contacts, %ld in pieces", contacts, pieces_found);
}
END_TEST

/* The displacement that is reported with a finding is that of the closed form, too. */
START_TEST(path_displacement_of_a_pair)
{
	for (long number = 0; number < random_cases(100); number++) {
		struct near_program n;

		near_program_init(&n, 3, number);
		for (int i = 0; i < 3; i++) {
			const axis_values *q = &n.p.corners[i], *tolerance = &n.steps[0].motion.tolerance;
			double given = body_pair_path_displacement(&n.p.duo.pair, q, tolerance);
			double most = closed_form(&n.p.duo, q, tolerance);

			require(fabs(given - most) <= 1e-9 * (1 + most), "case %ld: %.12g, is %.12g", number, given, most);
		}
		duo_release(&n.p.duo);
	}
}
END_TEST

/*
 * A plate of 60 mm from its axis to its corners is turned by C; above it is a head 600 mm long, carried by X and Z.
 * With 0.02 mm and 0.02 degrees the control can bring them nearer by at most 60 * radians(0.02) + 0.02 * sqrt(2) =
 * 0.0492 mm, and by less near the axis: 0.0427 mm where the head ends, 41 mm from it.
 */
START_TEST(a_long_head_over_a_small_plate)
{
	const struct chain chain = {.count = 3, .joints = {{SLOT_C, true, {0, 0, -1}, {0, 0, 0}},
							   {SLOT_X, false, {1, 0, 0}, {0, 0, 0}},
							   {SLOT_Z, false, {0, 0, 1}, {0, 0, 0}}}};
	const axis_values tolerance = {{[SLOT_X] = 0.02, [SLOT_Z] = 0.02, [SLOT_C] = radians(0.02)}};
	static const struct {
		double gap;
		bool found;
	} cases[] = {{0.3, false}, {0.06, false}, {0.0505, false}, {0.042, true}, {0.02, true}};
	struct mesh plate = {0}, head = {0};
	xform identity = xform_identity(), below = identity, above = identity;
	struct sweep sweep = {0};
	struct duo duo;

	below.translation.z = -20;
	solid_box(&plate, (vec3){60 * sqrt(0.5), 60 * sqrt(0.5), 20});
	solid_place(&plate, &below);
	above.translation.z = 300;
	solid_box(&head, (vec3){10, 10, 300});
	solid_place(&head, &above);
	duo_init(&duo, &chain, &plate, &head, &identity, &identity);
	for (size_t i = 0; i < COUNT(cases); i++) {
		for (int pieces = 1; pieces <= 3000; pieces *= 3000) {
			bool found = false;

			for (int k = 0; k < pieces && !found; k++) {
				double s = (double)k / pieces, t = (k + 1.0) / pieces;
				axis_values from = {{[SLOT_X] = 30 * s, [SLOT_Z] = cases[i].gap, [SLOT_C] = s}};
				axis_values to = {{[SLOT_X] = 30 * t, [SLOT_Z] = cases[i].gap, [SLOT_C] = t}};
				const struct chord chord = {.q0 = from, .q1 = to, .tolerance = &tolerance};
				struct contact contact;

				found = sweep_chord(&sweep, &duo.pair, &chord, 0, 1e-3, &contact) == SWEEP_CONTACT;
			}
			ck_assert_msg(found == cases[i].found, "%g mm, %d pieces: %d", cases[i].gap, pieces, found);
		}
	}
	sweep_release(&sweep);
	duo_release(&duo);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("verdicts");

	tcase_add_test(tcase, quick_ways_pass_only_what_the_sweep_does);
	tcase_add_test(tcase, findings_are_within_the_closed_form);
	tcase_add_test(tcase, path_displacement_of_a_pair);
	tcase_add_test(tcase, a_long_head_over_a_small_plate);
	return run_suite("one_verdict", tcase);
}
