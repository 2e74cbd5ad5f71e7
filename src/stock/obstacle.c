#include "stock/obstacle.h"

#include <math.h>

#include "base/minmax.h"
#include "geom/inside.h"
#include "geom/point_distance.h"

/* mm: too short to tell a direction. */
#define TINY 1e-6

/* A computed direction is off by less, as a share: TINY holds the rounding of some 1e-13 mm against it. */
#define ROUNDING 1e-6

static double mesh_distance(const struct obstacle *obstacle, vec3 point)
{
	const struct bvh *bvh = obstacle->bvh;
	const double distance = mesh_point_distance(bvh, point);
	const vec3 off = vec3_sub(point, bvh->origin);
	enum inside side;

	if (fabs(off.x) > bvh->half.x || fabs(off.y) > bvh->half.y || fabs(off.z) > bvh->half.z)
		return distance;
	side = mesh_inside(bvh, obstacle->topology, point);
	/* Who comes in passes the surface. A core has no surface of its own: what may be inside counts as inside. */
	return side == INSIDE_YES || (side == INSIDE_UNKNOWN && obstacle->inset > 0) ? -distance : distance;
}

/*
 * Where on its way the solid's axis is nearest to the point. At one height the signed distance grows with the distance
 * from the axis, since the solid reaches from the axis to one radius: so there it is least of all.
 */
static void off_axis(const struct obstacle *obstacle, vec3 point, double *dx, double *dy)
{
	const double x = obstacle->way_x, y = obstacle->way_y, length2 = x * x + y * y;
	const double s = length2 > 0 ? smaller(larger((point.x * x + point.y * y) / length2, 0), 1) : 0;

	*dx = point.x - s * x;
	*dy = point.y - s * y;
}

double obstacle_distance(const struct obstacle *obstacle, vec3 point)
{
	double dx, dy;

	if (!obstacle->revolved)
		return mesh_distance(obstacle, point) + obstacle->inset;
	off_axis(obstacle, point, &dx, &dy);
	return revolved_distance(obstacle->revolved, sqrt(dx * dx + dy * dy), point.z) + obstacle->inset;
}

/* How far the corners of a box reach from its middle along a unit vector of the obstacle's coordinates. */
static double box_reach(const xform *to_obstacle, vec3 unit, vec3 half)
{
	const vec3 along = mat3_apply_transposed(&to_obstacle->rotation, unit);

	return (half.x * fabs(along.x) + half.y * fabs(along.y) + half.z * fabs(along.z)) * (1 + ROUNDING) +
	       ROUNDING * vec3_norm(half);
}

/*
 * The signed distance to a convex solid is a convex function, also with a straight way: it lies above its tangent
 * plane in the middle of the box, and the plane is least at a corner.
 */
static double piece_distance(const struct obstacle *obstacle, const struct revolved *piece, const xform *to_obstacle,
			     vec3 centre, vec3 half)
{
	const vec3 point = xform_apply(to_obstacle, centre);
	double dx, dy, r, out_r, out_z, distance, length;
	vec3 out;

	off_axis(obstacle, point, &dx, &dy);
	r = sqrt(dx * dx + dy * dy);
	distance = revolved_nearest(piece, r, point.z, &out_r, &out_z);
	length = fabs(distance);
	/* Without a direction: on the surface, and on the axis. */
	if (length < TINY || (r < TINY && fabs(out_r) > 0))
		return distance - vec3_norm(half);
	out = r < TINY ? (vec3){0, 0, out_z} : (vec3){out_r * dx / r, out_r * dy / r, out_z};
	return distance - box_reach(to_obstacle, vec3_scale(1 / length, out), half);
}

double obstacle_box_distance(const struct obstacle *obstacle, const xform *to_obstacle, vec3 centre, vec3 half)
{
	const struct revolved *whole = obstacle->revolved;
	double least = INFINITY;
	size_t length;

	/* Pieces that meet are together deeper inside than each of them, so the core of several is not that of each. */
	if (!whole || (obstacle->inset > 0 && revolved_convex_run(whole, 0) < whole->count))
		return obstacle_distance(obstacle, xform_apply(to_obstacle, centre)) - vec3_norm(half);
	for (size_t i = 0; i < whole->count; i += length) {
		struct revolved piece = {.bands = &whole->bands[i]};

		piece.count = length = revolved_convex_run(whole, i);
		least = smaller(least, piece_distance(obstacle, &piece, to_obstacle, centre, half));
	}
	return least + obstacle->inset;
}
