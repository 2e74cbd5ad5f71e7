#include "geom/point_distance.h"

#include <math.h>

/* The square of the distance to the segment. */
static double segment_distance2(vec3 p, vec3 a, vec3 b)
{
	vec3 along = vec3_sub(b, a), to = vec3_sub(p, a);
	double length2 = vec3_norm2(along), s = length2 > 0 ? vec3_dot(to, along) / length2 : 0;

	return vec3_norm2(vec3_mad(to, -fmin(fmax(s, 0), 1), along));
}

/* The nearest point is in the plane's foot if that is inside all three sides, else on a side. */
static double triangle_distance2(vec3 p, const mesh_triangle *t)
{
	vec3 a = mesh_corner(t, 0), b = mesh_corner(t, 1), c = mesh_corner(t, 2);
	vec3 normal = vec3_cross(vec3_sub(b, a), vec3_sub(c, a));
	double size2 = vec3_norm2(normal), height = vec3_dot(vec3_sub(p, a), normal);

	if (size2 > 0 && vec3_dot(vec3_cross(vec3_sub(b, a), vec3_sub(p, a)), normal) >= 0 &&
	    vec3_dot(vec3_cross(vec3_sub(c, b), vec3_sub(p, b)), normal) >= 0 &&
	    vec3_dot(vec3_cross(vec3_sub(a, c), vec3_sub(p, c)), normal) >= 0)
		return height * height / size2;
	return fmin(segment_distance2(p, a, b), fmin(segment_distance2(p, b, c), segment_distance2(p, c, a)));
}

static double box_distance2(const struct bvh_node *node, int lane, vec3 off)
{
	double x = fmax(0, fabs(off.x - (double)node->centre[0][lane]) - (double)node->half[0][lane]);
	double y = fmax(0, fabs(off.y - (double)node->centre[1][lane]) - (double)node->half[1][lane]);
	double z = fmax(0, fabs(off.z - (double)node->centre[2][lane]) - (double)node->half[2][lane]);

	return x * x + y * y + z * z;
}

struct search {
	const struct bvh *bvh;
	vec3 point;
	double best;	/* the square of the distance of the nearest triangle so far */
	uint32_t triangle;
	long visits;	/* boxes looked at */
};

static void try_triangle(struct search *search, uint32_t triangle)
{
	double distance = triangle_distance2(search->point, &search->bvh->mesh.triangles[triangle]);

	if (!(distance < search->best))
		return;
	search->best = distance;
	search->triangle = triangle;
}

/* Nearest child first; as deep as the tree. */
static void try_node(struct search *search, const struct bvh_node *node)
{
	vec3 off = vec3_sub(search->point, search->bvh->origin);
	double least[BVH_WIDTH];

	search->visits += node->used;
	for (int lane = 0; lane < node->used; lane++)
		least[lane] = box_distance2(node, lane, off);
	for (int turn = 0; turn < node->used; turn++) {
		int nearest = 0;

		for (int lane = 1; lane < node->used; lane++) {
			if (least[lane] < least[nearest])
				nearest = lane;
		}
		if (!(least[nearest] < search->best))
			break;
		least[nearest] = INFINITY;
		for (uint32_t i = 0; i < node->count[nearest]; i++)
			try_triangle(search, node->first[nearest] + i);
		if (!node->count[nearest])
			try_node(search, &search->bvh->nodes[node->first[nearest]]);
	}
}

double mesh_point_distance(const struct bvh *bvh, vec3 point)
{
	struct search search = {.bvh = bvh, .point = point, .best = INFINITY};

	try_node(&search, &bvh->nodes[0]);
	return sqrt(search.best);
}

bool mesh_nearest_triangle(const struct bvh *bvh, vec3 point, double within, struct nearest_triangle *nearest,
			   long *visits)
{
	const double limit = within * within;
	struct search search = {.bvh = bvh, .point = point, .best = limit};

	try_node(&search, &bvh->nodes[0]);
	*visits += search.visits;
	if (!(search.best < limit))
		return false;
	*nearest = (struct nearest_triangle){sqrt(search.best), search.triangle};
	return true;
}
