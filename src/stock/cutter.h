/* cutter.h - what a turning cutter certainly removes: cubes that are inside it at one instant. */
#ifndef FIVECHECK_STOCK_CUTTER_H
#define FIVECHECK_STOCK_CUTTER_H

#include <stdbool.h>
#include <stddef.h>

#include "geom/vec3.h"
#include "stock/cell_part.h"
#include "stock/cube.h"
#include "stock/revolved.h"

/* The pose of a cutter in the stock's coordinates. */
struct cutter_place {
	vec3 origin;	/* of the cutter's mesh coordinates: the gauge point, mm */
	vec3 up;	/* unit: the mesh's Z, which points away from the tip */
};

/* A solid of revolution, and its convex pieces from the top down. It removes its whole volume along its path. */
struct cutter {
	struct revolved whole;
	struct revolved *pieces;	/* their bands are those of `whole` */
	size_t piece_count;
};

void cutter_init(struct cutter *cutter, const struct tool_solid *solid);
void cutter_release(struct cutter *cutter);

/* A cutter that moves from one pose to another: each point of its axis moves straight and at constant speed. */
struct cutter_way {
	struct cutter_place from, to;
};

/* The pose of the cutter after the share s of its path. */
struct cutter_place cutter_place_between(const struct cutter_place *from, const struct cutter_place *to, double s);

/* The box around the cutter on its path. */
void cutter_way_bounds(const struct cutter *cutter, const struct cutter_way *way, vec3 *low, vec3 *high);

/*
 * A time, 0 to 1, at which the whole cube is at least `depth` mm inside the cutter, and hardly any earlier one;
 * INFINITY if none was found. Cubes are tested inside each convex piece by their corners, and inside the whole cutter,
 * across the seams of its pieces, by the ball around them. The answer depends only on the arguments.
 */
double cutter_removes(const struct cutter *cutter, const struct cutter_way *way, const struct cube *cube, double depth);

/*
 * Is the whole part of a cell at least `depth` mm inside one convex piece of the cutter, at the time up to `latest` at
 * which the cutter's axis is nearest to the middle of the part? It may be at another time.
 */
bool cutter_removes_part(const struct cutter *cutter, const struct cutter_way *way, const struct cell_part *part,
			 double depth, double latest);

/*
 * May the cutter come within `distance` mm of the point? False is certain; true may be wrong if the cutter stays at
 * most COMES_WITHIN_SLACK farther away.
 */
#define COMES_WITHIN_SLACK 1e-3
bool cutter_comes_within(const struct cutter *cutter, const struct cutter_way *way, vec3 point, double distance);

#endif
