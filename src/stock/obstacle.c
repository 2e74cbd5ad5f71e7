#include "stock/obstacle.h"

#include <math.h>

#include "base/minmax.h"
#include "geom/inside.h"
#include "geom/point_distance.h"

/* mm: shorter vectors have no reliable direction. */
#define TINY 1e-6

/* The largest relative error of a computed direction: the rounding of some 1e-13 mm in a vector of at least TINY. */
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
	/*
	 * A body that enters crosses the surface. A core has no surface of its own, so what may be inside counts as
	 * inside.
	 */
	return side == INSIDE_YES || (side == INSIDE_UNKNOWN && obstacle->inset > 0) ? -distance : distance;
}

/*
 * The vector to the point from the position of the solid's axis, on its way, that is nearest to the point. At a given
 * height the signed distance increases with the distance from the axis, because the solid extends from the axis to one
 * radius. So the signed distance is least at this position.
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

/* The extent of a box from its middle along a unit vector of the obstacle's coordinates. */
static double box_reach(const xform *to_obstacle, vec3 unit, vec3 half)
{
	const vec3 along = mat3_apply_transposed(&to_obstacle->rotation, unit);

	return (half.x * fabs(along.x) + half.y * fabs(along.y) + half.z * fabs(along.z)) * (1 + ROUNDING) +
	       ROUNDING * vec3_norm(half);
}

/*
 * The signed distance to a convex solid is a convex function, also with a straight way, so it is above its tangent
 * plane at a point.
 */
struct tangent {
	double distance;	/* at the point */
	vec3 out;	/* unit, the obstacle's coordinates: the direction in which the distance grows; 0: unknown */
};

static struct tangent tangent_at(const struct obstacle *obstacle, const struct revolved *piece, vec3 point)
{
	double dx, dy, r, out_r, out_z, length;
	struct tangent tangent = {.distance = 0};

	off_axis(obstacle, point, &dx, &dy);
	r = sqrt(dx * dx + dy * dy);
	tangent.distance = revolved_nearest(piece, r, point.z, &out_r, &out_z);
	length = fabs(tangent.distance);
	/* On the surface and on the axis there is no direction. */
	if (length < TINY || (r < TINY && fabs(out_r) > 0))
		return tangent;
	tangent.out = r < TINY ? (vec3){0, 0, out_z} : (vec3){out_r * dx / r, out_r * dy / r, out_z};
	tangent.out = vec3_scale(1 / length, tangent.out);
	return tangent;
}

/* A lower bound of the distance of the box's points from the piece: the tangent plane is lowest at a corner. */
static double piece_distance(const struct tangent *tangent, const xform *to_obstacle, vec3 half)
{
	return tangent->distance - (vec3_norm2(tangent->out) > 0 ? box_reach(to_obstacle, tangent->out, half)
								 : vec3_norm(half));
}

/* The convex piece that begins with this band. */
static struct revolved piece_from(const struct obstacle *obstacle, size_t first)
{
	const struct revolved *whole = obstacle->revolved;

	return (struct revolved){.bands = &whole->bands[first], .count = revolved_convex_run(whole, first)};
}

/*
 * A point can be deeper in several touching pieces together than in each of them, so the core of several pieces is not
 * the union of their cores.
 */
static bool has_pieces(const struct obstacle *obstacle)
{
	const struct revolved *whole = obstacle->revolved;

	return whole && !(obstacle->inset > 0 && revolved_convex_run(whole, 0) < whole->count);
}

double obstacle_box_distance(const struct obstacle *obstacle, const xform *to_obstacle, vec3 centre, vec3 half)
{
	const vec3 point = xform_apply(to_obstacle, centre);
	double least = INFINITY;
	struct revolved piece;

	if (!has_pieces(obstacle))
		return obstacle_distance(obstacle, point) - vec3_norm(half);
	for (size_t i = 0; i < obstacle->revolved->count; i += piece.count) {
		struct tangent tangent;

		piece = piece_from(obstacle, i);
		tangent = tangent_at(obstacle, &piece, point);
		least = smaller(least, piece_distance(&tangent, to_obstacle, half));
	}
	return least + obstacle->inset;
}

/* The points of the box for which the tangent plane does not prove more than `within` mm. */
static struct half_space half_space_of(const struct tangent *tangent, const xform *to_obstacle, vec3 half,
				       double within)
{
	struct half_space space = {.normal = mat3_apply_transposed(&to_obstacle->rotation, tangent->out)};

	if (vec3_norm2(tangent->out) > 0)
		space.offset = within - tangent->distance + 2 * ROUNDING * vec3_norm(half);
	return space;
}

int obstacle_half_spaces(const struct obstacle *obstacle, const xform *to_obstacle, vec3 centre, vec3 half,
			 double within, struct half_space spaces[OBSTACLE_HALF_SPACES])
{
	const vec3 point = xform_apply(to_obstacle, centre);
	struct revolved piece;
	int count = 0;

	if (!has_pieces(obstacle))
		return -1;
	for (size_t i = 0; i < obstacle->revolved->count; i += piece.count) {
		struct tangent tangent;

		piece = piece_from(obstacle, i);
		tangent = tangent_at(obstacle, &piece, point);
		if (piece_distance(&tangent, to_obstacle, half) > within - obstacle->inset)
			continue;
		if (count == OBSTACLE_HALF_SPACES)
			return -1;
		spaces[count++] = half_space_of(&tangent, to_obstacle, half, within - obstacle->inset);
	}
	return count;
}
