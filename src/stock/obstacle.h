/* obstacle.h - a body that must not touch the stock, as a lower bound of its distance from points. */
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
	const struct revolved *revolved;	/* NULL: only the mesh is known */
	const struct bvh *bvh;
	const struct topology *topology;
	double way_x, way_y;	/* mm: with `revolved`: the obstacle is everything it sweeps along this straight path */
	double inset;	/* mm: the obstacle is the part at least this deep in the body (the core of a cutter) */
};

/*
 * mm: a lower bound of the signed distance of a point, in the body's mesh coordinates, from the obstacle. Only rounding
 * makes it smaller than the true distance, except near edges of a core. A smaller ball about the point contains nothing
 * of the body. An open mesh has no defined inside: only its surface counts, so its inset must be 0.
 */
double obstacle_distance(const struct obstacle *obstacle, vec3 point);

/*
 * mm: the same for a whole box with this middle and these halves of its edges: a lower bound of the signed distance of
 * each of its points. `to_obstacle` maps the box's coordinates to the body's.
 */
double obstacle_box_distance(const struct obstacle *obstacle, const xform *to_obstacle, vec3 centre, vec3 half);

/*
 * Half-spaces about the middle of such a box, in its coordinates: each point of the box that is nearer than `within` mm
 * to the obstacle is in one of them. Returns their number; -1: too many would be needed, or none are known.
 */
enum { OBSTACLE_HALF_SPACES = 6 };
int obstacle_half_spaces(const struct obstacle *obstacle, const xform *to_obstacle, vec3 centre, vec3 half,
			 double within, struct half_space spaces[OBSTACLE_HALF_SPACES]);

#endif
