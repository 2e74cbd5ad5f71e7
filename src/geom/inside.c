#include "geom/inside.h"

#include <math.h>
#include <stdlib.h>

#include "base/math/math_functions.h"
#include "base/mem.h"
#include "base/units.h"
#include "geom/tolerance.h"

/* Half of the signed solid angle of a triangle whose corners are given as seen from the point. */
static double half_solid_angle(const mesh_triangle *triangle, vec3 point)
{
	vec3 a = vec3_sub(mesh_corner(triangle, 0), point);
	vec3 b = vec3_sub(mesh_corner(triangle, 1), point);
	vec3 c = vec3_sub(mesh_corner(triangle, 2), point);
	double na = vec3_norm(a), nb = vec3_norm(b), nc = vec3_norm(c);
	double volume = vec3_dot(a, vec3_cross(b, c));
	double spread = na * nb * nc + vec3_dot(a, b) * nc + vec3_dot(b, c) * na + vec3_dot(c, a) * nb;

	return math_atan2(volume, spread);
}

/*
 * The error of a solid angle is a few roundings times the ratio of the triangle's size to the distance of the point
 * from its edges. Even a million errors add up to half a turn only if the point is within some 1e-9 of the mesh's size
 * of the mesh.
 */
int mesh_winding_number(const struct mesh *mesh, vec3 point)
{
	double half_sum = 0;

	for (size_t i = 0; i < mesh->count; i++)
		half_sum += half_solid_angle(&mesh->triangles[i], point);
	return (int)lround(half_sum / (2 * PI));
}

struct ray {
	const struct bvh *bvh;
	const uint32_t *shell_of;	/* or NULL */
	vec3 point, direction;
	double from_origin[3];	/* the point relative to the tree's origin */
	double along[3];	/* the direction, no component near 0 */
	double rounding;	/* mm */
	int *windings;	/* of each shell; NULL: the ray ends at the first triangle that it crosses */
};

/* 1 or -1; 0 if the sign may be due to rounding. */
static int sign_of_triple(vec3 d, vec3 a, vec3 b)
{
	double value = vec3_dot(d, vec3_cross(a, b));
	double bound = TRIPLE_ROUNDING * vec3_norm(d) * vec3_norm(a) * vec3_norm(b);

	return value > bound ? 1 : value < -bound ? -1 : 0;
}

/*
 * Counts the triangle if the ray crosses it. False: the ray ends here, passes too close to the triangle's edge, or
 * begins too close to its plane.
 */
static bool cross_triangle(struct ray *ray, size_t triangle)
{
	const mesh_triangle *t = &ray->bvh->mesh.triangles[triangle];
	uint32_t shell = ray->shell_of ? ray->shell_of[triangle] : 0;
	vec3 a = vec3_sub(mesh_corner(t, 0), ray->point), b = vec3_sub(mesh_corner(t, 1), ray->point);
	vec3 c = vec3_sub(mesh_corner(t, 2), ray->point);
	int ab = sign_of_triple(ray->direction, a, b), bc = sign_of_triple(ray->direction, b, c);
	int ca = sign_of_triple(ray->direction, c, a), ahead;
	bool front = ab > 0 || bc > 0 || ca > 0, back = ab < 0 || bc < 0 || ca < 0;

	if (shell == NO_SHELL || (front && back))
		return true;
	if (!ab || !bc || !ca)
		return false;
	ahead = sign_of_triple(a, b, c);
	if (!ahead)
		return false;
	/*
	 * The line crosses in front of the point if (a, b, c) has the same sign as the three products, else behind the
	 * point.
	 */
	if (ahead != ab)
		return true;
	if (!ray->windings)
		return false;
	ray->windings[shell] += ab;
	return true;
}

/* May the ray meet the box? */
static bool meets_box(const struct ray *ray, const struct bvh_node *node, int lane)
{
	double enter = 0, leave = INFINITY;

	for (int k = 0; k < 3; k++) {
		double to = (double)node->centre[k][lane] - ray->from_origin[k];
		double reach = (double)node->half[k][lane] + ray->rounding;
		double middle = to / ray->along[k], half = reach / fabs(ray->along[k]);

		enter = fmax(enter, middle - half);
		leave = fmin(leave, middle + half);
	}
	return enter <= leave;
}

/* The recursion is as deep as the tree. False: see cross_triangle. */
static bool cross_node(struct ray *ray, const struct bvh_node *node)
{
	for (int lane = 0; lane < node->used; lane++) {
		if (!meets_box(ray, node, lane))
			continue;
		if (!node->count[lane] && !cross_node(ray, &ray->bvh->nodes[node->first[lane]]))
			return false;
		for (size_t i = 0; i < node->count[lane]; i++) {
			if (!cross_triangle(ray, node->first[lane] + i))
				return false;
		}
	}
	return true;
}

/* Not along common directions of edges or diagonals. */
static const vec3 directions[] = {
    {0.4179, 0.6133, 0.6702},
    {-0.7211, 0.3571, 0.5937},
    {0.5309, -0.7823, 0.3259},
    {-0.3361, -0.5531, -0.7623},
};
enum { DIRECTIONS = sizeof(directions) / sizeof(directions[0]) };

/* False: see cross_triangle. */
static bool cast(const struct bvh *bvh, const uint32_t *shell_of, vec3 point, vec3 direction, int *windings)
{
	const vec3 off = vec3_sub(point, bvh->origin);
	struct ray ray = {
		.bvh = bvh, .shell_of = shell_of, .point = point, .direction = direction,
		.from_origin = {off.x, off.y, off.z},
		.along = {direction.x, direction.y, direction.z},
		.rounding = SLAB_ROUNDING * (bvh->radius + vec3_norm(off)), .windings = windings,
	};

	return cross_node(&ray, &bvh->nodes[0]);
}

bool mesh_ray_is_free(const struct bvh *bvh, vec3 point)
{
	for (int i = 0; i < DIRECTIONS; i++) {
		if (cast(bvh, NULL, point, directions[i], NULL))
			return true;
	}
	return false;
}

/*
 * For each shell, the number of times that a ray from the point leaves it less the number of times that the ray enters
 * it: the winding numbers of the closed shells. The caller provides windings, topology->shell_count long, or 1 without
 * shells. Traverses the tree. False: every ray that was tried passes too close to an edge.
 */
static bool cast_ray(const struct bvh *bvh, const struct topology *topology, vec3 point, int *windings)
{
	size_t count = topology->shells ? topology->shell_count : 1;
	bool good = false;

	for (int i = 0; i < DIRECTIONS && !good; i++) {
		for (size_t k = 0; k < count; k++)
			windings[k] = 0;
		good = cast(bvh, topology->shell_of, point, directions[i], windings);
	}
	return good;
}

int shell_winding_number(const struct mesh *mesh, const struct topology *topology, uint32_t shell, vec3 point)
{
	double half_sum = 0;

	for (size_t t = 0; t < mesh->count; t++)
		half_sum += topology->shell_of[t] == shell ? half_solid_angle(&mesh->triangles[t], point) : 0;
	return (int)lround(half_sum / (2 * PI));
}

static bool in_bounds(const struct shell *shell, vec3 p)
{
	return p.x >= shell->least.x && p.y >= shell->least.y && p.z >= shell->least.z && p.x <= shell->greatest.x &&
	       p.y <= shell->greatest.y && p.z <= shell->greatest.z;
}

/*
 * Could the point be inside an open shell, if its holes were closed? Small holes change the winding number by their
 * part of the view: if it is below a tenth, the point is outside.
 */
static bool open_shells_may_hold(const struct bvh *bvh, const struct topology *topology, vec3 point)
{
	const double threshold = 0.1;
	bool possible = false;

	for (uint32_t s = 0; s < topology->shell_count && !possible; s++) {
		const struct shell *shell = &topology->shells[s];
		double half_sum = 0;

		if (shell->kind != SHELL_OPEN || !in_bounds(shell, point))
			continue;
		for (size_t t = 0; t < bvh->mesh.count && !shell->flipped; t++)
			half_sum += topology->shell_of[t] == s ? half_solid_angle(&bvh->mesh.triangles[t], point) : 0;
		possible = shell->flipped || fabs(half_sum) > threshold * 2 * PI;
	}
	return possible;
}

static enum inside plain_inside(const struct bvh *bvh, const struct topology *topology, vec3 point)
{
	int *windings = mem_alloc((topology->shells ? topology->shell_count : 1) * sizeof(*windings)), sum = 0;

	if (cast_ray(bvh, topology, point, windings)) {
		for (size_t s = 0; s < (topology->shells ? topology->shell_count : 1); s++)
			sum += windings[s];
	} else {
		sum = mesh_winding_number(&bvh->mesh, point);
	}
	free(windings);
	return sum ? INSIDE_YES : INSIDE_NO;
}

/* The answer of the closed shells; open ones are left out. */
static enum inside inside_closed(const struct bvh *bvh, const struct topology *topology, vec3 point)
{
	int *windings, oriented = 0, odd = 0;
	bool good;

	if (topology->plain)
		return plain_inside(bvh, topology, point);
	windings = mem_alloc(topology->shell_count * sizeof(*windings));
	good = cast_ray(bvh, topology, point, windings);
	for (size_t s = 0; s < topology->shell_count && good; s++) {
		oriented += topology->shells[s].kind == SHELL_ORIENTED ? windings[s] : 0;
		odd += topology->shells[s].kind == SHELL_UNORIENTED && windings[s] % 2;
	}
	free(windings);
	if (good && (odd % 2 ? !oriented : !odd && oriented))
		return INSIDE_YES;
	/* Inside two shells, one of which does not define its solid side: a cavity, or one solid within another. */
	return !good || odd ? INSIDE_UNKNOWN : INSIDE_NO;
}

enum inside mesh_inside(const struct bvh *bvh, const struct topology *topology, vec3 point)
{
	const enum inside closed = inside_closed(bvh, topology, point);

	return closed == INSIDE_NO && !topology->plain && open_shells_may_hold(bvh, topology, point) ? INSIDE_UNKNOWN
												     : closed;
}

bool mesh_is_inside(const struct bvh *bvh, const struct topology *topology, vec3 point)
{
	return inside_closed(bvh, topology, point) == INSIDE_YES;
}

bool mesh_is_inside_closed(const struct bvh *bvh, vec3 point)
{
	static const struct topology closed = {.closed = true, .plain = true};

	return plain_inside(bvh, &closed, point) == INSIDE_YES;
}
