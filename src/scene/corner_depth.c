#include "scene/corner_depth.h"

#include <math.h>

#include "geom/point_distance.h"

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

double corner_depth(struct scene *scene, int inner, int outer, enum inside side)
{
	const struct bvh *solid = scene->bodies[outer].bvh, *other = scene->bodies[inner].bvh;
	const struct topology *topology = scene_body_topology(scene, outer);
	const xform back = xform_inverse(&scene->bodies[outer].body->placement);
	const xform pose = xform_mul(&back, &scene->bodies[inner].body->placement);
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
