#include "scene/corner_depth.h"

#include <math.h>

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

static bool is_in_box(const struct bvh *solid, vec3 p)
{
	vec3 off = vec3_sub(p, solid->origin);

	return fabs(off.x) < solid->half.x && fabs(off.y) < solid->half.y && fabs(off.z) < solid->half.z;
}

/* The pose of a body's mesh when the axes are at q. */
static xform pose_of(const struct scene *scene, int body, const axis_values *q)
{
	const xform link = machine_pose(scene->machine, scene->bodies[body].body->link, q);

	return xform_mul(&link, &scene->bodies[body].body->placement);
}

double corner_depth(struct scene *scene, int inner, int outer, const axis_values *q, enum inside side)
{
	const struct bvh *solid = scene->bodies[outer].bvh, *other = scene->bodies[inner].bvh;
	const struct topology *topology = scene_body_topology(scene, outer);
	const xform own = pose_of(scene, inner, q), base = pose_of(scene, outer, q), back = xform_inverse(&base);
	const xform pose = xform_mul(&back, &own);
	size_t points = 4 * other->mesh.count, step = points / POINTS_TRIED + 1;
	double depth = 0;

	/* With an odd step all points of triangles have their turn. */
	step |= 1;
	for (size_t i = 0; i < points; i += step) {
		vec3 p = xform_apply(&pose, point_of(&other->mesh.triangles[i / 4], (int)(i % 4)));
		bool known = side == INSIDE_YES ? is_in_box(solid, p) && mesh_inside(solid, topology, p) == INSIDE_YES
						: !is_in_box(solid, p) || mesh_inside(solid, topology, p) == INSIDE_NO;

		if (known)
			depth = fmax(depth, mesh_point_distance(solid, p));
	}
	return depth;
}
