#include "gcode/dialect/klartext/cycles/klartext_pattern.h"

#include <math.h>
#include <string.h>

#include "base/same_double.h"
#include "gcode/dialect/klartext/cycles/klartext_cycle.h"
#include "gcode/dialect/klartext/cycles/klartext_parameter.h"
#include "gcode/dialect/klartext/cycles/klartext_points.h"
#include "gcode/dialect/klartext/cycles/klartext_region.h"
#include "gcode/dialect/klartext/frames/klartext_frame.h"
#include "gcode/dialect/klartext/moves/klartext_comp.h"
#include "gcode/dialect/klartext/moves/klartext_move.h"
#include "gcode/dialect/klartext/words/klartext_global.h"

/* How the cycle is carried out at every point. */
struct visit {
	struct interp *interp;
	int column;
	double height; /* of the moves between points, programmed Z in mm */
	bool low; /* between points the tool stays at the height where the cycle has left it */
	bool rapid;
	struct canon_feed feed; /* if not rapid */
};

static bool go_to(const struct visit *visit, vec3 point)
{
	const struct klartext_target target = {.point = point, .others = visit->interp->state.position};

	return klartext_move_line(visit->interp, &target, visit->rapid, &visit->feed);
}

static bool go_up(const struct visit *visit)
{
	vec3 at = klartext_frame_point(visit->interp);

	at.z = visit->height;
	return go_to(visit, at);
}

/* Moves to a height, or at this height, anywhere in a rectangle with these half sides about the tool. */
static bool go_within(const struct visit *visit, double half_x, double half_y, double height)
{
	struct interp *interp = visit->interp;
	const struct canon_move move = {.kind = visit->rapid ? CANON_RAPID : CANON_FEED, .feed = visit->feed};
	const struct parallel_box box = klartext_frame_turned_box(interp, (const double[3]){half_x, half_y, 0});
	vec3 point = klartext_frame_point(interp), at;
	slot_values target = interp->state.position;

	point.z = height;
	at = klartext_frame_position(interp, point);
	slot_values_set_linear(&target, at);
	return parallel_moves_go(interp, &target, &move, &box);
}

/*
 * Covers the moves between the points in any order: the rectangle about the points and the tool, at the height between
 * them. After the last point the tool is above any of them at the height `end`, and as far aside as the cycle leaves
 * it.
 */
static bool cover_rectangle(const struct visit *visit, bool ends, double end)
{
	struct interp *interp = visit->interp;
	const struct klartext_points *points = &klartext_of(interp)->points;
	vec3 low = klartext_frame_point(interp), high = low;
	double half_x, half_y, aside[2];

	if (klartext_frame_is_scaled(interp))
		return fault(&interp->at, visit->column,
			     "FRAME while a scaling is in force is not supported: cancel the scaling first");
	for (int i = 0; i < points->count; i++) {
		low = vec3_min(low, points->items[i]);
		high = vec3_max(high, points->items[i]);
	}
	klartext_region_find_aside(interp, aside);
	if (!go_to(visit, (vec3){(low.x + high.x) / 2, (low.y + high.y) / 2, visit->height}))
		return false;
	memset(interp->comp.loose, 0, sizeof(interp->comp.loose));
	half_x = (high.x - low.x) / 2 + aside[0];
	half_y = (high.y - low.y) / 2 + aside[1];
	if (!go_within(visit, half_x, half_y, ends ? end : visit->height))
		return false;
	if (ends)
		klartext_region_leave_open(interp, half_x, half_y);
	return true;
}

static bool call_at_points(const struct visit *visit)
{
	struct interp *interp = visit->interp;
	struct klartext *klartext = klartext_of(interp);
	const struct klartext_cycle defined = klartext->cycles.active;
	const struct klartext_call_of call = {.interp = interp, .cycle = &defined, .column = visit->column};
	double surface = 0;
	bool good = true;

	if (klartext_global_is(klartext, 345, 1))
		return fault(&interp->at, visit->column,
			     "a pattern after GLOBAL DEF 125 with Q345=1: to which position the tool retracts is not "
			     "certain; Q345=0 is the second set-up clearance");
	if (defined.number == 0 || !defined.by_q || !klartext_parameter_find(&call, 203, &surface))
		return fault(&interp->at, visit->column,
			     "a pattern needs a cycle with Q203 that has been defined before it");
	if (klartext->points.surface && !same_double(surface, 0))
		return fault(&interp->at, visit->column,
			     "the points of the table have a surface in Z, and the cycle has another one in Q203: the "
			     "manual wants Q203=0");
	if (klartext->points.any_order && (!go_up(visit) || !cover_rectangle(visit, false, 0)))
		return false;
	for (int i = 0; i < klartext->points.count && good; i++) {
		const vec3 point = klartext->points.items[i];
		vec3 at = klartext_frame_point(interp);

		at.z = i > 0 && visit->low ? at.z : visit->height;
		good = go_to(visit, at);
		at.x = point.x;
		at.y = point.y;
		good = good && go_to(visit, at);
		memset(interp->comp.loose, 0, sizeof(interp->comp.loose));
		klartext_cycle_set(&klartext->cycles.active, "Q203", surface + point.z / interp->state.scale);
		good = good && klartext_cycle_carry_out(interp, visit->column);
	}
	klartext->cycles.active = defined;
	if (good && klartext->points.any_order) {
		const double end = klartext_frame_point(interp).z;

		good = go_up(visit) && cover_rectangle(visit, true, end);
	}
	return good;
}

/*
 * TNC 640 user's manual, "CYCL CALL PAT": between the points the tool is at the clearance height. This is the higher
 * one of its present Z and the second set-up clearance. F is the feed rate between the points.
 */
bool klartext_pattern_call(struct interp *interp, int column, const struct canon_feed *feed)
{
	struct klartext *klartext = klartext_of(interp);
	const struct klartext_call_of call = {.interp = interp, .cycle = &klartext->cycles.active, .column = column};
	struct visit visit = {
	    .interp = interp, .column = column, .height = klartext_frame_point(interp).z, .rapid = !feed};
	double highest = 0, surface, second;

	if (feed)
		visit.feed = *feed;
	if (klartext->points.count == 0)
		return fault(&interp->at, column,
			     "CYCL CALL PAT, but neither PATTERN DEF nor SEL PATTERN has given points");
	/* Moves between the points are not below the present height of the tool. */
	if (!klartext_cycle_check_values(interp, column, true) ||
	    (klartext->open.height && !klartext_comp_check_known(interp, column, "CYCL CALL PAT")))
		return false;
	if (klartext->cycles.active.number && klartext->cycles.active.by_q) {
		if (!klartext_parameter_length(&call, 203, &surface) || !klartext_parameter_length(&call, 204, &second))
			return false;
		for (int i = 0; i < klartext->points.count; i++)
			highest = fmax(highest, klartext->points.items[i].z);
		visit.height = fmax(visit.height, surface + highest + second);
	}
	return call_at_points(&visit);
}

/*
 * "POLAR PATTERN (Cycle 220)", "CARTESIAN PATTERN (Cycle 221)": their Q200, Q203 and Q204 replace those of the cycle.
 * Between the points the tool is at the set-up clearance, or with Q301=1 at the second one.
 */
static bool call_with(struct interp *interp, const struct klartext_call_of *pattern)
{
	struct klartext_cycles *cycles = &klartext_of(interp)->cycles;
	const struct klartext_cycle defined = cycles->active;
	struct visit visit = {.interp = interp, .column = pattern->column, .rapid = true};
	double clearance, surface, second;
	bool high, good;

	if (!klartext_parameter_need(pattern, 200, &clearance) || !klartext_parameter_need(pattern, 203, &surface) ||
	    !klartext_parameter_need(pattern, 204, &second))
		return false;
	if (!klartext_cycle_check_values(interp, pattern->column, false))
		return false;
	high = !same_double(klartext_parameter_or(pattern, 301, 1), 0);
	klartext_cycle_set(&cycles->active, "Q200", clearance);
	klartext_cycle_set(&cycles->active, "Q203", surface);
	klartext_cycle_set(&cycles->active, "Q204", high ? second : clearance);
	visit.height = (surface + second) * interp->state.scale;
	visit.low = !high;
	good = call_at_points(&visit);
	cycles->active = defined;
	return good;
}

static bool whole(const struct klartext_call_of *call, int q, int *value)
{
	double number;

	if (!klartext_parameter_need(call, q, &number))
		return false;
	if (!(number >= 1 && number <= KLARTEXT_POINTS_MAX) || !same_double(floor(number), number))
		return fault(&call->interp->at, call->column, "Q%d is a whole number from 1 to %d", q,
			     KLARTEXT_POINTS_MAX);
	*value = (int)number;
	return true;
}

bool klartext_pattern_circle(struct interp *interp, const struct klartext_cycle *cycle)
{
	const struct klartext_call_of call = {.interp = interp, .cycle = cycle, .column = cycle->column};
	double diameter, start, end, step;
	vec3 centre = {0, 0, 0};
	int count;

	if (!klartext_parameter_length(&call, 216, &centre.x) || !klartext_parameter_length(&call, 217, &centre.y) ||
	    !klartext_parameter_length(&call, 244, &diameter) || !klartext_parameter_need(&call, 245, &start) ||
	    !klartext_parameter_need(&call, 246, &end) || !klartext_parameter_need(&call, 247, &step) ||
	    !whole(&call, 241, &count))
		return false;
	if (same_double(klartext_parameter_or(&call, 365, 0), 1))
		return fault(&interp->at, cycle->column,
			     "CYCL DEF 220 with Q365=1, on circles from point to point, is not "
			     "supported");
	/* A step of 0 spreads the points over the angle; on a whole circle the last point is not the first one. */
	if (same_double(step, 0))
		step = (end - start) / (same_double(fabs(end - start), 360) ? count : fmax(1, count - 1));
	klartext_points_begin(interp);
	return klartext_points_add_circle(interp, cycle->column, centre, diameter, start, step, count) &&
	       call_with(interp, &call);
}

bool klartext_pattern_lines(struct interp *interp, const struct klartext_cycle *cycle)
{
	const struct klartext_call_of call = {.interp = interp, .cycle = cycle, .column = cycle->column};
	vec3 start = {0, 0, 0};
	double spacing[2], angle;
	int count[2];

	if (!klartext_parameter_length(&call, 225, &start.x) || !klartext_parameter_length(&call, 226, &start.y) ||
	    !klartext_parameter_length(&call, 237, &spacing[0]) ||
	    !klartext_parameter_length(&call, 238, &spacing[1]) || !whole(&call, 242, &count[0]) ||
	    !whole(&call, 243, &count[1]) || !klartext_parameter_need(&call, 224, &angle))
		return false;
	const struct klartext_grid grid = {.start = start,
				  .spacing = {spacing[0], spacing[1]},
				  .angle = {angle, angle + 90},
				  .count = {count[0], count[1]},
				  .zigzag = true};

	klartext_points_begin(interp);
	return klartext_points_add_grid(interp, cycle->column, &grid) && call_with(interp, &call);
}
