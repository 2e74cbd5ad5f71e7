/* moved_tri.h - triangles of a mesh, and their places at a pose. */
#ifndef FIVECHECK_GEOM_MOVED_TRI_H
#define FIVECHECK_GEOM_MOVED_TRI_H

#include "geom/mesh.h"
#include "geom/tri.h"
#include "geom/xform.h"

static inline tri tri_of(const struct mesh *mesh, size_t index)
{
	const mesh_triangle *t = &mesh->triangles[index];

	return (tri){{mesh_corner(t, 0), mesh_corner(t, 1), mesh_corner(t, 2)}};
}

static inline tri tri_transform(const tri *t, const xform *pose)
{
	return (tri){{xform_apply(pose, t->p[0]), xform_apply(pose, t->p[1]), xform_apply(pose, t->p[2])}};
}

static inline vec3 tri_least(const tri *t)
{
	return vec3_min(t->p[0], vec3_min(t->p[1], t->p[2]));
}

static inline vec3 tri_greatest(const tri *t)
{
	return vec3_max(t->p[0], vec3_max(t->p[1], t->p[2]));
}

/* A lower bound of the distance between a and the hull of b's two places, from their boxes. */
static inline double tri_box_gap(const tri *a, const tri *b0, const tri *b1)
{
	vec3 below = vec3_sub(vec3_min(tri_least(b0), tri_least(b1)), tri_greatest(a));
	vec3 above = vec3_sub(tri_least(a), vec3_max(tri_greatest(b0), tri_greatest(b1)));

	return vec3_norm(vec3_max(vec3_max(below, above), (vec3){0, 0, 0}));
}

#endif
