#include "machine/tool_solid.h"

#include <assert.h>
#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "base/math/math_functions.h"
#include "base/mem.h"
#include "base/units.h"

/* A corner of the outline, in the half plane of radius and height. */
struct corner {
	double r, z;
};

struct outline {
	struct corner *corners;	/* from the top down */
	size_t count;
};

/*
 * How the solid is approximated. Rounding moves a stored vertex by at most sqrt(3)/2 FLT_EPSILON times the greatest
 * coordinate, which is less than `margin`. So the outline is first thickened by a square of half-width margin. The
 * square contains the disc of radius margin, and no corner of the result is farther than 3.2 margins from the solid. A
 * ring of n vertices on radius r / cos(pi/n) contains the circle of radius r, and tangents to an arc enclose the arc.
 */
struct plan {
	double margin;
	size_t ring;	/* vertices around */
	size_t arc;	/* chords of the tip's quarter circle */
};

/* The least number of tangents over `angle` whose distance from a circle of radius r is at most `error`. */
static size_t tangents(double r, double angle, double error)
{
	/* r / cos(x) - r = error, with x half the angle of one tangent. */
	double x = math_acos(r / (r + error));

	return (size_t)ceil(angle / (2 * x));
}

static double largest_radius(const struct tool_solid *solid)
{
	double r = 0;

	for (size_t i = 0; i < solid->count; i++)
		r = fmax(r, fmax(solid->sections[i].diameter, solid->sections[i].diameter_end) / 2);
	return r;
}

double tool_solid_bottom(const struct tool_solid *solid)
{
	double z = solid->top;

	for (size_t i = 0; i < solid->count; i++)
		z -= solid->sections[i].length;
	return z;
}

static double end_radius(const struct tool_solid *solid)
{
	return solid->sections[solid->count - 1].diameter_end / 2;
}

static double arc_radius(const struct tool_solid *solid)
{
	switch (solid->tip) {
	case TIP_BALL:
		return end_radius(solid);
	case TIP_BULL:
		return solid->corner;
	case TIP_FLAT:
	case TIP_CONE:
		break;
	}
	return 0;
}

static struct plan make_plan(const struct tool_solid *solid)
{
	double r = largest_radius(solid), arc = arc_radius(solid);
	double reach = fmax(r, fmax(fabs(solid->top), fabs(tool_solid_bottom(solid))));
	struct plan plan = {.margin = 1.1 * (double)FLT_EPSILON * (reach + TOOL_SOLID_DEVIATION)};
	/* 3.2 margins of thickening and one of rounding; the rest is for the facets. */
	double error = 0.95 * TOOL_SOLID_DEVIATION - 5 * plan.margin;

	assert(error > 0.1 * TOOL_SOLID_DEVIATION);
	if (arc > 0) {
		error /= 2;
		plan.arc = tangents(arc, PI / 2, error);
	}
	plan.ring = tangents(r + 3 * plan.margin + error, 2 * PI, error);
	if (plan.ring < 8)
		plan.ring = 8;
	return plan;
}

void tool_solid_cut(const struct tool_solid *solid, double height, struct arena *arena, struct tool_solid *upper,
		    struct tool_solid *lower)
{
	double cut = tool_solid_bottom(solid) + height, z = solid->top, end;
	struct tool_section *above = arena_alloc(arena, solid->count * sizeof(*above));
	struct tool_section *below = arena_alloc(arena, solid->count * sizeof(*below));

	*upper = (struct tool_solid){.sections = above, .top = z, .tip = TIP_FLAT};
	*lower = *solid;
	lower->sections = below;
	lower->count = 0;
	lower->top = cut;
	for (size_t i = 0; i < solid->count; i++) {
		const struct tool_section *s = &solid->sections[i];
		double at = s->diameter;

		end = z - s->length;
		if (z > cut && end < cut)
			at += (s->diameter_end - s->diameter) * (z - cut) / s->length;
		if (z > cut)
			above[upper->count++] = (struct tool_section){
				z - fmax(end, cut), s->diameter, end < cut ? at : s->diameter_end};
		if (end < cut)
			below[lower->count++] = (struct tool_section){fmin(z, cut) - end, at, s->diameter_end};
		z = end;
	}
}

double tool_solid_tip_height(const struct tool_solid *solid)
{
	if (solid->tip == TIP_CONE)
		return end_radius(solid) / math_tan(solid->angle / 2);
	return arc_radius(solid);
}

static void add_corner(struct outline *outline, double r, double z)
{
	if (outline->count) {
		const struct corner *last = &outline->corners[outline->count - 1];

		if ((float)last->r == (float)r && (float)last->z == (float)z)
			return;
	}
	outline->corners[outline->count++] = (struct corner){r, z};
}

/* The change of the radius downward: 1 it grows, -1 it shrinks. */
static int slope(double above, double below)
{
	return (below > above) - (below < above);
}

/*
 * The corner where one section ends and the next begins. Thickened by a square, a shrinking outline moves by (margin,
 * -margin) and a growing one by (margin, margin). Where they meet, the larger radius covers the heights of both.
 */
static void add_joint(struct outline *outline, const struct tool_section *upper, const struct tool_section *lower,
		      double z, double margin)
{
	double r = upper->diameter_end / 2, next = lower->diameter / 2;
	int up = slope(upper->diameter, upper->diameter_end), step = slope(r, next);
	int down = slope(lower->diameter, lower->diameter_end);
	bool grows = up > 0 || step > 0 || down > 0, shrinks = up < 0 || step < 0 || down < 0;
	double above = r + margin, below = next + margin, most;

	if (!grows && !shrinks)
		return;
	if (!grows || !shrinks) {
		double shift = grows ? margin : -margin;

		add_corner(outline, above, z + shift);
		add_corner(outline, below, z + shift);
		return;
	}
	if (up < 0)
		above += 2 * margin * (upper->diameter - upper->diameter_end) / 2 / upper->length;
	if (down > 0)
		below += 2 * margin * (lower->diameter_end - lower->diameter) / 2 / lower->length;
	most = fmax(above, below);
	add_corner(outline, above, z + margin);
	add_corner(outline, most, z + margin);
	add_corner(outline, most, z - margin);
	add_corner(outline, below, z - margin);
}

/* The quarter circle from the side of the last section to its end, by `chords` + 1 tangents. */
static void add_arc(struct outline *outline, const struct tool_solid *solid, double z, const struct plan *plan)
{
	double c = arc_radius(solid), r = end_radius(solid) - c;
	double half = PI / 4 / (double)plan->arc, reach = c / math_cos(half);

	for (size_t i = 0; i < plan->arc; i++) {
		double angle = (double)(2 * i + 1) * half;

		add_corner(outline, r + reach * math_cos(angle) + plan->margin,
			   z + c - reach * math_sin(angle) - plan->margin);
	}
}

static void add_tip(struct outline *outline, const struct tool_solid *solid, double z, const struct plan *plan)
{
	const struct tool_section *last = &solid->sections[solid->count - 1];
	double r = end_radius(solid);

	switch (solid->tip) {
	case TIP_FLAT:
		if (slope(last->diameter, last->diameter_end) > 0)
			add_corner(outline, r + plan->margin, z + plan->margin);
		add_corner(outline, r + plan->margin, z - plan->margin);
		break;
	case TIP_CONE:
		/* Decimal rounding may make a height slightly too large; the tip must not exceed its section. */
		add_corner(outline, r + plan->margin,
			   z + fmin(tool_solid_tip_height(solid), last->length) - plan->margin);
		add_corner(outline, plan->margin, z - plan->margin);
		break;
	case TIP_BALL:
	case TIP_BULL:
		add_arc(outline, solid, z, plan);
		break;
	}
}

static size_t most_corners(const struct tool_solid *solid, const struct plan *plan)
{
	return 2 + 4 * (solid->count - 1) + 2 + plan->arc;
}

static void outline_init(struct outline *outline, const struct tool_solid *solid, const struct plan *plan)
{
	const struct tool_section *first = &solid->sections[0];
	double z = solid->top;

	outline->corners = mem_zalloc(most_corners(solid, plan), sizeof(*outline->corners));
	outline->count = 0;
	add_corner(outline, first->diameter / 2 + plan->margin, z + plan->margin);
	if (slope(first->diameter, first->diameter_end) < 0)
		add_corner(outline, first->diameter / 2 + plan->margin, z - plan->margin);
	for (size_t i = 0; i + 1 < solid->count; i++) {
		z -= solid->sections[i].length;
		add_joint(outline, &solid->sections[i], &solid->sections[i + 1], z, plan->margin);
	}
	add_tip(outline, solid, tool_solid_bottom(solid), plan);
}

struct vertex {
	float p[3];
};

/* Leaves out triangles that rounding has made lines; their other two edges cancel each other. */
static void add_triangle(struct mesh *mesh, struct vertex a, struct vertex b, struct vertex c)
{
	const struct vertex corners[3] = {a, b, c};
	mesh_triangle *t = &mesh->triangles[mesh->count];

	for (int i = 0; i < 3; i++) {
		const float *p = corners[i].p, *q = corners[(i + 1) % 3].p;

		if (p[0] == q[0] && p[1] == q[1] && p[2] == q[2])
			return;
		memcpy(t->v[i], p, sizeof(t->v[i]));
	}
	mesh->count++;
}

/* The directions from the axis to the vertices of a ring. */
struct circle {
	double *cosine, *sine;
	size_t count;
};

static void circle_init(struct circle *circle, size_t count)
{
	circle->count = count;
	circle->cosine = mem_alloc(2 * count * sizeof(*circle->cosine));
	circle->sine = circle->cosine + count;
	for (size_t k = 0; k < count; k++) {
		double angle = 2 * PI * (double)k / (double)count;

		circle->cosine[k] = math_cos(angle);
		circle->sine[k] = math_sin(angle);
	}
}

static void fill_ring(struct vertex *ring, const struct circle *circle, struct corner corner)
{
	double r = corner.r / math_cos(PI / (double)circle->count);

	for (size_t k = 0; k < circle->count; k++)
		ring[k] = (struct vertex){
			{(float)(r * circle->cosine[k]), (float)(r * circle->sine[k]), (float)corner.z}};
}

static void add_cap(struct mesh *mesh, const struct vertex *ring, size_t count, bool faces_up)
{
	struct vertex centre = {{0, 0, ring[0].p[2]}};

	for (size_t k = 0; k < count; k++) {
		size_t next = (k + 1) % count;

		add_triangle(mesh, centre, ring[faces_up ? k : next], ring[faces_up ? next : k]);
	}
}

static void add_band(struct mesh *mesh, const struct vertex *upper, const struct vertex *lower, size_t count)
{
	for (size_t k = 0; k < count; k++) {
		size_t next = (k + 1) % count;

		add_triangle(mesh, upper[k], lower[k], lower[next]);
		add_triangle(mesh, upper[k], lower[next], upper[next]);
	}
}

/* A fan at each end, and two triangles per vertex between rings. */
static size_t most_triangles(const struct plan *plan, const struct outline *outline)
{
	return 2 * plan->ring * outline->count;
}

size_t tool_solid_triangles(const struct tool_solid *solid)
{
	const struct plan plan = make_plan(solid);
	struct outline outline;

	outline_init(&outline, solid, &plan);
	free(outline.corners);
	return most_triangles(&plan, &outline);
}

static void mesh_by(const struct plan *plan, const struct tool_solid *solid, struct arena *arena, struct mesh *out)
{
	struct outline outline;
	struct vertex *rings = mem_zalloc(2 * plan->ring, sizeof(*rings));
	struct vertex *upper = rings, *lower = rings + plan->ring;
	struct circle circle;

	circle_init(&circle, plan->ring);
	outline_init(&outline, solid, plan);
	*out = (struct mesh){
		.triangles = arena_alloc(arena, most_triangles(plan, &outline) * sizeof(mesh_triangle))};
	fill_ring(lower, &circle, outline.corners[0]);
	add_cap(out, lower, plan->ring, true);
	for (size_t i = 1; i < outline.count; i++) {
		struct vertex *spare = upper;

		upper = lower;
		lower = spare;
		fill_ring(lower, &circle, outline.corners[i]);
		add_band(out, upper, lower, plan->ring);
	}
	add_cap(out, lower, plan->ring, false);
	free(outline.corners);
	free(circle.cosine);
	free(rings);
}

void tool_solid_mesh(const struct tool_solid *solid, struct arena *arena, struct mesh *out)
{
	const struct plan plan = make_plan(solid);

	mesh_by(&plan, solid, arena, out);
}

void tool_solid_coarse_mesh(const struct tool_solid *solid, struct arena *arena, struct mesh *out)
{
	struct plan plan = make_plan(solid);

	plan.ring = 8;
	plan.arc = plan.arc ? 1 : 0;
	mesh_by(&plan, solid, arena, out);
}

bool tool_solid_contains(const struct tool_solid *solid, vec3 p, double margin)
{
	double tip = tool_solid_bottom(solid) + tool_solid_tip_height(solid);
	double z = solid->top, r = sqrt(p.x * p.x + p.y * p.y);

	for (size_t i = 0; i < solid->count; i++) {
		const struct tool_section *s = &solid->sections[i];
		double share = (z - p.z) / s->length;

		z -= s->length;
		if (p.z > z + margin && p.z > tip + margin && share * s->length > margin)
			return r + margin < 0.5 * (s->diameter + (s->diameter_end - s->diameter) * share);
	}
	return false;
}
