#include "scene/corner_depth.h"

#include <math.h>

#include "base/minmax.h"
#include "geom/point_distance.h"
#include "machine/chain.h"

/* Points of a body that are tested. */
enum { POINTS_TRIED = 400 };

/* The corners of a triangle, and then its middle. */
static vec3 point_of(const mesh_triangle *t, int k)
{
	vec3 sum = vec3_add(mesh_corner(t, 0), vec3_add(mesh_corner(t, 1), mesh_corner(t, 2)));

	return k < 3 ? mesh_corner(t, k) : vec3_scale(1.0 / 3, sum);
}

/* mm: how far inside the solid's box the point lies, which is as deep as it can be in the solid; below 0: outside. */
static double room_in_box(const struct bvh *solid, vec3 p)
{
	vec3 off = vec3_sub(p, solid->origin);

	return fmin(solid->half.x - fabs(off.x), fmin(solid->half.y - fabs(off.y), solid->half.z - fabs(off.z)));
}

/* On which side of the body's surface the point lies that has so much room in its box. */
static enum inside side_of(struct scene *scene, int body, vec3 p, double room)
{
	if (!(room > 0))
		return INSIDE_NO;
	return mesh_inside(scene->bodies[body].bvh, scene_body_topology(scene, body), p);
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
	double depth = 0;

	/* With an odd step all points of triangles have their turn. */
	step |= 1;
	for (size_t i = 0; i < points; i += step) {
		vec3 p = xform_apply(&pose, point_of(&other->mesh.triangles[i / 4], (int)(i % 4)));
		const double least = larger(depth, beyond), room = room_in_box(solid, p);
		double distance;

		if (side == INSIDE_YES && !(room > least))
			continue;
		distance = mesh_point_distance(solid, p);
		/* Which side a point is on takes longer to find than how far it is from the surface. */
		if (distance > least && side_of(scene, outer, p, room) == side)
			depth = distance;
	}
	return depth;
}
