#include <math.h>

#include "machine/tool_core.h"

/* A point or a rim that stands out by more than this many times the depth must have a core of its own. */
#define STANDS_OUT 6

/* The most halvings of the depth for the sake of a point or a rim: those of needles become ever thinner. */
#define HALVINGS 4

/* A ball that is larger than the depth by this factor must fit, so that the core is more than a point or a line. */
#define FITS 1.001

/* Heights from the top down at which the solid has at least some radius, without a gap. */
struct run {
	double top, bottom;
};

/* The solid's sections from the top down; a cone is one more. A rounded tip counts as its cylinder. */
struct piece {
	double top, bottom;
	double r_top, r_bottom;
};

static size_t piece_count(const struct tool_solid *solid)
{
	return solid->count + (solid->tip == TIP_CONE ? 1 : 0);
}

/* The piece with this number, which begins at the height `top`. */
static struct piece piece_below(const struct tool_solid *solid, size_t number, double top)
{
	const struct tool_section *section = &solid->sections[number < solid->count ? number : solid->count - 1];
	const double r = section->diameter / 2;
	const double cone = solid->tip == TIP_CONE ? fmin(tool_solid_tip_height(solid), section->length) : 0;

	if (number == solid->count)
		return (struct piece){top, top - cone, r, 0};
	if (number + 1 == solid->count && cone > 0)
		return (struct piece){top, top - section->length + cone, r, r};
	return (struct piece){top, top - section->length, r, section->diameter_end / 2};
}

/* The heights of a piece at which its radius is at least r; the top is below the bottom if there are none. */
static struct run wide_part(const struct piece *piece, double r)
{
	const double grows = piece->r_bottom - piece->r_top;
	const double at = piece->top - (r - piece->r_top) / grows * (piece->top - piece->bottom);

	if (piece->r_top >= r && piece->r_bottom >= r)
		return (struct run){piece->top, piece->bottom};
	if (piece->r_top < r && piece->r_bottom < r)
		return (struct run){piece->bottom, piece->top};
	return grows > 0 ? (struct run){at, piece->bottom} : (struct run){piece->top, at};
}

/*
 * Is there a run of heights with at least the radius r, and `length` long, whose lower end is not above `end`? A ball
 * that has this length as its diameter, and no larger radius than r, fits into such a run.
 */
static bool has_run(const struct tool_solid *solid, double r, double length, double end)
{
	struct run run = {INFINITY, INFINITY};
	struct piece piece = {.bottom = solid->top};

	for (size_t i = 0; i < piece_count(solid); i++) {
		struct run part;

		piece = piece_below(solid, i, piece.bottom);
		part = wide_part(&piece, r);
		if (!(part.top >= part.bottom))
			continue;
		if (part.top < piece.top || run.bottom > piece.top)
			run.top = part.top;
		run.bottom = part.bottom;
		if (run.top - run.bottom >= length && run.bottom <= end)
			return true;
	}
	return false;
}

static double widest(const struct tool_solid *solid)
{
	double most = 0;

	for (size_t i = 0; i < solid->count; i++)
		most = fmax(most, 0.5 * fmax(solid->sections[i].diameter, solid->sections[i].diameter_end));
	return most;
}

static bool has_core(const struct tool_solid *solid, double depth)
{
	return has_run(solid, FITS * depth, 2 * FITS * depth, INFINITY);
}

static bool point_and_rim_have_cores(const struct tool_solid *solid, double depth)
{
	const double ball = FITS * depth, out = STANDS_OUT * depth;

	return has_run(solid, ball, 2 * ball, tool_solid_bottom(solid) + out) &&
	       has_run(solid, fmax(ball, widest(solid) - out), 2 * ball, INFINITY);
}

double tool_core_depth(const struct tool_solid *solid, double depth)
{
	double all = depth;

	if (!(depth > 0))
		return depth;
	for (int i = 0; i <= HALVINGS; i++) {
		if (has_core(solid, all) && point_and_rim_have_cores(solid, all))
			return all;
		all /= 2;
	}
	while (!has_core(solid, depth))
		depth /= 2;
	return depth;
}
