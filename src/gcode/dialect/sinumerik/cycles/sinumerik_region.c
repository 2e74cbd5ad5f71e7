#include "gcode/dialect/sinumerik/cycles/sinumerik_region.h"

#include <math.h>
#include <string.h>

#include "base/math/math_functions.h"
#include "base/units.h"
#include "gcode/dialect/sinumerik/block/sinumerik_tool.h"
#include "gcode/dialect/sinumerik/cycles/sinumerik_argument.h"
#include "gcode/dialect/sinumerik/frames/sinumerik_frame.h"
#include "gcode/dialect/sinumerik/frames/sinumerik_open_place.h"
#include "gcode/dialect/sinumerik/path/sinumerik_target.h"

/* The maximum number of slots of one call. */
#define PARTS_MAX 1000

/* The units of _VARI of pockets and slots: 1 roughing, 2 finishing, 4 finishing of the edge. */
enum { CHAMFER = 5 };

/* A box in the plane that contains the tool centre. Program coordinates, mm. */
struct box {
	double low[2], high[2];
};

struct milling {
	struct sinumerik_arguments of;
	enum axis_slot a, b, depth;	/* the plane, and the axis perpendicular to it */
	struct sinumerik_heights height;
	double beyond;	/* mm: how far the tool may be below the depth and above the safe height */
	double radius;	/* mm: of the tool; 0 if it is not known, which makes the region larger */
	double feed;	/* mm/s */
};

static double length(const struct milling *m, size_t i)
{
	return sinumerik_argument_length(&m->of, i);
}

/* The box around a rectangle from low to high, which is rotated by degrees about a point. */
static struct box turned(double at_a, double at_b, double degrees, const struct box *along)
{
	const double c = math_cos_degrees(degrees), s = math_sin_degrees(degrees);
	const double middle[2] = {(along->low[0] + along->high[0]) / 2, (along->low[1] + along->high[1]) / 2};
	const double half[2] = {(along->high[0] - along->low[0]) / 2, (along->high[1] - along->low[1]) / 2};
	const double x = at_a + c * middle[0] - s * middle[1], y = at_b + s * middle[0] + c * middle[1];
	const double half_x = fabs(c) * half[0] + fabs(s) * half[1], half_y = fabs(s) * half[0] + fabs(c) * half[1];

	return (struct box){{x - half_x, y - half_y}, {x + half_x, y + half_y}};
}

static struct box about(double a, double b, double half_a, double half_b)
{
	return (struct box){{a - half_a, b - half_b}, {a + half_a, b + half_b}};
}

static struct box hull(const struct box *one, const struct box *other)
{
	struct box both;

	for (int i = 0; i < 2; i++) {
		both.low[i] = fmin(one->low[i], other->low[i]);
		both.high[i] = fmax(one->high[i], other->high[i]);
	}
	return both;
}

/* Half of a length, less the tool radius. */
static double inside(const struct milling *m, double whole)
{
	return fmax(0, fabs(whole) / 2 - m->radius);
}

/* ------------------------------------------------------------------- moves */

/*
 * Moves to the middle of a box at a height; the tool may be anywhere in the box about the path. A feed of 0 is a
 * rapid.
 */
static bool go(struct milling *m, const struct box *box, double height, double beyond, double feed)
{
	slot_values target = *sinumerik_frame_place(m->of.interp);
	double half[SLOT_Z + 1] = {0};

	target.v[m->a] = (box->low[0] + box->high[0]) / 2;
	target.v[m->b] = (box->low[1] + box->high[1]) / 2;
	target.v[m->depth] = height;
	half[m->a] = (box->high[0] - box->low[0]) / 2;
	half[m->b] = (box->high[1] - box->low[1]) / 2;
	half[m->depth] = beyond;
	return sinumerik_open_place_go(m->of.interp, &target, half, feed);
}

/* From the present place to above the region, one axis after the other or all at once: anywhere between. */
static bool approach(struct milling *m, const struct box *all)
{
	const slot_values *place = sinumerik_frame_place(m->of.interp);
	const struct box here = about(place->v[m->a], place->v[m->b], 0, 0), both = hull(&here, all);
	const double z = place->v[m->depth], low = fmin(z, m->height.clear), high = fmax(z, m->height.clear);

	const double a = (all->low[0] + all->high[0]) / 2, b = (all->low[1] + all->high[1]) / 2;
	const struct box middle = about(a, b, 0, 0);

	return go(m, &both, (low + high) / 2, (high - low) / 2, 0) && go(m, &middle, m->height.clear, 0, 0) &&
	       go(m, all, m->height.safe, 0, 0);
}

/* Into one part of the region and out of it. */
static bool mill_part(struct milling *m, const struct box *part)
{
	return go(m, part, m->height.bottom, m->beyond, m->feed) && go(m, part, m->height.safe, m->beyond, m->feed);
}

/* Above the region the position is uncertain until the axes of the plane are commanded. */
static bool retract(struct milling *m, const struct box *all)
{
	struct interp *interp = m->of.interp;
	double half[SLOT_Z + 1] = {0};

	half[m->a] = (all->high[0] - all->low[0]) / 2;
	half[m->b] = (all->high[1] - all->low[1]) / 2;
	if (!go(m, all, m->height.clear, 0, 0))
		return false;
	sinumerik_open_place_set(interp, half);
	return true;
}

static bool mill(struct milling *m, const struct box *parts, int count)
{
	struct box all = parts[0];

	sinumerik_open_place_take_over(m->of.interp);
	for (int i = 1; i < count; i++)
		all = hull(&all, &parts[i]);
	if (!approach(m, &all))
		return false;
	/* Between the parts the tool may be anywhere above all of them; the approach has covered this. */
	for (int i = 0; i < count; i++) {
		if ((count > 1 && !go(m, &parts[i], m->height.safe, 0, 0)) || !mill_part(m, &parts[i]))
			return false;
	}
	return (count == 1 || go(m, &all, m->height.safe, 0, 0)) && retract(m, &all);
}

/* ------------------------------------------------------------------ cycles */

/* "POCKET1": LENG by WID about CPA, CPO, rotated by STA1. */
static bool rectangle(struct milling *m)
{
	const struct box along = about(0, 0, inside(m, length(m, 5)), inside(m, length(m, 6)));
	const struct box part =
	    turned(length(m, 8), length(m, 9), sinumerik_argument_or(&m->of, 10, 0), &along);

	return mill(m, &part, 1);
}

/*
 * "POCKET3": like POCKET1, given by its centre, or by a corner and the signs of _LENG and _WID. The thousands of
 * _GMODE select which; with 0 a setting of the control does (_ZSD[2]).
 */
static bool rectangle_or_corner(struct milling *m)
{
	const bool centred = sinumerik_argument_digit(&m->of, 26, 3) == 1;
	const double half_a = inside(m, length(m, 4)) + (centred ? 0 : fabs(length(m, 4)) / 2);
	const double half_b = inside(m, length(m, 5)) + (centred ? 0 : fabs(length(m, 5)) / 2);
	const struct box along = about(0, 0, half_a, half_b);
	const struct box part = turned(length(m, 7), length(m, 8), sinumerik_argument_or(&m->of, 9, 0), &along);

	return mill(m, &part, 1);
}

/* "POCKET2": a circle of radius PRAD about CPA, CPO. */
static bool disc(struct milling *m)
{
	const double radius = inside(m, 2 * length(m, 5));
	const struct box part = about(length(m, 6), length(m, 7), radius, radius);

	return mill(m, &part, 1);
}

/* "POCKET4": a radius, or in newer versions a diameter. Taken as a radius, the region contains both. */
static bool disc_or_half(struct milling *m)
{
	const double radius = inside(m, 2 * length(m, 4));
	const struct box part = about(length(m, 5), length(m, 6), radius, radius);

	return mill(m, &part, 1);
}

/* The indices of the arguments that LONGHOLE and SLOT1 both have. */
struct slots {
	size_t number, length, at_a, at_b, radius, start, step, geometry;
	double half_width;
};

/*
 * Slots that point away from a centre and begin at a radius. STA1 is the angle of the first slot, and INDA the step;
 * INDA=0 divides the full circle. _GMODE may select other dimensions: then the region begins as far on the other
 * side.
 */
static bool radial_slots(struct milling *m, const struct slots *at)
{
	const double number = sinumerik_argument_or(&m->of, at->number, 0),
		     step = sinumerik_argument_or(&m->of, at->step, 0);
	const double radius = fabs(length(m, at->radius)), slot = fabs(length(m, at->length));
	const bool otherwise = sinumerik_argument_counts(&m->of, at->geometry);
	const struct box along = {{radius - (otherwise ? slot : 0), -at->half_width}, {radius + slot, at->half_width}};
	struct box parts[PARTS_MAX] = {0};

	if (!(number >= 1 && number <= PARTS_MAX) || floor(number) < number)
		return fault(&m->of.interp->at, m->of.column, "%s needs a number of slots, NUM, from 1 to %d",
			     m->of.cycle, PARTS_MAX);
	for (int i = 0; i < (int)number; i++)
		parts[i] = turned(length(m, at->at_a), length(m, at->at_b),
				  sinumerik_argument_or(&m->of, at->start, 0) +
				      i * (fabs(step) > 0 ? step : 360 / number),
				  &along);
	return mill(m, parts, (int)number);
}

/* "LONGHOLE": as wide as the tool. */
static bool long_holes(struct milling *m)
{
	return radial_slots(m, &(struct slots){5, 6, 7, 8, 9, 10, 11, 17, 0});
}

static bool straight_slots(struct milling *m)
{
	return radial_slots(m, &(struct slots){5, 6, 8, 9, 10, 11, 12, 28, inside(m, length(m, 7))});
}

/* "SLOT2": slots of width WID on a circle of radius RAD about CPA, CPO. */
static bool circular_slots(struct milling *m)
{
	const double radius = fabs(length(m, 10)) + inside(m, length(m, 7));
	const struct box part = about(length(m, 8), length(m, 9), radius, radius);

	return mill(m, &part, 1);
}

/*
 * "CYCLE71": a face from a corner, rotated by _STA. The tool passes its edges by _FDP and _FDP1, and by at most its
 * diameter more.
 */
static bool turned_face(struct milling *m)
{
	const double over = fabs(length(m, 11)) + fabs(length(m, 15)) + 2 * m->radius;
	const double a = length(m, 6), b = length(m, 7);
	const struct box along = {{fmin(0, a) - over, fmin(0, b) - over}, {fmax(0, a) + over, fmax(0, b) + over}};
	const struct box part = turned(length(m, 4), length(m, 5), sinumerik_argument_or(&m->of, 8, 0), &along);

	return mill(m, &part, 1);
}

/*
 * "CYCLE61": a face from one corner to another. _AMODE says whether the second corner is a position or a length: the
 * region contains both. The tool begins and ends beside the face, at most by its diameter and the safety distance.
 */
static bool face(struct milling *m)
{
	const double over = 2 * m->radius + fabs(length(m, SINUMERIK_SDIS));
	const double a = length(m, 4), b = length(m, 5), to_a = length(m, 6), to_b = length(m, 7);
	const struct box corner = about(a, b, over, over), absolute = about(to_a, to_b, over, over);
	const struct box relative = about(a + to_a, b + to_b, over, over);
	struct box part = hull(&corner, &absolute);

	part = hull(&part, &relative);
	return mill(m, &part, 1);
}

/* An internal thread: the helix may begin and end above and below the thread. */
static bool thread(struct milling *m, size_t diameter, size_t pitch, size_t outside, size_t at_a)
{
	const double radius = inside(m, length(m, diameter));
	const struct box part = about(length(m, at_a), length(m, at_a + 1), radius, radius);

	if (sinumerik_argument_counts(&m->of, outside))
		return fault(&m->of.interp->at, m->of.column,
			     "%s on an outside thread: how far aside the tool goes is not known", m->of.cycle);
	if (!(length(m, pitch) > 0))
		return fault(&m->of.interp->at, m->of.column, "%s needs the pitch of its thread in mm or inches, PIT",
			     m->of.cycle);
	m->beyond = 2 * length(m, pitch);
	return mill(m, &part, 1);
}

static bool thread_70(struct milling *m)
{
	return sinumerik_argument_digit(&m->of, 16, 0) > 1
		   ? fault(&m->of.interp->at, m->of.column,
			   "CYCLE70 with a pitch in threads an inch or in modules (_PITA) is not supported")
		   : thread(m, 4, 7, 11, 12);
}

static bool thread_90(struct milling *m)
{
	return thread(m, 5, 7, 10, 11);
}

/* 840D sl, "Milling cycles": the indices of their arguments. */
static const struct cycle {
	const char *name;
	bool (*mill)(struct milling *m);
	size_t feed;	/* in the plane */
	struct sinumerik_modes modes;
	size_t machining;	/* _VARI, if the cycle can make a chamfer; 0: it cannot */
	size_t place;	/* of the two coordinates of its place; 0: MCALL cannot call it at positions */
} cycles[] = {
	{"POCKET1", rectangle, 12, {0, 0, 0, true}, 0, 8},
	{"POCKET2", disc, 9, {0, 0, 0, true}, 0, 6},
	{"POCKET3", rectangle_or_corner, 13, {26, 27, 28, false}, 16, 7},
	{"POCKET4", disc_or_half, 10, {22, 23, 24, false}, 13, 5},
	{"SLOT1", straight_slots, 14, {28, 29, 30, true}, 18, 8},
	{"SLOT2", circular_slots, 14, {26, 27, 28, true}, 18, 8},
	{"LONGHOLE", long_holes, 13, {17, 18, 19, true}, 0, 7},
	{"CYCLE61", face, 11, {0, 14, 15, false}, 0, 0},
	{"CYCLE70", thread_70, 10, {20, 21, 22, false}, 0, 12},
	{"CYCLE71", turned_face, 13, {0, 0, 0, false}, 0, 0},
	{"CYCLE90", thread_90, 8, {0, 0, 0, true}, 0, 11},
};

static const struct cycle *find(const char *name)
{
	for (size_t i = 0; i < sizeof(cycles) / sizeof(cycles[0]); i++) {
		if (!strcmp(cycles[i].name, name))
			return &cycles[i];
	}
	return NULL;
}

bool sinumerik_region_is(const char *name)
{
	return find(name) != NULL;
}

/* The feed of the cycle, or else the active one. */
static bool find_feed(struct milling *m, size_t i)
{
	const struct interp *interp = m->of.interp;

	m->feed = sinumerik_argument_or(&m->of, i, 0) * sinumerik_of(interp)->feed_scale / SECONDS_PER_MINUTE;
	if (!(m->feed > 0))
		m->feed = interp->state.feed_linear / SECONDS_PER_MINUTE;
	return m->feed > 0 || fault(&interp->at, m->of.column, "%s without a feed rate", m->of.cycle);
}

/* A pointed tool comes nearer to the edge of a pocket than its radius: units of _VARI. */
static bool check_machining(const struct milling *m, const struct cycle *cycle)
{
	return !cycle->machining || sinumerik_argument_digit(&m->of, cycle->machining, 0) != CHAMFER ||
	       fault(&m->of.interp->at, m->of.column,
		     "%s that makes a chamfer (units of _VARI 5) is not supported: how near to the edge the tool goes "
		     "is not known",
		     m->of.cycle);
}

bool sinumerik_region_mill(struct interp *interp, const char *name, const double *arguments, size_t count, int column)
{
	const struct cycle *cycle = find(name);
	const int plane = interp->state.plane;
	struct milling m = {.of = {interp, name, column, arguments, count}, .radius = sinumerik_tool_radius(interp)};

	/* Scaling does not change the radius of the tool. */
	if (sinumerik_frame_resizes(interp))
		return fault(&interp->at, column, "%s while SCALE is in force is not supported", name);
	m.depth = plane == G17 ? SLOT_Z : plane == G18 ? SLOT_Y : SLOT_X;
	m.a = plane == G17 ? SLOT_X : plane == G18 ? SLOT_Z : SLOT_Y;
	m.b = plane == G17 ? SLOT_Y : plane == G18 ? SLOT_X : SLOT_Z;
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++) {
		if (!interp->config->has_axis[slot])
			return fault(&interp->at, column, "%s needs the axes X, Y and Z", name);
	}
	return check_machining(&m, cycle) && sinumerik_argument_heights(&m.of, &cycle->modes, &m.height) &&
	       find_feed(&m, cycle->feed) && cycle->mill(&m);
}

/* "Machining position, position pattern (MCALL)": then the place of the cycle itself is omitted. */
bool sinumerik_region_check_modal(struct interp *interp, const char *name, const double *arguments, size_t count,
				  int column)
{
	const struct cycle *cycle = find(name);
	const struct sinumerik_arguments of = {interp, name, column, arguments, count};

	if (!cycle->place)
		return fault(&interp->at, column, "MCALL %s: a face is milled where the cycle itself says", name);
	return (!sinumerik_argument_given(&of, cycle->place) && !sinumerik_argument_given(&of, cycle->place + 1)) ||
	       fault(&interp->at, column,
		     "MCALL %s with a place of its own (arguments %zu and %zu): whether this or the position counts is "
		     "not certain; leave them empty",
		     name, cycle->place + 1, cycle->place + 2);
}

bool sinumerik_region_mill_here(struct interp *interp, const char *name, const double *arguments, size_t count,
				int column)
{
	const size_t place = find(name)->place;
	const enum axis_slot a = interp->state.plane == G17   ? SLOT_X
				 : interp->state.plane == G18 ? SLOT_Z
							      : SLOT_Y;
	const enum axis_slot b = interp->state.plane == G17   ? SLOT_Y
				 : interp->state.plane == G18 ? SLOT_X
							      : SLOT_Z;
	const slot_values *here = sinumerik_frame_place(interp);
	double all[SINUMERIK_ARGUMENTS_MAX];

	if (!sinumerik_open_place_check(interp, column, name))
		return false;
	for (size_t i = 0; i < SINUMERIK_ARGUMENTS_MAX; i++)
		all[i] = i < count ? arguments[i] : NAN;
	all[place] = here->v[a] / interp->state.scale;
	all[place + 1] = here->v[b] / interp->state.scale;
	return sinumerik_region_mill(interp, name, all, count > place + 2 ? count : place + 2, column);
}
