#include "geom/tolerance.h"
#include "scene/sweep.h"

#include <float.h>
#include <limits.h>
#include <math.h>

#include "base/minmax.h"
#include "geom/moved_tri.h"
#include "scene/coherence.h"

/*
 * If the distance of the remembered triangles has grown by this factor, they are probably not the closest ones any
 * more.
 */
#define STALE 1.25

/* One search. */
struct search {
	struct sweep *sweep;
	const struct body_pair *pair;
	xform pose;
	struct box_motion boxes;
	double share;	/* share of the distance that must be proven */
	double found;	/* mm: two triangles are this close */
	vec3 direction;	/* from one triangle to the other, a unit vector; 0: unknown */
	double proven;	/* mm: everything dismissed so far is farther than this */
	size_t depth;
};

static void push_subtrees(struct search *search, const struct subtree *a, const struct subtree *b, float least)
{
	sweep_queue_reserve(search->sweep, search->depth + 1)[search->depth] = (struct bvh_pair){*a, *b, least};
	search->depth++;
}

/* Can a pair with this lower bound of its distance be dismissed? If so, the bound counts as proved. */
static bool dismiss(struct search *search, double least)
{
	if (least < search->share * search->found)
		return false;
	search->proven = smaller(search->proven, least);
	return true;
}

/* mm: the gap between two subtrees along an axis that helped before. */
static double gap_of(const struct search *search, const struct subtree *a, const struct subtree *b)
{
	if (!search->pair->coherence)
		return 0;
	return coherence_gap(search->pair->coherence, &search->pose, search->pair, &a->box, &b->box);
}

/* Opens the larger subtree. Its nearest child is pushed last, so it is examined first. */
static void push_children(struct search *search, const struct bvh_pair *entry)
{
	bool open_a = bvh_pair_opens_a(&entry->a, &entry->b);
	const struct bvh *bvh = open_a ? search->pair->a : search->pair->b;
	const struct subtree *opened = open_a ? &entry->a : &entry->b, *kept = open_a ? &entry->b : &entry->a;
	const struct bvh_node *node = &bvh->nodes[opened->leaf.first];
	float apart[BVH_WIDTH], lost[BVH_WIDTH];
	int order[BVH_WIDTH];

	boxes_apart(&search->boxes, open_a ? 0 : 1, node, &kept->box,
		    (float)(search->share * search->found) * (1 + FLOAT_MARGIN), apart, lost);
	search->sweep->visits += node->used;
	for (int i = 0; i < node->used; i++) {
		int at = i;

		for (; at > 0 && apart[order[at - 1]] < apart[i]; at--)
			order[at] = order[at - 1];
		order[at] = i;
	}
	for (int i = 0; i < node->used; i++) {
		int lane = order[i];
		struct subtree child;

		if (dismiss(search, apart[lane]))
			continue;
		child = subtree_child(node, lane);
		if (dismiss(search, gap_of(search, open_a ? &child : kept, open_a ? kept : &child)))
			continue;
		push_subtrees(search, open_a ? &child : kept, open_a ? kept : &child, apart[lane]);
	}
}

static void remember(const struct search *search, size_t i, size_t j, vec3 direction)
{
	struct coherence *coherence = search->pair->coherence;

	if (!coherence)
		return;
	coherence->near_a = (uint32_t)i;
	coherence->near_b = (uint32_t)j;
	coherence_learn(coherence, direction, &search->pose);
}

/* The triangles that were close last time give an upper bound of the distance before the search begins. */
static void recall(struct search *search)
{
	const struct coherence *coherence = search->pair->coherence;
	vec3 on_a, on_b;
	tri a, b;

	if (!coherence)
		return;
	a = tri_of(&search->pair->a->mesh, coherence->near_a);
	b = tri_of(&search->pair->b->mesh, coherence->near_b);
	b = tri_transform(&b, &search->pose);
	search->found = tri_distance(&a, &b, &on_a, &on_b);
	search->direction = vec3_unit(vec3_sub(on_b, on_a));
}

static void measure_triangles(struct search *search, size_t i, size_t j, const tri *a, const tri *b)
{
	vec3 on_a, on_b, direction;
	double distance = tri_distance(a, b, &on_a, &on_b), gap;

	direction = vec3_unit(vec3_sub(on_b, on_a));
	if (distance < search->found) {
		search->found = distance;
		search->direction = direction;
		remember(search, i, j, direction);
	}
	/* The proof is the gap along an axis, not the distance that the triangle test computes. */
	gap = tri_gap(a, b, direction);
	if (!(gap >= search->proven))
		search->proven = gap > 0 ? gap : 0;
}

/*
 * Are the triangles no closer than the closest so far, as seen along the direction of its distance? Measured: this
 * holds for most triangles of a part, and a projection costs a twentieth of a distance.
 */
static bool is_behind(struct search *search, const tri *a, const tri *b)
{
	const double gap = tri_gap(a, b, search->direction);

	if (gap < search->found)
		return false;
	search->proven = smaller(search->proven, gap);
	return true;
}

static void measure_leaves(struct search *search, struct leaf a, struct leaf b)
{
	tri of_b[BVH_LEAF_SIZE];

	for (int j = 0; j < b.count; j++) {
		tri t = tri_of(&search->pair->b->mesh, b.first + (size_t)j);

		of_b[j] = tri_transform(&t, &search->pose);
	}
	for (int i = 0; i < a.count; i++) {
		tri of_a = tri_of(&search->pair->a->mesh, a.first + (size_t)i);

		for (int j = 0; j < b.count; j++)
			if (!dismiss(search, tri_box_gap(&of_a, &of_b[j], &of_b[j])) &&
			    !is_behind(search, &of_a, &of_b[j]))
				measure_triangles(search, a.first + (size_t)i, b.first + (size_t)j, &of_a, &of_b[j]);
	}
}

/* Replaces the larger subtree by the child whose box is nearest to the other subtree. */
static void go_nearer(struct search *search, struct bvh_pair *at)
{
	const bool open_a = bvh_pair_opens_a(&at->a, &at->b);
	struct subtree *opened = open_a ? &at->a : &at->b;
	const struct subtree *kept = open_a ? &at->b : &at->a;
	const struct bvh *bvh = open_a ? search->pair->a : search->pair->b;
	const struct bvh_node *node = &bvh->nodes[opened->leaf.first];
	float apart[BVH_WIDTH], lost[BVH_WIDTH];
	int nearest = 0;

	boxes_apart(&search->boxes, open_a ? 0 : 1, node, &kept->box, FLT_MAX, apart, lost);
	search->sweep->visits += node->used;
	for (int i = 1; i < node->used; i++)
		nearest = apart[i] < apart[nearest] ? i : nearest;
	*opened = subtree_child(node, nearest);
}

/*
 * If the bodies have moved on without distance queries, the triangles that were close last time are not close any more.
 * Then the required share of their distance may be nearly the whole distance of the bodies. Proving this takes long,
 * and the search may meet no closer triangles on the way. So a pair of triangles that are roughly the closest is found
 * first.
 */
static void look_nearer(struct search *search)
{
	const struct coherence *coherence = search->pair->coherence;
	struct bvh_pair at = {subtree_root(search->pair->a), subtree_root(search->pair->b), 0};
	tri a, b;

	if (!coherence || search->found <= STALE * coherence->near)
		return;
	while (!at.a.leaf.count || !at.b.leaf.count)
		go_nearer(search, &at);
	a = tri_of(&search->pair->a->mesh, at.a.leaf.first);
	b = tri_of(&search->pair->b->mesh, at.b.leaf.first);
	b = tri_transform(&b, &search->pose);
	measure_triangles(search, at.a.leaf.first, at.b.leaf.first, &a, &b);
}

double sweep_distance(struct sweep *sweep, const struct body_pair *pair, const axis_values *q, double share,
		      double enough, long max_visits)
{
	struct search search = {.sweep = sweep, .pair = pair, .share = share, .found = INFINITY, .proven = INFINITY};
	struct subtree a = subtree_root(pair->a), b = subtree_root(pair->b);
	const vec3 no_axis_displacement[VIEWS] = {{0, 0, 0}, {0, 0, 0}};
	const double no_displacement[VIEWS] = {0, 0};
	long visits_end = max_visits ? sweep->visits + max_visits : LONG_MAX;
	double rounding;
	xform ends[2];

	search.pose = ends[0] = ends[1] = body_pair_pose(pair, q);
	rounding = body_pair_rounding(pair, q, search.pose.translation);
	box_motion_init(&search.boxes, pair->a, pair->b, ends, no_axis_displacement, no_displacement);
	push_subtrees(&search, &a, &b, 0);
	recall(&search);
	look_nearer(&search);
	while (search.depth && search.found > enough && sweep->visits < visits_end && !sweep_breaks_off(sweep)) {
		struct bvh_pair entry = sweep->queue[--search.depth];

		if (dismiss(&search, entry.least))
			continue;
		if (entry.a.leaf.count && entry.b.leaf.count)
			measure_leaves(&search, entry.a.leaf, entry.b.leaf);
		else
			push_children(&search, &entry);
	}
	if (pair->coherence)
		pair->coherence->near = search.found;
	return search.depth ? 0 : larger(search.proven - rounding, 0);
}

void sweep_nearest_triangles(struct sweep *sweep, const struct body_pair *pair, const axis_values *q, double share,
			     struct nearest_triangles *nearest)
{
	struct body_pair bodies = *pair;
	struct coherence coherence = {0};
	xform pose;

	bodies.coherence = &coherence;
	sweep_distance(sweep, &bodies, q, share, 0, 0);
	pose = body_pair_pose(pair, q);
	nearest->a = tri_of(&pair->a->mesh, coherence.near_a);
	nearest->b = tri_of(&pair->b->mesh, coherence.near_b);
	nearest->b = tri_transform(&nearest->b, &pose);
	nearest->distance = tri_distance(&nearest->a, &nearest->b, &nearest->on_a, &nearest->on_b);
}

void sweep_nearest(struct sweep *sweep, const struct body_pair *pair, struct contact *contact)
{
	struct nearest_triangles nearest;

	sweep_nearest_triangles(sweep, pair, &contact->q, 1, &nearest);
	if (nearest.distance < contact->distance) {
		contact->distance = nearest.distance;
		contact->point = vec3_lerp(nearest.on_a, nearest.on_b, 0.5);
	}
}
