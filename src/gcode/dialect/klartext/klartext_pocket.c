#include "gcode/dialect/klartext/klartext_pocket.h"

#include <math.h>
#include <string.h>

#include "base/math/math_functions.h"
#include "base/same_double.h"
#include "gcode/dialect/klartext/klartext_frame.h"
#include "gcode/dialect/klartext/klartext_region.h"

/* mm: "starting position 2 mm to the right of the unmachined stud" (TNC 640, "RECTANGULAR STUD (Cycle 256)"). */
#define STUD_SIDE 2.0

/* ------------------------------------------------------------------ pockets */

/* The length of a parameter that is a size: the region of a negative one would shrink to its centre. */
static bool find_size(const struct klartext_call_of *call, int q, double *value)
{
	double length;

	if (!klartext_parameter_length(call, q, &length))
		return false;
	if (length < 0)
		return fault(&call->interp->at, call->column, "Q%d of CYCL DEF %d is a size and cannot be negative", q,
			     call->cycle->number);
	*value = length;
	return true;
}

/* A box of these half sides, turned by an angle: the box about it along X and Y. */
static void turn_box(struct klartext_region *region, double along, double across, double degrees)
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

static void shift_centre(struct klartext_region *region, double x, double y, double degrees)
{
	region->centre.x += math_cos_degrees(degrees) * x - math_sin_degrees(degrees) * y;
	region->centre.y += math_sin_degrees(degrees) * x + math_cos_degrees(degrees) * y;
}

/* The tool's radius, as far as it is known: the region is the greater without. */
static double tool_radius(const struct klartext_call_of *call)
{
	const struct tool *tool = tool_table_find(&call->interp->tools, call->interp->state.tool);

	return tool ? fmax(0, tool->diameter / 2 + fmin(0, klartext_of(call->interp)->delta_radius)) : 0;
}

/* "RECTANGULAR POCKET (Cycle 251)": Q218 by Q219, turned by Q224 about where the tool stands. */
static bool rectangular_pocket(const struct klartext_call_of *call, struct klartext_region *region)
{
	static const double places[5][2] = {{0, 0}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
	const double turn = klartext_parameter_or(call, 224, 0), radius = tool_radius(call);
	double length, width, way[2];

	if (!find_size(call, 218, &length) || !find_size(call, 219, &width) ||
	    !find_place(call, places, way))
		return false;
	shift_centre(region, way[0] * length / 2, way[1] * width / 2, turn);
	turn_box(region, fmax(0, length / 2 - radius), fmax(0, width / 2 - radius), turn);
	return true;
}

/* "SLOT MILLING (Cycle 253)": Q218 long and Q219 wide, turned by Q374. */
static bool slot(const struct klartext_call_of *call, struct klartext_region *region)
{
	const double turn = klartext_parameter_or(call, 374, 0), radius = tool_radius(call);
	double length, width, way[2];

	if (!find_size(call, 218, &length) || !find_size(call, 219, &width))
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

static void disc(struct klartext_region *region, double diameter, double radius)
{
	region->half[0] = region->half[1] = fmax(0, diameter / 2 - radius);
}

/* "CIRCULAR POCKET (Cycle 252)": Q223; "BORE MILLING (Cycle 208)": Q335, with the tool where it is called. */
static bool circular_pocket(const struct klartext_call_of *call, struct klartext_region *region)
{
	double diameter;

	if (!find_size(call, call->cycle->number == 208 ? 335 : 223, &diameter))
		return false;
	disc(region, diameter, tool_radius(call));
	return true;
}

/* "CIRCULAR SLOT (Cycle 254)": Q219 wide, on a pitch circle Q375 about Q216, Q217. */
static bool circular_slot(const struct klartext_call_of *call, struct klartext_region *region)
{
	double diameter, width, x, y;

	if (!find_size(call, 375, &diameter) || !find_size(call, 219, &width) ||
	    !klartext_parameter_length(call, 216, &x) || !klartext_parameter_length(call, 217, &y))
		return false;
	if (!same_double(klartext_parameter_or(call, 367, 0), 0))
		return fault(&call->interp->at, call->column,
			     "CYCL DEF 254 with Q367 other than 0 is not supported yet");
	region->centre.x = x;
	region->centre.y = y;
	region->fixed = true;
	disc(region, diameter + width, tool_radius(call));
	return true;
}

/* "THREAD MILLING (Cycle 262)": Q335 and the pitch Q239, by which it may begin above or end below. */
static bool thread(const struct klartext_call_of *call, struct klartext_region *region)
{
	double diameter, pitch;

	if (!find_size(call, 335, &diameter) || !klartext_parameter_length(call, 239, &pitch))
		return false;
	disc(region, diameter, tool_radius(call));
	region->beyond = fabs(pitch);
	return true;
}

/*
 * "THREAD MILLING/COUNTERSINKING (Cycle 263)", "THREAD DRILLING/MILLING (264)", "HELICAL THREAD DRILLING (265)": Q356
 * is the depth of the bore, Q358 and Q359 the depth and the offset of the countersink at the front.
 */
static bool deep_thread(const struct klartext_call_of *call, struct klartext_region *region)
{
	const double aside = fabs(klartext_parameter_length_or(call, 359, 0));
	const double surface = klartext_parameter_length_or(call, 203, 0);

	if (!thread(call, region))
		return false;
	region->half[0] = region->half[1] = fmax(region->half[0], aside);
	region->bottom = fmin(region->bottom, surface + klartext_parameter_length_or(call, 356, 0));
	region->bottom = fmin(region->bottom, surface + klartext_parameter_length_or(call, 358, 0));
	return true;
}

/*
 * "BACK BORING (Cycle 204)": through the bore, Q251 beside its centre, until the edge stands Q200 below the workpiece
 * of thickness Q250; the underside of the tool is Q252 lower. A depth Q249 of 0 does nothing.
 */
static bool back_bore(const struct klartext_call_of *call, struct klartext_region *region)
{
	double depth, thickness, aside, edge, clearance, surface, second;

	if (!klartext_parameter_length(call, 249, &depth))
		return false;
	region->nothing = same_double(depth, 0);
	if (region->nothing)
		return true;
	if (!klartext_parameter_length(call, 250, &thickness) || !klartext_parameter_length(call, 251, &aside) ||
	    !klartext_parameter_length(call, 252, &edge) || !klartext_parameter_length(call, 200, &clearance) ||
	    !klartext_parameter_length(call, 203, &surface) || !klartext_parameter_length(call, 204, &second))
		return false;
	if (clearance < 0 || second < 0)
		return fault(&call->interp->at, call->column, "a set-up clearance (Q200, Q204) cannot be negative");
	region->top = surface + clearance;
	region->clear = surface + fmax(second, clearance);
	region->bottom = surface - fabs(thickness) - fabs(edge) - clearance;
	region->half[0] = region->half[1] = fabs(aside);
	return true;
}

/* ------------------------------------------------------------ studs, faces */

/* About a stud the tool needs its diameter to be known: it stays outside. */
static bool need_radius(const struct klartext_call_of *call, double *radius)
{
	const struct tool *tool = tool_table_find(&call->interp->tools, call->interp->state.tool);

	if (!tool || !(tool->diameter > 0))
		return fault(&call->interp->at, call->column,
			     "CYCL DEF %d needs the radius of the tool: give the tool of the setup a <cutter>, or "
			     "diameter=\"\"",
			     call->cycle->number);
	*radius = tool->diameter / 2 + fmax(0, klartext_of(call->interp)->delta_radius);
	return true;
}

/*
 * The tool comes to the blank from outside on a semicircle, for which the manual wants room of its diameter and 2 mm;
 * on some controls from the set-up clearance beside the blank.
 */
static double beside_stud(const struct klartext_call_of *call, double radius)
{
	return 3 * radius + fmax(STUD_SIDE, klartext_parameter_length_or(call, 200, 0));
}

/* "RECTANGULAR STUD (Cycle 256)": Q218 by Q219, of a blank Q424 by Q425. */
static bool rectangular_stud(const struct klartext_call_of *call, struct klartext_region *region)
{
	static const double places[5][2] = {{0, 0}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
	const double turn = klartext_parameter_or(call, 224, 0);
	double length, width, blank[2], radius, way[2], most;

	if (!find_size(call, 218, &length) || !find_size(call, 219, &width) ||
	    !find_size(call, 424, &blank[0]) || !find_size(call, 425, &blank[1]) ||
	    !need_radius(call, &radius) || !find_place(call, places, way))
		return false;
	shift_centre(region, way[0] * length / 2, way[1] * width / 2, turn);
	most = fmax(fmax(length, width), fmax(blank[0], blank[1])) / 2 + beside_stud(call, radius);
	turn_box(region, most, most, turn);
	return true;
}

/* "CIRCULAR STUD (Cycle 257)": Q223, of a blank Q222. */
static bool circular_stud(const struct klartext_call_of *call, struct klartext_region *region)
{
	double diameter, blank, radius;

	if (!find_size(call, 223, &diameter) || !find_size(call, 222, &blank) ||
	    !need_radius(call, &radius))
		return false;
	region->half[0] = region->half[1] = fmax(diameter, blank) / 2 + beside_stud(call, radius);
	return true;
}

/*
 * "POLYGON STUD (Cycle 258)": Q572 corners, on a circle of Q571, or with Q573=0 about it; of a blank Q222.
 */
static bool polygon_stud(const struct klartext_call_of *call, struct klartext_region *region)
{
	const double about = klartext_parameter_or(call, 573, 0);
	double diameter, blank, corners, radius;

	if (!find_size(call, 571, &diameter) || !find_size(call, 222, &blank) ||
	    !klartext_parameter_need(call, 572, &corners) || !need_radius(call, &radius))
		return false;
	if (!(corners >= 3 && corners <= 30) || !same_double(floor(corners), corners))
		return fault(&call->interp->at, call->column, "Q572 of CYCL DEF 258 is a whole number from 3 to 30");
	if (same_double(about, 0))
		diameter /= math_cos_degrees(180 / corners);
	else if (!same_double(about, 1))
		return fault(&call->interp->at, call->column, "Q573 of CYCL DEF 258 is 0 or 1");
	region->half[0] = region->half[1] = fmax(diameter, blank) / 2 + beside_stud(call, radius);
	return true;
}

/* "OUTSIDE THREAD MILLING (Cycle 267)": Q335 and the pitch Q239; Q358 and Q359 countersink at the front. */
static bool outside_thread(const struct klartext_call_of *call, struct klartext_region *region)
{
	double diameter, pitch, radius;

	if (!find_size(call, 335, &diameter) || !klartext_parameter_length(call, 239, &pitch) ||
	    !need_radius(call, &radius))
		return false;
	region->half[0] = region->half[1] = diameter / 2 + beside_stud(call, radius) + fabs(pitch) +
					    fabs(klartext_parameter_length_or(call, 359, 0));
	region->beyond = fabs(pitch);
	region->bottom = fmin(region->bottom, klartext_parameter_length_or(call, 203, 0) +
						  klartext_parameter_length_or(call, 358, 0));
	return true;
}

/*
 * "MULTIPASS MILLING (Cycle 230)" from Q227 down on the surface itself, "FACE MILLING (Cycle 232)" and (233) from Q227
 * down to Q386: a rectangle Q218 by Q219 from Q225, Q226 on, and beside it the tool with its clearance Q357.
 */
static bool face(const struct klartext_call_of *call, struct klartext_region *region)
{
	const bool one_level = call->cycle->number == 230;
	double start[3], side[2], end, clearance, radius;

	if (!klartext_parameter_length(call, 225, &start[0]) || !klartext_parameter_length(call, 226, &start[1]) ||
	    !klartext_parameter_length(call, 227, &start[2]) || !klartext_parameter_length(call, 218, &side[0]) ||
	    !klartext_parameter_length(call, 219, &side[1]) || !klartext_parameter_length(call, 200, &clearance) ||
	    !need_radius(call, &radius))
		return false;
	end = start[2];
	if (!one_level && !klartext_parameter_length(call, 386, &end))
		return false;
	if (clearance < 0)
		return fault(&call->interp->at, call->column, "a set-up clearance (Q200, Q204) cannot be negative");
	region->fixed = true;
	region->centre.x = start[0] + side[0] / 2;
	region->centre.y = start[1] + side[1] / 2;
	for (int i = 0; i < 2; i++)
		region->half[i] =
		    fabs(side[i]) / 2 + 2 * radius + fmax(clearance, klartext_parameter_length_or(call, 357, 0));
	region->top = fmax(start[2], end) + clearance;
	region->bottom = fmin(start[2], end);
	region->clear = fmax(region->top, fmax(start[2], end) + klartext_parameter_length_or(call, 204, 0));
	return true;
}

/* ------------------------------------------------------------------- cycles */

/* `levels`: Q200, Q201, Q203 and Q204 are its heights. */
static const struct {
	int number, feed;
	bool levels;
	bool (*find)(const struct klartext_call_of *call, struct klartext_region *region);
} cycles[] = {
    {204, 253, false, back_bore},      {208, 206, true, circular_pocket},
    {230, 207, false, face},	       {232, 207, false, face},
    {233, 207, false, face},	       {251, 207, true, rectangular_pocket},
    {252, 207, true, circular_pocket}, {253, 207, true, slot},
    {254, 207, true, circular_slot},   {256, 207, true, rectangular_stud},
    {257, 207, true, circular_stud},   {258, 207, true, polygon_stud},
    {262, 207, true, thread},	       {263, 207, true, deep_thread},
    {264, 207, true, deep_thread},     {265, 207, true, deep_thread},
    {267, 207, true, outside_thread},
};

bool klartext_pocket_is(int number)
{
	for (size_t i = 0; i < sizeof(cycles) / sizeof(cycles[0]); i++) {
		if (cycles[i].number == number)
			return true;
	}
	return false;
}

static bool find_levels(const struct klartext_call_of *call, struct klartext_region *region)
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

static bool check_scaling(const struct klartext_call_of *call)
{
	return !klartext_frame_is_scaled(call->interp) ||
	       fault(
		   &call->interp->at, call->column,
		   "CYCL DEF %d while a scaling is in force: the size of what it mills is then not known here; cancel "
		   "the scaling first",
		   call->cycle->number);
}

static bool carry_out(const struct klartext_call_of *call, struct klartext_region *region)
{
	/* A finishing allowance that is negative lets the tool go farther. */
	const double more = fmax(0, -klartext_parameter_length_or(call, 368, 0));

	if (region->nothing)
		return true;
	if (!(region->feed > 0))
		return fault(&call->interp->at, call->column, "a cycle without a feed rate");
	region->half[0] += more;
	region->half[1] += more;
	region->bottom -= fmax(0, -klartext_parameter_length_or(call, 369, 0));
	return klartext_region_carry_out(call, region);
}

bool klartext_pocket_make(const struct klartext_call_of *call)
{
	struct klartext_region region = {.centre = klartext_frame_point(call->interp)};

	if (!check_scaling(call))
		return false;
	for (size_t i = 0; i < sizeof(cycles) / sizeof(cycles[0]); i++) {
		if (cycles[i].number == call->cycle->number)
			return (!cycles[i].levels || find_levels(call, &region)) && cycles[i].find(call, &region) &&
			       (region.nothing || klartext_parameter_feed(call, cycles[i].feed, &region.feed)) &&
			       carry_out(call, &region);
	}
	return true;
}

/* ------------------------------------------------------------- older cycles */

/* X and Y of lines 4 and 5, of which `share` counts to each side. */
static bool find_sides(const struct klartext_call_of *call, struct klartext_region *region, double share, double radius)
{
	bool found[2] = {false, false};

	for (int i = 0; i < call->cycle->count; i++) {
		const struct klartext_cycle_word *word = &call->cycle->words[i];
		const int axis = word->name[0] == 'X' ? 0 : 1;

		if (!word->given || (strcmp(word->name, "X") != 0 && strcmp(word->name, "Y") != 0))
			continue;
		region->half[axis] = fmax(0, fabs(word->value) * call->interp->state.scale * share - radius);
		found[axis] = true;
	}
	return (found[0] && found[1]) ||
	       fault(&call->interp->at, call->column, "CYCL DEF %d needs its sides in X and Y", call->cycle->number);
}

/*
 * TNC 407 user's manual: "SLOT MILLING (Cycle 3)" from one end of a slot X by Y, in the direction of their signs;
 * "POCKET MILLING (Cycle 4)" X by Y, "CIRCULAR POCKET (Cycle 5)" of a radius, both about where the tool stands. Lines 1
 * and 2 are set-up clearance and depth, the last one has F.
 */
bool klartext_pocket_make_old(const struct klartext_call_of *call)
{
	const double scale = call->interp->state.scale, radius = tool_radius(call);
	const double set_up = fabs(klartext_parameter_part(call, 1)) * scale,
		     depth = klartext_parameter_part(call, 2) * scale;
	const int number = call->cycle->number;
	struct klartext_region region = {.centre = klartext_frame_point(call->interp)};

	if (!check_scaling(call))
		return false;
	if (depth > 0)
		return fault(&call->interp->at, call->column, "the depth of CYCL DEF %d is above the surface", number);
	region.top = region.clear = region.centre.z;
	region.bottom = region.top - set_up + depth;
	region.nothing = same_double(depth, 0);
	region.feed = klartext_parameter_per_second(call, klartext_parameter_part(call, number == 5 ? 5 : 6));
	if (number == 5)
		disc(&region, 2 * fabs(klartext_parameter_part(call, 4)) * scale, radius);
	else if (!find_sides(call, &region, number == 3 ? 1 : 0.5, number == 3 ? 0 : radius))
		return false;
	return carry_out(call, &region);
}
