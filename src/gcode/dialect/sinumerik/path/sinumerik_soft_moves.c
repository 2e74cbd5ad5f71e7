#include "gcode/dialect/sinumerik/path/sinumerik_soft_moves.h"

#include <math.h>

#include "gcode/dialect/sinumerik/frames/sinumerik_frame.h"
#include "gcode/dialect/sinumerik/path/sinumerik_target.h"
#include "gcode/execute/cutter_comp/comp_moves.h"
#include "gcode/execute/cutter_comp/cutter_comp.h"
#include "gcode/execute/motion_commands.h"
#include "gcode/execute/rotated_frame.h"
#include "geom/tolerance.h"

/* -------------------------------------------------------------------- heights */

static bool read_height(struct interp *interp, const struct sinumerik_block *block, enum sinumerik_address address,
			struct sinumerik_soft_height *height)
{
	const enum axis_slot across = comp_slot_across(interp);
	const double value = sinumerik_target_length(interp, block->address_value[address]);
	slot_values place = *sinumerik_frame_place(interp);

	height->given = sinumerik_block_has_address(block, address);
	if (!height->given)
		return true;
	height->absolute = block->address_way[address] == SINUMERIK_WAY_AC;
	height->value = value;
	if (height->absolute) {
		place.v[across] = value;
		height->value = sinumerik_frame_straight(interp, &place).v[across];
	}
	return height->absolute || block->address_way[address] == SINUMERIK_WAY_MODAL ||
	       fault(&interp->at, block->address_column[address], "only a distance or AC() may stand here");
}

bool sinumerik_soft_moves_read_heights(struct interp *interp, const struct sinumerik_block *block,
				       struct sinumerik_soft_words *words)
{
	return read_height(interp, block, SINUMERIK_DISCL, &words->clearance) &&
	       read_height(interp, block, SINUMERIK_DISRP, &words->retract);
}

static double height_of(const struct sinumerik_soft_height *height, double base, double otherwise)
{
	if (!height->given)
		return otherwise;
	return height->absolute ? height->value : base + height->value;
}

bool sinumerik_soft_moves_find_heights(struct interp *interp, const struct sinumerik_soft_words *words, double base,
				       double outer, double *upper, double *lower)
{
	bool *cautioned = &sinumerik_of(interp)->soft.cautioned;

	*lower = height_of(&words->clearance, base, base);
	*upper = height_of(&words->retract, base, isnan(outer) ? *lower : outer);
	if (*lower < base - SAME_POINT || *upper < *lower - SAME_POINT)
		return fault(&interp->at, words->column,
			     "the heights of G%d are not in order: the contour at %.6g mm, P2 (DISCL) at %.6g mm and "
			     "P1 (DISRP, or the other end) at %.6g mm",
			     words->code / 10, base, *lower, *upper);
	if (sinumerik_of(interp)->comp.soft_way == 0 && *lower > base + SAME_POINT && !*cautioned) {
		*cautioned = true;
		caution(&interp->at, words->column,
			"before any G340 or G341, MD20150 says whether the height changes on the path that touches the "
			"contour: it does, as with G340 on a control as delivered; write G340 or G341");
	}
	return true;
}

/* --------------------------------------------------------------------- speeds */

/* The feed with a value of F in mm or degrees a minute or a turn. */
static bool find_feed(struct interp *interp, double linear, double angular, struct canon_feed *feed)
{
	struct state *state = &interp->state;
	const double own_linear = state->feed_linear, own_angular = state->feed_angular;
	bool good;

	state->feed_linear = linear;
	state->feed_angular = angular;
	good = motion_commands_feed(interp, feed);
	state->feed_linear = own_linear;
	state->feed_angular = own_angular;
	return good;
}

/*
 * "Approach and retraction velocities": the speed of the block before is that of the way from P0 to P2. FAD is that of
 * the way from P2 to P3 with G341, and on to P4 with G340; without FAD and F it is the speed of the block before, also
 * if that is the rapid rate. F is that of the rest. On retraction the old speed holds up to P2, and F behind it.
 */
bool sinumerik_soft_moves_find_feeds(struct interp *interp, const struct sinumerik_block *block,
				     struct sinumerik_soft_words *words)
{
	const struct sinumerik_soft *soft = &sinumerik_of(interp)->soft;
	const double fad = block->address_value[SINUMERIK_FAD];

	words->has_slow = sinumerik_block_has_address(block, SINUMERIK_FAD);
	words->has_feed = sinumerik_block_has(block, 'F');
	words->rapid_before = soft->motion_before == G0;
	if (words->has_slow && !(fad > 0))
		return fault(&interp->at, block->address_column[SINUMERIK_FAD], "FAD must be more than 0");
	if (words->has_slow && !find_feed(interp, fad * sinumerik_of(interp)->feed_scale, fad, &words->slow))
		return false;
	if (words->has_feed && !motion_commands_feed(interp, &words->own))
		return false;
	return words->rapid_before || find_feed(interp, soft->linear_before, soft->angular_before, &words->before);
}

/* ---------------------------------------------------------------------- moves */

void sinumerik_soft_moves_put_at(struct interp *interp, const slot_values *straight)
{
	const slot_values position = rotated_frame_position(&interp->state, straight);

	for (int slot = 0; slot < SLOT_COUNT; slot++)
		state_set_position(&interp->state, slot, position.v[slot]);
}

slot_values sinumerik_soft_moves_place(const struct interp *interp, const slot_values *like, struct plane_point point,
				       double height)
{
	slot_values place = *like;

	place.v[comp_slot_a(interp)] = point.a;
	place.v[comp_slot_b(interp)] = point.b;
	place.v[comp_slot_across(interp)] = height;
	return place;
}

static bool is_here(const struct interp *interp, const slot_values *target)
{
	const slot_values here = rotated_frame_straight(&interp->state);
	double most = 0;

	for (int slot = SLOT_X; slot <= SLOT_Z; slot++)
		most = fmax(most, fabs(target->v[slot] - here.v[slot]));
	return most < SAME_POINT;
}

bool sinumerik_soft_moves_line(struct interp *interp, const slot_values *target, const struct canon_feed *feed)
{
	struct canon_move move = {.kind = feed ? CANON_FEED : CANON_RAPID};

	if (is_here(interp, target))
		return true;
	if (feed)
		move.feed = *feed;
	interp->block.motion = interp->block.g[G_MOTION] = feed ? G1 : G0;
	return cutter_comp_is_on(interp) ? cutter_comp_line(interp, target, &move)
					 : motion_commands_go(interp, target, &move);
}

static bool go_arc(struct interp *interp, const slot_values *target, const struct sinumerik_soft_path *path,
		   const struct canon_feed *feed)
{
	const slot_values here = rotated_frame_straight(&interp->state);
	double centre[3] = {here.v[SLOT_X], here.v[SLOT_Y], here.v[SLOT_Z]}, normal[3] = {0};
	struct canon_move move = {.kind = CANON_ARC, .feed = *feed};

	interp->block.motion = interp->block.g[G_MOTION] = path->clockwise ? G2 : G3;
	if (cutter_comp_is_on(interp))
		return cutter_comp_arc(interp, target, path->centre, 1, &move);
	centre[comp_slot_a(interp)] = path->centre.a;
	centre[comp_slot_b(interp)] = path->centre.b;
	normal[comp_slot_across(interp)] = 1;
	move.arc.centre = rotated_frame_point(&interp->state, (vec3){centre[0], centre[1], centre[2]});
	move.arc.normal = rotated_frame_normal(&interp->state, (vec3){normal[0], normal[1], normal[2]});
	move.arc.sweep =
	    arc_sweep(comp_here(interp), comp_point_of(interp, target), path->centre, path->clockwise, 1, 0);
	return motion_commands_go(interp, target, &move);
}

bool sinumerik_soft_moves_path(struct interp *interp, const slot_values *target, const struct sinumerik_soft_path *path,
			       const struct canon_feed *feed)
{
	return path->is_arc ? go_arc(interp, target, path, feed) : sinumerik_soft_moves_line(interp, target, feed);
}
