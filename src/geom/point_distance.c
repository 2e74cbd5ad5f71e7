#include "geom/point_distance.h"

#include <math.h>

#include "base/minmax.h"
#include "geom/simd_kernels.h"

/* The vector from the segment's nearest point to p. */
static vec3 from_segment(vec3 p, vec3 a, vec3 b)
{
	vec3 along = vec3_sub(b, a), to = vec3_sub(p, a);
	double length2 = vec3_norm2(along), s = length2 > 0 ? vec3_dot(to, along) / length2 : 0;

	return vec3_mad(to, -smaller(larger(s, 0), 1), along);
}

/* Smaller sines of angles are below the rounding of a cross product. */
#define LEAST_SINE 1e-6

/* The shortest of the vectors from the three sides to p. */
static vec3 from_sides(vec3 p, const vec3 corner[3])
{
	vec3 least = from_segment(p, corner[0], corner[1]);

	for (int k = 1; k < 3; k++) {
		const vec3 other = from_segment(p, corner[k], corner[(k + 1) % 3]);

		least = vec3_norm2(other) < vec3_norm2(least) ? other : least;
	}
	return least;
}

/*
 * The vector from the triangle's nearest point to p. The products along two sides show whether this point is a corner,
 * on a side, or inside (Ericson, Real-Time Collision Detection, 5.1.5). Whatever the rounding of the products, the
 * chosen point belongs to the triangle.
 */
static vec3 from_triangle(vec3 p, const mesh_triangle *t)
{
	const vec3 corner[3] = {mesh_corner(t, 0), mesh_corner(t, 1), mesh_corner(t, 2)};
	const vec3 ab = vec3_sub(corner[1], corner[0]), ac = vec3_sub(corner[2], corner[0]);
	const vec3 to_a = vec3_sub(p, corner[0]), to_b = vec3_sub(p, corner[1]), to_c = vec3_sub(p, corner[2]);
	const double ab_a = vec3_dot(ab, to_a), ac_a = vec3_dot(ac, to_a);
	const double ab_b = vec3_dot(ab, to_b), ac_b = vec3_dot(ac, to_b);
	const double ab_c = vec3_dot(ab, to_c), ac_c = vec3_dot(ac, to_c);
	double of_a, of_b, of_c, sum;

	if (ab_a <= 0 && ac_a <= 0)
		return to_a;
	if (ab_b >= 0 && ac_b <= ab_b)
		return to_b;
	if (ac_c >= 0 && ab_c <= ac_c)
		return to_c;
	of_c = ab_a * ac_b - ab_b * ac_a;
	if (of_c <= 0 && ab_a >= 0 && ab_b <= 0)
		return from_segment(p, corner[0], corner[1]);
	of_b = ab_c * ac_a - ab_a * ac_c;
	if (of_b <= 0 && ac_a >= 0 && ac_c <= 0)
		return from_segment(p, corner[0], corner[2]);
	of_a = ab_b * ac_c - ab_c * ac_b;
	if (of_a <= 0 && ac_b >= ab_b && ab_c >= ac_c)
		return from_segment(p, corner[1], corner[2]);
	/* The square of twice the area. */
	sum = of_a + of_b + of_c;
	if (!(sum > LEAST_SINE * LEAST_SINE * vec3_norm2(ab) * vec3_norm2(ac)))
		return from_sides(p, corner);
	return vec3_mad(vec3_mad(to_a, -of_b / sum, ab), -of_c / sum, ac);
}

static double triangle_distance2(vec3 p, const mesh_triangle *t)
{
	return vec3_norm2(from_triangle(p, t));
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

/* A search for a triangle within the square root of `best` (mm) of the point. */
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
	double distance = triangle_distance2(search->point, &search->bvh->mesh.triangles[triangle]);

	if (!(distance < search->best))
		return;
	search->best = distance;
	search->done = distance <= search->enough;
	search->triangle = triangle;
}

/* The nearest open child; at least one is open. */
static int nearest_of(unsigned open, const float near2[BVH_WIDTH])
{
	int nearest = __builtin_ctz(open);

	for (open &= open - 1; open; open &= open - 1) {
		const int lane = __builtin_ctz(open);

		nearest = near2[lane] < near2[nearest] ? lane : nearest;
	}
	return nearest;
}

/* Visits the nearest child first; the recursion is as deep as the tree. */
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
	return sqrt(triangle_distance2(point, triangle));
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
		.at = vec3_sub(point, from_triangle(point, &bvh->mesh.triangles[search.triangle])),
	};
	return true;
}
