#include "gcode/dialect/klartext/klartext_region.h"

#include <math.h>

#include "base/math/math_functions.h"
#include "base/same_double.h"
#include "gcode/dialect/klartext/klartext_frame.h"
#include "gcode/execute/motion_commands.h"

/* A box about a point, both in programmed coordinates: the centre of the tool is in it. mm. */
struct region {
	vec3 centre; /* in the plane */
	double half[2]; /* along X and Y */
	double top, bottom, clear; /* heights: set-up clearance, depth, second set-up clearance */
	double beyond; /* how far it may go over and under them */
	double feed; /* mm/s */
	bool nothing; /* a depth of 0: the cycle is not carried out */
};

/* A box of these half sides, turned by an angle: the box about it along X and Y. */
static void turn_box(struct region *region, double along, double across, double degrees)
{
	const double c = fabs(math_cos_degrees(degrees)), s = fabs(math_sin_degrees(degrees));

	region->half[0] = c * along + s * across;
	region->half[1] = s * along + c * across;
}

/* Where the centre of a pocket or a slot lies from where the tool stands, in units of its half sides (Q367). */
static bool find_place(const struct klartext_call_of *call, const double places[5][2], double way[2])
{
	const double place = klartext_parameter_or(call, 367, 0);

	if (!(place >= 0 && place <= 4) || !same_double(floor(place), place))
		return fault(&call->interp->at, call->column, "Q367 of CYCL DEF %d is a whole number from 0 to 4",
			     call->cycle->number);
	way[0] = places[(int)place][0];
	way[1] = places[(int)place][1];
	return true;
}

static void shift_centre(struct region *region, double x, double y, double degrees)
{
	region->centre.x += math_cos_degrees(degrees) * x - math_sin_degrees(degrees) * y;
	region->centre.y += math_sin_degrees(degrees) * x + math_cos_degrees(degrees) * y;
}

/* The tool's radius, as far as it is known: the region is the greater without. */
static double tool_radius(const struct klartext_call_of *call)
{
	const struct tool *tool = tool_table_find(&call->interp->tools, call->interp->state.tool);

	return tool ? fmax(0, tool->diameter / 2 + fmin(0, klartext_of(call->interp)->wider)) : 0;
}

/* "RECTANGULAR POCKET (Cycle 251)": Q218 by Q219, turned by Q224 about where the tool stands. */
static bool rectangular_pocket(const struct klartext_call_of *call, struct region *region)
{
	static const double places[5][2] = {{0, 0}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
	const double turn = klartext_parameter_or(call, 224, 0), radius = tool_radius(call);
	double length, width, way[2];

	if (!klartext_parameter_length(call, 218, &length) || !klartext_parameter_length(call, 219, &width) ||
	    !find_place(call, places, way))
		return false;
	shift_centre(region, way[0] * length / 2, way[1] * width / 2, turn);
	turn_box(region, fmax(0, length / 2 - radius), fmax(0, width / 2 - radius), turn);
	return true;
}

/* "SLOT MILLING (Cycle 253)": Q218 long and Q219 wide, turned by Q374. */
static bool slot(const struct klartext_call_of *call, struct region *region)
{
	const double turn = klartext_parameter_or(call, 374, 0), radius = tool_radius(call);
	double length, width, way[2];

	if (!klartext_parameter_length(call, 218, &length) || !klartext_parameter_length(call, 219, &width))
		return false;
	/* Its left end, the centre of its left circle, that of its right circle, its right end. */
	const double places[5][2] = {
	    {0, 0}, {length / 2, 0}, {(length - width) / 2, 0}, {(width - length) / 2, 0}, {-length / 2, 0}};

	if (!find_place(call, places, way))
		return false;
	shift_centre(region, way[0], way[1], turn);
	turn_box(region, fmax(0, length / 2 - radius), fmax(0, width / 2 - radius), turn);
	return true;
}

static void disc(struct region *region, double diameter, double radius)
{
	region->half[0] = region->half[1] = fmax(0, diameter / 2 - radius);
}

/* "CIRCULAR POCKET (Cycle 252)": Q223; "BORE MILLING (Cycle 208)": Q335, with the tool where it is called. */
static bool circular_pocket(const struct klartext_call_of *call, struct region *region)
{
	double diameter;

	if (!klartext_parameter_length(call, call->cycle->number == 208 ? 335 : 223, &diameter))
		return false;
	disc(region, diameter, tool_radius(call));
	return true;
}

/* "CIRCULAR SLOT (Cycle 254)": Q219 wide, on a pitch circle Q375 about Q216, Q217. */
static bool circular_slot(const struct klartext_call_of *call, struct region *region)
{
	double diameter, width, x, y;

	if (!klartext_parameter_length(call, 375, &diameter) || !klartext_parameter_length(call, 219, &width) ||
	    !klartext_parameter_length(call, 216, &x) || !klartext_parameter_length(call, 217, &y))
		return false;
	if (!same_double(klartext_parameter_or(call, 367, 0), 0))
		return fault(&call->interp->at, call->column,
			     "CYCL DEF 254 with Q367 other than 0 is not supported yet");
	region->centre.x = x;
	region->centre.y = y;
	disc(region, diameter + width, tool_radius(call));
	return true;
}

/* "THREAD MILLING (Cycle 262)": Q335 and the pitch Q239, by which it may begin above or end below. */
static bool thread(const struct klartext_call_of *call, struct region *region)
{
	double diameter, pitch;

	if (!klartext_parameter_length(call, 335, &diameter) || !klartext_parameter_length(call, 239, &pitch))
		return false;
	disc(region, diameter, tool_radius(call));
	region->beyond = fabs(pitch);
	return true;
}

static const struct {
	int number, feed;
	bool (*find)(const struct klartext_call_of *call, struct region *region);
} cycles[] = {{208, 206, circular_pocket}, {251, 207, rectangular_pocket},
	      {252, 207, circular_pocket}, {253, 207, slot},
	      {254, 207, circular_slot},   {262, 207, thread}};

bool klartext_region_is(int number)
{
	for (size_t i = 0; i < sizeof(cycles) / sizeof(cycles[0]); i++) {
		if (cycles[i].number == number)
			return true;
	}
	return false;
}

/* -------------------------------------------------------------------- moves */

static bool find_heights(const struct klartext_call_of *call, struct region *region)
{
	struct klartext_heights heights;

	if (!klartext_parameter_heights(call, &heights))
		return false;
	region->nothing = heights.nothing;
	region->top = heights.start;
	region->bottom = heights.bottom;
	region->clear = heights.clear;
	return true;
}

/* To a point, anywhere in the region about the way there. A feed of 0 is a rapid. */
static bool go(const struct klartext_call_of *call, const struct region *region, vec3 point, double feed)
{
	struct interp *interp = call->interp;
	const vec3 position = klartext_frame_position(interp, point);
	const vec3 spread =
	    klartext_frame_box(interp, (const double[3]){region->half[0], region->half[1], region->beyond});
	struct canon_move move = {.kind = feed > 0 ? CANON_FEED : CANON_RAPID, .feed.linear = feed};
	slot_values target = interp->state.position;

	move.spread[SLOT_X] = spread.x;
	move.spread[SLOT_Y] = spread.y;
	move.spread[SLOT_Z] = spread.z;
	target.v[SLOT_X] = position.x;
	target.v[SLOT_Y] = position.y;
	target.v[SLOT_Z] = position.z;
	return motion_commands_go(interp, &target, &move);
}

/* Over the region the tool may stand anywhere, until X and Y are commanded. */
static void leave_open(const struct klartext_call_of *call, const struct region *region)
{
	const vec3 box = klartext_frame_box(call->interp, (const double[3]){region->half[0], region->half[1], 0});
	double *loose = call->interp->comp.loose;

	loose[SLOT_X] += box.x;
	loose[SLOT_Y] += box.y;
	loose[SLOT_Z] += box.z;
}

static bool carry_out(const struct klartext_call_of *call, const struct region *region)
{
	vec3 at = klartext_frame_point(call->interp);
	struct region column = *region;

	/* Down before it goes across, or across before it goes down: anywhere over the region and the way to it. */
	column.half[0] += fabs(at.x - region->centre.x);
	column.half[1] += fabs(at.y - region->centre.y);
	at.z = region->top;
	if (!go(call, &column, at, 0))
		return false;
	at.x = region->centre.x;
	at.y = region->centre.y;
	if (!go(call, region, at, region->feed))
		return false;
	at.z = region->bottom;
	if (!go(call, region, at, region->feed))
		return false;
	at.z = region->top;
	if (!go(call, region, at, region->feed))
		return false;
	at.z = region->clear;
	if (!go(call, region, at, 0))
		return false;
	leave_open(call, region);
	return true;
}

bool klartext_region_make(const struct klartext_call_of *call)
{
	struct region region = {.centre = klartext_frame_point(call->interp)};

	if (klartext_frame_is_scaled(call->interp))
		return fault(&call->interp->at, call->column,
			     "CYCL DEF %d while a scaling is in force: how large what it mills is then is not known "
			     "here; cancel the scaling first",
			     call->cycle->number);
	for (size_t i = 0; i < sizeof(cycles) / sizeof(cycles[0]); i++) {
		if (cycles[i].number != call->cycle->number)
			continue;
		if (!find_heights(call, &region) || !klartext_parameter_feed(call, cycles[i].feed, &region.feed) ||
		    !cycles[i].find(call, &region))
			return false;
		if (!(region.feed > 0))
			return fault(&call->interp->at, call->column, "a cycle without a feed rate");
		/* A finishing allowance that is negative lets the tool go farther. */
		region.half[0] += fmax(0, -klartext_parameter_length_or(call, 368, 0));
		region.half[1] += fmax(0, -klartext_parameter_length_or(call, 368, 0));
		return region.nothing || carry_out(call, &region);
	}
	return true;
}
