#include "scene/cutter_depth.h"

#include "geom/inside.h"
#include "geom/point_distance.h"
#include "machine/tool_core.h"

/* The numbers of points examined in a mesh for each depth: along its axis, and beside some of its triangles. */
enum { AXIS_POINTS = 64, TRIANGLES = 500 };

/* The most halvings of the depth for a mesh: to a thousandth. */
enum { HALVINGS = 10 };

struct mesh_search {
	const struct bvh *bvh;
	const struct topology *topology;
	double depth;
};

static bool is_deep(const struct mesh_search *search, vec3 point)
{
	return mesh_point_distance(search->bvh, point) >= search->depth &&
	       mesh_inside(search->bvh, search->topology, point) == INSIDE_YES;
}

static bool axis_is_deep(const struct mesh_search *search)
{
	const struct bvh *bvh = search->bvh;

	for (int i = 0; i < AXIS_POINTS; i++) {
		const double share = (i + 0.5) / AXIS_POINTS;

		if (is_deep(search, (vec3){0, 0, bvh->origin.z + bvh->half.z * (2 * share - 1)}))
			return true;
	}
	return false;
}

/* Is the point just below the middle of a triangle deep? It is where the mesh is thicker than twice the depth. */
static bool beside_is_deep(const struct mesh_search *search, const mesh_triangle *triangle)
{
	const vec3 a = mesh_corner(triangle, 0), b = mesh_corner(triangle, 1), c = mesh_corner(triangle, 2);
	const vec3 normal = vec3_cross(vec3_sub(b, a), vec3_sub(c, a));
	const vec3 middle = vec3_scale(1.0 / 3, vec3_add(a, vec3_add(b, c)));
	const double length = vec3_norm(normal), off = 1.001 * search->depth / length;

	return length > 0 && (is_deep(search, vec3_mad(middle, off, normal)) ||
			      is_deep(search, vec3_mad(middle, -off, normal)));
}

static bool some_are_deep(const struct mesh_search *search)
{
	const struct mesh *mesh = &search->bvh->mesh;
	const size_t step = mesh->count / TRIANGLES + 1;

	if (axis_is_deep(search))
		return true;
	for (size_t i = 0; i < mesh->count; i += step)
		if (beside_is_deep(search, &mesh->triangles[i]))
			return true;
	return false;
}

double cutter_depth(struct scene *scene, int body, double depth)
{
	const struct body *cutter = scene->bodies[body].body;
	struct mesh_search search = {.depth = depth};

	if (cutter->profile)
		return tool_core_depth(cutter->profile, depth);
	search.bvh = scene_body_bvh(scene, body);
	search.topology = scene_body_topology(scene, body);
	/* An open mesh has no depth at all, and a check says so. */
	if (topology_is_open(search.topology) || !(depth > 0))
		return depth;
	for (int i = 0; i <= HALVINGS; i++) {
		if (some_are_deep(&search))
			return search.depth;
		search.depth /= 2;
	}
	return 0;
}
