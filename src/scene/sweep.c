#include "scene/sweep.h"

#include <math.h>
#include <stdlib.h>

#include "base/mem.h"
#include "scene/branch.h"
#include "scene/memory.h"

/* Halving more often than a double has bits brings nothing new. */
#define DEPTH_MAX 60

/*
 * What share of the larger branch's size the boxes may lose by moving before
 * the motion is halved. Measured: 0.06 to 0.15 are about equally good, 0.4 costs
 * four times as much where bodies nearly touch while they turn.
 */
#define LOOSE 0.1f

/* Regions kept at a time; a sweep that needs more is cut in two and done part by part. */
#define REGIONS_MAX 4096

/* Node pairs that could be looked at in the time that halving a region takes. */
#define HALVING_VISITS 20

/* Node pairs looked at, some 100 us, between two questions whether to go on. */
#define ASK_VISITS 10000

struct sweep_entry {
	struct region *region;
	struct branch a, b;
	bool tested;	/* the boxes were not found apart over this region, and `loose` is known */
	float loose;	/* mm: about what the boxes' test loses because they move */
};

/* One walk. */
struct walk {
	struct sweep *sweep;
	const struct body_pair *pair;
	double clearance, tolerance;
	struct contact *contact;
	size_t depth;	/* of the stack */
	bool any;	/* one contact is enough, early or late */
	long visits_end;	/* stop when the sweep has made so many visits; 0: never */
};

void sweep_release(struct sweep *sweep)
{
	free(sweep->stack);
	free(sweep->queue);
	for (size_t i = 0; i < sweep->region_capacity; i++)
		free(sweep->regions[i]);
	free(sweep->regions);
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

struct branch_pair *sweep_queue_reserve(struct sweep *sweep, size_t count)
{
	sweep->queue = mem_grow(sweep->queue, &sweep->queue_capacity, count, sizeof(*sweep->queue));
	return sweep->queue;
}

static struct region *new_region(struct sweep *sweep)
{
	if (sweep->region_count == sweep->region_capacity) {
		sweep->regions = mem_grow(sweep->regions, &sweep->region_slots, sweep->region_capacity + 1,
					  sizeof(struct region *));
		sweep->regions[sweep->region_capacity++] = mem_alloc(sizeof(struct region));
	}
	return sweep->regions[sweep->region_count++];
}

/* A new entry on top of the stack, for the caller to fill; entries may move. */
static struct sweep_entry *push(struct walk *walk)
{
	struct sweep *sweep = walk->sweep;

	if (walk->depth == sweep->stack_capacity)
		sweep->stack = mem_grow(sweep->stack, &sweep->stack_capacity, walk->depth + 1, sizeof(*sweep->stack));
	return &sweep->stack[walk->depth++];
}

static bool is_final(const struct walk *walk, const struct region *region)
{
	return region->reach <= 0.5 * walk->tolerance;
}

/* How a step of a walk ends. */
enum progress { GOES_ON, FINISHED, TOO_DEEP, TOO_MANY_REGIONS };

/* Later half first onto the stack, so that the earlier is looked at first. */
static enum progress push_halves(struct walk *walk, const struct sweep_entry *entry)
{
	struct region *region = entry->region;
	struct sweep_entry half = *entry;

	if (region->depth >= DEPTH_MAX)
		return TOO_DEEP;
	if (!region->halved && walk->sweep->region_count + 2 > REGIONS_MAX)
		return TOO_MANY_REGIONS;
	if (!region->halved) {
		struct region *first = new_region(walk->sweep), *second = new_region(walk->sweep);

		region_halve(region, walk->pair, first, second);
		walk->sweep->bisections++;
		walk->sweep->visits += HALVING_VISITS;
	}
	half.tested = false;
	half.region = region->halves[1];
	*push(walk) = half;
	half.region = region->halves[0];
	*push(walk) = half;
	return GOES_ON;
}

/* Opens the larger of two branches and keeps the children that are not proved apart. */
static void push_children(struct walk *walk, const struct sweep_entry *entry)
{
	bool open_a = branch_opens_first(&entry->a, &entry->b);
	const struct bvh *bvh = open_a ? walk->pair->a : walk->pair->b;
	const struct bvh_node *node = &bvh->nodes[open_a ? entry->a.leaf.first : entry->b.leaf.first];
	const struct branch kept = open_a ? entry->b : entry->a;
	struct region *region = entry->region;
	float apart[BVH_WIDTH], loose[BVH_WIDTH];

	boxes_apart(&region->boxes, open_a ? 0 : 1, node, &kept.box, (float)walk->clearance * (1 + 0x1p-20f), apart,
		    loose);
	walk->sweep->visits += node->used;
	for (int l = node->used; l-- > 0;) {
		struct sweep_entry *child;

		if (apart[l] > walk->clearance) {
			walk->sweep->certificates++;
			continue;
		}
		child = push(walk);
		child->region = region;
		child->a = open_a ? branch_child(node, l) : kept;
		child->b = open_a ? kept : branch_child(node, l);
		child->tested = true;
		child->loose = loose[l];
	}
}

static bool apart_by_boxes(struct walk *walk, struct sweep_entry *entry)
{
	walk->sweep->visits++;
	if (box_pair_apart(&entry->region->boxes, &entry->a.box, &entry->b.box, &entry->loose) > walk->clearance) {
		walk->sweep->certificates++;
		return true;
	}
	return false;
}

static bool apart_by_memory(const struct walk *walk, const struct sweep_entry *entry)
{
	struct memory *memory = walk->pair->memory;

	return memory && memory_parts_branches(memory, entry->region, walk->pair, &entry->a, &entry->b, walk->clearance);
}

/*
 * Where boxes are loose because they move, not because they are large, halving the
 * motion gains more than opening them.
 */
static bool is_loose(const struct sweep_entry *entry)
{
	float larger = entry->a.size > entry->b.size ? entry->a.size : entry->b.size;

	return entry->loose > LOOSE * larger;
}

static enum progress step(struct walk *walk, struct sweep_entry *entry)
{
	bool final = is_final(walk, entry->region);

	if (!entry->tested && apart_by_boxes(walk, entry))
		return GOES_ON;
	if (!final && is_loose(entry))
		return push_halves(walk, entry);
	if (!entry->a.leaf.count || !entry->b.leaf.count) {
		if (apart_by_memory(walk, entry))
			walk->sweep->certificates++;
		else
			push_children(walk, entry);
		return GOES_ON;
	}
	walk->sweep->visits += entry->a.leaf.count * entry->b.leaf.count;
	switch (leaf_prove(entry->region, walk->pair, entry->a.leaf, entry->b.leaf, walk->clearance, final,
			   walk->contact, &walk->sweep->certificates)) {
	case LEAF_TOUCHES:
		return walk->any ? FINISHED : GOES_ON;
	case LEAF_OPEN:
		return push_halves(walk, entry);
	case LEAF_APART:
		break;
	}
	return GOES_ON;
}

static enum progress run(struct walk *walk, struct region *whole)
{
	const struct sweep_entry root = {whole, branch_root(walk->pair->a), branch_root(walk->pair->b), false, 0};
	enum progress progress = GOES_ON;

	walk->depth = 0;
	walk->contact->s = INFINITY;
	*push(walk) = root;
	while (walk->depth && progress == GOES_ON) {
		struct sweep_entry entry = walk->sweep->stack[--walk->depth];

		if (entry.region->s0 >= walk->contact->s)
			continue;
		if (sweep_breaks_off(walk->sweep) || (walk->visits_end && walk->sweep->visits > walk->visits_end))
			return TOO_DEEP;
		progress = step(walk, &entry);
	}
	return progress;
}

/* Recursion ends: each half has one more of at most DEPTH_MAX halvings behind it. */
static enum sweep_answer sweep_region(struct walk *walk, const struct region *part)
{
	struct region *whole, first, second;
	enum sweep_answer answer;

	walk->sweep->region_count = 0;
	whole = new_region(walk->sweep);
	*whole = *part;
	switch (run(walk, whole)) {
	case GOES_ON:
	case FINISHED:
		return walk->contact->s < INFINITY ? SWEEP_CONTACT : SWEEP_APART;
	case TOO_DEEP:
		return SWEEP_UNDECIDED;
	case TOO_MANY_REGIONS:
		break;
	}
	*whole = *part;
	region_halve(whole, walk->pair, &first, &second);
	walk->sweep->bisections++;
	answer = sweep_region(walk, &first);
	return answer == SWEEP_APART ? sweep_region(walk, &second) : answer;
}

enum sweep_answer sweep_chord(struct sweep *sweep, const struct body_pair *pair, const struct chord *chord,
			      double clearance, double tolerance, struct contact *contact)
{
	struct walk walk = {.sweep = sweep, .pair = pair, .clearance = clearance, .tolerance = tolerance,
			    .contact = contact};
	struct region whole;

	region_init(&whole, pair, REGION_CHORD, chord);
	return sweep_region(&walk, &whole);
}

enum sweep_answer sweep_chord_any(struct sweep *sweep, const struct body_pair *pair, const struct chord *chord,
				  double clearance, double tolerance, struct contact *contact)
{
	struct walk walk = {.sweep = sweep, .pair = pair, .clearance = clearance, .tolerance = tolerance,
			    .contact = contact};
	struct region whole;

	walk.any = true;
	region_init(&whole, pair, REGION_CHORD, chord);
	return sweep_region(&walk, &whole);
}

enum sweep_answer sweep_box(struct sweep *sweep, const struct body_pair *pair, const axis_values *low,
			    const axis_values *high, double clearance, double tolerance, long max_visits,
			    struct contact *contact)
{
	struct walk walk = {.sweep = sweep, .pair = pair, .clearance = clearance, .tolerance = tolerance,
			    .contact = contact};
	struct chord box = {.q0 = *low, .q1 = *high};
	struct region whole;

	walk.any = true;
	if (max_visits)
		walk.visits_end = sweep->visits + max_visits;
	region_init(&whole, pair, REGION_BOX, &box);
	return sweep_region(&walk, &whole);
}
