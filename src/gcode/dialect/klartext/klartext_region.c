#include "gcode/dialect/klartext/klartext_region.h"

#include <math.h>

#include "gcode/dialect/klartext/klartext_frame.h"
#include "gcode/execute/motion_commands.h"

/* To a point, anywhere in the region about the way there. A feed of 0 is a rapid. */
static bool go(const struct klartext_call_of *call, const struct klartext_region *region, vec3 point, double feed)
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
static void leave_open(const struct klartext_call_of *call, const struct klartext_region *region)
{
	const vec3 box = klartext_frame_box(call->interp, (const double[3]){region->half[0], region->half[1], 0});
	double *loose = call->interp->comp.loose;

	loose[SLOT_X] += box.x;
	loose[SLOT_Y] += box.y;
	loose[SLOT_Z] += box.z;
}

bool klartext_region_carry_out(const struct klartext_call_of *call, const struct klartext_region *region)
{
	vec3 at = klartext_frame_point(call->interp);
	struct klartext_region column = *region;

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
