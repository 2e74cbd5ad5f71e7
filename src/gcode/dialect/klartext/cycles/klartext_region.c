#include "gcode/dialect/klartext/cycles/klartext_region.h"

#include <math.h>

#include "gcode/dialect/klartext/frames/klartext_frame.h"

/* mm: more than 0, so that a move counts as one of a set of parallel moves, whose exact path is not known. */
#define NARROW 1e-9

/* Moves to a point, anywhere in the region about the straight way. A feed of 0 is a rapid. */
static bool go(const struct klartext_call_of *call, const struct klartext_region *region, vec3 point, double feed)
{
	struct interp *interp = call->interp;
	const vec3 position = klartext_frame_position(interp, point);
	const struct parallel_box box =
	    klartext_frame_turned_box(interp, (const double[3]){region->half[0], region->half[1], region->beyond});
	const struct canon_move move = {.kind = feed > 0 ? CANON_FEED : CANON_RAPID, .feed.linear = feed};
	slot_values target = interp->state.position;

	slot_values_set_linear(&target, position);
	return parallel_moves_go(interp, &target, &move, &box);
}

void klartext_region_leave_open(struct interp *interp, double half_x, double half_y)
{
	const double half[3] = {half_x, half_y, 0};
	const vec3 about = klartext_frame_box(interp, half);
	double *loose = interp->comp.loose;

	loose[SLOT_X] = about.x;
	loose[SLOT_Y] = about.y;
	loose[SLOT_Z] = about.z;
	klartext_of(interp)->open.aside = true;
	klartext_of(interp)->open.box = klartext_frame_turned_box(interp, half);
}

void klartext_region_find_aside(const struct interp *interp, double aside[2])
{
	const struct klartext_open *open = &klartext_of(interp)->open;
	const double *loose = interp->comp.loose;
	const double most = vec3_norm((vec3){loose[SLOT_X], loose[SLOT_Y], loose[SLOT_Z]});

	for (int i = 0; i < 2; i++) {
		const vec3 along = klartext_frame_direction(interp, (vec3){i == 0, i == 1, 0});

		aside[i] = most > 0 && open->aside ? 0 : most;
		for (int side = 0; most > 0 && open->aside && side < 3; side++)
			aside[i] += fabs(vec3_dot(along, open->box.half[side]));
	}
}

/* Widens the region: if the position of the tool is already uncertain, so is the place of a region about it. */
static void widen(const struct klartext_call_of *call, struct klartext_region *region)
{
	double *loose = call->interp->comp.loose;
	const double open = vec3_norm((vec3){loose[SLOT_X], loose[SLOT_Y], loose[SLOT_Z]});

	region->half[0] += region->fixed ? 0 : open;
	region->half[1] += region->fixed ? 0 : open;
	region->beyond += klartext_of(call->interp)->open.aside ? 0 : loose[SLOT_Z];
	loose[SLOT_X] = loose[SLOT_Y] = loose[SLOT_Z] = 0;
}

/*
 * Moves from the position of the tool to above the region. The axes may move one after the other or all at once, so the
 * whole box between is covered.
 */
static bool approach(const struct klartext_call_of *call, const struct klartext_region *region, const double aside[2])
{
	const struct klartext_region nowhere = {.half = {0, 0}};
	struct klartext_region all = *region;
	vec3 at = klartext_frame_point(call->interp);
	const double here[2] = {at.x, at.y}, centre[2] = {region->centre.x, region->centre.y};
	double middle[2];

	for (int i = 0; i < 2; i++) {
		const double low = fmin(here[i] - aside[i], centre[i] - region->half[i]);
		const double high = fmax(here[i] + aside[i], centre[i] + region->half[i]);

		middle[i] = (low + high) / 2;
		all.half[i] = (high - low) / 2;
	}
	at.x = middle[0];
	at.y = middle[1];
	if (!go(call, &nowhere, at, 0))
		return false;
	at.z = region->top;
	return go(call, &all, at, 0);
}

bool klartext_region_carry_out(const struct klartext_call_of *call, const struct klartext_region *given)
{
	const struct klartext_region within = {.half = {NARROW, NARROW}};
	struct klartext_region region = *given;
	vec3 at = region.centre;
	double aside[2];

	klartext_region_find_aside(call->interp, aside);
	widen(call, &region);
	at.z = region.top;
	/* The approach covers the way to the middle of the region; the way down covers every way up. */
	if (!approach(call, &region, aside) || !go(call, &within, at, 0))
		return false;
	at.z = region.bottom;
	if (!go(call, &region, at, region.feed))
		return false;
	at.z = region.top;
	if (!go(call, &within, at, region.feed))
		return false;
	at.z = region.clear;
	if (!go(call, &region, at, 0))
		return false;
	klartext_region_leave_open(call->interp, region.half[0], region.half[1]);
	return true;
}
