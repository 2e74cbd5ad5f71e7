/* obstacle.h - a body that must not touch the stock, as a bound on the distance of points to it. */
#ifndef FIVECHECK_STOCK_OBSTACLE_H
#define FIVECHECK_STOCK_OBSTACLE_H

#include "geom/bvh.h"
#include "geom/topology.h"
#include "geom/vec3.h"
#include "geom/xform.h"
#include "stock/cell_part.h"
#include "stock/revolved.h"

/* Borrows everything. */
struct obstacle {
	const struct revolved *revolved;	/* NULL: the mesh alone is known */
	const struct bvh *bvh;
	const struct topology *topology;
	double way_x, way_y;	/* mm: with `revolved`: everything counts that it passes on this straight way */
	double inset;	/* mm: only what lies at least this deep in the body counts (the core of a cutter) */
};

/*
 * mm: a lower bound on the signed distance of a point, in the body's mesh coordinates, to what counts of the body. It
 * falls short by rounding only, except near edges of a core. A ball about the point that is smaller contains nothing of
 * the body. The inside of an open mesh is unknown: of such a mesh only the surface counts. So its inset must be 0.
 */
double obstacle_distance(const struct obstacle *obstacle, vec3 point);

/*
 * mm: the same of a whole box with this middle and these halves of its edges: a lower bound on the signed distance of
 * each of its points. `to_obstacle` takes the box's coordinates to the body's.
 */
double obstacle_box_distance(const struct obstacle *obstacle, const xform *to_obstacle, vec3 centre, vec3 half);

/*
 * Half-spaces about the middle of such a box, in its coordinates: each point of the box that is nearer than `within` mm
 * to what counts of the body lies in one of them. Returns their number; -1: it takes too many, or none are known.
 */
enum { OBSTACLE_HALF_SPACES = 6 };
int obstacle_half_spaces(const struct obstacle *obstacle, const xform *to_obstacle, vec3 centre, vec3 half,
			 double within, struct half_space spaces[OBSTACLE_HALF_SPACES]);

#endif
