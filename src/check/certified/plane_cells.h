/*
 * plane_cells.h - travelling planes that together keep two bodies apart: each between a part of one and of the other.
 */
#ifndef FIVECHECK_CHECK_CERTIFIED_PLANE_CELLS_H
#define FIVECHECK_CHECK_CERTIFIED_PLANE_CELLS_H

#include <stdbool.h>
#include <stddef.h>

#include "check/certified/travelling_plane.h"

struct plane_part;
struct plane_cell;

/*
 * Every pair of a triangle of one body and one of the other lies in a cell of the front; the cell of both whole bodies
 * holds all. Each cell keeps the last planes that were of use.
 */
struct plane_cells {
	const struct body_pair *bodies;
	struct body_shapes *shapes[2];	/* held, or NULL before the first search: of A, B */
	struct plane_part *parts;	/* owned: parts of both bodies */
	size_t part_count, part_capacity;
	struct plane_cell *cells;	/* owned; the first one is that of the whole bodies */
	size_t cell_count, cell_capacity;
	long visits;	/* node pairs that all searches were worth */
};

/* Keeps no memory until the first search. */
void plane_cells_init(struct plane_cells *cells, const struct body_pair *bodies);
void plane_cells_release(struct plane_cells *cells);

/* A copy for another check of the same bodies, which the caller releases. */
void plane_cells_copy(struct plane_cells *to, const struct plane_cells *from);

/* Begins with the whole bodies again: smaller gaps are needed from here on, so cells may be larger. */
void plane_cells_join(struct plane_cells *cells);

/* Do kept planes leave gaps of more than `needed` mm throughout the motion? */
bool plane_cells_cover(struct plane_cells *cells, const struct plane_motion *motion, double needed);

/* Which planes to ask: those between the whole bodies cost least. */
enum planes_asked {
	PLANES_OF_WHOLE,
	PLANES_OF_PARTS,
	PLANES_ALL
};

/*
 * mm: kept planes leave gaps of more than this throughout the motion; -INFINITY: they leave none. Of more
 * than `most` any may be given.
 */
double plane_cells_rest(struct plane_cells *cells, const struct plane_motion *motion, double most,
			enum planes_asked asked);

/*
 * mm: the same after planes were measured again at q, which is an end of a straight motion: it costs a small part of a
 * search. Of the whole bodies the plane that was of use last, `along` another normal or its own (NULL) as for
 * plane_search_carry; of the parts the same in each cell that has less than `needed` mm.
 */
double plane_cells_carry_whole(struct plane_cells *cells, const axis_values *q, const struct plane_motion *motion,
			       double needed, const vec3 *along);
double plane_cells_carry_parts(struct plane_cells *cells, const axis_values *q, const struct plane_motion *motion,
			       double needed);

/* mm: what the plane of the whole bodies that was of use last leaves where it was measured; -INFINITY: none was. */
double plane_cells_gap_of_whole(const struct plane_cells *cells);

/*
 * Do planes prove the motion, new ones at q in the cells where no kept plane does? It may take their gaps at both ends
 * of the motion: then the planes that are kept need not cover it.
 */
bool plane_cells_search(struct plane_cells *cells, const axis_values *q, const struct plane_motion *motion,
			double needed);

#endif
