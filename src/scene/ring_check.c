#include "scene/ring_check.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "base/math/math_functions.h"
#include "base/mem.h"
#include "base/units.h"
#include "geom/weld.h"

/* mm: coordinates of the same place in a mesh file differ by less. */
static const double SAME = 1e-3;
/* A circle has at least this number of corners, in each of eight equal parts of the turn. */
enum { CORNERS_LEAST = 12, PARTS = 8 };
/* mm: smaller circles are bores for screws, which may be anywhere. */
static const double RADIUS_LEAST = 20;
/* The distance of a circle's corners from its middle equals the radius to within this share. */
static const double ROUND = 2e-3;
/* mm: a circle is on the axis if its middle is within this distance of the axis. */
static const double MIDDLE_OFF = 0.2;

/* Triangles: testing a larger mesh would take longer than reading it. */
enum { MESH_MOST = 50000 };

/*
 * A corner in a plane perpendicular to the axis: the height of the plane, and the position in it, with the axis at 0.
 */
struct corner {
	double height, x, y;
};

/* The edge on which a wall stands on the plane. */
struct edge {
	struct corner ends[2];
};

struct rings {
	vec3 location, direction;	/* of the axis */
	vec3 across[2];
	struct edge *edges;
	size_t count, capacity;
	/* The circle whose middle is nearest to the axis. */
	double nearest, diameter;
};

/* The frame of the axis in the coordinates of a body's mesh. */
struct frame {
	vec3 location, direction, across[2];
};

static struct frame frame_of(const struct rings *rings, const struct body *body)
{
	const xform back = xform_inverse(&body->placement);

	return (struct frame){
		.location = xform_apply(&back, rings->location),
		.direction = mat3_apply(&back.rotation, rings->direction),
		.across = {mat3_apply(&back.rotation, rings->across[0]), mat3_apply(&back.rotation, rings->across[1])},
	};
}

static struct corner corner_of(const struct frame *frame, vec3 off, double height)
{
	return (struct corner){height, vec3_dot(off, frame->across[0]), vec3_dot(off, frame->across[1])};
}

/* Adds the one edge with which a wall stands on a plane. Triangles that lie in a plane are ignored. */
static void add_wall(struct rings *rings, const struct frame *frame, const mesh_triangle *triangle)
{
	int levels = 0, from = 0, to;
	double height[3];
	vec3 off[3];

	for (int k = 0; k < 3; k++) {
		off[k] = vec3_sub(mesh_corner(triangle, k), frame->location);
		height[k] = vec3_dot(off[k], frame->direction);
	}
	for (int k = 0; k < 3; k++) {
		const bool level = fabs(height[k] - height[(k + 1) % 3]) < SAME;

		levels += level;
		from = level ? k : from;
	}
	if (levels != 1)
		return;
	to = (from + 1) % 3;
	if (rings->count == rings->capacity)
		rings->edges = mem_grow(rings->edges, &rings->capacity, rings->count + 1, sizeof(*rings->edges));
	rings->edges[rings->count++] = (struct edge){{corner_of(frame, off[from], height[from]),
						      corner_of(frame, off[to], height[to])}};
}

static void add_walls(struct rings *rings, const struct scene_body *body)
{
	const struct mesh *mesh = &body->bvh->mesh;
	const struct frame frame = frame_of(rings, body->body);

	for (size_t t = 0; t < mesh->count; t++)
		add_wall(rings, &frame, &mesh->triangles[t]);
}

/* Corners are numbered edge * 2 + end. */
static struct corner end_of(const struct rings *rings, size_t corner)
{
	return rings->edges[corner / 2].ends[corner % 2];
}

/* Coordinates are far below 2^63 times SAME. */
static int64_t grid(double v)
{
	const double place = v / SAME + 0.5;
	const int64_t towards_0 = (int64_t)place;

	return towards_0 - ((double)towards_0 > place);
}

/* Corners at the same grid point are the same corner. */
static bool are_one(struct corner p, struct corner q)
{
	return grid(p.height) == grid(q.height) && grid(p.x) == grid(q.x) && grid(p.y) == grid(q.y);
}

/*
 * The upper half is the same for all corners at one grid point (constants of splitmix64); the lower half is the corner.
 */
static uint64_t key_of(struct corner at, size_t corner)
{
	uint64_t hash = (uint64_t)grid(at.height) * UINT64_C(0x9e3779b97f4a7c15);

	hash = (hash ^ hash >> 30 ^ (uint64_t)grid(at.x)) * UINT64_C(0xbf58476d1ce4e5b9);
	hash = (hash ^ hash >> 27 ^ (uint64_t)grid(at.y)) * UINT64_C(0x94d049bb133111eb);
	return hash >> 32 << 32 | corner;
}

static size_t root_of(size_t *roots, size_t i)
{
	while (roots[i] != i)
		i = roots[i] = roots[roots[i]];
	return i;
}

/* The circle through corners that are spread over a whole turn, by least squares (Kasa). False: there is none. */
static bool fit_circle(const struct corner *corners, size_t count, double *middle, double *radius)
{
	double mx = 0, my = 0, xx = 0, xy = 0, yy = 0, xr = 0, yr = 0, sum = 0, determinant, cx, cy;
	unsigned parts = 0;

	for (size_t i = 0; i < count; i++) {
		mx += corners[i].x / (double)count;
		my += corners[i].y / (double)count;
	}
	for (size_t i = 0; i < count; i++) {
		double x = corners[i].x - mx, y = corners[i].y - my, rr = x * x + y * y;

		xx += x * x;
		xy += x * y;
		yy += y * y;
		xr += x * rr;
		yr += y * rr;
		sum += rr;
	}
	determinant = xx * yy - xy * xy;
	if (!(determinant > 1e-6 * xx * yy))
		return false;
	cx = (xr * yy - yr * xy) / (2 * determinant);
	cy = (yr * xx - xr * xy) / (2 * determinant);
	*radius = sqrt(cx * cx + cy * cy + sum / (double)count);
	for (size_t i = 0; i < count; i++) {
		double x = corners[i].x - mx - cx, y = corners[i].y - my - cy;

		if (fabs(math_hypot(x, y) - *radius) > ROUND * *radius)
			return false;
		parts |= 1U << (unsigned)fmin(PARTS - 1, floor((math_atan2(y, x) + PI) * PARTS / (2 * PI)));
	}
	*middle = math_hypot(mx + cx, my + cy);
	return parts == (1U << PARTS) - 1;
}

static void judge_outline(struct rings *rings, const struct corner *corners, size_t count)
{
	double middle, radius;

	if (count < CORNERS_LEAST || !fit_circle(corners, count, &middle, &radius) || radius < RADIUS_LEAST ||
	    middle >= rings->nearest)
		return;
	rings->nearest = middle;
	rings->diameter = 2 * radius;
}

/* Joins the edges that share corners; leaves one entry for each corner in keys[0] to [count - 1] and returns count. */
static size_t join_edges(const struct rings *rings, struct soup *keys, size_t *roots)
{
	const size_t all = 2 * rings->count;
	size_t count = 0, first = 0;	/* of those that are left with the same upper half of their keys */

	for (size_t i = 0; i < rings->count; i++)
		roots[i] = i;
	for (size_t i = 0; i < all; i++)
		keys->keys[i] = key_of(end_of(rings, i), i);
	soup_sort_keys(keys, all, 64);
	for (size_t i = 0; i < all; i++) {
		const uint64_t key = keys->keys[i];
		const uint32_t corner = (uint32_t)key;
		size_t k;

		if (first < count && keys->keys[first] >> 32 != key >> 32)
			first = count;
		for (k = first; k < count; k++)
			if (are_one(end_of(rings, (uint32_t)keys->keys[k]), end_of(rings, corner)))
				break;
		if (k < count)
			roots[root_of(roots, corner / 2)] = root_of(roots, (uint32_t)keys->keys[k] / 2);
		else
			keys->keys[count++] = key;
	}
	return count;
}

/* Joins the edges that share corners to outlines, and tests whether each is a circle. */
static void judge_edges(struct rings *rings)
{
	const size_t n = rings->count;
	struct soup keys = {.keys = mem_alloc(2 * n * sizeof(*keys.keys)),
			    .scratch = mem_alloc(2 * n * sizeof(*keys.scratch))};
	struct corner *outlines = mem_alloc(2 * n * sizeof(*outlines));	/* those of one outline are adjacent */
	size_t *roots = mem_alloc(n * sizeof(*roots)), *ends = mem_zalloc(n + 2, sizeof(*ends));
	const size_t count = join_edges(rings, &keys, roots);

	for (size_t i = 0; i < count; i++)
		ends[root_of(roots, (uint32_t)keys.keys[i] / 2) + 2]++;
	for (size_t i = 1; i < n + 2; i++)
		ends[i] += ends[i - 1];
	/* ends[i + 1] is the position of the next corner of outline i; after the loop it is the end of the outline. */
	for (size_t i = 0; i < count; i++)
		outlines[ends[root_of(roots, (uint32_t)keys.keys[i] / 2) + 1]++] =
		    end_of(rings, (uint32_t)keys.keys[i]);
	for (size_t i = 0; i < n; i++)
		judge_outline(rings, outlines + ends[i], ends[i + 1] - ends[i]);
	soup_release(&keys);
	free(outlines);
	free(roots);
	free(ends);
}

/* Judges the circles of the bodies on a link until one is on the axis; false: a mesh is too large. */
static bool judge_link(const struct scene *scene, int link, struct rings *rings)
{
	for (size_t i = 0; i < scene->body_count && rings->nearest > MIDDLE_OFF; i++) {
		const struct scene_body *body = &scene->bodies[i];

		if (!body_is_of_link(body->body, link))
			continue;
		if (body->bvh->mesh.count > MESH_MOST)
			return false;
		rings->count = 0;
		add_walls(rings, body);
		judge_edges(rings);
	}
	return true;
}

/*
 * Judges the circles of a link about a line, then those of the link that carries it. Sets the doubt's value and limit
 * to the nearest circle of the link itself. False: a circle has its middle on the line, or nothing can be decided.
 */
static bool lies_beside(const struct scene *scene, int link, vec3 location, vec3 direction, struct doubt *doubt)
{
	struct rings rings = {.location = location, .direction = direction, .nearest = INFINITY};
	bool beside = false;

	rings.across[0] = vec3_unit(vec3_cross(direction, fabs(direction.x) < 0.7 ? (vec3){1, 0, 0} : (vec3){0, 1, 0}));
	rings.across[1] = vec3_cross(direction, rings.across[0]);
	if (judge_link(scene, link, &rings) && rings.nearest > MIDDLE_OFF && !isinf(rings.nearest)) {
		doubt->value = rings.nearest;
		doubt->limit = rings.diameter;
		beside = link == 0 || (judge_link(scene, scene->machine->axes[link - 1].parent, &rings) &&
				       rings.nearest > MIDDLE_OFF);
	}
	free(rings.edges);
	return beside;
}

void ring_check(const struct scene *scene, struct doubts *doubts)
{
	const struct spindle *spindle = &scene->machine->spindle;
	struct doubt doubt = {.kind = DOUBT_ROTARY_BESIDE};

	for (size_t i = 0; i < scene->machine->axis_count; i++) {
		const struct axis *axis = &scene->machine->axes[i];

		doubt.axis = (int)i;
		if (axis->rotary && !axis->checked &&
		    lies_beside(scene, (int)i + 1, axis->location, axis->direction, &doubt))
			doubts_add(doubts, &doubt);
	}
	doubt.kind = DOUBT_SPINDLE_BESIDE;
	if (spindle->present && !spindle->checked &&
	    lies_beside(scene, spindle->link, spindle->location, spindle->direction, &doubt))
		doubts_add(doubts, &doubt);
}
