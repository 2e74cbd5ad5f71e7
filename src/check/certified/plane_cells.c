#include "check/certified/plane_cells.h"

#include <math.h>

#include <stdlib.h>
#include <string.h>

#include "base/ablation.h"
#include "base/mem.h"
#include "base/minmax.h"
#include "check/certified/plane_search.h"
#include "scene/body_shapes.h"

/*
 * Measured on a program whose nozzle slides over a turning table: with whole bodies only, the check takes 3 times as
 * long; with cells without profiles, 4 times; with one kept plane, a fifth longer. 12 kept planes save a twentieth.
 */
enum { CELLS_MOST = 48, PLANES_KEPT = 4 };

/* The cell of the whole bodies is searched again after at most this number of searches of the front. */
enum { WHOLE_BACKOFF_MAX = 64 };

struct plane_cell {
	size_t part[2];
	bool divided;	/* smaller cells have replaced it */
	int idle, backoff;	/* searches to leave out now, and after the next failed one */
	int count, newest;
	struct kept_plane kept[PLANES_KEPT];
};

void plane_cells_init(struct plane_cells *cells, const struct body_pair *bodies)
{
	*cells = (struct plane_cells){.bodies = bodies};
}

void plane_cells_release(struct plane_cells *cells)
{
	for (int i = 0; i < 2; i++)
		body_shapes_release(cells->shapes[i]);
	free(cells->parts);
	free(cells->cells);
	*cells = (struct plane_cells){.bodies = cells->bodies};
}

void plane_cells_copy(struct plane_cells *to, const struct plane_cells *from)
{
	*to = *from;
	for (int i = 0; i < 2; i++)
		if (to->shapes[i])
			body_shapes_hold(to->shapes[i]);
	if (!from->cell_count)
		return;
	to->parts = mem_realloc(NULL, from->part_count, sizeof(*to->parts));
	to->cells = mem_realloc(NULL, from->cell_count, sizeof(*to->cells));
	to->part_capacity = from->part_count;
	to->cell_capacity = from->cell_count;
	memcpy(to->parts, from->parts, from->part_count * sizeof(*to->parts));
	memcpy(to->cells, from->cells, from->cell_count * sizeof(*to->cells));
}

void plane_cells_join(struct plane_cells *cells)
{
	if (!cells->cell_count)
		return;
	cells->cell_count = 1;
	cells->cells[0].divided = false;
	cells->cells[0].idle = cells->cells[0].backoff = 0;
}

static const struct bvh *bvh_of(const struct plane_cells *cells, int body)
{
	return body ? cells->bodies->b : cells->bodies->a;
}

static const xform *place_of(const struct plane_cells *cells, int body)
{
	return body ? &cells->bodies->place_b : &cells->bodies->place_a;
}

/* The joint next to a body. */
static const struct joint *joint_next_to(const struct plane_cells *cells, int body)
{
	const struct chain *chain = cells->bodies->chain;

	return &chain->joints[body ? chain->count - 1 : 0];
}

/* The shapes of the body that all its pairs share, or else new ones. */
static struct body_shapes *shapes_of(const struct plane_cells *cells, int body)
{
	const struct body_pair *bodies = cells->bodies;

	return bodies->shapes[body] ? body_shapes_hold(bodies->shapes[body])
				    : body_shapes_new(bvh_of(cells, body), place_of(cells, body));
}

/* The profile of a leaf, or of the whole tree. */
static void init_profile(struct plane_cells *cells, int body, struct leaf leaf, struct profile *profile)
{
	const struct joint *joint = joint_next_to(cells, body);
	const bool whole = !leaf.count && leaf.first == 0;

	if (whole)
		body_shapes_profile(cells->shapes[body], joint->location, joint->direction, profile, &cells->visits);
	else
		profile_init(profile, bvh_of(cells, body), leaf, place_of(cells, body), joint->location,
			     joint->direction, &cells->visits);
}

static void add_part(struct plane_cells *cells, int body, struct leaf leaf)
{
	const struct corner_runs *corners = body_shapes_corners(cells->shapes[body]);
	struct plane_part *part;

	cells->parts =
	    mem_grow(cells->parts, &cells->part_capacity, cells->part_count + 1, sizeof(*cells->parts));
	part = &cells->parts[cells->part_count++];
	*part = (struct plane_part){.body = body, .mesh = mesh_part_of(bvh_of(cells, body), corners, leaf),
				    .has_profile = WITH_PROFILES && joint_next_to(cells, body)->rotary};
	if (part->has_profile)
		init_profile(cells, body, leaf, &part->profile);
}

static void add_cell(struct plane_cells *cells, size_t a, size_t b)
{
	cells->cells =
	    mem_grow(cells->cells, &cells->cell_capacity, cells->cell_count + 1, sizeof(*cells->cells));
	cells->cells[cells->cell_count++] = (struct plane_cell){.part = {a, b}};
}

static bool cell_covers(struct plane_cell *cell, const struct chain *chain, const struct plane_motion *motion,
			double needed)
{
	for (int i = 0; i < cell->count; i++) {
		int k = (cell->newest + i) % cell->count;

		if (travelling_plane_rest(&cell->kept[k].plane, chain, motion, needed) > needed) {
			cell->newest = k;
			return true;
		}
	}
	return false;
}

/* The cell that failed last is tested first next time. */
static void move_to_front(struct plane_cells *cells, size_t i)
{
	struct plane_cell keep;

	if (i <= 1)
		return;
	keep = cells->cells[1];
	cells->cells[1] = cells->cells[i];
	cells->cells[i] = keep;
}

bool plane_cells_cover(struct plane_cells *cells, const struct plane_motion *motion, double needed)
{
	const struct chain *chain = cells->bodies->chain;

	if (!cells->cell_count)
		return false;
	if (cell_covers(&cells->cells[0], chain, motion, needed))
		return true;
	if (!cells->cells[0].divided)
		return false;
	for (size_t i = 1; i < cells->cell_count; i++) {
		if (!cells->cells[i].divided && !cell_covers(&cells->cells[i], chain, motion, needed)) {
			move_to_front(cells, i);
			return false;
		}
	}
	return true;
}

/* mm: the gap that the cell's planes leave. If one leaves more than `most`, the result is any such gap. */
static double cell_rest(struct plane_cell *cell, const struct chain *chain, const struct plane_motion *motion,
			double most)
{
	double best = -INFINITY;

	for (int i = 0; i < cell->count && best < most; i++) {
		const int k = (cell->newest + i) % cell->count;
		const double rest = travelling_plane_rest(&cell->kept[k].plane, chain, motion, best);

		if (!(rest < most))
			cell->newest = k;
		best = larger(best, rest);
	}
	return best;
}

double plane_cells_rest(struct plane_cells *cells, const struct plane_motion *motion, double most,
			enum planes_asked asked)
{
	const struct chain *chain = cells->bodies->chain;
	double whole = -INFINITY, least = INFINITY;
	size_t nearest = 0;

	if (!cells->cell_count)
		return -INFINITY;
	if (asked != PLANES_OF_PARTS)
		whole = cell_rest(&cells->cells[0], chain, motion, most);
	if (whole > most || asked == PLANES_OF_WHOLE || !cells->cells[0].divided)
		return whole;
	for (size_t i = 1; i < cells->cell_count && least > whole; i++) {
		double rest;

		if (cells->cells[i].divided)
			continue;
		rest = cell_rest(&cells->cells[i], chain, motion, smaller(least, most));
		if (rest < least) {
			least = rest;
			nearest = i;
		}
	}
	move_to_front(cells, nearest);
	return larger(whole, least);
}

/* ------------------------------------------------------------------ search */

static bool search_cell(struct plane_cells *cells, struct plane_search *search, size_t at)
{
	const struct plane_cell *cell = &cells->cells[at];

	return plane_search_between(search, &cells->parts[cell->part[0]], &cells->parts[cell->part[1]],
				    cell->count ? &cell->kept[cell->newest] : NULL);
}

static void keep_plane(struct plane_cell *cell, const struct kept_plane *plane)
{
	if (cell->count < PLANES_KEPT)
		cell->newest = cell->count++;
	else
		cell->newest = (cell->newest + PLANES_KEPT - 1) % PLANES_KEPT;
	cell->kept[cell->newest] = *plane;
}

/* mm: the gap that the cell's newest plane leaves, measured again. A plane that leaves more than 0 is kept. */
static double carry_cell(struct plane_cells *cells, struct plane_search *search, struct plane_cell *cell,
			 const vec3 *along)
{
	double rest;

	if (!cell->count)
		return -INFINITY;
	rest = plane_search_carry(search, &cells->parts[cell->part[0]], &cells->parts[cell->part[1]],
				  &cell->kept[cell->newest], along);
	if (rest > 0)
		keep_plane(cell, &search->best);
	return rest;
}

double plane_cells_carry_whole(struct plane_cells *cells, const axis_values *q, const struct plane_motion *motion,
			       double needed, const vec3 *along)
{
	struct plane_search search;
	double rest;

	if (!cells->cell_count || !cells->cells[0].count)
		return -INFINITY;
	plane_search_init(&search, cells->bodies, q, motion, needed, &cells->visits);
	rest = carry_cell(cells, &search, &cells->cells[0], along);
	/* The next search looks at the whole bodies first. */
	if (rest > 0)
		cells->cells[0].idle = cells->cells[0].backoff = 0;
	return rest;
}

double plane_cells_gap_of_whole(const struct plane_cells *cells)
{
	const struct plane_cell *whole = cells->cell_count ? &cells->cells[0] : NULL;

	return whole && whole->count ? whole->kept[whole->newest].plane.gap : -INFINITY;
}

double plane_cells_carry_parts(struct plane_cells *cells, const axis_values *q, const struct plane_motion *motion,
			       double needed)
{
	struct plane_search search;
	double least = INFINITY;

	if (!cells->cell_count || !cells->cells[0].divided)
		return -INFINITY;
	plane_search_init(&search, cells->bodies, q, motion, needed, &cells->visits);
	for (size_t i = 1; i < cells->cell_count && least > 0; i++) {
		struct plane_cell *cell = &cells->cells[i];
		double rest;

		if (cell->divided)
			continue;
		rest = cell_rest(cell, cells->bodies->chain, motion, needed);
		if (!(rest > needed))
			rest = larger(rest, carry_cell(cells, &search, cell, NULL));
		least = smaller(least, rest);
	}
	return least;
}

/* Makes the children of the part parts of their own; false: the part has no children. */
static bool divide_part(struct plane_cells *cells, size_t at)
{
	const struct plane_part part = cells->parts[at];
	const struct bvh_node *node;

	if (part.mesh.leaf.count || part.child_count)
		return part.child_count > 0;
	node = &bvh_of(cells, part.body)->nodes[part.mesh.leaf.first];
	if (node->used < 2)
		return false;
	cells->parts[at].first_child = cells->part_count;
	cells->parts[at].child_count = node->used;
	for (int i = 0; i < node->used; i++)
		add_part(cells, part.body, (struct leaf){node->first[i], node->count[i]});
	return true;
}

/* Divides the larger part of the cell. */
static bool divide_cell(struct plane_cells *cells, size_t at)
{
	const size_t part[2] = {cells->cells[at].part[0], cells->cells[at].part[1]};
	int body = cells->parts[part[1]].mesh.radius > cells->parts[part[0]].mesh.radius;
	size_t first, count;

	if (!divide_part(cells, part[body])) {
		body = !body;
		if (!divide_part(cells, part[body]))
			return false;
	}
	first = cells->parts[part[body]].first_child;
	count = cells->parts[part[body]].child_count;
	if (cells->cell_count + count > CELLS_MOST)
		return false;
	for (size_t i = 0; i < count; i++)
		add_cell(cells, body ? part[0] : first + i, body ? first + i : part[1]);
	cells->cells[at].divided = true;
	return true;
}

/* Finds a plane for the cell or divides it; false: neither helps over the motion. */
static bool renew_cell(struct plane_cells *cells, struct plane_search *search, size_t at)
{
	const bool proved = search_cell(cells, search, at);

	if (search->life < 0)
		return divide_cell(cells, at);
	keep_plane(&cells->cells[at], &search->best);
	return proved;
}

/* The same for the cell of the whole bodies. False also if the front must be searched. */
static bool renew_whole(struct plane_cells *cells, struct plane_search *search)
{
	struct plane_cell *whole = &cells->cells[0];
	bool proved;

	if (whole->divided && whole->idle > 0) {
		whole->idle--;
		return false;
	}
	proved = search_cell(cells, search, 0);
	if (search->life >= 0) {
		keep_plane(whole, &search->best);
		whole->backoff = 0;
	}
	if (proved)
		return true;
	if (search->life < 0 && !whole->divided)
		divide_cell(cells, 0);
	whole = &cells->cells[0];
	whole->backoff = whole->backoff < WHOLE_BACKOFF_MAX ? 2 * whole->backoff + 1 : WHOLE_BACKOFF_MAX;
	whole->idle = whole->backoff;
	return false;
}

bool plane_cells_search(struct plane_cells *cells, const axis_values *q, const struct plane_motion *motion,
			double needed)
{
	struct plane_search search;
	const struct body_pair *bodies = cells->bodies;

	if (chain_is_rigid(bodies->chain))
		return false;
	if (!cells->cell_count) {
		for (int i = 0; i < 2; i++) {
			cells->shapes[i] = shapes_of(cells, i);
			add_part(cells, i, (struct leaf){0, 0});
		}
		add_cell(cells, 0, 1);
	}
	plane_search_init(&search, bodies, q, motion, needed, &cells->visits);
	if (renew_whole(cells, &search))
		return true;
	if (!cells->cells[0].divided)
		return false;
	for (size_t i = 1; i < cells->cell_count; i++) {
		struct plane_cell *cell = &cells->cells[i];

		if (cell->divided || cell_covers(cell, bodies->chain, motion, needed))
			continue;
		if (!renew_cell(cells, &search, i)) {
			move_to_front(cells, i);
			return false;
		}
	}
	return true;
}
