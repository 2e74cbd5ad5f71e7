#include "geom/point_distance.h"

#include <math.h>

#include "base/minmax.h"
#include "geom/simd_kernels.h"

/* From p's nearest point of the segment to p. */
static vec3 from_segment(vec3 p, vec3 a, vec3 b)
{
	vec3 along = vec3_sub(b, a), to = vec3_sub(p, a);
	double length2 = vec3_norm2(along), s = length2 > 0 ? vec3_dot(to, along) / length2 : 0;

	return vec3_mad(to, -smaller(larger(s, 0), 1), along);
}

/* Sines of angles below this are lost in the rounding of a cross product: the normal may then point anywhere. */
#define LEAST_SINE 1e-6

/* Is the foot of p in the triangle's plane beyond the side? */
static bool is_beyond(vec3 p, vec3 from, vec3 to, vec3 normal)
{
	return vec3_dot(vec3_cross(vec3_sub(to, from), vec3_sub(p, from)), normal) < 0;
}

/*
 * The nearest point is in the plane's foot if that is inside all three sides, else on a side beyond which the foot is.
 * A square that is not below `limit` is of no use: any such may be given.
 */
static double triangle_distance2(vec3 p, const mesh_triangle *t, double limit)
{
	const vec3 corner[3] = {mesh_corner(t, 0), mesh_corner(t, 1), mesh_corner(t, 2)};
	const vec3 ab = vec3_sub(corner[1], corner[0]), ac = vec3_sub(corner[2], corner[0]);
	const vec3 normal = vec3_cross(ab, ac);
	const double size2 = vec3_norm2(normal), height = vec3_dot(vec3_sub(p, corner[0]), normal);
	const bool flat = size2 > LEAST_SINE * LEAST_SINE * vec3_norm2(ab) * vec3_norm2(ac);
	double least = INFINITY;
	bool inside = size2 > 0;

	if (flat && height * height >= limit * size2)
		return INFINITY;
	for (int k = 0; k < 3; k++) {
		const vec3 from = corner[k], to = corner[(k + 1) % 3];
		const bool beyond = is_beyond(p, from, to, normal);

		inside &= !beyond;
		if (beyond || !flat)
			least = smaller(least, vec3_norm2(from_segment(p, from, to)));
	}
	return inside ? height * height / size2 : least;
}

/* The point of the triangle that is nearest to p, as triangle_distance2 sees it. */
static vec3 triangle_nearest_point(vec3 p, const mesh_triangle *t)
{
	const vec3 corner[3] = {mesh_corner(t, 0), mesh_corner(t, 1), mesh_corner(t, 2)};
	const vec3 normal = vec3_cross(vec3_sub(corner[1], corner[0]), vec3_sub(corner[2], corner[0]));
	const double size2 = vec3_norm2(normal), height = vec3_dot(vec3_sub(p, corner[0]), normal);
	vec3 least = from_segment(p, corner[0], corner[1]);
	bool inside = size2 > 0;

	for (int k = 0; k < 3; k++) {
		const vec3 from = corner[k], to = corner[(k + 1) % 3], other = from_segment(p, from, to);

		inside &= !is_beyond(p, from, to, normal);
		least = vec3_norm2(other) < vec3_norm2(least) ? other : least;
	}
	return inside ? vec3_mad(p, -height / size2, normal) : vec3_sub(p, least);
}

struct search {
	const struct bvh *bvh;
	const struct simd_kernels *kernels;
	vec3 point;
	float from[3], slack;	/* as boxes_near_fn asks for them */
	double best;	/* the square of the distance of the nearest triangle so far */
	double enough;	/* the square of a distance that ends the search once a triangle is so near */
	bool done;
	uint32_t triangle;
	long visits;	/* boxes looked at */
};

/* More than 8 roundings of float. */
#define SLACK_SHARE 0x1p-20

/* A search for a triangle within the square root of `best` mm. */
static struct search search_of(const struct bvh *bvh, vec3 point, double best, double enough)
{
	const vec3 off = vec3_sub(point, bvh->origin);

	return (struct search){
		.bvh = bvh,
		.kernels = simd_kernels_at_level(bvh->simd_level),
		.point = point,
		.from = {(float)off.x, (float)off.y, (float)off.z},
		.slack = (float)(SLACK_SHARE * (vec3_norm(off) + 2 * vec3_norm(bvh->half))),
		.best = best,
		.enough = enough,
	};
}

static void try_triangle(struct search *search, uint32_t triangle)
{
	double distance = triangle_distance2(search->point, &search->bvh->mesh.triangles[triangle], search->best);

	if (!(distance < search->best))
		return;
	search->best = distance;
	search->done = distance <= search->enough;
	search->triangle = triangle;
}

/* The nearest child that is open. */
static int nearest_of(unsigned open, const float near2[BVH_WIDTH])
{
	int nearest = 0;

	for (int lane = 1; open >> lane; lane++) {
		if ((open >> lane & 1) && (!(open >> nearest & 1) || near2[lane] < near2[nearest]))
			nearest = lane;
	}
	return nearest;
}

/* Nearest child first; as deep as the tree. */
static void try_node(struct search *search, const struct bvh_node *node)
{
	float near2[BVH_WIDTH];
	unsigned open = search->kernels->boxes_near(node, search->from, search->slack,
						    (float)(search->best * (1 + SLACK_SHARE)), near2);

	search->visits += node->used;
	while (open && !search->done) {
		const int nearest = nearest_of(open, near2);

		if (!((double)near2[nearest] < search->best))
			break;
		open &= ~(1u << nearest);
		for (uint32_t i = 0; i < node->count[nearest]; i++)
			try_triangle(search, node->first[nearest] + i);
		if (!node->count[nearest])
			try_node(search, &search->bvh->nodes[node->first[nearest]]);
	}
}

double mesh_point_distance_above(const struct bvh *bvh, vec3 point, double enough)
{
	struct search search = search_of(bvh, point, INFINITY, enough * enough);

	try_node(&search, &bvh->nodes[0]);
	return sqrt(search.best);
}

double mesh_point_distance(const struct bvh *bvh, vec3 point)
{
	return mesh_point_distance_above(bvh, point, 0);
}

double triangle_point_distance(const mesh_triangle *triangle, vec3 point)
{
	return sqrt(triangle_distance2(point, triangle, INFINITY));
}

bool mesh_nearest_triangle(const struct bvh *bvh, vec3 point, double within, double enough,
			   struct nearest_triangle *nearest, long *visits)
{
	const double limit = within * within;
	struct search search = search_of(bvh, point, limit, enough * enough);

	try_node(&search, &bvh->nodes[0]);
	*visits += search.visits;
	if (!(search.best < limit))
		return false;
	*nearest = (struct nearest_triangle){
		.distance = sqrt(search.best),
		.triangle = search.triangle,
		.at = triangle_nearest_point(point, &bvh->mesh.triangles[search.triangle]),
	};
	return true;
}
