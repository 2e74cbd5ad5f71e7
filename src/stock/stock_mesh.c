#include "stock/stock_mesh.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "base/mem.h"
#include "base/minmax.h"
#include "geom/point_distance.h"
#include "geom/tolerance.h"

/* The size of the cells below a cube of the mesh, as a share of its edge. */
#define FINE 0.125

/* Cubes of the mesh, by their numbers along X, Y and Z from the corner of the root. */
struct grid {
	struct stock_cells *cells;
	double time;
	double edge;
	uint64_t most;	/* give up when the log's count of gets reaches this */
	int size;	/* cubes along each side of the root */
	uint8_t *bits;	/* the cubes of the mesh */
	uint8_t *sure;	/* the cubes that are certainly there as a whole; NULL: not wanted */
	struct mesh *mesh;
	size_t capacity;
};

struct cube_number {
	int at[3];
};

static size_t bit_of(const struct grid *grid, struct cube_number n)
{
	return ((size_t)n.at[2] * (size_t)grid->size + (size_t)n.at[1]) * (size_t)grid->size + (size_t)n.at[0];
}

static bool is_set(const uint8_t *bits, size_t bit)
{
	return bits[bit / 8] >> bit % 8 & 1;
}

static bool is_full(const struct grid *grid, struct cube_number n)
{
	for (int k = 0; k < 3; k++)
		if (n.at[k] < 0 || n.at[k] >= grid->size)
			return false;
	return is_set(grid->bits, bit_of(grid, n));
}

/* The cube at the lower corner of a cell, or around the cell. */
static struct cube_number number_of(const struct grid *grid, const struct cube *cell)
{
	const struct cube *root = &grid->cells->root;
	const double low[3] = {cell->centre.x - cell->half - (root->centre.x - root->half),
			       cell->centre.y - cell->half - (root->centre.y - root->half),
			       cell->centre.z - cell->half - (root->centre.z - root->half)};
	struct cube_number n;

	for (int k = 0; k < 3; k++)
		n.at[k] = (int)(low[k] / grid->edge + FINE / 4);
	return n;
}

/* Of the cubes of a cell, `count` along each side, the one with this index. */
static struct cube_number cube_in(struct cube_number first, int count, int index)
{
	return (struct cube_number){{first.at[0] + index % count, first.at[1] + index / count % count,
				     first.at[2] + index / (count * count)}};
}

/*
 * Marks the cubes of a cell, of which no cutter has touched any, as certainly there, except for those that the true
 * blank may not have. The recursion is as deep as the cells.
 */
static void mark_sure(struct grid *grid, const struct cube *cell)
{
	const struct blank *blank = &grid->cells->blank;
	const double radius = sqrt(3) * cell->half * (1 + POSE_ROUNDING);
	const double depth = blank->excess > 0 ? mesh_point_distance(blank->bvh, cell->centre) : INFINITY;
	const int count = (int)(2 * cell->half / grid->edge + 0.5);
	const struct cube_number first = number_of(grid, cell);

	if (depth + radius <= blank->excess || (count <= 1 && depth - radius <= blank->excess))
		return;
	for (int i = 0; i < 8 && depth - radius <= blank->excess; i++) {
		const struct cube part = stock_cells_child(cell, i);

		mark_sure(grid, &part);
	}
	for (int i = 0; i < count * count * count && depth - radius > blank->excess; i++) {
		const size_t bit = bit_of(grid, cube_in(first, count, i));

		grid->sure[bit / 8] |= (uint8_t)(1 << bit % 8);
	}
}

/*
 * Marks the cubes that a cell contains; a cell smaller than a cube marks the cube around it. `whole`: the cell is
 * inside the blank as it is drawn, and untouched.
 */
static void fill(struct grid *grid, const struct cube *cell, bool whole)
{
	const int count = (int)larger(1, 2 * cell->half / grid->edge + 0.5);
	const struct cube_number first = number_of(grid, cell);

	for (int i = 0; i < count * count * count; i++) {
		const size_t bit = bit_of(grid, cube_in(first, count, i));

		grid->bits[bit / 8] |= (uint8_t)(1 << bit % 8);
	}
	if (grid->sure && whole && cell->half > 0.4 * grid->edge)
		mark_sure(grid, cell);
}

static bool is_exhausted(const struct grid *grid)
{
	return grid->cells->log->store->gets > grid->most;
}

/* stock_cells_visit_fn: a cell that is there. True: visit its parts. */
static bool take_cell(void *context, const struct cube *cell, bool whole)
{
	struct grid *grid = context;

	if (is_exhausted(grid) || (cell->half < 0.75 * grid->edge && is_full(grid, number_of(grid, cell))))
		return false;
	if (!whole && cell->half > 0.75 * FINE * grid->edge)
		return true;
	fill(grid, cell, whole);
	return false;
}

/* Limited to the blank's bounds, so that a box keeps its faces; values within rounding of a bound are set to it. */
static double bounded(double x, double low, double high, double rounding)
{
	return x < low + 3 * rounding ? low : x > high - 3 * rounding ? high : x;
}

static void corner_of(const struct grid *grid, struct cube_number n, const int corner[3], float out[3])
{
	const struct stock_cells *cells = grid->cells;
	const double origin[3] = {cells->root.centre.x - cells->root.half, cells->root.centre.y - cells->root.half,
				  cells->root.centre.z - cells->root.half};
	const double low[3] = {cells->low.x, cells->low.y, cells->low.z};
	const double high[3] = {cells->high.x, cells->high.y, cells->high.z};

	for (int k = 0; k < 3; k++)
		out[k] =
		    (float)bounded(origin[k] + grid->edge * (n.at[k] + corner[k]), low[k], high[k], cells->rounding);
}

static void add_triangle(struct grid *grid, struct cube_number n, int corners[3][3])
{
	struct mesh *mesh = grid->mesh;

	mesh->triangles = mem_grow(mesh->triangles, &grid->capacity, mesh->count + 1, sizeof(*mesh->triangles));
	for (int i = 0; i < 3; i++)
		corner_of(grid, n, corners[i], mesh->triangles[mesh->count].v[i]);
	mesh->count++;
}

/* The face of a cube toward `side` along an axis, counter-clockwise seen from outside. */
static void add_face(struct grid *grid, struct cube_number n, int axis, int side)
{
	const int u = (axis + 1) % 3, v = (axis + 2) % 3;
	int quad[4][3];

	for (int i = 0; i < 4; i++) {
		const int turn = side ? i : 3 - i;

		quad[i][axis] = side;
		quad[i][u] = turn == 1 || turn == 2;
		quad[i][v] = turn >= 2;
	}
	add_triangle(grid, n, (int[3][3]){{quad[0][0], quad[0][1], quad[0][2]}, {quad[1][0], quad[1][1], quad[1][2]},
					  {quad[2][0], quad[2][1], quad[2][2]}});
	add_triangle(grid, n, (int[3][3]){{quad[0][0], quad[0][1], quad[0][2]}, {quad[2][0], quad[2][1], quad[2][2]},
					  {quad[3][0], quad[3][1], quad[3][2]}});
}

static void add_faces(struct grid *grid, struct cube_number n)
{
	for (int face = 0; face < 6; face++) {
		struct cube_number next = n;

		next.at[face / 2] += face % 2 ? 1 : -1;
		if (!is_full(grid, next))
			add_face(grid, n, face / 2, face % 2);
	}
}

static void add_cubes(struct grid *grid)
{
	for (int z = 0; z < grid->size; z++)
		for (int y = 0; y < grid->size; y++)
			for (int x = 0; x < grid->size; x++)
				if (is_full(grid, (struct cube_number){{x, y, z}}))
					add_faces(grid, (struct cube_number){{x, y, z}});
}

/* The steps to the neighbours of a cube, in this fraction of an edge, rounded up: across a face, an edge, a corner. */
#define STEP_PARTS 64
static const uint16_t step_lengths[] = {0, 64, 91, 111};

/*
 * Reduces the depth of a cube to what its neighbours permit: half of the neighbours for each `side`. A point that moves
 * by these steps ends in a cube that is not there, so its depth below the surface is at most their length.
 */
static uint16_t depth_beside(const struct grid *grid, const uint16_t *depths, struct cube_number n, int side)
{
	uint16_t least = depths[bit_of(grid, n)];

	for (int i = 14; i < 27; i++) {
		const int off[3] = {side * (i % 3 - 1), side * (i / 3 % 3 - 1), side * (i / 9 - 1)};
		const struct cube_number next = {{n.at[0] + off[0], n.at[1] + off[1], n.at[2] + off[2]}};
		const int step = step_lengths[abs(off[0]) + abs(off[1]) + abs(off[2])];
		const int depth = is_full(grid, next) ? depths[bit_of(grid, next)] + step : step;

		least = (uint16_t)(depth < least ? depth : least);
	}
	return least;
}

/* mm: the largest depth below the surface of a point in a cube that is not certainly there. */
static double deepest_doubt(const struct grid *grid)
{
	const int size = grid->size, count = size * size * size;
	uint16_t *depths = mem_alloc((size_t)count * sizeof(*depths));
	uint16_t deepest = 0;

	for (int i = 0; i < count; i++)
		depths[i] = UINT16_MAX;
	for (int turn = 0; turn < 2 * count; turn++) {
		const int i = turn < count ? turn : 2 * count - 1 - turn;
		const struct cube_number n = {{i % size, i / size % size, i / (size * size)}};

		if (!is_set(grid->bits, (size_t)i))
			continue;
		depths[i] = depth_beside(grid, depths, n, turn < count ? -1 : 1);
		if (turn >= count && !is_set(grid->sure, (size_t)i) && depths[i] > deepest)
			deepest = depths[i];
	}
	free(depths);
	return grid->edge * deepest / STEP_PARTS;
}

double stock_mesh_build(struct stock_cells *cells, double time, int parts, uint64_t effort, struct mesh *mesh,
			double *excess)
{
	const vec3 size = vec3_sub(cells->high, cells->low);
	const double longest = larger(size.x, larger(size.y, size.z));
	const uint64_t gets = cells->log->store->gets;
	struct grid grid = {.cells = cells,
			    .time = time,
			    .edge = 2 * cells->least_half,
			    .most = effort < UINT64_MAX - gets ? gets + effort : UINT64_MAX,
			    .mesh = mesh};
	size_t bytes;

	/* Cubes need not be smaller than the smallest cells times 1 / FINE. */
	while (grid.edge * parts < longest)
		grid.edge *= 2;
	grid.size = (int)(2 * cells->root.half / grid.edge + 0.5);
	bytes = (size_t)grid.size * (size_t)grid.size * (size_t)grid.size / 8 + 1;
	grid.bits = mem_zalloc(bytes, 1);
	grid.sure = excess ? mem_zalloc(bytes, 1) : NULL;
	*mesh = (struct mesh){.count = 0};
	stock_cells_visit(cells, time, take_cell, &grid);
	if (is_exhausted(&grid))
		grid.edge = 0;
	else
		add_cubes(&grid);
	if (excess && grid.edge > 0)
		*excess = deepest_doubt(&grid);
	free(grid.sure);
	free(grid.bits);
	return grid.edge;
}

/*
 * The largest number of cubes along the longest side of the blank, which gives a mesh that other programs handle with
 * ease, and the smallest.
 */
enum { REMAINDER_PARTS_MOST = 128, REMAINDER_PARTS_LEAST = 8 };

void stock_remainder_build(struct stock_cells *cells, double time, uint64_t effort, struct stock_remainder *remainder)
{
	int parts = REMAINDER_PARTS_MOST;

	*remainder = (struct stock_remainder){.known = true};
	for (;; parts /= 2) {
		remainder->edge = stock_mesh_build(cells, time, parts,
						   parts <= REMAINDER_PARTS_LEAST ? UINT64_MAX : effort,
						   &remainder->mesh, &remainder->excess);
		if (remainder->edge > 0)
			return;
		remainder->coarse = true;
	}
}

/* The largest and the smallest number of cubes along the longest side of the blank. */
enum { VIEW_PARTS_MOST = 128, VIEW_PARTS_LEAST = 8 };

/* The largest number of chunks of the log examined for one size of cubes: half a second or so. */
#define VIEW_EFFORT 400000

void stock_view_build(struct stock_cells *cells, struct stock_view *view)
{
	if (!cut_log_end(cells->log, view->time))
		return;
	view->cut = true;
	for (int parts = VIEW_PARTS_MOST;; parts /= 2) {
		const bool last = parts <= VIEW_PARTS_LEAST;
		const double edge = stock_mesh_build(cells, view->time, parts, last ? UINT64_MAX : VIEW_EFFORT,
						     &view->mesh, &view->excess);

		if (last || (edge > 0 && view->mesh.count <= view->most))
			return;
		mesh_release(&view->mesh);
	}
}
