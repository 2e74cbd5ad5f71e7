#include "gcode/dialect/klartext/moves/klartext_move.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/same_double.h"
#include "base/units.h"
#include "gcode/dialect/klartext/frames/klartext_frame.h"
#include "gcode/dialect/klartext/frames/klartext_preset.h"
#include "gcode/execute/endpoint.h"
#include "gcode/execute/motion_commands.h"
#include "gcode/execute/tool_length.h"
#include "geom/tolerance.h"

/* Degrees: the error of Q120 to Q122 if a post writes them with three decimals. */
#define ROUNDED_ANGLE 0.00051

/* ----------------------------------------------------------------- targets */

/* The target of an axis that moves by the difference of the angle and its display, which is reduced to 360 degrees. */
static double difference_target(const struct interp *interp, int slot, double value)
{
	const double offset = interp->state.offset.v[slot];

	return value + offset + 360 * floor((interp->state.position.v[slot] - offset + SAME_DEGREES) / 360);
}

static double reduced(double value)
{
	return value - 360 * floor(value / 360);
}

/*
 * "M126" (iTNC 530 user's manual): a rotary axis with a reduced display takes the shorter way. Without M126 a machine
 * parameter decides. In the machine file, wrap says whether the display is reduced. The manual does not say whether the
 * control reduces a programmed angle before it takes the difference.
 */
static bool check_way(struct interp *interp, int slot, double value, double target, int column)
{
	struct klartext_rotary *rotary = &klartext_of(interp)->rotary;
	enum wrap wrap = interp->config->wrap[slot];

	if (rotary->shortest && wrap == WRAP_NONE && !rotary->cautioned &&
	    fabs(target - interp->state.position.v[slot]) > 180) {
		rotary->cautioned = true;
		caution(&interp->at, column,
			"M126 is in force, but %c counts as a plain number: if its display is reduced to 360 degrees, "
			"wrap=\"shortest\" of the axis in the machine file says so",
			AXIS_LETTERS[slot]);
	}
	if (wrap == WRAP_SIGN)
		return fault(
		    &interp->at, column,
		    "wrap=\"sign\" of %c: this control takes the shorter way (wrap=\"shortest\") or a plain number",
		    AXIS_LETTERS[slot]);
	if (rotary->shortest || wrap == WRAP_NONE || interp->config->controller.rotary_way == ROTARY_WAY_SHORTER ||
	    (fabs(difference_target(interp, slot, value) - target) < SAME_DEGREES &&
	     fabs(difference_target(interp, slot, reduced(value)) - target) < SAME_DEGREES))
		return true;
	if (interp->config->controller.rotary_way == ROTARY_WAY_PLAIN)
		return fault(&interp->at, column,
			     "an angle of %c outside of 0 to 360 without M126: it is not known whether the control "
			     "reduces it before it takes the difference: set rotary_angle=\"as-written\" or "
			     "\"reduced\" in the machine file's <controller>, or write M126, or an angle from 0 to "
			     "360",
			     AXIS_LETTERS[slot]);
	return fault(
	    &interp->at, column,
	    "%c would go the shorter way, as wrap=\"shortest\" of the machine file says, but M126 is not in force: "
	    "whether the control goes the plain way without it is a parameter of the machine: set "
	    "rotary_way=\"plain\" or \"shorter\" in the machine file's <controller>, or write M126",
	    AXIS_LETTERS[slot]);
}

/* Does the axis move by the difference of the angle and the reduced display? If so, finds the target. */
static bool goes_plain(const struct interp *interp, int slot, double value, double *target)
{
	const struct controller *controller = &interp->config->controller;

	if (!slot_is_rotary(slot) || interp->config->wrap[slot] != WRAP_SHORTEST ||
	    klartext_of(interp)->rotary.shortest || controller->rotary_way != ROTARY_WAY_PLAIN ||
	    (controller->rotary_angle == ROTARY_ANGLE_UNKNOWN && !(value >= 0 && value < 360)))
		return false;
	*target = difference_target(interp, slot,
				    controller->rotary_angle == ROTARY_ANGLE_REDUCED ? reduced(value) : value);
	return true;
}

static bool find_other(struct interp *interp, const struct klartext_words *words, int slot, slot_values *others)
{
	const struct state *state = &interp->state;
	double value = words->value[slot];

	if (words->increments & 1U << slot) {
		if (klartext_of(interp)->rotary.shifted[slot] &&
		    interp->config->controller.increments_after_shift != INCREMENTS_FROM_POSITION)
			return fault(
			    &interp->at, words->column[slot],
			    "an increment of %c after its datum was shifted: from where the control counts is not "
			    "known here; give %c as an absolute coordinate first, or set "
			    "increments_after_shift=\"stay\" in the machine file's <controller> if it counts from "
			    "where the axis stands",
			    AXIS_LETTERS[slot], AXIS_LETTERS[slot]);
		others->v[slot] += value;
		return true;
	}
	klartext_of(interp)->rotary.shifted[slot] = false;
	if (goes_plain(interp, slot, value, &others->v[slot]))
		return true;
	return endpoint_absolute(interp, slot, value, state->offset.v[slot], words->column[slot], &others->v[slot]) &&
	       (!slot_is_rotary(slot) || check_way(interp, slot, value, others->v[slot], words->column[slot]));
}

bool klartext_move_target(struct interp *interp, const struct klartext_words *words, struct klartext_target *target)
{
	double point[3];

	/* The preset comes first, because it gives the coordinates. */
	if (words->axes && (!klartext_preset_check(interp, words->first_column) ||
			    !klartext_preset_check_plane(interp, words->first_column) ||
			    !klartext_frame_check_shift(interp, words->axes, words->first_column)))
		return false;
	target->others = interp->state.position;
	target->turns = words->axes & (1U << SLOT_A | 1U << SLOT_B | 1U << SLOT_C);
	target->point = klartext_frame_point(interp);
	if (!words->axes)
		return true;
	point[0] = target->point.x;
	point[1] = target->point.y;
	point[2] = target->point.z;
	for (int slot = 0; words->axes >> slot; slot++) {
		if (!klartext_words_has(words, slot))
			continue;
		if (slot > SLOT_Z) {
			if (!find_other(interp, words, slot, &target->others))
				return false;
		} else {
			bool increment = words->increments & 1U << slot;

			if (increment && !klartext_frame_check_increment(interp, slot, words->column[slot]))
				return false;
			point[slot] = words->value[slot] + (increment ? point[slot] : 0);
		}
	}
	target->point = (vec3){point[0], point[1], point[2]};
	return true;
}

bool klartext_move_feed(struct interp *interp, const struct klartext_words *words, bool *rapid, struct canon_feed *feed)
{
	struct state *state = &interp->state;
	int column = words->feed_column ? words->feed_column : words->first_column;

	*rapid = words->feed == KLARTEXT_FEED_MAX;
	*feed = (struct canon_feed){0};
	if (words->feed == KLARTEXT_FEED_VALUE && (words->feed_per_revolution || klartext_of(interp)->per_revolution)) {
		if (!(state->speed > 0))
			return fault(&interp->at, column,
				     "a feed per revolution (FU, M136) without a spindle speed (S)");
		state->feed_linear = words->feed_bare * state->scale * state->speed;
		state->feed_angular = words->feed_bare * state->speed;
	} else if (words->feed == KLARTEXT_FEED_VALUE) {
		state->feed_linear = words->feed_value;
		state->feed_angular = words->feed_bare;
	} else if (words->feed == KLARTEXT_FEED_AUTO) {
		if (!(klartext_of(interp)->tool.feed > 0))
			return fault(&interp->at, column, "F AUTO, but TOOL CALL has given no F");
		state->feed_linear = klartext_of(interp)->tool.feed;
		state->feed_angular = klartext_of(interp)->tool.feed_bare;
	}
	if (*rapid)
		return true;
	if (!(state->feed_linear > 0))
		return fault(&interp->at, column, "a move without a feed rate: F or FMAX is needed");
	feed->linear = state->feed_linear / SECONDS_PER_MINUTE;
	feed->angular = radians(state->feed_angular) / SECONDS_PER_MINUTE;
	return true;
}

/* --------------------------------------------------------------- directions */

static bool direction_at(const struct klartext_path *path, vec3 at, vec3 *direction)
{
	vec3 way = vec3_sub(path->end, path->start), radius;

	if (!path->known)
		return false;
	if (!path->arc) {
		*direction = way;
	} else {
		radius = vec3_sub(at, path->centre);
		radius = vec3_mad(radius, -vec3_dot(radius, path->normal), path->normal);
		*direction = vec3_scale(path->sweep > 0 ? 1 : -1, vec3_cross(path->normal, radius));
	}
	if (!(vec3_norm(*direction) > SAME_POINT))
		return false;
	*direction = vec3_unit(*direction);
	return true;
}

bool klartext_move_start_direction(const struct klartext_path *path, vec3 *direction)
{
	return direction_at(path, path->start, direction);
}

bool klartext_move_end_direction(const struct klartext_path *path, vec3 *direction)
{
	return direction_at(path, path->end, direction);
}

/* ------------------------------------------------------------------- moves */

void klartext_move_put(struct interp *interp, vec3 point)
{
	const vec3 at = klartext_frame_position(interp, point);

	state_set_position(&interp->state, SLOT_X, at.x);
	state_set_position(&interp->state, SLOT_Y, at.y);
	state_set_position(&interp->state, SLOT_Z, at.z);
}

bool klartext_move_in_plane(const struct interp *interp, const slot_values *others)
{
	const struct klartext_stay *stay = &klartext_of(interp)->stay;

	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		double off = remainder(others->v[slot] - state_from_canonical(slot, stay->rotary.v[slot]), 360);

		if (stay->needed[slot] && fabs(off) > ROUNDED_ANGLE)
			return false;
	}
	return true;
}

bool klartext_move_refuse_waiting(struct interp *interp, int column)
{
	const struct klartext_stay *stay = &klartext_of(interp)->stay;
	char needed[64] = "";

	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		const size_t length = strlen(needed);
		const double angle = state_from_canonical(slot, stay->rotary.v[slot]) - interp->state.offset.v[slot];

		if (stay->needed[slot])
			snprintf(needed + length, sizeof(needed) - length, " %c%.7g", AXIS_LETTERS[slot], angle + 0.0);
	}
	return fault(&interp->at, column,
		     "PLANE ... STAY needs the rotary axes at%s: a move of linear axes before they stand there is not "
		     "supported; turn them there first, or write TURN",
		     needed);
}

bool klartext_move_check(struct interp *interp, const struct klartext_target *target, int column)
{
	const struct klartext *klartext = klartext_of(interp);
	bool tilted = interp->state.tcp == TCP_BY_PLANE, leaves = false;

	if (!target->turns && klartext->stay.waits)
		return klartext_move_refuse_waiting(interp, column);
	for (int slot = SLOT_A; slot <= SLOT_C; slot++)
		leaves = leaves || fabs(target->others.v[slot] - interp->state.position.v[slot]) > SAME_DEGREES;
	if (tilted && leaves)
		return fault(&interp->at, column,
			     "a rotary axis leaves the tilted plane: write PLANE RESET first, or M128");
	return true;
}

bool klartext_move_end_tcp(struct interp *interp, int column)
{
	struct klartext *klartext = klartext_of(interp);
	bool tilted = klartext->frame.tilted;

	klartext->stay.waits = tilted && !klartext_move_in_plane(interp, &interp->state.position);
	return tool_length_switch_tcp(interp, column, tilted && !klartext->stay.waits ? TCP_BY_PLANE : TCP_OFF);
}

static bool go(struct interp *interp, const struct klartext_target *target, struct canon_move *move)
{
	slot_values position = target->others;
	vec3 xyz = klartext_frame_position(interp, target->point);
	struct klartext *klartext = klartext_of(interp);

	klartext->tool.moved = true;
	klartext->programmed = klartext->stay.waits ? klartext->programmed : target->point;
	if (klartext->stay.waits) {
		/* Only the rotary axes move. */
		position.v[SLOT_X] = interp->state.position.v[SLOT_X];
		position.v[SLOT_Y] = interp->state.position.v[SLOT_Y];
		position.v[SLOT_Z] = interp->state.position.v[SLOT_Z];
	} else {
		position.v[SLOT_X] = xyz.x;
		position.v[SLOT_Y] = xyz.y;
		position.v[SLOT_Z] = xyz.z;
	}
	return klartext->open.aside && move->kind != CANON_ARC
		   ? parallel_moves_go_from_open(interp, &position, move, &klartext->open.box)
		   : motion_commands_go(interp, &position, move);
}

bool klartext_move_line(struct interp *interp, const struct klartext_target *target, bool rapid,
			const struct canon_feed *feed)
{
	struct canon_move move;

	canon_move_begin(&move, rapid ? CANON_RAPID : CANON_FEED);
	move.feed = *feed;
	return go(interp, target, &move);
}

bool klartext_move_turning(struct interp *interp, const struct klartext_target *target, struct canon_move *move)
{
	return go(interp, target, move);
}

bool klartext_move_within(struct interp *interp, const struct klartext_target *target, const struct klartext_path *path)
{
	const vec3 factor = klartext_of(interp)->frame.scale;
	const vec3 spread = klartext_frame_box(
	    interp, (const double[3]){path->half[0] * factor.x, path->half[1] * factor.y, path->half[2] * factor.z});
	struct canon_move move = {.kind = CANON_FEED, .feed = path->feed};

	move.spread[SLOT_X] = spread.x;
	move.spread[SLOT_Y] = spread.y;
	move.spread[SLOT_Z] = spread.z;
	return go(interp, target, &move);
}

bool klartext_move_check_arc(struct interp *interp, const struct klartext_path *path, int column)
{
	const struct klartext_frame *frame = &klartext_of(interp)->frame;
	const double factor[3] = {frame->scale.x, frame->scale.y, frame->scale.z};
	const double normal[3] = {path->normal.x, path->normal.y, path->normal.z};
	double first = 0;

	for (int i = 0; i < 3; i++) {
		if (same_double(fabs(normal[i]), 1))
			continue;
		if (first > 0 && !same_double(first, factor[i]))
			return fault(&interp->at, column,
				     "a circle while the factors of its plane's axes differ would be an ellipse");
		first = factor[i];
	}
	return true;
}

bool klartext_move_arc(struct interp *interp, const struct klartext_target *target, const struct klartext_path *arc)
{
	struct canon_move move = {.kind = CANON_ARC, .feed = arc->feed};
	const struct klartext_frame *frame = &klartext_of(interp)->frame;
	bool mirrored = frame->any && (frame->mirror[0] + frame->mirror[1] + frame->mirror[2]) % 2 == 1;

	move.arc.centre = klartext_frame_position(interp, arc->centre);
	move.arc.normal = klartext_frame_direction(interp, arc->normal);
	move.arc.sweep = mirrored ? -arc->sweep : arc->sweep;
	return go(interp, target, &move);
}
