#include "gcode/dialect/klartext/cycles/klartext_hole.h"

#include <math.h>

#include "gcode/dialect/klartext/frames/klartext_frame.h"
#include "gcode/execute/motion_commands.h"
#include "geom/tolerance.h"

/* The tool at the hole. */
struct drill {
	struct interp *interp;
	const struct klartext_hole *hole;
	vec3 at; /* programmed */
	double feed; /* for moves without a feed, so that their time is finite */
};

static bool go(struct drill *drill, double feed)
{
	const vec3 position = klartext_frame_position(drill->interp, drill->at);
	struct canon_move move = {
	    .kind = feed > 0 ? CANON_FEED : CANON_RAPID, .spindle_turns = drill->hole->turns,
	    .turn = drill->hole->turns ? TURN_OF_TAP : TURN_UNKNOWN, .feed.linear = feed};
	slot_values target = drill->interp->state.position;

	slot_values_set_linear(&target, position);
	return motion_commands_go(drill->interp, &target, &move);
}

static bool rapid(struct drill *drill, double height)
{
	drill->at.z = height;
	return go(drill, 0);
}

static bool feed_to(struct drill *drill, double height, double feed)
{
	drill->at.z = height;
	return go(drill, feed);
}

static bool rest(struct drill *drill)
{
	return !(drill->hole->dwell > 0) ||
	       motion_commands_emit(drill->interp,
				    &(struct canon_move){.kind = CANON_DWELL, .seconds = drill->hole->dwell});
}

/*
 * Drills peck by peck. Between pecks the tool breaks chips, or it retracts to the set-up clearance and returns to just
 * above the last depth.
 */
static bool peck(struct drill *drill)
{
	const struct klartext_hole *hole = drill->hole;
	double size = hole->peck, depth = hole->start - hole->clearance - size;
	int breaks = 0;

	while (hole->peck > 0 && depth > hole->bottom + SAME_COORDINATE) {
		bool only_break = breaks < hole->chip_breaks;

		if (!feed_to(drill, depth, hole->feed))
			return false;
		breaks = only_break ? breaks + 1 : 0;
		if (only_break
			? !rapid(drill, fmin(hole->start, depth + hole->break_way))
			: !rapid(drill, hole->start) || !rapid(drill, fmin(hole->start, depth + hole->clearance)))
			return false;
		size = fmax(size - hole->less, fmin(hole->least, size));
		depth -= size;
	}
	return feed_to(drill, hole->bottom, hole->feed);
}

static bool step_aside(struct drill *drill, double sign)
{
	const struct klartext_hole *hole = drill->hole;

	if (!(fabs(hole->aside_x) + fabs(hole->aside_y) > 0))
		return true;
	drill->at.x += sign * hole->aside_x;
	drill->at.y += sign * hole->aside_y;
	return go(drill, 0);
}

static bool leave(struct drill *drill)
{
	const struct klartext_hole *hole = drill->hole;

	if (hole->out > 0 ? !feed_to(drill, hole->start, hole->out) : !rapid(drill, hole->start))
		return false;
	return (!(hole->clear > hole->start) || rapid(drill, hole->clear));
}

bool klartext_hole_make(struct interp *interp, const struct klartext_hole *hole, int column)
{
	struct drill drill = {.interp = interp, .hole = hole, .at = klartext_frame_point(interp)};

	if (hole->nothing)
		return true;
	if (!(hole->feed > 0))
		return fault(&interp->at, column, "a cycle without a feed rate");
	return rapid(&drill, hole->start) && peck(&drill) && rest(&drill) && step_aside(&drill, 1) && leave(&drill) &&
	       step_aside(&drill, -1);
}
