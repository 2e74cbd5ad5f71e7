/* stock_mesh.h - the stock that remains at a time, as a closed mesh of cube faces. */
#ifndef FIVECHECK_STOCK_STOCK_MESH_H
#define FIVECHECK_STOCK_STOCK_MESH_H

#include <stdbool.h>
#include <stddef.h>

#include "geom/mesh.h"
#include "stock/stock_cells.h"

/*
 * At most `parts` cubes along the blank's longest side, and more than half of that unless cells are larger. A cube is
 * left out if all of it was certainly cut, part by part, in cells of an eighth of its edge. So the mesh encloses the
 * true stock. It is larger by a bounded amount: no point of the mesh is farther than twice the edge from the stock that
 * would remain if every cutter were smaller by a quarter of the edge. The mesh, in the stock's mesh coordinates,
 * belongs to the caller; it is empty if nothing remains. Returns the edge.
 *
 * *excess (or NULL): all material deeper than this below the surface of the mesh is certainly there. This may be far
 * more than two edges, where small cutters left something in each of many cubes.
 *
 * If more than `effort` chunks of the log would have to be examined, the result is 0 and the mesh is empty.
 */
double stock_mesh_build(struct stock_cells *cells, double time, int parts, uint64_t effort, struct mesh *mesh,
			double *excess);

/* The stock after a program. The owner releases the mesh. */
struct stock_remainder {
	bool known;	/* the program was checked to its end; then: */
	struct mesh mesh;	/* as of stock_mesh_build; empty if nothing remains */
	double excess;	/* mm: material deeper than this below the mesh's surface is certainly there */
	double edge;	/* mm: of its cubes */
	bool coarse;	/* the cubes are larger than usual, to limit the time */
};

/*
 * The remaining stock at the end, in 64 to 128 cubes along the blank's longest side, or fewer if that would take more
 * than `effort` chunks of the log.
 */
void stock_remainder_build(struct stock_cells *cells, double time, uint64_t effort, struct stock_remainder *remainder);

/* The stock as a report shows it. The owner of the report asks, and releases the mesh. */
struct stock_view {
	double time;	/* in steps of the program (cut_log.h); at most the end of the check */
	size_t most;	/* the most triangles of the mesh, unless the coarsest has more; 0: none needed */
	bool cut;	/* a cutter has been in the blank by then; else the blank is shown: */
	struct mesh mesh;	/* in the stock's mesh coordinates; empty if nothing remains */
	double excess;	/* mm: as of stock_mesh_build */
};

/*
 * Fills in `view`: the more triangles it allows, the smaller the cubes. Where many cuts overlap they are larger, so
 * that a picture takes seconds.
 */
void stock_view_build(struct stock_cells *cells, struct stock_view *view);

#endif
