#include "scene/corner_depth.h"

#include <math.h>

#include "base/minmax.h"
#include "geom/point_distance.h"
#include "machine/chain.h"

/* The number of points of a body that are tested. */
enum { POINTS_TRIED = 400 };
/* The number of balls that are kept: searching more of them would take longer than they save. */
enum { BALLS_KEPT = 32 };

/* A corner of a triangle (k below 3) or its middle. */
static vec3 point_of(const mesh_triangle *t, int k)
{
	vec3 sum = vec3_add(mesh_corner(t, 0), vec3_add(mesh_corner(t, 1), mesh_corner(t, 2)));

	return k < 3 ? mesh_corner(t, k) : vec3_scale(1.0 / 3, sum);
}

/* mm: how deep the point is inside the solid's box, an upper bound of its depth in the solid; below 0: outside. */
static double room_in_box(const struct bvh *solid, vec3 p)
{
	vec3 off = vec3_sub(p, solid->origin);

	return smaller(solid->half.x - fabs(off.x), smaller(solid->half.y - fabs(off.y), solid->half.z - fabs(off.z)));
}

/* Balls around points on one side of a surface that do not reach the surface: every point in them is on that side. */
struct cleared {
	vec3 centre[BALLS_KEPT];
	double radius[BALLS_KEPT];
	int count;
};

static bool is_cleared(const struct cleared *cleared, vec3 p)
{
	for (int i = 0; i < cleared->count; i++) {
		if (vec3_norm2(vec3_sub(p, cleared->centre[i])) < cleared->radius[i] * cleared->radius[i])
			return true;
	}
	return false;
}

static void clear_ball(struct cleared *cleared, vec3 centre, double radius)
{
	if (cleared->count == BALLS_KEPT)
		return;
	cleared->centre[cleared->count] = centre;
	cleared->radius[cleared->count++] = radius;
}

/* Is the point inside the body's mesh? A doubt does not need the topology of a large mesh that is closed. */
static bool is_inside(struct scene *scene, int body, vec3 p)
{
	const struct bvh *solid = scene->bodies[body].bvh;

	if (mesh_ray_is_free(solid, p))
		return false;
	return scene_body_is_balanced(scene, body) ? mesh_is_inside_closed(solid, p)
						   : mesh_is_inside(solid, scene_body_topology(scene, body), p);
}

/*
 * The side of the body's surface on which the point is; `room` is from room_in_box. If `side` is INSIDE_YES, the result
 * INSIDE_NO means only that the point is not known to be inside; then the same holds for all points that no surface
 * separates from it.
 */
static enum inside side_of(struct scene *scene, int body, vec3 p, double room, enum inside side)
{
	const struct bvh *solid = scene->bodies[body].bvh;

	if (!(room > 0))
		return INSIDE_NO;
	if (side == INSIDE_YES)
		return is_inside(scene, body, p) ? INSIDE_YES : INSIDE_NO;
	return mesh_inside(solid, scene_body_topology(scene, body), p);
}

/* The pose of a body's mesh when the axes are at q. */
static xform pose_of(const struct scene *scene, int body, const axis_values *q)
{
	const xform link = machine_pose(scene->machine, scene->bodies[body].body->link, q);

	return xform_mul(&link, &scene->bodies[body].body->placement);
}

double corner_depth(struct scene *scene, int inner, int outer, const axis_values *q, enum inside side, double beyond)
{
	const struct bvh *solid = scene->bodies[outer].bvh, *other = scene->bodies[inner].bvh;
	const xform own = pose_of(scene, inner, q), base = pose_of(scene, outer, q), back = xform_inverse(&base);
	const xform pose = xform_mul(&back, &own);
	size_t points = 4 * other->mesh.count, step = points / POINTS_TRIED + 1;
	const enum inside other_side = side == INSIDE_YES ? INSIDE_NO : INSIDE_YES;
	struct cleared cleared = {.count = 0};
	double depth = 0;

	/* An odd step tries all points of triangles: corners and middles. */
	step |= 1;
	for (size_t i = 0; i < points; i += step) {
		vec3 p = xform_apply(&pose, point_of(&other->mesh.triangles[i / 4], (int)(i % 4)));
		const double least = larger(depth, beyond), room = room_in_box(solid, p);
		enum inside found;
		double distance;

		if ((side == INSIDE_YES && !(room > least)) || is_cleared(&cleared, p))
			continue;
		distance = mesh_point_distance_above(solid, p, least);
		/* To find a point's side takes longer than to find its distance from the surface. */
		if (!(distance > least))
			continue;
		found = side_of(scene, outer, p, room, side);
		if (found == side)
			depth = distance;
		else if (found == other_side)
			clear_ball(&cleared, p, distance);
	}
	return depth;
}
