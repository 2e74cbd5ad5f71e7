#include "report/html/turned.h"

#include <math.h>
#include <stdlib.h>

#include "base/math/math_functions.h"
#include "base/mem.h"
#include "base/same_double.h"
#include "base/units.h"

/*
 * An edge of the outline: an edge in the half plane y = 0, x >= 0 of a triangle whose third corner is in front of it.
 */
struct outline_edge {
	struct turned_corner from, to;
};

struct outline {
	struct outline_edge *edges;
	size_t count, capacity;
};

static bool is_on_outline(const float p[3])
{
	return !(p[1] < 0 || p[1] > 0) && p[0] >= 0;
}

static struct outline edges_of(const struct mesh *mesh)
{
	struct outline outline = {0};

	for (size_t i = 0; i < 3 * mesh->count; i++) {
		const mesh_triangle *t = &mesh->triangles[i / 3];
		const float *a = t->v[i % 3], *b = t->v[(i + 1) % 3], *c = t->v[(i + 2) % 3];

		if (!is_on_outline(a) || !is_on_outline(b) || !(c[1] > 0))
			continue;
		outline.edges = mem_grow(outline.edges, &outline.capacity, outline.count + 1, sizeof(*outline.edges));
		outline.edges[outline.count++] =
		    (struct outline_edge){{(double)a[0], (double)a[2]}, {(double)b[0], (double)b[2]}};
	}
	return outline;
}

static bool same_corner(struct turned_corner a, struct turned_corner b)
{
	return same_double(a.r, b.r) && same_double(a.z, b.z);
}

/* The edge that begins at the corner; NULL: there is none. */
static const struct outline_edge *edge_from(const struct outline *outline, struct turned_corner corner)
{
	for (size_t i = 0; i < outline->count; i++) {
		if (same_corner(outline->edges[i].from, corner))
			return &outline->edges[i];
	}
	return NULL;
}

/* The edge that begins on the axis and has no edge before it. */
static const struct outline_edge *first_edge(const struct outline *outline)
{
	const struct outline_edge *first = NULL;

	for (size_t i = 0; i < outline->count; i++) {
		const struct outline_edge *it = &outline->edges[i];

		if (!(it->from.r > 0) && (!first || it->from.z > first->from.z))
			first = it;
	}
	return first;
}

/*
 * Follows the outline from the axis to the axis. Leaves out corners within a tenth of TURNED_ERROR of the one before.
 */
static bool follow(struct turned *turned, const struct outline *outline)
{
	const struct outline_edge *edge = first_edge(outline);

	for (size_t i = 0; edge && i < outline->count; i++) {
		const struct turned_corner at = edge->to,
					   *last = turned->count ? &turned->corners[turned->count - 1] : NULL;

		if (!(at.r > 0))
			return turned->count > 1;
		if (!last || math_hypot(at.r - last->r, at.z - last->z) > TURNED_ERROR / 10)
			turned->corners[turned->count++] = at;
		edge = edge_from(outline, at);
	}
	return false;
}

/* Triangles at the centre of the upper cap: as many as the polygons have vertices. */
static size_t count_facets(const struct mesh *mesh, double top)
{
	size_t count = 0;

	for (size_t i = 0; i < 3 * mesh->count; i++) {
		const float *p = mesh->triangles[i / 3].v[i % 3];

		count += same_double((double)p[0], 0) && same_double((double)p[1], 0) && same_double((double)p[2], top);
	}
	return count;
}

/* Is the hypotenuse of these two sides at most half of TURNED_ERROR? */
static bool is_near(double x, double y)
{
	return x * x + y * y <= TURNED_ERROR * TURNED_ERROR / 4;
}

/* Is the vertex one of a polygon's, or on the axis? */
static bool is_explained(const struct turned *turned, const float p[3])
{
	const double x = (double)p[0], y = (double)p[1], r = sqrt(x * x + y * y);
	const double part = 2 * PI / (double)turned->facets, angle = part * round(math_atan2(y, x) / part);

	if (!(r > 0))
		return true;
	if (!is_near(x - r * math_cos(angle), y - r * math_sin(angle)))
		return false;
	for (size_t i = 0; i < turned->count; i++) {
		if (is_near(r - turned->corners[i].r, (double)p[2] - turned->corners[i].z))
			return true;
	}
	return false;
}

/* Are all vertices explained, and is the number of triangles that of two caps and the bands between them? */
static bool explains(const struct turned *turned, const struct mesh *mesh, size_t edges)
{
	if (turned->facets < 3 || mesh->count != 2 * turned->facets * (edges - 1))
		return false;
	for (size_t i = 0; i < 3 * mesh->count; i++) {
		if (!is_explained(turned, mesh->triangles[i / 3].v[i % 3]))
			return false;
	}
	return true;
}

bool turned_init(struct turned *turned, const struct mesh *mesh)
{
	struct outline outline = edges_of(mesh);
	struct turned result = {.corners = mem_alloc((outline.count + 1) * sizeof(*result.corners))};
	const struct outline_edge *first = first_edge(&outline);
	bool good = first && follow(&result, &outline);

	if (good) {
		result.facets = count_facets(mesh, first->from.z);
		good = explains(&result, mesh, outline.count);
	}
	free(outline.edges);
	if (good)
		*turned = result;
	else
		turned_release(&result);
	return good;
}

void turned_release(struct turned *turned)
{
	free(turned->corners);
	*turned = (struct turned){0};
}
