/*
 * plane_cells.h - travelling planes that together keep two bodies apart, each between a part of one body and a part of
 * the other.
 */
#ifndef FIVECHECK_CHECK_CERTIFIED_PLANE_CELLS_H
#define FIVECHECK_CHECK_CERTIFIED_PLANE_CELLS_H

#include <stdbool.h>
#include <stddef.h>

#include "check/certified/travelling_plane.h"

struct plane_part;
struct plane_cell;

/*
 * Every pair of a triangle of one body and one of the other is in a cell of the front; the cell of both whole bodies
 * contains all pairs. Each cell keeps the last planes that succeeded.
 */
struct plane_cells {
	const struct body_pair *bodies;
	struct body_shapes *shapes[2];	/* of A, B; NULL before the first search */
	struct plane_part *parts;	/* owned: parts of both bodies */
	size_t part_count, part_capacity;
	struct plane_cell *cells;	/* owned; the first one is the cell of the whole bodies */
	size_t cell_count, cell_capacity;
	long visits;	/* the cost of all searches in node pairs */
};

/* Allocates nothing before the first search. */
void plane_cells_init(struct plane_cells *cells, const struct body_pair *bodies);
void plane_cells_release(struct plane_cells *cells);

/* A copy for another check of the same bodies, which the caller releases. */
void plane_cells_copy(struct plane_cells *to, const struct plane_cells *from);

/* Begins with the whole bodies again: smaller gaps are enough from now on, so cells may be larger. */
void plane_cells_join(struct plane_cells *cells);

/* Do kept planes leave gaps of more than `needed` mm throughout the motion? */
bool plane_cells_cover(struct plane_cells *cells, const struct plane_motion *motion, double needed);

/* Which planes to try: those between the whole bodies cost least. */
enum planes_asked {
	PLANES_OF_WHOLE,
	PLANES_OF_PARTS,
	PLANES_ALL
};

/*
 * mm: kept planes leave gaps of more than this throughout the motion; -INFINITY: they leave none. If they leave more
 * than `most`, any value above `most` may be returned.
 */
double plane_cells_rest(struct plane_cells *cells, const struct plane_motion *motion, double most,
			enum planes_asked asked);

/*
 * mm: the same after planes were measured again at q, an end of a straight motion; this costs a small part of a search.
 * Between the whole bodies, the plane that succeeded last is measured, with the normal `along` or its own (NULL) as in
 * plane_search_carry; between parts, the same in each cell with less than `needed` mm.
 */
double plane_cells_carry_whole(struct plane_cells *cells, const axis_values *q, const struct plane_motion *motion,
			       double needed, const vec3 *along);
double plane_cells_carry_parts(struct plane_cells *cells, const axis_values *q, const struct plane_motion *motion,
			       double needed);

/* mm: the gap of the last successful plane of the whole bodies where it was measured; -INFINITY: there is none. */
double plane_cells_gap_of_whole(const struct plane_cells *cells);

/*
 * Do planes prove the motion, with new ones at q in the cells where no kept plane does? The proof may use their gaps at
 * both ends of the motion: then the kept planes need not cover it.
 */
bool plane_cells_search(struct plane_cells *cells, const axis_values *q, const struct plane_motion *motion,
			double needed);

#endif
