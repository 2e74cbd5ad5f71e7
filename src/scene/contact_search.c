#include "scene/contact_search.h"

#include <math.h>

#include "base/minmax.h"
#include "geom/moved_tri.h"
#include "scene/coherence.h"

/*
 * The number of positions that are tried, spread over the travel, and of those from which the bodies are moved
 * together.
 */
enum { SAMPLES = 32, DESCENTS = 3 };

/* Steps of one descent. Measured: nearly all descents that find a contact need less than half of them. */
enum { STEPS = 16 };

/* The largest number of node pairs for the search for close triangles in one step. */
#define STEP_VISITS 400

/* mm: a descent aims at a position where the closest triangles overlap by this depth. */
#define DEPTH 0.5

/* mm: the weight of a radian when a descent chooses among the joints. */
#define RADIAN 100.0

/*
 * The i-th number of van der Corput's sequence to this base, between 0 and 1. For every n the first n numbers are
 * spread evenly.
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

/* Both bodies at one position of the axes. */
struct pose_look {
	const struct body_pair *pair;
	xform pose;
	struct box_motion boxes;
	double clearance;
};

/* Are the corners of b on both sides of the plane of a? If not, the triangles hardly ever meet. */
static bool plane_parts(const tri *a, const tri *b)
{
	vec3 n = vec3_cross(vec3_sub(a->p[1], a->p[0]), vec3_sub(a->p[2], a->p[0]));
	double d0 = vec3_dot(n, vec3_sub(b->p[0], a->p[0])), d1 = vec3_dot(n, vec3_sub(b->p[1], a->p[0]));
	double d2 = vec3_dot(n, vec3_sub(b->p[2], a->p[0]));

	return smaller(d0, smaller(d1, d2)) <= 0 && larger(d0, larger(d1, d2)) >= 0;
}

static bool triangles_meet(const struct pose_look *at, const tri *a, const tri *b)
{
	vec3 on_a, on_b;

	if (tri_box_gap(a, b, b) > at->clearance)
		return false;
	if (at->clearance > 0)
		return tri_distance(a, b, &on_a, &on_b) <= at->clearance;
	return plane_parts(a, b) && plane_parts(b, a) && tri_meet(a, b);
}

static bool leaves_meet(const struct pose_look *at, struct leaf a, struct leaf b)
{
	for (int j = 0; j < b.count; j++) {
		tri of_b = tri_of(&at->pair->b->mesh, b.first + (size_t)j);

		of_b = tri_transform(&of_b, &at->pose);
		for (int i = 0; i < a.count; i++) {
			tri of_a = tri_of(&at->pair->a->mesh, a.first + (size_t)i);

			if (triangles_meet(at, &of_a, &of_b))
				return true;
		}
	}
	return false;
}

/* Queues the children of the larger subtree that may be close enough; returns the new length of the queue. */
static size_t queue_children(struct sweep *sweep, const struct pose_look *at, const struct bvh_pair *entry,
			     size_t depth)
{
	bool open_a = bvh_pair_opens_a(&entry->a, &entry->b);
	const struct subtree *opened = open_a ? &entry->a : &entry->b, *kept = open_a ? &entry->b : &entry->a;
	const struct bvh_node *node = &(open_a ? at->pair->a : at->pair->b)->nodes[opened->leaf.first];
	struct bvh_pair *queue = sweep_queue_reserve(sweep, depth + BVH_WIDTH);
	float apart[BVH_WIDTH], lost[BVH_WIDTH];

	boxes_apart(&at->boxes, open_a ? 0 : 1, node, &kept->box, (float)at->clearance, apart, lost);
	sweep->visits += node->used;
	for (int i = 0; i < node->used; i++) {
		struct subtree child;

		if (apart[i] > at->clearance)
			continue;
		child = subtree_child(node, i);
		queue[depth++] = open_a ? (struct bvh_pair){child, *kept, 0} : (struct bvh_pair){*kept, child, 0};
	}
	return depth;
}

/*
 * Do the surfaces meet at q? A sweep would also find the first contact, and a distance query the distance, but both
 * cost several times as much for bodies that overlap deeply.
 */
static bool meets_at(const struct look *look, const axis_values *q)
{
	struct pose_look at = {.pair = &look->pair, .clearance = look->clearance};
	const vec3 no_axis_displacement[VIEWS] = {{0, 0, 0}, {0, 0, 0}};
	const double no_displacement[VIEWS] = {0, 0};
	struct sweep *sweep = look->sweep;
	xform ends[2];
	size_t depth = 1;

	at.pose = ends[0] = ends[1] = body_pair_pose(&look->pair, q);
	box_motion_init(&at.boxes, look->pair.a, look->pair.b, ends, no_axis_displacement, no_displacement);
	*sweep_queue_reserve(sweep, 1) =
	    (struct bvh_pair){subtree_root(look->pair.a), subtree_root(look->pair.b), 0};
	while (depth && !sweep_breaks_off(sweep)) {
		const struct bvh_pair entry = sweep->queue[--depth];

		if (!entry.a.leaf.count || !entry.b.leaf.count)
			depth = queue_children(sweep, &at, &entry, depth);
		else if (leaves_meet(&at, entry.a.leaf, entry.b.leaf))
			return true;
	}
	return false;
}

/*
 * mm per mm or radian: the speed at which each joint moves the point of b along n; all in the coordinates of a's link.
 */
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
 * Moves the joints so that the point moves by `wanted` mm along the normal, according to the rates and within the
 * travel. The motion is the shortest one; if a joint reaches its limit, the others do the rest. False: no joint moves.
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

/* Moves the closest triangles together repeatedly. True: the bodies meet at *q. */
static bool descends(struct look *look, int steps, axis_values *q)
{
	const struct body_pair *pair = &look->pair;

	for (int step = 0; step < steps; step++) {
		double rates[SLOT_COUNT];
		struct chain_state state;
		vec3 on_a, on_b, n;
		tri a, b;
		xform pose;

		sweep_distance(look->sweep, pair, q, 0.5, look->clearance, STEP_VISITS);
		if (look->coherence.near <= look->clearance)
			return true;
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

static void keep_contact(struct contact_search *search, const axis_values *q)
{
	search->count = search->count < CONTACTS_KEPT ? search->count + 1 : CONTACTS_KEPT;
	for (int i = search->count - 1; i > 0; i--)
		search->met[i] = search->met[i - 1];
	search->met[0] = *q;
}

/* The position, moved into the travel. Axes that did not matter for the other bodies are at 0 in it. */
static axis_values within_travel(const axis_values *near, const struct look *look)
{
	axis_values q;

	for (int k = 0; k < SLOT_COUNT; k++)
		q.v[k] = fmin(fmax(near->v[k], look->low->v[k]), look->high->v[k]);
	return q;
}

/* Do the bodies meet where similar bodies met, or at one of the samples? */
static bool look_around(const struct contact_search *search, struct look *look, axis_values *q)
{
	for (int i = 0; i < search->count; i++) {
		*q = within_travel(&search->met[i], look);
		if (meets_at(look, q))
			return true;
	}
	for (int i = 1; i <= SAMPLES; i++) {
		*q = sample(look, i);
		if (meets_at(look, q))
			return true;
	}
	return false;
}

/* Can the bodies be moved together from where similar bodies met, or from one of the first samples? */
static bool move_together(const struct contact_search *search, struct look *look, axis_values *q)
{
	if (search->count) {
		*q = within_travel(&search->met[0], look);
		if (descends(look, STEPS, q))
			return true;
	}
	for (int i = 1; i <= DESCENTS; i++) {
		*q = sample(look, i);
		if (descends(look, STEPS, q))
			return true;
	}
	return false;
}

bool contact_search_recalls(struct contact_search *search, struct sweep *sweep, const struct body_pair *pair,
			    double clearance, const axis_values *low, const axis_values *high, const axis_values *near,
			    int steps)
{
	struct look look = {.sweep = sweep, .pair = *pair, .clearance = clearance, .low = low, .high = high};
	axis_values q = within_travel(near, &look);

	look.pair.coherence = &look.coherence;
	if (!meets_at(&look, &q) && !descends(&look, steps, &q))
		return false;
	keep_contact(search, &q);
	return true;
}

bool contact_search_finds(struct contact_search *search, struct sweep *sweep, const struct body_pair *pair,
			  double clearance, const axis_values *low, const axis_values *high, bool moves)
{
	struct look look = {.sweep = sweep, .pair = *pair, .clearance = clearance, .low = low, .high = high};
	axis_values q = *low;

	look.pair.coherence = &look.coherence;
	if (moves ? !move_together(search, &look, &q) : !look_around(search, &look, &q))
		return false;
	keep_contact(search, &q);
	return true;
}
