#include "machine/library/tool_profile.h"

#include <math.h>
#include <stdlib.h>

#include "base/math/math_functions.h"
#include "base/mem.h"
#include "machine/tool_solid.h"

/* mm: the largest deviation of frustums from an arc that they enclose. */
#define ARC_DEVIATION 0.005
/* mm: heights that differ by less are the same; the sections of a setup are at least this long. */
#define SAME_HEIGHT TOOL_SECTION_MIN
/* mm: the largest displacement, by rounding, of a point on a line. */
#define SAME_LINE 1e-9
enum { ARC_STEPS_MAX = 256 };

void tool_profile_release(struct tool_profile *profile)
{
	free(profile->pieces);
	*profile = (struct tool_profile){0};
}

void tool_profile_add(struct tool_profile *profile, double z0, double r0, double z1, double r1)
{
	const struct profile_piece up = {z0, z1, fmax(r0, 0), fmax(r1, 0)}, down = {z1, z0, fmax(r1, 0), fmax(r0, 0)};

	if (!(fabs(z1 - z0) > 0))
		return;
	profile->pieces = mem_grow(profile->pieces, &profile->capacity, profile->count + 1, sizeof(*profile->pieces));
	profile->pieces[profile->count++] = z0 < z1 ? up : down;
}

/* --------------------------------------------------------------------- arcs */

/* The angle of the arc, in (0, 2 pi], with the sign of its direction. */
static double turn_of(double from, double to, bool left)
{
	const double full = 2 * math_acos(-1);
	double turn = fmod(left ? to - from : from - to, full);

	if (turn <= 0)
		turn += full;
	return left ? turn : -turn;
}

/*
 * The number of steps for which tangents at their ends meet within the deviation outside the arc: r (1 / cos(h / 2) -
 * 1).
 */
static int steps_of(double radius, double turn)
{
	for (int n = 1; n < ARC_STEPS_MAX; n++) {
		double half = fabs(turn) / n / 2;

		if (half < 1 && radius * (1 / math_cos(half) - 1) <= ARC_DEVIATION)
			return n;
	}
	return ARC_STEPS_MAX;
}

void tool_profile_add_arc(struct tool_profile *profile, double z0, double r0, double z1, double r1, double center_z,
			  double center_r, bool left)
{
	double radius = math_hypot(r0 - center_r, z0 - center_z);
	double from = math_atan2(z0 - center_z, r0 - center_r);
	double turn = turn_of(from, math_atan2(z1 - center_z, r1 - center_r), left);
	int n = steps_of(radius, turn);
	double step = turn / n, outer = radius / math_cos(step / 2);
	/* The middle of a convex arc is outside its chord; the chords of a concave arc are outside the arc already. */
	bool bulges = center_r + radius * math_cos(from + turn / 2) > (r0 + r1) / 2;
	double z = z0, r = r0;

	for (int i = 0; i < n; i++) {
		double middle = from + (i + 0.5) * step, end = from + (i + 1) * step;
		double next_z = i + 1 < n ? center_z + radius * math_sin(end) : z1;
		double next_r = i + 1 < n ? center_r + radius * math_cos(end) : r1;

		if (bulges) {
			double corner_z = center_z + outer * math_sin(middle),
			       corner_r = center_r + outer * math_cos(middle);

			tool_profile_add(profile, z, r, corner_z, corner_r);
			tool_profile_add(profile, corner_z, corner_r, next_z, next_r);
		} else {
			tool_profile_add(profile, z, r, next_z, next_r);
		}
		z = next_z;
		r = next_r;
	}
}

double tool_profile_top(const struct tool_profile *profile)
{
	double top = 0;

	for (size_t i = 0; i < profile->count; i++)
		top = fmax(top, profile->pieces[i].high);
	return top;
}

/* ----------------------------------------------------------------- sections */

static double radius_at(const struct profile_piece *p, double z)
{
	return p->radius_low + (p->radius_high - p->radius_low) * (z - p->low) / (p->high - p->low);
}

/* The outermost piece in the middle of an interval without an end or crossing inside; NULL: there is none. */
static const struct profile_piece *outermost(const struct tool_profile *profile, double low, double high)
{
	double middle = (low + high) / 2;
	const struct profile_piece *best = NULL;

	for (size_t i = 0; i < profile->count; i++) {
		const struct profile_piece *p = &profile->pieces[i];

		if (p->low <= middle && middle <= p->high && (!best || radius_at(p, middle) > radius_at(best, middle)))
			best = p;
	}
	return best;
}

struct heights {
	double *z;
	size_t count, capacity;
};

static void add_height(struct heights *heights, double low, double high, double z)
{
	if (!(z > low && z < high))
		return;
	heights->z = mem_grow(heights->z, &heights->capacity, heights->count + 1, sizeof(*heights->z));
	heights->z[heights->count++] = z;
}

/* Adds the height at which two pieces have the same radius, if it is inside both. */
static void add_crossing(struct heights *heights, const struct profile_piece *a, const struct profile_piece *b)
{
	double low = fmax(a->low, b->low), high = fmin(a->high, b->high), below, above;

	if (!(low < high))
		return;
	below = radius_at(a, low) - radius_at(b, low);
	above = radius_at(a, high) - radius_at(b, high);
	if (below * above < 0)
		add_height(heights, low, high, low + (high - low) * below / (below - above));
}

static int by_value(const void *a, const void *b)
{
	double x = *(const double *)a, y = *(const double *)b;

	return (x > y) - (x < y);
}

/*
 * The heights at which the outline may change, from low to high, including both; they differ by at least SAME_HEIGHT.
 */
static void find_heights(struct heights *heights, const struct tool_profile *profile, double low, double high)
{
	size_t kept = 0;

	for (size_t i = 0; i < profile->count; i++) {
		add_height(heights, low, high, profile->pieces[i].low);
		add_height(heights, low, high, profile->pieces[i].high);
		for (size_t k = 0; k < i; k++)
			add_crossing(heights, &profile->pieces[i], &profile->pieces[k]);
	}
	if (heights->count)
		qsort(heights->z, heights->count, sizeof(*heights->z), by_value);
	for (size_t i = 0; i < heights->count; i++) {
		double last = kept ? heights->z[kept - 1] : low, z = heights->z[i];

		if (z - last >= SAME_HEIGHT && high - z >= SAME_HEIGHT)
			heights->z[kept++] = z;
	}
	heights->count = kept;
}

void tool_profile_join(struct tool_profile *profile, const struct tool_profile *other)
{
	for (size_t i = 0; i < other->count; i++) {
		const struct profile_piece *p = &other->pieces[i];

		tool_profile_add(profile, p->low, p->radius_low, p->high, p->radius_high);
	}
}

double tool_profile_hides(const struct tool_profile *outer, const struct tool_profile *inner, double from)
{
	struct tool_profile both = {0};
	struct heights heights = {0};
	double hidden = from, top;

	tool_profile_join(&both, outer);
	tool_profile_join(&both, inner);
	top = tool_profile_top(&both);
	find_heights(&heights, &both, from, top);
	for (size_t i = 0; i <= heights.count; i++) {
		double end = i < heights.count ? heights.z[i] : top, middle = (hidden + end) / 2;
		const struct profile_piece *a = outermost(outer, hidden, end), *b = outermost(inner, hidden, end);

		if (b && (!a || radius_at(a, middle) < radius_at(b, middle)))
			break;
		hidden = end;
	}
	free(heights.z);
	tool_profile_release(&both);
	return hidden;
}

static struct optional_number given(double value)
{
	return (struct optional_number){.given = true, .value = value};
}

/* The largest radii of all pieces at the ends of an interval: every outline between them is inside the frustum. */
static struct section_description section_between(const struct tool_profile *profile, double low, double high,
						  double gap)
{
	const struct profile_piece *p = outermost(profile, low, high);
	double at_low = gap / 2, at_high = at_low;

	if (p) {
		at_low = radius_at(p, fmax(low, p->low));
		at_high = radius_at(p, fmin(high, p->high));
	}
	at_low = fmax(at_low, TOOL_DIAMETER_MIN / 2);
	at_high = fmax(at_high, TOOL_DIAMETER_MIN / 2);
	return (struct section_description){
		.length = high - low, .diameter = 2 * at_high, .diameter_end = given(2 * at_low)};
}

/* Is the joint of two sections on the line from the top of the upper one to the end of the lower one? */
static bool is_straight(const struct section_description *upper, const struct section_description *lower)
{
	const double share = upper->length / (upper->length + lower->length);
	const double joint = upper->diameter + share * (lower->diameter_end.value - upper->diameter);

	return fabs(upper->diameter_end.value - joint) < SAME_LINE && fabs(lower->diameter - joint) < SAME_LINE;
}

/*
 * Adds a section below the others, or makes the last one longer: heights where other pieces only touch the outline from
 * inside divide it, too.
 */
static void add_section(struct piece_description *out, struct section_description section)
{
	struct section_description *last = out->section_count ? &out->sections[out->section_count - 1] : NULL;

	if (!last || !is_straight(last, &section)) {
		out->sections[out->section_count++] = section;
		return;
	}
	last->length += section.length;
	last->diameter_end = section.diameter_end;
}

void tool_profile_sections(const struct tool_profile *profile, double low, double high, double gap,
			   struct arena *arena, struct piece_description *out)
{
	struct heights heights = {0};
	double above = high;

	find_heights(&heights, profile, low, high);
	out->sections = arena_alloc(arena, (heights.count + 1) * sizeof(*out->sections));
	out->section_count = 0;
	for (size_t i = heights.count + 1; i > 0; i--) {
		double below = i > 1 ? heights.z[i - 2] : low;

		add_section(out, section_between(profile, below, above, gap));
		above = below;
	}
	free(heights.z);
}
