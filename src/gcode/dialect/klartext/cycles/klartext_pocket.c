#include "gcode/dialect/klartext/cycles/klartext_pocket.h"

#include <math.h>
#include <string.h>

#include "base/math/math_functions.h"
#include "base/same_double.h"
#include "gcode/dialect/klartext/cycles/klartext_face.h"
#include "gcode/dialect/klartext/cycles/klartext_region.h"
#include "gcode/dialect/klartext/cycles/klartext_shape.h"
#include "gcode/dialect/klartext/cycles/klartext_stud.h"
#include "gcode/dialect/klartext/frames/klartext_frame.h"

/* "RECTANGULAR POCKET (Cycle 251)": Q218 by Q219, turned by Q224 about the position of the tool. */
static bool rectangular_pocket(const struct klartext_call_of *call, struct klartext_region *region)
{
	static const double places[5][2] = {{0, 0}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
	const double turn = klartext_parameter_or(call, 224, 0), radius = klartext_shape_tool_radius(call);
	double length, width, way[2];

	if (!klartext_shape_size(call, 218, &length) || !klartext_shape_size(call, 219, &width) ||
	    !klartext_shape_place(call, places, way))
		return false;
	klartext_shape_shift(region, way[0] * length / 2, way[1] * width / 2, turn);
	klartext_shape_turn(region, fmax(0, length / 2 - radius), fmax(0, width / 2 - radius), turn);
	return true;
}

/* "SLOT MILLING (Cycle 253)": Q218 long and Q219 wide, turned by Q374. */
static bool slot(const struct klartext_call_of *call, struct klartext_region *region)
{
	const double turn = klartext_parameter_or(call, 374, 0), radius = klartext_shape_tool_radius(call);
	double length, width, way[2];

	if (!klartext_shape_size(call, 218, &length) || !klartext_shape_size(call, 219, &width))
		return false;
	/*
	 * The shift of the slot for Q367 = 0 to 4. The tool stands at the centre, at the left end, at the centre of the
	 * left circle, at the centre of the right circle, or at the right end.
	 */
	const double places[5][2] = {
	    {0, 0}, {length / 2, 0}, {(length - width) / 2, 0}, {(width - length) / 2, 0}, {-length / 2, 0}};

	if (!klartext_shape_place(call, places, way))
		return false;
	klartext_shape_shift(region, way[0], way[1], turn);
	klartext_shape_turn(region, fmax(0, length / 2 - radius), fmax(0, width / 2 - radius), turn);
	return true;
}

/*
 * "CIRCULAR POCKET (Cycle 252)": diameter Q223. "BORE MILLING (Cycle 208)": diameter Q335. The tool stands at the
 * centre when the cycle is called.
 */
static bool circular_pocket(const struct klartext_call_of *call, struct klartext_region *region)
{
	double diameter;

	if (!klartext_shape_size(call, call->cycle->number == 208 ? 335 : 223, &diameter))
		return false;
	klartext_shape_disc(region, diameter, klartext_shape_tool_radius(call));
	return true;
}

/* "CIRCULAR SLOT (Cycle 254)": Q219 wide, on a pitch circle Q375 about Q216, Q217. */
static bool circular_slot(const struct klartext_call_of *call, struct klartext_region *region)
{
	double diameter, width;

	if (!klartext_shape_size(call, 375, &diameter) || !klartext_shape_size(call, 219, &width) ||
	    !klartext_shape_middle(call, region))
		return false;
	if (!same_double(klartext_parameter_or(call, 367, 0), 0))
		return fault(&call->interp->at, call->column,
			     "CYCL DEF 254 with Q367 other than 0 is not supported");
	klartext_shape_disc(region, diameter + width, klartext_shape_tool_radius(call));
	return true;
}

/*
 * TNC 426 user's manual: "SLOT (oblong hole) with reciprocating plunge-cut (Cycle 210)", Q218 by Q219 about Q216, Q217,
 * turned by Q224; "CIRCULAR SLOT (Cycle 211)", Q219 wide on a pitch circle Q244.
 */
static bool old_slot(const struct klartext_call_of *call, struct klartext_region *region)
{
	const double radius = klartext_shape_tool_radius(call);
	double length, width;

	if (!klartext_shape_size(call, 218, &length) || !klartext_shape_size(call, 219, &width) ||
	    !klartext_shape_middle(call, region))
		return false;
	klartext_shape_turn(region, fmax(0, length / 2 - radius), fmax(0, width / 2 - radius),
			    klartext_parameter_or(call, 224, 0));
	return true;
}

static bool old_circular_slot(const struct klartext_call_of *call, struct klartext_region *region)
{
	double diameter, width;

	if (!klartext_shape_size(call, 244, &diameter) || !klartext_shape_size(call, 219, &width) ||
	    !klartext_shape_middle(call, region))
		return false;
	klartext_shape_disc(region, diameter + width, klartext_shape_tool_radius(call));
	return true;
}

/*
 * The same manual: "POCKET FINISHING (Cycle 212)", Q218 by Q219 about Q216, Q217; "CIRCULAR POCKET FINISHING (Cycle
 * 214)", from a diameter Q222 to Q223 about the same point.
 */
static bool finished_pocket(const struct klartext_call_of *call, struct klartext_region *region)
{
	const double radius = klartext_shape_tool_radius(call);

	for (int i = 0; i < 2; i++) {
		double side;

		if (!klartext_shape_size(call, 218 + i, &side))
			return false;
		region->half[i] = fmax(0, side / 2 - radius);
	}
	return klartext_shape_middle(call, region);
}

static bool finished_circular_pocket(const struct klartext_call_of *call, struct klartext_region *region)
{
	double blank, finished;

	if (!klartext_shape_size(call, 222, &blank) || !klartext_shape_size(call, 223, &finished) ||
	    !klartext_shape_middle(call, region))
		return false;
	klartext_shape_disc(region, fmax(blank, finished), klartext_shape_tool_radius(call));
	return true;
}

/*
 * "THREAD MILLING (Cycle 262)": diameter Q335 and pitch Q239. The helix may begin one pitch above the thread or end one
 * pitch below it.
 */
static bool thread(const struct klartext_call_of *call, struct klartext_region *region)
{
	double diameter, pitch;

	if (!klartext_shape_size(call, 335, &diameter) || !klartext_parameter_length(call, 239, &pitch))
		return false;
	klartext_shape_disc(region, diameter, klartext_shape_tool_radius(call));
	region->beyond = fabs(pitch);
	return true;
}

/*
 * "THREAD MILLING/COUNTERSINKING (Cycle 263)", "THREAD DRILLING/MILLING (264)", "HELICAL THREAD DRILLING (265)": Q356
 * is the depth of the bore. Q358 and Q359 are the depth and the offset of the countersink at the front.
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
 * "BACK BORING (Cycle 204)": the tool goes through the bore, Q251 beside its centre, until the edge is Q200 below the
 * workpiece of thickness Q250. The underside of the tool is Q252 lower than the edge. With a depth Q249 of 0 the cycle
 * does nothing.
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

/* ------------------------------------------------------------------- cycles */

/* `levels`: the heights of the cycle are Q200, Q201, Q203 and Q204. */
static const struct {
	int number, feed;
	bool levels;
	bool (*find)(const struct klartext_call_of *call, struct klartext_region *region);
} cycles[] = {
    {204, 253, false, back_bore},
    {208, 206, true, circular_pocket},
    {210, 207, true, old_slot},
    {211, 207, true, old_circular_slot},
    {212, 207, true, finished_pocket},
    {213, 207, true, klartext_stud_finish},
    {214, 207, true, finished_circular_pocket},
    {215, 207, true, klartext_stud_finish},
    {230, 207, false, klartext_face_at},
    {232, 207, false, klartext_face_at},
    {233, 207, false, klartext_face_here},
    {251, 207, true, rectangular_pocket},
    {252, 207, true, circular_pocket},
    {253, 207, true, slot},
    {254, 207, true, circular_slot},
    {256, 207, true, klartext_stud_rectangle},
    {257, 207, true, klartext_stud_circle},
    {258, 207, true, klartext_stud_polygon},
    {262, 207, true, thread},
    {263, 207, true, deep_thread},
    {264, 207, true, deep_thread},
    {265, 207, true, deep_thread},
    {267, 207, true, klartext_stud_thread},
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
	/* A negative finishing allowance lets the tool go farther out. */
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

/* Reads X and Y of lines 4 and 5; the region reaches `share` of them to each side. */
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
 * TNC 407 user's manual: "SLOT MILLING (Cycle 3)" begins at one end of a slot X by Y and runs in the direction of their
 * signs. "POCKET MILLING (Cycle 4)", X by Y, and "CIRCULAR POCKET (Cycle 5)", of a radius, lie about the position of
 * the tool. Lines 1 and 2 are set-up clearance and depth; the last line has F.
 */
bool klartext_pocket_make_old(const struct klartext_call_of *call)
{
	const double scale = call->interp->state.scale, radius = klartext_shape_tool_radius(call);
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
		klartext_shape_disc(&region, 2 * fabs(klartext_parameter_part(call, 4)) * scale, radius);
	else if (!find_sides(call, &region, number == 3 ? 1 : 0.5, number == 3 ? 0 : radius))
		return false;
	return carry_out(call, &region);
}
