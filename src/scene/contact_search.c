#include "scene/contact_search.h"

#include <math.h>

#include "geom/moved_tri.h"
#include "scene/coherence.h"

/* Positions that are tried, spread over the travel; from the first few of them the bodies are moved together. */
enum { SAMPLES = 32, DESCENTS = 3 };

/* Steps of one descent. Measured: of the descents that find a contact nearly all need less than half of them. */
enum { STEPS = 16 };

/* The most node pairs that the search for near triangles looks at in a step. */
#define STEP_VISITS 400

/* mm: a descent aims at a position where the nearest triangles are this deep in each other. */
#define DEPTH 0.5

/* mm: a radian counts as much as this many mm where a descent chooses among the joints. */
#define RADIAN 100.0

/*
 * The i-th number of van der Corput's sequence to this base, between 0 and 1. The first n numbers are evenly spread for
 * every n.
 */
static double spread(int i, int base)
{
	double share = 1, sum = 0;

	for (; i > 0; i /= base) {
		share /= base;
		sum += share * (i % base);
	}
	return sum;
}

/* One search. */
struct look {
	struct sweep *sweep;
	struct body_pair pair;
	struct coherence coherence;
	double clearance;
	const axis_values *low, *high;
};

static axis_values sample(const struct look *look, int i)
{
	static const int bases[SLOT_COUNT] = {2, 3, 5, 7, 11, 13, 17, 19, 23};
	axis_values q;

	for (int k = 0; k < SLOT_COUNT; k++)
		q.v[k] = look->low->v[k] + (look->high->v[k] - look->low->v[k]) * spread(i, bases[k]);
	return q;
}

static bool meets_at(const struct look *look, const axis_values *q)
{
	struct chord still = {.q0 = *q, .q1 = *q};
	struct body_pair pair = look->pair;
	struct contact contact;

	pair.coherence = NULL;
	return sweep_chord_any(look->sweep, &pair, &still, look->clearance, 1, &contact) == SWEEP_CONTACT;
}

/* mm per mm or radian: how fast each joint moves the point of b along n; all in the coordinates of a's link. */
static void rates_along(const struct chain *chain, const struct chain_state *state, vec3 n, vec3 point, double *rates)
{
	for (size_t i = 0; i < chain->count; i++) {
		vec3 way = state->direction[i];

		if (chain->joints[i].rotary)
			way = vec3_cross(way, vec3_sub(point, state->location[i]));
		rates[i] = vec3_dot(n, way);
	}
}

/*
 * Moves the joints so that the rates bring about `wanted` mm along the normal, if the travel allows it: the shortest
 * way, and what a joint at its limit cannot do the others do. False: no joint moves.
 */
static bool move_along(const struct look *look, const double *rates, double wanted, axis_values *q)
{
	const struct chain *chain = look->pair.chain;
	bool held[SLOT_COUNT] = {false}, moved = false, again = true;

	while (again) {
		double sum = 0, done = 0;

		again = false;
		for (size_t i = 0; i < chain->count; i++)
			sum += held[i] ? 0 : rates[i] * rates[i] / (chain->joints[i].rotary ? RADIAN * RADIAN : 1);
		if (!(sum > 1e-12))
			break;
		for (size_t i = 0; i < chain->count; i++) {
			int slot = chain->joints[i].slot;
			double weight = chain->joints[i].rotary ? 1 / (RADIAN * RADIAN) : 1;
			double to = q->v[slot] + wanted * rates[i] * weight / sum;
			double at = fmin(fmax(to, look->low->v[slot]), look->high->v[slot]);

			if (held[i])
				continue;
			if (fabs(at - to) > 0)
				again = held[i] = true;
			moved |= fabs(at - q->v[slot]) > 1e-9;
			done += (at - q->v[slot]) * rates[i];
			q->v[slot] = at;
		}
		wanted -= done;
	}
	return moved;
}

/* Moves the nearest triangles together, again and again; true: at *q they meet. */
static bool descends(struct look *look, axis_values *q)
{
	const struct body_pair *pair = &look->pair;

	for (int step = 0; step < STEPS; step++) {
		double rates[SLOT_COUNT];
		struct chain_state state;
		vec3 on_a, on_b, n;
		tri a, b;
		xform pose;

		sweep_distance(look->sweep, pair, q, 0.5, look->clearance, STEP_VISITS);
		if (look->coherence.near <= look->clearance)
			return meets_at(look, q);
		pose = body_pair_pose(pair, q);
		a = tri_of(&pair->a->mesh, look->coherence.near_a);
		b = tri_of(&pair->b->mesh, look->coherence.near_b);
		b = tri_transform(&b, &pose);
		tri_distance(&a, &b, &on_a, &on_b);
		n = mat3_apply(&pair->place_a.rotation, vec3_unit(vec3_sub(on_b, on_a)));
		chain_state_init(&state, pair->chain, q, &pair->ball_a, &pair->ball_b);
		rates_along(pair->chain, &state, n, xform_apply(&pair->place_a, on_b), rates);
		if (!move_along(look, rates, look->clearance - look->coherence.near - DEPTH, q))
			return false;
	}
	return false;
}

static void keep(struct contact_search *search, const axis_values *q)
{
	search->count = search->count < CONTACTS_KEPT ? search->count + 1 : CONTACTS_KEPT;
	for (int i = search->count - 1; i > 0; i--)
		search->met[i] = search->met[i - 1];
	search->met[0] = *q;
}

/* The kept position, moved into the travel: axes that did not count for the other bodies are at 0 in it. */
static axis_values kept(const struct contact_search *search, int i, const struct look *look)
{
	axis_values q;

	for (int k = 0; k < SLOT_COUNT; k++)
		q.v[k] = fmin(fmax(search->met[i].v[k], look->low->v[k]), look->high->v[k]);
	return q;
}

static bool look_around(const struct contact_search *search, struct look *look, axis_values *q)
{
	for (int i = 0; i < search->count; i++) {
		*q = kept(search, i, look);
		if (meets_at(look, q))
			return true;
	}
	if (search->count) {
		*q = kept(search, 0, look);
		if (descends(look, q))
			return true;
	}
	for (int i = 1; i <= SAMPLES; i++) {
		*q = sample(look, i);
		if (meets_at(look, q) || (i <= DESCENTS && descends(look, q)))
			return true;
	}
	return false;
}

bool contact_search_finds(struct contact_search *search, struct sweep *sweep, const struct body_pair *pair,
			  double clearance, const axis_values *low, const axis_values *high)
{
	struct look look = {.sweep = sweep, .pair = *pair, .clearance = clearance, .low = low, .high = high};
	axis_values q;

	look.pair.coherence = &look.coherence;
	if (!look_around(search, &look, &q))
		return false;
	keep(search, &q);
	return true;
}
