#include "machine/tool_core.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#include "base/math/math_functions.h"
#include "base/mem.h"

/*
 * mm: a radius that is only rounding. The radius of a side is 0 at a cut, and there it may come out a little above 0; a
 * section with this radius would be a needle below the core of every point.
 */
static const double RADIUS_ROUNDING = 1e-9;

/* A frustum in the half plane of height and radius; top > bottom. */
struct frustum {
	double top, bottom;
	double r_top, r_bottom;
};

/*
 * The erosion of the solid of revolution r <= R(h) by a ball of radius `depth` is
 * r <= R(g) - sqrt(depth^2 - (h - g)^2) for every height g within `depth` of h. Each
 * line below is an upper bound on one of these arcs or on their envelope, so
 * that any choice among the lines encloses the erosion.
 */
struct eroder {
	const struct frustum *frustums;	/* from the top down, without gaps */
	size_t count;
	double top;	/* of the solid: the core ends there */
	double bottom;	/* of the solid: everything within `depth` of it is removed */
	double depth;
	double *cuts;	/* descending heights: between two of them one line bounds the core */
	size_t cut_count;
};

/* A straight bound of the radius between two heights. */
struct line {
	double r_top, r_bottom;
};

static double slope(const struct frustum *f)
{
	return (f->r_top - f->r_bottom) / (f->top - f->bottom);
}

/* How far a point at the distance `depth`, along the normal of a frustum's side, is below its foot point. */
static double foot_above(const struct frustum *f, double depth)
{
	return -depth * slope(f) / math_hypot(1, slope(f));
}

static double radius_at(const struct frustum *f, double h)
{
	return f->r_bottom + slope(f) * (h - f->bottom);
}

/*
 * The sections as frustums. A cone becomes a separate frustum; a rounded tip counts as its cylinder. Returns their
 * number.
 */
static size_t frustums_of(const struct tool_solid *solid, struct frustum *out)
{
	const struct tool_section *last = &solid->sections[solid->count - 1];
	double h = solid->top, cone;
	size_t count = 0;

	for (size_t i = 0; i < solid->count; i++) {
		const struct tool_section *section = &solid->sections[i];

		out[count++] = (struct frustum){h, h - section->length, section->diameter / 2,
						section->diameter_end / 2};
		h -= section->length;
	}
	if (solid->tip != TIP_CONE)
		return count;
	cone = fmin(tool_solid_tip_height(solid), last->length);
	if (cone < last->length)
		out[count - 1].bottom = h + cone;
	else
		count--;
	out[count++] = (struct frustum){h + cone, h, last->diameter / 2, 0};
	return count;
}

/* The lower of two lines, compared at their middles. */
static struct line lower_of(struct line a, struct line b)
{
	return a.r_top + a.r_bottom <= b.r_top + b.r_bottom ? a : b;
}

/* The bound from the edge at height `edge` with radius r, for heights within `depth` of it: the chord of an arc. */
static struct line below_edge(const struct eroder *e, double edge, double r, double top, double bottom)
{
	/* The edge and the heights at `depth` from it are cuts, so one test at the middle is enough. */
	if (fabs(0.5 * (top + bottom) - edge) > e->depth)
		return (struct line){INFINITY, INFINITY};
	return (struct line){r - e->depth + fabs(top - edge), r - e->depth + fabs(bottom - edge)};
}

/*
 * The bound from a frustum. If the foot points are on its side, the bound is the side moved inward along its normal. At
 * the frustum's own heights the bound is the side moved by `depth` along the radius, which is less sharp.
 */
static struct line below_side(const struct eroder *e, const struct frustum *f, double top, double bottom)
{
	double middle = 0.5 * (top + bottom), foot = middle + foot_above(f, e->depth), inward;

	if (foot < f->top && foot > f->bottom)
		inward = e->depth * math_hypot(1, slope(f));
	else if (middle < f->top && middle > f->bottom)
		inward = e->depth;
	else
		return (struct line){INFINITY, INFINITY};
	return (struct line){radius_at(f, top) - inward, radius_at(f, bottom) - inward};
}

/* The bound between two neighbouring cuts. */
static struct line bound(const struct eroder *e, double top, double bottom)
{
	struct line best = {INFINITY, INFINITY};

	if (0.5 * (top + bottom) < e->bottom + e->depth)
		return (struct line){0, 0};
	for (size_t i = 0; i < e->count; i++) {
		const struct frustum *f = &e->frustums[i];

		best = lower_of(best, below_side(e, f, top, bottom));
		if (i > 0)
			best = lower_of(best, below_edge(e, f->top, f->r_top, top, bottom));
		best = lower_of(best, below_edge(e, f->bottom, f->r_bottom, top, bottom));
	}
	return best;
}

static void add_cut(struct eroder *e, double h)
{
	if (h < e->top && h > e->bottom)
		e->cuts[e->cut_count++] = h;
}

static int descending(const void *a, const void *b)
{
	double x = *(const double *)a, y = *(const double *)b;

	return (x < y) - (x > y);
}

/* The heights at which another bound may become the lowest, or the radius may become 0. */
static void make_cuts(struct eroder *e)
{
	e->cuts = mem_zalloc(9 * e->count + 3, sizeof(*e->cuts));
	e->cut_count = 0;
	e->cuts[e->cut_count++] = e->top;
	e->cuts[e->cut_count++] = e->bottom;
	add_cut(e, e->bottom + e->depth);
	for (size_t i = 0; i < e->count; i++) {
		const struct frustum *f = &e->frustums[i];

		for (int side = -1; side <= 1; side++) {
			add_cut(e, f->top + side * e->depth);
			add_cut(e, f->bottom + side * e->depth);
		}
		add_cut(e, f->top - foot_above(f, e->depth));
		add_cut(e, f->bottom - foot_above(f, e->depth));
		if (fabs(slope(f)) > 0)
			add_cut(e, f->bottom + (e->depth * math_hypot(1, slope(f)) - f->r_bottom) / slope(f));
	}
	qsort(e->cuts, e->cut_count, sizeof(*e->cuts), descending);
}

/* The largest radius that the bounds permit between two heights; there may be cuts between them. */
static double largest_bound(const struct eroder *e, double top, double bottom)
{
	double most = 0;

	for (size_t i = 0; i + 1 < e->cut_count; i++) {
		double high = fmin(e->cuts[i], top), low = fmax(e->cuts[i + 1], bottom);

		if (high > low) {
			struct line line = bound(e, high, low);

			most = fmax(most, fmax(line.r_top, line.r_bottom));
		}
	}
	return most;
}

/* The first cut below h, but not below `end`. */
static double next_cut(const struct eroder *e, double h, double end)
{
	for (size_t i = 0; i < e->cut_count; i++)
		if (e->cuts[i] < h && e->cuts[i] > end)
			return e->cuts[i];
	return end;
}

/*
 * Makes the sections of the core from its top to `end`, without sections of radius 0 at the lower end. If cuts are
 * close together one cylinder encloses several pieces, so that no section is too short.
 */
static size_t erode(const struct eroder *e, double end, struct tool_section *sections)
{
	size_t count = 0, kept = 0;
	double top = e->top;

	while (top > end) {
		double bottom = next_cut(e, top, end);
		struct line line;

		if (top - bottom >= TOOL_SECTION_MIN) {
			line = bound(e, top, bottom);
		} else {
			bottom = fmax(top - TOOL_SECTION_MIN, end);
			line.r_top = line.r_bottom = largest_bound(e, top, bottom);
		}
		sections[count++] = (struct tool_section){top - bottom, 2 * fmax(line.r_top, TOOL_DIAMETER_MIN / 2),
							  2 * fmax(line.r_bottom, TOOL_DIAMETER_MIN / 2)};
		if (line.r_top > RADIUS_ROUNDING || line.r_bottom > RADIUS_ROUNDING)
			kept = count;
		top = bottom;
	}
	return kept;
}

/* Does the tip remain round, with a radius smaller by `depth`? */
static bool keeps_round_tip(const struct tool_solid *solid, double depth)
{
	const struct tool_section *last = &solid->sections[solid->count - 1];

	return (solid->tip == TIP_BALL || (solid->tip == TIP_BULL && solid->corner > depth + TOOL_SECTION_MIN)) &&
	       last->diameter / 2 > depth + TOOL_SECTION_MIN;
}

static struct tool_solid make_core(struct eroder *eroder, const struct tool_solid *solid, struct arena *arena)
{
	struct tool_solid core = {.top = solid->top, .tip = TIP_FLAT};
	struct tool_section *sections;
	double tip;

	make_cuts(eroder);
	/* Between two cuts there is at most one section, and one that continues. */
	sections = arena_alloc(arena, 2 * eroder->cut_count * sizeof(*sections));
	core.sections = sections;
	if (keeps_round_tip(solid, eroder->depth)) {
		double d = solid->sections[solid->count - 1].diameter - 2 * eroder->depth;

		/* The rounding begins at the same height and has the same centre. */
		tip = tool_solid_tip_height(solid);
		core.count = erode(eroder, eroder->bottom + tip, sections);
		sections[core.count++] = (struct tool_section){tip - eroder->depth, d, d};
		core.tip = solid->tip;
		core.corner = solid->tip == TIP_BULL ? solid->corner - eroder->depth : 0;
	} else {
		core.count = erode(eroder, eroder->bottom, sections);
	}
	free(eroder->cuts);
	return core;
}

/*
 * The frustums of the solid, after one for the tool above it if that is thinner: then the rest of the upper end is
 * surface. Returns their number; there is space for two more than the solid has sections.
 */
static size_t frustums_with(const struct tool_solid *solid, double depth, double above, struct frustum *out)
{
	size_t count = 0;

	if (above < solid->sections[0].diameter / 2)
		out[count++] = (struct frustum){solid->top + 2 * depth, solid->top, above, above};
	return count + frustums_of(solid, out + count);
}

struct tool_solid tool_core(const struct tool_solid *solid, double depth, double above, struct arena *arena)
{
	struct frustum *frustums;
	struct eroder eroder = {.depth = depth, .top = solid->top};
	struct tool_solid core;

	if (!(depth > 0))
		return *solid;
	frustums = mem_zalloc(solid->count + 2, sizeof(*frustums));
	eroder.frustums = frustums;
	eroder.count = frustums_with(solid, depth, above, frustums);
	eroder.bottom = frustums[eroder.count - 1].bottom;
	core = make_core(&eroder, solid, arena);
	free(frustums);
	return core;
}
