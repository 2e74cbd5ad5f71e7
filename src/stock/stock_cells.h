/*
 * stock_cells.h - an outer bound of the stock that remains at a time: cubes that are divided only where a query needs
 * it.
 *
 * The blank is inside one cube, which divides into eight, and so on down to a smallest edge. A cell leaves the stock at
 * the first time at which the log proves that one cutter removes the whole cell. The cells, and the times at which they
 * leave, depend only on the blank and the log: stored cells are only answers of earlier queries. So the order of
 * queries changes no answer. The union of the cells that exist at a time encloses the true stock, and it only ever
 * shrinks.
 */
#ifndef FIVECHECK_STOCK_STOCK_CELLS_H
#define FIVECHECK_STOCK_STOCK_CELLS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "geom/bvh.h"
#include "geom/topology.h"
#include "geom/xform.h"
#include "stock/cut_log.h"
#include "stock/obstacle.h"

/* The stock before the first cut, in its mesh coordinates. Borrows everything. */
struct blank {
	const struct bvh *bvh;
	const struct topology *topology;	/* of a closed mesh */
	double uncertainty;	/* mm: how much larger the true blank may be */
	double excess;	/* mm: how much smaller it may be */
};

struct stock_cell {
	double removed;	/* time at which it left; INFINITY: not yet, in the log up to `searched` */
	uint64_t searched;	/* place in the log */
	uint32_t children;	/* number of the group of its eight children; 0: not divided yet */
	uint32_t kind : 2;	/* enum blank_side */
	uint32_t chunk : 30;	/* of the log: a cut in it removed the last queried part of the cell; else any */
};

/* The position of a cell relative to the blank. */
enum blank_side { BLANK_PARTLY, BLANK_INSIDE, BLANK_OUTSIDE };

/* 32 MB of cells. */
#define STOCK_CELL_GROUPS 174000

struct stock_cells {
	struct blank blank;
	const struct cut_log *log;	/* borrowed */
	struct cube root;
	vec3 low, high;	/* the box around the blank; cells end there */
	double rounding;	/* mm: how much larger the box is than the mesh, without the uncertainty */
	double least_half;	/* mm: half the edge of the smallest cells */
	struct stock_cell *cells;	/* groups of eight; cell 0 is the root, group 0 has no other */
	size_t group_count, group_capacity;
	size_t most_groups;	/* beyond this number a query begins with the root alone; the answers stay the same */
	long visits;	/* cells examined */
};

/* Cells down to an edge of `edge` mm at most, but more than half of it. */
void stock_cells_init(struct stock_cells *cells, const struct blank *blank, const struct cut_log *log, double edge);
void stock_cells_release(struct stock_cells *cells);

/* mm: half the diagonal of a smallest cell. No cell extends farther than twice this beyond the blank. */
double stock_cells_radius(const struct stock_cells *cells);

/* One of the eight parts of a cell, 0 to 7. */
struct cube stock_cells_child(const struct cube *cube, int number);

/* An obstacle and its pose: stock coordinates to its own. */
struct placed_obstacle {
	const struct obstacle *obstacle;
	xform to_obstacle;
};

/* How exactly a distance is computed. */
struct distance_query {
	double least, enough;	/* mm: distances below `least` or above `enough` need not be exact */
	double share;	/* cells are divided while half their diagonal exceeds this share of their distance */
	bool by_parts;	/* leave out cells whose nearer part was removed: pays only with a small share */
};

/*
 * mm: a lower bound of the distance of the obstacle from the stock at `time`; at most `enough`. It may be negative. The
 * result for a later time, or with smaller cells, is not less.
 */
double stock_cells_distance(struct stock_cells *cells, const struct placed_obstacle *placed, double time,
			    const struct distance_query *query);

/*
 * Is there a cell that is not proved farther than `within` mm from the obstacle? Cells with half an edge of
 * `finest_half` mm or less are not divided. *found is the first such cell.
 */
bool stock_cells_meet(struct stock_cells *cells, const struct placed_obstacle *placed, double time, double within,
		      double finest_half, struct cube *found);

/*
 * Calls `visit` for each cell that exists at `time`, from the root down. Cells that are only in the rounding of the box
 * are left out. `whole`: the cell is inside the blank, and no cutter can have touched it. If `visit` returns true, the
 * parts of the cell are visited, too.
 */
typedef bool stock_cells_visit_fn(void *context, const struct cube *cell, bool whole);
void stock_cells_visit(struct stock_cells *cells, double time, stock_cells_visit_fn *visit, void *context);

/*
 * Searches a point of the stock that is certainly there at `time` (no cutter can have touched it) and at least `depth`
 * mm inside the obstacle. It gives up after `effort` cells of each of some sizes: false proves nothing.
 */
bool stock_cells_prove(struct stock_cells *cells, const struct placed_obstacle *placed, double time, double depth,
		       long effort, vec3 *point);

#endif
