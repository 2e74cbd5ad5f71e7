/* stock_mesh.h - the stock that remains at a time, as a closed mesh of cube faces. */
#ifndef FIVECHECK_STOCK_STOCK_MESH_H
#define FIVECHECK_STOCK_STOCK_MESH_H

#include <stdbool.h>
#include <stddef.h>

#include "geom/mesh.h"
#include "stock/stock_cells.h"

/*
 * At most `parts` cubes along the blank's longest side, and more than half of that unless cells are larger. A cube
 * is left out if all of it was certainly cut, part by part, in cells of an eighth of its edge. So the mesh encloses the
 * true stock. It is larger by a bounded amount: cutters that are smaller by a quarter of the edge leave more than the
 * true ones do, and no point of the mesh is farther than twice the edge from what they leave. The mesh, in the stock's
 * mesh coordinates, is the caller's; it is empty if nothing remains. Returns the edge.
 *
 * *excess (or NULL): all that lies deeper than this below the mesh's surface is certainly there. That may be far more
 * than two edges, where small cutters left something in each of many cubes.
 *
 * If more than `effort` chunks of the log would have to be looked at, the result is 0 and the mesh is empty.
 */
double stock_mesh_build(struct stock_cells *cells, double time, int parts, uint64_t effort, struct mesh *mesh,
			double *excess);

/* What a program leaves. The owner releases the mesh. */
struct stock_remainder {
	bool known;	/* the program was followed to its end: */
	struct mesh mesh;	/* as of stock_mesh_build; empty if nothing remains */
	double excess;	/* mm: what lies deeper than this below the mesh's surface is certainly there */
	double edge;	/* mm: of its cubes */
	bool coarse;	/* the cubes are larger than usual, because that would have taken too long */
};

/*
 * The stock that remains at the end, in 64 to 128 cubes along the blank's longest side; in fewer where that would take
 * more than `effort` chunks of the log.
 */
void stock_remainder_build(struct stock_cells *cells, double time, uint64_t effort, struct stock_remainder *remainder);

/* The stock as a report shows it. The owner of the report asks, and releases the mesh. */
struct stock_view {
	double time;	/* in steps of the program (cut_log.h); the check takes its own end if that is sooner */
	size_t most;	/* triangles of the mesh, unless the coarsest mesh has more; 0: nothing is wanted */
	bool cut;	/* a cutter has been in the blank by then, and the mesh is the answer; else the blank is: */
	struct mesh mesh;	/* in the stock's mesh coordinates; empty if nothing remains */
	double excess;	/* mm: as of stock_mesh_build */
};

/*
 * Fills in what `view` asks for: the more triangles it allows, the smaller the cubes; where many cuts overlap they are
 * larger, so that a picture takes seconds.
 */
void stock_view_build(struct stock_cells *cells, struct stock_view *view);

#endif
