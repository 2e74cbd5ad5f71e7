#include "scene/ring_check.h"

#include <math.h>
#include <stdlib.h>

#include "base/math/math_functions.h"
#include "base/mem.h"
#include "base/units.h"

/* mm: coordinates of one place in a mesh file differ by less. */
static const double SAME = 1e-3;
/* A circle has at least so many corners, in so many of eight equal parts of the turn: all. */
enum { CORNERS_LEAST = 12, PARTS = 8 };
/* mm: smaller circles are bores for screws, which may be anywhere. */
static const double RADIUS_LEAST = 20;
/* The corners of a circle are as far from its middle as its radius within this share of it. */
static const double ROUND = 2e-3;
/* mm: a circle has its middle on the axis if it is no farther off. */
static const double MIDDLE_OFF = 0.2;

/* Triangles: a larger mesh would take longer to look at than to read. */
enum { MESH_MOST = 50000 };

/* A corner in a plane across the axis: the height of the plane, and the place in it, with the axis at 0. */
struct corner {
	double height, x, y;
};

/* The edge on which a wall stands on the plane. */
struct edge {
	struct corner ends[2];
};

struct outline_corner {
	struct corner at;
	size_t edge;
	int end;
};

struct rings {
	vec3 location, direction;	/* of the axis */
	vec3 across[2];
	struct edge *edges;
	size_t count, capacity;
	/* The circle whose middle is nearest to the axis. */
	double nearest, diameter;
};

static struct corner corner_of(const struct rings *rings, vec3 p)
{
	vec3 off = vec3_sub(p, rings->location);

	return (struct corner){vec3_dot(off, rings->direction), vec3_dot(off, rings->across[0]),
			       vec3_dot(off, rings->across[1])};
}

/* A wall stands on a plane with one edge; triangles that lie in a plane have nothing to say. */
static void add_wall(struct rings *rings, const struct corner corners[3])
{
	int level[3], levels = 0, from = 0;

	for (int k = 0; k < 3; k++) {
		level[k] = fabs(corners[k].height - corners[(k + 1) % 3].height) < SAME;
		levels += level[k];
		from = level[k] ? k : from;
	}
	if (levels != 1)
		return;
	rings->edges = mem_grow(rings->edges, &rings->capacity, rings->count + 1, sizeof(*rings->edges));
	rings->edges[rings->count++] = (struct edge){{corners[from], corners[(from + 1) % 3]}};
}

static void add_walls(struct rings *rings, const struct scene_body *body)
{
	const struct mesh *mesh = &body->bvh->mesh;

	for (size_t t = 0; t < mesh->count; t++) {
		struct corner corners[3];

		for (int k = 0; k < 3; k++)
			corners[k] = corner_of(
			    rings, xform_apply(&body->body->placement, mesh_corner(&mesh->triangles[t], k)));
		add_wall(rings, corners);
	}
}

static int compare(double a, double b)
{
	return (a > b) - (a < b);
}

static double grid(double v)
{
	return floor(v / SAME + 0.5);
}

/* By plane, then by place; corners on one point of a grid are one corner. */
static int by_place(const void *a, const void *b)
{
	const struct corner *p = &((const struct outline_corner *)a)->at, *q = &((const struct outline_corner *)b)->at;
	int order = compare(grid(p->height), grid(q->height));

	order = order ? order : compare(grid(p->x), grid(q->x));
	return order ? order : compare(grid(p->y), grid(q->y));
}

static size_t root_of(size_t *roots, size_t i)
{
	while (roots[i] != i)
		i = roots[i] = roots[roots[i]];
	return i;
}

/* The circle through corners that are spread over a whole turn, by least squares (Kasa). False: they are on none. */
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

/* Puts the corners of one outline beside each other: by the number of their outline. */
struct member {
	size_t outline;
	struct corner at;
};

static int by_outline(const void *a, const void *b)
{
	size_t p = ((const struct member *)a)->outline, q = ((const struct member *)b)->outline;

	return (p > q) - (p < q);
}

/* Joins the edges that share corners to outlines, and looks whether each is a circle. */
static void judge_edges(struct rings *rings)
{
	const size_t n = rings->count;
	struct outline_corner *corners = mem_zalloc(2 * n + 1, sizeof(*corners));
	struct member *members = mem_zalloc(2 * n + 1, sizeof(*members));
	struct corner *outline = mem_zalloc(2 * n + 1, sizeof(*outline));
	size_t *roots = mem_zalloc(n + 1, sizeof(*roots)), count = 0;

	for (size_t i = 0; i < 2 * n; i++)
		corners[i] = (struct outline_corner){rings->edges[i / 2].ends[i % 2], i / 2, (int)(i % 2)};
	for (size_t i = 0; i < n; i++)
		roots[i] = i;
	qsort(corners, 2 * n, sizeof(*corners), by_place);
	for (size_t i = 1; i < 2 * n; i++)
		if (by_place(&corners[i - 1], &corners[i]) == 0)
			roots[root_of(roots, corners[i].edge)] = root_of(roots, corners[i - 1].edge);
	for (size_t i = 0; i < 2 * n; i++)
		if (i == 0 || by_place(&corners[i - 1], &corners[i]) != 0)
			members[count++] = (struct member){root_of(roots, corners[i].edge), corners[i].at};
	qsort(members, count, sizeof(*members), by_outline);
	for (size_t i = 0, from = 0; i < count; i++) {
		outline[i - from] = members[i].at;
		if (i + 1 < count && members[i + 1].outline == members[i].outline)
			continue;
		judge_outline(rings, outline, i + 1 - from);
		from = i + 1;
	}
	free(corners);
	free(members);
	free(outline);
	free(roots);
}

/* Judges the circles of the bodies on a link until one is on the axis; false: a mesh is too large, or was not read. */
static bool judge_link(const struct scene *scene, int link, struct rings *rings)
{
	for (size_t i = 0; i < scene->body_count && rings->nearest > MIDDLE_OFF; i++) {
		const struct scene_body *body = &scene->bodies[i];

		if (body->body->link != link || body->body->role != ROLE_MACHINE)
			continue;
		if (!body->bvh || body->bvh->mesh.count > MESH_MOST)
			return false;
		rings->count = 0;
		add_walls(rings, body);
		judge_edges(rings);
	}
	return true;
}

/*
 * Judges the circles of a link about a line, then those of the link that carries it. Fills in the doubt's value and
 * limit with the nearest circle of the link itself; false: a circle has its middle on the line, or nothing can be said.
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
