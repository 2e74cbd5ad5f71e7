/* inside.h - is a point inside a mesh? */
#ifndef FIVECHECK_GEOM_INSIDE_H
#define FIVECHECK_GEOM_INSIDE_H

#include "geom/bvh.h"
#include "geom/mesh.h"
#include "geom/topology.h"
#include "geom/vec3.h"

/*
 * The winding number of a closed mesh about a point that is not on its
 * surface: the sum of the signed solid angles of its triangles over 4 pi (Van
 * Oosterom and Strackee, "The solid angle of a plane triangle", 1983). Nonzero
 * is inside; a cavity counts 0.
 */
int mesh_winding_number(const struct mesh *mesh, vec3 point);

enum inside {
	INSIDE_NO,
	INSIDE_YES,
	INSIDE_UNKNOWN	/* the mesh is open there, or its shells do not say which side is solid */
};

/*
 * Is the point, which is not on the surface, inside the mesh? `topology` is that of bvh->mesh. Oriented shells
 * are judged together by their winding number: a shell that faces the other way inside another one is a cavity.
 */
enum inside mesh_inside(const struct bvh *bvh, const struct topology *topology, vec3 point);

/*
 * Does mesh_inside return INSIDE_YES? For an open shell this costs far less: whether it might hold the point, if its
 * holes were closed, is not computed.
 */
bool mesh_is_inside(const struct bvh *bvh, const struct topology *topology, vec3 point);

/* The winding number of a mesh whose edges are known to be balanced (edge_balance.h), without a topology. */
bool mesh_is_inside_closed(const struct bvh *bvh, vec3 point);

/*
 * Does one of a few rays from the point cross no triangle? Then mesh_inside does not return INSIDE_YES for the point,
 * and no topology is needed.
 */
bool mesh_ray_is_free(const struct bvh *bvh, vec3 point);

/* The winding number about the point of one oriented shell of a mesh that has shells. */
int shell_winding_number(const struct mesh *mesh, const struct topology *topology, uint32_t shell, vec3 point);

#endif
