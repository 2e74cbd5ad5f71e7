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
 * If more than `effort` chunks of the log would have to be looked at, the result is 0 and the mesh is empty.
 */
double stock_mesh_build(struct stock_cells *cells, double time, int parts, uint64_t effort, struct mesh *mesh);

/* What a program leaves. The owner releases the mesh. */
struct stock_remainder {
	bool stock;	/* the setup has one */
	bool known;	/* the program was followed to its end: */
	struct mesh mesh;
	double edge;	/* mm: of its cubes */
};

/* The stock as a report shows it. The owner of the report asks, and releases the mesh. */
struct stock_view {
	double time;	/* in steps of the program (cut_log.h); the check takes its own end if that is sooner */
	size_t most;	/* triangles of the mesh, unless the coarsest mesh has more; 0: nothing is wanted */
	bool cut;	/* a cutter has been in the blank by then, and the mesh is the answer; else the blank is: */
	struct mesh mesh;	/* in the stock's mesh coordinates; empty if nothing remains */
	double excess;	/* mm: the mesh holds all that remains, and reaches no farther, path tolerance aside */
};

/*
 * Fills in what `view` asks for: the more triangles it allows, the smaller the cubes; where many cuts overlap they are
 * larger, so that a picture takes seconds.
 */
void stock_view_build(struct stock_cells *cells, struct stock_view *view);

#endif
