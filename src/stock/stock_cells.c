#include "stock/stock_cells.h"

#include <math.h>
#include <stdlib.h>

#include "base/mem.h"
#include "base/minmax.h"
#include "geom/inside.h"
#include "geom/point_distance.h"
#include "geom/tolerance.h"

/* A cell stores this many bits of the number of a chunk. */
#define CHUNK_MASK ((UINT32_C(1) << 30) - 1)

static const double sqrt3 = 1.7320508075688773;

/* The position relative to the blank of a cell whose parent is partly in the blank. */
static enum blank_side side_of(const struct blank *blank, const struct cube *cube)
{
	const double radius = sqrt3 * cube->half;
	const vec3 off = vec3_sub(cube->centre, blank->bvh->origin);
	const double size = vec3_norm(off) + blank->bvh->radius + vec3_norm(blank->bvh->origin);
	const double margin = blank->bvh->mesh.rounding + POSE_ROUNDING * size;
	const double distance = mesh_point_distance(blank->bvh, cube->centre);

	if (distance <= radius + margin)
		return BLANK_PARTLY;
	if (mesh_inside(blank->bvh, blank->topology, cube->centre) != INSIDE_NO)
		return BLANK_INSIDE;
	return distance > radius + margin + blank->uncertainty ? BLANK_OUTSIDE : BLANK_PARTLY;
}

/* Removes all cells but the root. */
static void start_over(struct stock_cells *cells)
{
	/* The root is the only cell in its group. */
	cells->group_count = 1;
	cells->cells[0] = (struct stock_cell){.removed = INFINITY, .kind = side_of(&cells->blank, &cells->root) & 3u};
}

/*
 * Cells store earlier answers, which can be computed again: so memory does not grow with the program. Called at the
 * start of a query.
 */
static void limit_memory(struct stock_cells *cells)
{
	if (cells->group_count > cells->most_groups)
		start_over(cells);
}

void stock_cells_init(struct stock_cells *cells, const struct blank *blank, const struct cut_log *log, double edge)
{
	const vec3 half = blank->bvh->half;
	const double size = vec3_norm(blank->bvh->origin) + blank->bvh->radius;
	const double rounding = blank->bvh->mesh.rounding + POSE_ROUNDING * size;
	const double beyond = blank->uncertainty + rounding;
	const double needed = larger(half.x, larger(half.y, half.z)) + beyond;
	const vec3 reach = vec3_add(half, (vec3){beyond, beyond, beyond});

	*cells = (struct stock_cells){.blank = *blank, .log = log, .most_groups = STOCK_CELL_GROUPS};
	cells->rounding = rounding;
	cells->low = vec3_sub(blank->bvh->origin, reach);
	cells->high = vec3_add(blank->bvh->origin, reach);
	cells->least_half = 0.5 * edge;
	cells->root = (struct cube){blank->bvh->origin, cells->least_half};
	while (cells->root.half < needed * (1 + POSE_ROUNDING))
		cells->root.half *= 2;
	cells->cells = mem_grow(NULL, &cells->group_capacity, 1, 8 * sizeof(*cells->cells));
	start_over(cells);
}

void stock_cells_release(struct stock_cells *cells)
{
	free(cells->cells);
	*cells = (struct stock_cells){.group_count = 0};
}

double stock_cells_radius(const struct stock_cells *cells)
{
	return sqrt3 * cells->least_half;
}

struct cube stock_cells_child(const struct cube *cube, int number)
{
	const double half = 0.5 * cube->half;
	const vec3 sign = {number & 1 ? 1 : -1, number & 2 ? 1 : -1, number & 4 ? 1 : -1};

	return (struct cube){vec3_mad(cube->centre, half, sign), half};
}

/* Makes the eight children of a cell. */
static void divide(struct stock_cells *cells, size_t index, const struct cube *cube)
{
	const enum blank_side side = (enum blank_side)cells->cells[index].kind;
	const size_t group = cells->group_count++;

	cells->cells = mem_grow(cells->cells, &cells->group_capacity, group + 1, 8 * sizeof(*cells->cells));
	cells->cells[index].children = (uint32_t)group;
	for (int i = 0; i < 8; i++) {
		const struct cube child = stock_cells_child(cube, i);

		cells->cells[8 * group + (size_t)i] = (struct stock_cell){
			.removed = INFINITY,
			.kind = (side == BLANK_PARTLY ? side_of(&cells->blank, &child) : side) & 3u,
		};
	}
}

/* One query: what is near the obstacle at a time? */
struct search {
	struct stock_cells *cells;
	const struct placed_obstacle *placed;
	double time;
	uint64_t log_end;	/* the position of the time in the log */
	double best;	/* mm: distance; everything that was left out is at least this far away */
	const struct distance_query *distance;
	double within, finest_half;	/* meet */
	struct cube *found;
	double depth;	/* prove */
	long effort;
	vec3 *point;
};

static bool is_there(struct search *search, size_t index, const struct cube *cube)
{
	struct stock_cell *cell = &search->cells->cells[index];

	search->cells->visits++;
	if (cell->kind == BLANK_OUTSIDE || cell->removed <= search->time)
		return false;
	if (isinf(cell->removed) && cell->searched < search->log_end)
		cell->removed = cut_log_search(search->cells->log, cube, &cell->searched, search->log_end);
	return cell->removed > search->time;
}

/* Is more of the cell within the blank's box than rounding? */
static bool has_part(const struct stock_cells *cells, const struct cube *cube)
{
	const vec3 c = cube->centre;
	const double h = cube->half - 3 * cells->rounding;

	return c.x - h < cells->high.x && c.x + h > cells->low.x && c.y - h < cells->high.y && c.y + h > cells->low.y &&
	       c.z - h < cells->high.z && c.z + h > cells->low.z;
}

/* The part of the cell within the blank's bounds; the rest does not count. False: no part is. */
static bool bounded_box(const struct stock_cells *cells, const struct cube *cube, vec3 *centre, vec3 *half)
{
	const vec3 reach = {cube->half, cube->half, cube->half};
	const vec3 low = vec3_max(vec3_sub(cube->centre, reach), cells->low);
	const vec3 high = vec3_min(vec3_add(cube->centre, reach), cells->high);

	*centre = vec3_scale(0.5, vec3_add(low, high));
	*half = vec3_scale(0.5, vec3_sub(high, low));
	return low.x <= high.x && low.y <= high.y && low.z <= high.z;
}

/*
 * Is all of the cell that may be closer to the obstacle than `within` removed, each part of it by one cut? Beside a
 * wall this decides a large cell, which would otherwise take many small ones.
 */
static bool is_cut_near(struct search *search, size_t index, const struct cube *cube, double gap, double within)
{
	struct stock_cell *cell = &search->cells->cells[index];
	struct half_space spaces[OBSTACLE_HALF_SPACES];
	struct cell_part part;
	size_t chunk = cell->chunk;
	vec3 centre, half;
	int count;

	/* If the part is the whole cell, is_there has tested it already. */
	if (within >= gap + 2 * sqrt3 * cube->half)
		return false;
	if (!search->log_end || !bounded_box(search->cells, cube, &centre, &half))
		return false;
	count = obstacle_half_spaces(search->placed->obstacle, &search->placed->to_obstacle, centre, half, within,
				     spaces);
	for (int i = 0; i < count; i++) {
		cell_part_init(&part, centre, half, &spaces[i]);
		if (part.count &&
		    !cut_log_removes_part(search->cells->log, &part, search->time, search->log_end, &chunk))
			return false;
	}
	cell->chunk = chunk & CHUNK_MASK;
	return count >= 0;
}

static double gap_of(const struct search *search, const struct cube *cube)
{
	vec3 centre, half;

	if (!bounded_box(search->cells, cube, &centre, &half))
		return INFINITY;
	return obstacle_box_distance(search->placed->obstacle, &search->placed->to_obstacle, centre, half);
}

/* The children of a cell in the order of their distances; `first` is the index of the first of the group. */
struct children {
	size_t first;
	struct cube cubes[8];
	double gaps[8];
	int order[8];
};

static void look_at_children(struct search *search, size_t index, const struct cube *cube, struct children *out)
{
	if (!search->cells->cells[index].children)
		divide(search->cells, index, cube);
	out->first = 8 * (size_t)search->cells->cells[index].children;
	for (int i = 0; i < 8; i++) {
		int at = i;

		out->cubes[i] = stock_cells_child(cube, i);
		out->gaps[i] = search->cells->cells[out->first + (size_t)i].kind == BLANK_OUTSIDE
				       ? INFINITY
				       : gap_of(search, &out->cubes[i]);
		for (; at > 0 && out->gaps[out->order[at - 1]] > out->gaps[i]; at--)
			out->order[at] = out->order[at - 1];
		out->order[at] = i;
	}
}

/* The cell is there and its gap is below `best`. The recursion is as deep as the cells. */
static void nearest(struct search *search, size_t index, const struct cube *cube, double gap)
{
	struct children children;

	/* Dividing cells that are small compared with their distance does not pay. */
	if (sqrt3 * cube->half <= search->distance->share * gap || cube->half <= search->cells->least_half) {
		search->best = gap;
		return;
	}
	look_at_children(search, index, cube, &children);
	for (int turn = 0; turn < 8 && search->best > search->distance->least; turn++) {
		const int i = children.order[turn];

		if (!(children.gaps[i] < search->best))
			return;
		if (is_there(search, children.first + (size_t)i, &children.cubes[i]) &&
		    !(search->distance->by_parts && is_cut_near(search, children.first + (size_t)i, &children.cubes[i],
								children.gaps[i], search->best)))
			nearest(search, children.first + (size_t)i, &children.cubes[i], children.gaps[i]);
	}
}

double stock_cells_distance(struct stock_cells *cells, const struct placed_obstacle *placed, double time,
			    const struct distance_query *query)
{
	struct search search = {.cells = cells, .placed = placed, .time = time,
				.log_end = cut_log_end(cells->log, time), .best = query->enough,
				.distance = query};
	const double gap = gap_of(&search, &cells->root);

	limit_memory(cells);
	if (gap < search.best && is_there(&search, 0, &cells->root))
		nearest(&search, 0, &cells->root, gap);
	return search.best;
}

static bool meets(struct search *search, size_t index, const struct cube *cube)
{
	struct children children;

	if (cube->half <= search->finest_half || cube->half <= search->cells->least_half) {
		*search->found = *cube;
		return true;
	}
	look_at_children(search, index, cube, &children);
	for (int turn = 0; turn < 8; turn++) {
		const int i = children.order[turn];

		if (children.gaps[i] > search->within)
			return false;
		if (is_there(search, children.first + (size_t)i, &children.cubes[i]) &&
		    !is_cut_near(search, children.first + (size_t)i, &children.cubes[i], children.gaps[i],
				 search->within) &&
		    meets(search, children.first + (size_t)i, &children.cubes[i]))
			return true;
	}
	return false;
}

bool stock_cells_meet(struct stock_cells *cells, const struct placed_obstacle *placed, double time, double within,
		      double finest_half, struct cube *found)
{
	struct search search = {.cells = cells, .placed = placed, .time = time,
				.log_end = cut_log_end(cells->log, time), .within = within, .finest_half = finest_half,
				.found = found};

	limit_memory(cells);
	return gap_of(&search, &cells->root) <= within && is_there(&search, 0, &cells->root) &&
	       meets(&search, 0, &cells->root);
}

/* Is the point certainly in the blank, and in none of the cuts? */
static bool is_surely_there(const struct search *search, vec3 point)
{
	const struct blank *blank = &search->cells->blank;

	return !cut_log_reaches(search->cells->log, point, 0, search->time) &&
	       (!(blank->excess > 0) || mesh_point_distance(blank->bvh, point) > blank->excess) &&
	       mesh_inside(blank->bvh, blank->topology, point) == INSIDE_YES;
}

static bool is_deep_enough(const struct search *search, vec3 point)
{
	const struct placed_obstacle *placed = search->placed;

	return obstacle_distance(placed->obstacle, xform_apply(&placed->to_obstacle, point)) <= -search->depth;
}

/* The cell is there, and a part of it may be deep enough. */
static bool proves(struct search *search, size_t index, const struct cube *cube)
{
	struct children children;

	if (search->cells->cells[index].kind == BLANK_INSIDE && is_deep_enough(search, cube->centre) &&
	    is_surely_there(search, cube->centre)) {
		*search->point = cube->centre;
		return true;
	}
	if (cube->half <= search->finest_half || search->effort-- <= 0)
		return false;
	look_at_children(search, index, cube, &children);
	for (int turn = 0; turn < 8; turn++) {
		const int i = children.order[turn];

		if (children.gaps[i] > -search->depth)
			return false;
		if (is_there(search, children.first + (size_t)i, &children.cubes[i]) &&
		    proves(search, children.first + (size_t)i, &children.cubes[i]))
			return true;
	}
	return false;
}

bool stock_cells_prove(struct stock_cells *cells, const struct placed_obstacle *placed, double time, double depth,
		       long effort, vec3 *point)
{
	struct search search = {.cells = cells, .placed = placed, .time = time,
				.log_end = cut_log_end(cells->log, time), .depth = depth, .effort = effort,
				.point = point};
	const double gap = gap_of(&search, &cells->root);

	limit_memory(cells);
	if (gap > -depth || !is_there(&search, 0, &cells->root))
		return false;
	/* Coarse cells first: otherwise cells along a surface use up the effort before most of the rest is examined. */
	search.finest_half = cells->root.half / 8;
	search.effort = effort;
	while (!proves(&search, 0, &cells->root)) {
		if (search.finest_half <= cells->least_half)
			return false;
		search.finest_half /= 4;
		search.effort = effort;
	}
	return true;
}

static void visit_cell(struct search *search, size_t index, const struct cube *cube, stock_cells_visit_fn *visit,
		       void *context)
{
	const struct stock_cells *cells = search->cells;
	const bool whole = cells->cells[index].kind == BLANK_INSIDE &&
			   !cut_log_reaches(cells->log, cube->centre, sqrt3 * cube->half, search->time);
	size_t first;

	if (!visit(context, cube, whole) || cube->half <= cells->least_half)
		return;
	if (!cells->cells[index].children)
		divide(search->cells, index, cube);
	first = 8 * (size_t)cells->cells[index].children;
	for (int i = 0; i < 8; i++) {
		const struct cube child = stock_cells_child(cube, i);

		if (has_part(cells, &child) && is_there(search, first + (size_t)i, &child))
			visit_cell(search, first + (size_t)i, &child, visit, context);
	}
}

void stock_cells_visit(struct stock_cells *cells, double time, stock_cells_visit_fn *visit, void *context)
{
	struct search search = {.cells = cells, .time = time, .log_end = cut_log_end(cells->log, time)};

	limit_memory(cells);
	if (is_there(&search, 0, &cells->root))
		visit_cell(&search, 0, &cells->root, visit, context);
}
