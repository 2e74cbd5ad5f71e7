#include "stock/obstacle.h"

#include <math.h>

#include "base/minmax.h"
#include "geom/inside.h"
#include "geom/point_distance.h"

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
 * The least distance of the point from the axis on its way. At one height the signed distance grows with the distance
 * from the axis, since the solid reaches from the axis to one radius: so the least distance gives the least of all.
 */
static double least_radius(const struct obstacle *obstacle, vec3 point)
{
	const double x = obstacle->way_x, y = obstacle->way_y, length2 = x * x + y * y;
	const double s = length2 > 0 ? smaller(larger((point.x * x + point.y * y) / length2, 0), 1) : 0;
	const double dx = point.x - s * x, dy = point.y - s * y;

	return sqrt(dx * dx + dy * dy);
}

double obstacle_distance(const struct obstacle *obstacle, vec3 point)
{
	if (obstacle->revolved)
		return revolved_distance(obstacle->revolved, least_radius(obstacle, point), point.z) + obstacle->inset;
	return mesh_distance(obstacle, point) + obstacle->inset;
}
