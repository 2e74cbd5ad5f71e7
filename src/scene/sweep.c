#include "scene/sweep.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>

#include "base/mem.h"
#include "geom/tolerance.h"
#include "scene/bvh_pair.h"
#include "scene/coherence.h"

/* More halvings of a chord, or of one joint's part of a box, than a double has bits have no effect. */
#define DEPTH_MAX 60

/*
 * The motion is halved if the box test loses more than this share of the larger subtree's size because the boxes move.
 * Measured: 0.06 to 0.15 perform alike; 0.4 costs four times as much where bodies nearly touch while they rotate.
 */
#define LOST 0.1

/* The largest number of intervals in one walk; a sweep that needs more is divided into parts. */
#define INTERVALS_MAX 4096

/* Halving an interval takes as long as visiting this number of node pairs. */
#define HALVING_VISITS 20

/* The number of node pairs until the caller is asked again whether to stop: about 100 us. */
#define ASK_VISITS 10000

struct sweep_entry {
	struct motion_interval *interval;
	struct subtree a, b;
	bool tested;	/* the boxes were not proved apart over this interval, and `lost` is known */
	float lost;	/* mm: roughly how much the boxes' test loses because the boxes move */
};

/* One walk. */
struct walk {
	struct sweep *sweep;
	const struct body_pair *pair;
	double clearance, tolerance;
	double coherence_margin;	/* mm: what the remembered axes must prove beyond the clearance */
	struct contact *contact;
	size_t depth;	/* the stack's entries in use */
	size_t intervals;	/* made so far */
	bool any;	/* any contact will do, early or late */
	double lost;	/* share of the larger subtree: halve the motion if the box test loses more (LOST) */
	int depth_max;	/* of intervals */
	long visits_end;	/* stop at this many visits of the sweep */
	double from, to;	/* of a chord: look only at intervals that have an instant between these */
};

void sweep_release(struct sweep *sweep)
{
	free(sweep->stack);
	free(sweep->queue);
	interval_pool_release(&sweep->intervals);
	*sweep = (struct sweep){0};
}

bool sweep_breaks_off(struct sweep *sweep)
{
	if (sweep->visits >= sweep->ask_at) {
		sweep->ask_at = sweep->visits + ASK_VISITS;
		sweep->broken_off = sweep->broken_off || cancel_asked(sweep->cancel);
	}
	return sweep->broken_off;
}

struct bvh_pair *sweep_queue_reserve(struct sweep *sweep, size_t count)
{
	sweep->queue = mem_grow(sweep->queue, &sweep->queue_capacity, count, sizeof(*sweep->queue));
	return sweep->queue;
}

/* Adds an entry for the interval to the stack; the caller fills in the rest. Other entries may move. */
static struct sweep_entry *push(struct walk *walk, struct motion_interval *interval)
{
	struct sweep *sweep = walk->sweep;
	struct sweep_entry *entry;

	if (walk->depth == sweep->stack_capacity)
		sweep->stack = mem_grow(sweep->stack, &sweep->stack_capacity, walk->depth + 1, sizeof(*sweep->stack));
	entry = &sweep->stack[walk->depth++];
	entry->interval = interval;
	interval_pool_share(interval);
	return entry;
}

static bool is_final(const struct walk *walk, const struct motion_interval *interval)
{
	return interval->reach <= 0.5 * walk->tolerance;
}

/* How a step of a walk ends. */
enum progress { GOES_ON, FINISHED, TOO_DEEP, TOO_MANY_INTERVALS };

/* Pushes the later half first, so that the earlier one is examined first. */
static enum progress push_halves(struct walk *walk, const struct sweep_entry *entry)
{
	struct interval_pool *pool = &walk->sweep->intervals;
	struct motion_interval *interval = entry->interval;

	if (interval->depth >= walk->depth_max)
		return TOO_DEEP;
	if (!interval->halved && walk->intervals + 2 > INTERVALS_MAX)
		return TOO_MANY_INTERVALS;
	if (!interval->halved) {
		motion_interval_halve(interval, walk->pair, interval_pool_take(pool), interval_pool_take(pool));
		walk->intervals += 2;
		walk->sweep->bisections++;
		walk->sweep->visits += HALVING_VISITS;
	}
	for (int i = 2; i-- > 0;) {
		struct sweep_entry *half = push(walk, interval->halves[i]);

		half->a = entry->a;
		half->b = entry->b;
		half->tested = false;
	}
	return GOES_ON;
}

/* mm: points that are farther apart than this need no closer examination in the interval. */
static double required_in(const struct walk *walk, const struct motion_interval *interval)
{
	return walk->clearance + interval->path;
}

/* Opens the larger of two subtrees, and pushes the children that are not proved apart. */
static void push_children(struct walk *walk, const struct sweep_entry *entry)
{
	bool open_a = bvh_pair_opens_a(&entry->a, &entry->b);
	const struct bvh *bvh = open_a ? walk->pair->a : walk->pair->b;
	const struct bvh_node *node = &bvh->nodes[open_a ? entry->a.leaf.first : entry->b.leaf.first];
	const struct subtree kept = open_a ? entry->b : entry->a;
	struct motion_interval *interval = entry->interval;
	double required = required_in(walk, interval);
	float apart[BVH_WIDTH], lost[BVH_WIDTH];

	boxes_apart(&interval->boxes, open_a ? 0 : 1, node, &kept.box, (float)required * (1 + FLOAT_MARGIN), apart,
		    lost);
	walk->sweep->visits += node->used;
	for (int l = node->used; l-- > 0;) {
		struct sweep_entry *child;

		if (apart[l] > required) {
			walk->sweep->certificates++;
			continue;
		}
		child = push(walk, interval);
		child->a = open_a ? subtree_child(node, l) : kept;
		child->b = open_a ? kept : subtree_child(node, l);
		child->tested = true;
		child->lost = lost[l];
	}
}

static bool apart_by_boxes(struct walk *walk, struct sweep_entry *entry)
{
	walk->sweep->visits++;
	if (box_pair_apart(&entry->interval->boxes, &entry->a.box, &entry->b.box, &entry->lost) >
	    required_in(walk, entry->interval)) {
		walk->sweep->certificates++;
		return true;
	}
	return false;
}

static bool apart_by_coherence(const struct walk *walk, const struct sweep_entry *entry)
{
	struct coherence *coherence = walk->pair->coherence;

	return coherence && coherence_separates_subtrees(coherence, entry->interval, walk->pair, &entry->a, &entry->b,
					       required_in(walk, entry->interval) + walk->coherence_margin);
}

/*
 * If the box test loses much because the boxes move, not because they are large, halving the motion gains more than
 * opening the boxes.
 */
static bool is_loose(const struct walk *walk, const struct sweep_entry *entry)
{
	float larger = entry->a.size > entry->b.size ? entry->a.size : entry->b.size;

	return entry->lost > walk->lost * larger;
}

static enum progress step(struct walk *walk, struct sweep_entry *entry)
{
	bool final = is_final(walk, entry->interval);

	if (!entry->tested && apart_by_boxes(walk, entry))
		return GOES_ON;
	if (!final && is_loose(walk, entry))
		return push_halves(walk, entry);
	if (!entry->a.leaf.count || !entry->b.leaf.count) {
		if (apart_by_coherence(walk, entry))
			walk->sweep->certificates++;
		else
			push_children(walk, entry);
		return GOES_ON;
	}
	walk->sweep->visits += entry->a.leaf.count * entry->b.leaf.count;
	switch (tri_pair_prove(entry->interval, walk->pair, entry->a.leaf, entry->b.leaf,
			   &(struct tri_pair_query){walk->clearance, walk->coherence_margin, final}, walk->contact,
			   &walk->sweep->certificates)) {
	case TRI_PAIR_TOUCHES:
		return walk->any ? FINISHED : GOES_ON;
	case TRI_PAIR_OPEN:
		return push_halves(walk, entry);
	case TRI_PAIR_APART:
		break;
	}
	return GOES_ON;
}

/* Can the entry's interval be skipped, because it is after the first contact or outside the part to examine? */
static bool is_left_out(const struct walk *walk, const struct motion_interval *interval)
{
	return interval->s0 >= walk->contact->s || interval->s1 < walk->from || interval->s0 > walk->to;
}

/* Makes one step, unless the walk must stop. */
static enum progress limited_step(struct walk *walk, struct sweep_entry *entry)
{
	struct sweep *sweep = walk->sweep;

	if (sweep_breaks_off(sweep))
		return TOO_DEEP;
	if (sweep->visits > walk->visits_end) {
		sweep->exhausted = true;
		return TOO_DEEP;
	}
	return step(walk, entry);
}

/* Continues with the contact that was found so far. */
static enum progress run_walk(struct walk *walk, const struct motion_interval *part)
{
	struct sweep *sweep = walk->sweep;
	struct motion_interval *whole = interval_pool_copy(&sweep->intervals, part);
	struct sweep_entry *root = push(walk, whole);
	enum progress progress = GOES_ON;

	root->a = subtree_root(walk->pair->a);
	root->b = subtree_root(walk->pair->b);
	root->tested = false;
	walk->intervals = 1;
	interval_pool_leave(&sweep->intervals, whole);
	while (walk->depth && progress == GOES_ON) {
		struct sweep_entry entry = sweep->stack[--walk->depth];

		if (!is_left_out(walk, entry.interval))
			progress = limited_step(walk, &entry);
		interval_pool_leave(&sweep->intervals, entry.interval);
	}
	while (walk->depth)
		interval_pool_leave(&sweep->intervals, sweep->stack[--walk->depth].interval);
	return progress;
}

static enum sweep_answer answer_of(const struct walk *walk, enum progress progress)
{
	if (progress == TOO_DEEP)
		return SWEEP_UNDECIDED;
	return walk->contact->s < INFINITY ? SWEEP_CONTACT : SWEEP_APART;
}

/*
 * Sweeps the chord from `from` to `to`, in parts if there are too many intervals. Every part begins with the whole
 * chord and halves it in the same way, so the parts together examine the same nodes and triangles over the same
 * intervals as one walk: the limit of intervals changes no result. The recursion ends, because a part of 2^-50 of the
 * chord has a few hundred intervals around it and a thousand in it.
 */
static enum progress run_part(struct walk *walk, const struct motion_interval *whole, double from, double to)
{
	double middle = 0.5 * (from + to);
	enum progress progress;

	walk->from = from;
	walk->to = to;
	progress = run_walk(walk, whole);
	if (progress != TOO_MANY_INTERVALS)
		return progress;
	progress = run_part(walk, whole, from, middle);
	if (progress != GOES_ON || walk->contact->s <= middle)
		return progress;
	return run_part(walk, whole, middle, to);
}

static enum sweep_answer sweep_over(struct walk *walk, const struct chord *chord)
{
	enum progress progress;
	struct motion_interval whole;
	double first;

	motion_interval_init(&whole, walk->pair, INTERVAL_CHORD, chord);
	walk->from = 0;
	walk->to = 1;
	walk->contact->s = INFINITY;
	progress = run_walk(walk, &whole);
	if (progress != TOO_MANY_INTERVALS)
		return answer_of(walk, progress);
	progress = run_part(walk, &whole, 0, 0.5);
	if (progress == GOES_ON && walk->contact->s > 0.5)
		progress = run_part(walk, &whole, 0.5, 1);
	if (progress != GOES_ON || walk->any || !(walk->contact->s < INFINITY))
		return answer_of(walk, progress);
	/*
	 * If several pairs of triangles touch at the first instant, returns the one that a single walk would meet
	 * first.
	 */
	first = walk->contact->s;
	walk->contact->s = INFINITY;
	return answer_of(walk, run_part(walk, &whole, first, first));
}

/*
 * The recursion ends: every half is halved once more, at most depth_max times. Its intervals are not on the stack,
 * which some threads have little of.
 */
static enum sweep_answer sweep_parts(struct walk *walk, const struct motion_interval *part)
{
	struct interval_pool *pool = &walk->sweep->intervals;
	struct motion_interval *whole;
	enum progress progress;
	enum sweep_answer answer;

	walk->contact->s = INFINITY;
	progress = run_walk(walk, part);
	if (progress != TOO_MANY_INTERVALS)
		return answer_of(walk, progress);
	if (part->depth >= walk->depth_max)
		return SWEEP_UNDECIDED;
	whole = interval_pool_copy(pool, part);
	motion_interval_halve(whole, walk->pair, interval_pool_take(pool), interval_pool_take(pool));
	walk->sweep->bisections++;
	answer = sweep_parts(walk, whole->halves[0]);
	if (answer == SWEEP_APART)
		answer = sweep_parts(walk, whole->halves[1]);
	interval_pool_leave(pool, whole);
	return answer;
}

/* The number of visits at which a query that may take `most` visits stops (0: the sweep's effort is the limit). */
static long visits_end(const struct sweep *sweep, long most)
{
	if (sweep->effort && (!most || sweep->effort < most))
		most = sweep->effort;
	return most ? sweep->visits + most : LONG_MAX;
}

enum sweep_answer sweep_chord(struct sweep *sweep, const struct body_pair *pair, const struct chord *chord,
			      double clearance, double tolerance, struct contact *contact)
{
	struct walk walk = {.sweep = sweep, .pair = pair, .clearance = clearance, .tolerance = tolerance,
			    .contact = contact, .coherence_margin = tolerance, .lost = LOST, .depth_max = DEPTH_MAX,
			    .visits_end = visits_end(sweep, 0)};

	return sweep_over(&walk, chord);
}

enum sweep_answer sweep_chord_any(struct sweep *sweep, const struct body_pair *pair, const struct chord *chord,
				  double clearance, double tolerance, struct contact *contact)
{
	struct walk walk = {.sweep = sweep, .pair = pair, .clearance = clearance, .tolerance = tolerance,
			    .contact = contact, .any = true, .lost = LOST, .depth_max = DEPTH_MAX,
			    .visits_end = visits_end(sweep, 0)};

	return sweep_over(&walk, chord);
}

enum sweep_answer sweep_box(struct sweep *sweep, const struct body_pair *pair, const struct swept_box *box,
			    double clearance, double tolerance, struct contact *contact)
{
	struct walk walk = {.sweep = sweep, .pair = pair, .clearance = clearance, .tolerance = tolerance,
			    .contact = contact, .any = true, .lost = box->lost, .to = 1,
			    .depth_max = DEPTH_MAX * (int)pair->chain->count,
			    .visits_end = visits_end(sweep, box->max_visits)};
	const struct chord positions = {.q0 = *box->low, .q1 = *box->high};
	struct motion_interval whole;

	motion_interval_init(&whole, pair, INTERVAL_BOX, &positions);
	return sweep_parts(&walk, &whole);
}
