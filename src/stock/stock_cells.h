/*
 * stock_cells.h - an outer bound of the stock that remains at a time: cubes that are divided only where a question
 * remains.
 *
 * The blank lies in one cube, which divides into eight, and so on down to a smallest edge. A cell leaves the stock at
 * the first time at which the log proves that one cutter removes the whole of it. What a cell is, and when it leaves,
 * depends on the blank and the log alone: the cells that are stored are answers that were given before. So the order
 * of questions changes no answer. The union of the cells that are there at a time encloses the true stock, and it only
 * ever shrinks.
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
	double uncertainty;	/* mm: the true blank may be larger by so much */
	double excess;	/* mm: or smaller by so much */
};

struct stock_cell {
	double removed;	/* time at which it left; INFINITY: it had not when the log was searched up to `searched` */
	uint64_t searched;	/* place in the log */
	uint32_t children;	/* number of the group of its eight children; 0: not divided yet */
	uint32_t kind : 2;	/* enum blank_side */
	uint32_t chunk : 30;	/* of the log: a cut in it removed a part of the cell that was asked for; else any */
};

/* How a cell lies in the blank. */
enum blank_side { BLANK_PARTLY, BLANK_INSIDE, BLANK_OUTSIDE };

/* 32 MB of cells. */
#define STOCK_CELL_GROUPS 174000

struct stock_cells {
	struct blank blank;
	const struct cut_log *log;	/* borrowed */
	struct cube root;
	vec3 low, high;	/* the box around the blank; cells end there */
	double rounding;	/* mm: the box is larger than the mesh by so much, uncertainty aside */
	double least_half;	/* mm: half the edge of the smallest cells */
	struct stock_cell *cells;	/* groups of eight; cell 0 is the root, group 0 has no other */
	size_t group_count, group_capacity;
	size_t most_groups;	/* beyond this many a question begins with the root alone; the answers stay the same */
	long visits;	/* cells that were looked at */
};

/* Cells down to an edge of `edge` mm at most, but more than half of it. */
void stock_cells_init(struct stock_cells *cells, const struct blank *blank, const struct cut_log *log, double edge);
void stock_cells_release(struct stock_cells *cells);

/* mm: half of the diagonal of a smallest cell. No cell reaches farther than twice this beyond the blank. */
double stock_cells_radius(const struct stock_cells *cells);

/* An obstacle and where it stands: stock coordinates to its own. */
struct placed_obstacle {
	const struct obstacle *obstacle;
	xform to_obstacle;
};

/* How exactly a distance is asked for. */
struct distance_query {
	double least, enough;	/* mm: distances below the one do not matter; those beyond the other are all alike */
	double share;	/* cells are divided as long as half their diagonal is more than this share of their distance */
	bool by_parts;	/* leave out cells of which all that is nearer was removed: pays with a small share alone */
};

/*
 * mm: a lower bound on the distance of the obstacle from the stock that is there at `time`; at most `enough`. It may be
 * negative. The result for a later time, or with smaller cells, is not less than what is proved here.
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
 * Calls `visit` for each cell that is there at `time`, from the root down. Cells that only the rounding of the box
 * reaches are left out. `whole`: the cell lies in the blank, and no cutter can have touched it. `visit` returns true if
 * it wants the parts of the cell, too.
 */
typedef bool stock_cells_visit_fn(void *context, const struct cube *cell, bool whole);
void stock_cells_visit(struct stock_cells *cells, double time, stock_cells_visit_fn *visit, void *context);

/*
 * Looks for a point of the stock that is certainly there at `time` (no cutter can have touched it) and lies at least
 * `depth` mm inside the obstacle. It gives up after `effort` cells of each of some sizes: false proves nothing.
 */
bool stock_cells_prove(struct stock_cells *cells, const struct placed_obstacle *placed, double time, double depth,
		       long effort, vec3 *point);

#endif
