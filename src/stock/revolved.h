/* revolved.h - a tool's solid of revolution as its outline, with the distance of a point to its surface. */
#ifndef FIVECHECK_STOCK_REVOLVED_H
#define FIVECHECK_STOCK_REVOLVED_H

#include <stdbool.h>
#include <stddef.h>

#include "machine/tool_solid.h"

/*
 * The outline between two heights, in the half plane of radius and height: a straight line, or a quarter circle that
 * begins upright at (r_top, top) and ends level at (r_bottom, bottom), about the point (r_bottom, top).
 */
struct revolved_band {
	double top, bottom;	/* mm; top > bottom */
	double r_top, r_bottom;
	bool round;
};

/* Bands from the top down, without gaps. Level surfaces close the solid at both ends and where radii jump. */
struct revolved {
	struct revolved_band *bands;
	size_t count;
	double radius;	/* mm: the largest */
};

/* The true solid of the sections; the triangles of tool_solid_mesh enclose it. */
void revolved_init(struct revolved *revolved, const struct tool_solid *solid);
void revolved_release(struct revolved *revolved);

/* Is no place thinner than a place below it? */
bool revolved_widens_upward(const struct revolved *revolved);

/*
 * The volume that such a solid sweeps on a path of `length` mm along its axis, from the lower end of the path: the
 * solid with its top raised. revolved_release frees the copy.
 */
void revolved_init_stretched(struct revolved *stretched, const struct revolved *revolved, double length);

/*
 * mm: the distance of the point at radius r >= 0 and height z from the surface; negative inside. Where the solid is
 * convex the function is also convex.
 */
double revolved_distance(const struct revolved *revolved, double r, double z);

/*
 * The same. (*out_r, *out_z) is the outward vector between the point and the nearest point of the surface, with that
 * length.
 */
double revolved_nearest(const struct revolved *revolved, double r, double z, double *out_r, double *out_z);

/*
 * The number of bands from `first` on that together are convex: there the radius is a concave function of the height.
 * At least 1.
 */
size_t revolved_convex_run(const struct revolved *revolved, size_t first);

#endif
