#include "gcode/execute/motion_commands.h"

#include <assert.h>
#include <math.h>

#include "base/apart.h"
#include "base/minmax.h"
#include "base/same_double.h"
#include "base/units.h"
#include "gcode/execute/dynamic_work_offset.h"
#include "gcode/execute/path_rounding.h"
#include "gcode/execute/pocket_outline.h"
#include "gcode/execute/polar_pieces.h"
#include "gcode/execute/probed_axes.h"
#include "gcode/execute/rotated_frame.h"

/* Sets the data of a move that depend on the modes and the block. */
static void fill_in(struct interp *interp, struct canon_move *move)
{
	struct state *state = &interp->state;

	move->file = interp->at.file;
	move->line = interp->at.line;
	/* A spindle stop is not counted as a move. */
	interp->moves += move->kind != CANON_SPINDLE_STOP;
	move->number = interp->moves;
	move->tcp = state->tcp != TCP_OFF;
	move->plane = state->tcp == TCP_BY_PLANE;
	move->blend = state->blend;
	move->blend_tolerance = state->blend_tolerance;
	move->blend_turn = state->blend_turn;
	move->spindle_turns |= state->spindle != SPINDLE_STOPPED && !state->speed_is_zero;
	if (move->turn == TURN_UNKNOWN && state->spindle != SPINDLE_STOPPED)
		move->turn = state->spindle == SPINDLE_CLOCKWISE ? TURN_CLOCKWISE : TURN_COUNTERCLOCKWISE;
	state->origin.length = state->length;
	state->origin.turned = state->frame.on || state->own_frame;
	move->origin = &state->origin;
	if (state->spindle != SPINDLE_STOPPED)
		move->spindle_speed = state->spindle == SPINDLE_CLOCKWISE ? state->speed : -state->speed;
}

/* Are there axes that may deviate from the path of every move? */
static bool widens(const struct interp *interp)
{
	const double *loose = interp->comp.loose;

	return larger(loose[SLOT_X], larger(loose[SLOT_Y], loose[SLOT_Z])) > 0 || interp->state.cylinder.on;
}

/* Adds the deviation of these axes to a move that fill_in has completed. */
static void widen(const struct interp *interp, struct canon_move *move)
{
	const struct state *state = &interp->state;

	for (int slot = SLOT_X; slot <= SLOT_Z; slot++) {
		if (!(interp->comp.loose[slot] > 0))
			continue;
		/* The move that ended the compensation has covered all possible positions of the axis. */
		move->between[slot] |= !(move->spread[slot] > 0);
		move->spread[slot] += interp->comp.loose[slot];
	}
	/* The path is on the surface of the cylinder: a deviation there turns the axis by deviation / radius. */
	if (state->cylinder.on)
		move->turn_spread[state->cylinder.slot - SLOT_A] +=
		    path_rounding(interp, move) / state->cylinder.radius;
}

void motion_commands_fill(struct interp *interp, struct canon_move *move)
{
	fill_in(interp, move);
	if (widens(interp))
		widen(interp, move);
}

bool motion_commands_enqueue(struct interp *interp, const struct comp_item *item)
{
	return comp_queue_add(&interp->comp.queue, item) ||
	       fault(&interp->at, 1, "too many blocks under cutter compensation without a move in its plane");
}

static bool send(struct interp *interp, const struct canon_move *move)
{
	if (interp->comp.queue.count > 0)
		return motion_commands_enqueue(interp, &(struct comp_item){.kind = COMP_PAUSE, .move = *move});
	return interp->state.polar_interpolation.on ? polar_pieces_tell(interp, move)
						    : canon_tell_move(interp->sink, move);
}

static APART bool emit_wide(struct interp *interp, struct canon_move move)
{
	fill_in(interp, &move);
	widen(interp, &move);
	return send(interp, &move);
}

bool motion_commands_emit(struct interp *interp, struct canon_move *move)
{
	const bool spindle_turns = move->spindle_turns;
	const double spindle_speed = move->spindle_speed;
	const enum canon_turn turn = move->turn;
	bool good;

	if (interp->state.pocket_milling.takes) {
		pocket_outline_take(&interp->state.pocket_milling, move);
		return true;
	}
	/* These members must be restored for the caller's next move. A copy of the move is slow, and seldom needed. */
	if (widens(interp))
		return emit_wide(interp, *move);
	fill_in(interp, move);
	good = send(interp, move);
	move->spindle_turns = spindle_turns;
	move->spindle_speed = spindle_speed;
	move->turn = turn;
	return good;
}

static bool go_to(struct interp *interp, const slot_values *position, struct canon_move *move)
{
	struct state *state = &interp->state;

	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		if (!same_double(state->position.v[slot], position->v[slot]))
			state_set_position(state, slot, position->v[slot]);
	}
	move->end = state->canonical;
	return motion_commands_emit(interp, move);
}

/* Moves from the places where a probe may have stopped. */
static APART bool go_probed(struct interp *interp, const slot_values *position, struct canon_move *move)
{
	struct state *state = &interp->state;
	const slot_values start = state->position;
	struct canon_move before;
	struct probed_plan plan;
	int open = SLOT_X;

	move->after_probe = true;
	before = *move;
	if (!probed_axes_plan(state, position, move->kind == CANON_ARC, &plan, &open))
		return probed_axes_is_known(interp, open, block_column(&interp->block, AXIS_LETTERS[open]));
	before.kind = move->kind == CANON_ARC ? CANON_FEED : move->kind;
	for (int i = 0; i < plan.via_count; i++) {
		if (!go_to(interp, &plan.via[i], &before))
			return false;
	}
	move->arc.centre.x += state->position.v[SLOT_X] - start.v[SLOT_X];
	move->arc.centre.y += state->position.v[SLOT_Y] - start.v[SLOT_Y];
	move->arc.centre.z += state->position.v[SLOT_Z] - start.v[SLOT_Z];
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++) {
		move->between[slot] = state->settles[slot] && !(move->spread[slot] > 0);
		move->spread[slot] += plan.spread[slot];
	}
	if (!go_to(interp, &plan.end, move))
		return false;
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++) {
		move->spread[slot] -= plan.spread[slot];
		move->between[slot] = false;
	}
	move->after_probe = false;
	probed_axes_arrive(state, &plan);
	return true;
}

bool motion_commands_go(struct interp *interp, const slot_values *target, struct canon_move *move)
{
	struct state *state = &interp->state;
	const slot_values *position = target;
	slot_values turned;

	if (state->frame.on) {
		turned = rotated_frame_position(state, target);
		position = &turned;
	}
	if (state->dynamic.on && !dynamic_work_offset_check_turn(interp, position))
		return false;
	return probed_axes_any(state) ? go_probed(interp, position, move) : go_to(interp, position, move);
}

bool motion_commands_cover_probed(struct interp *interp, int column)
{
	struct state *state = &interp->state;
	struct canon_move move = {.kind = CANON_RAPID};
	int last = -1;

	for (int slot = SLOT_X; slot <= SLOT_Z; slot++) {
		slot_values low = state->position, high = state->position;

		if (!state->probed[slot] || !state->probe_bounded[slot])
			continue;
		if (last >= 0)
			return probed_axes_is_known(interp, slot, column);
		last = slot;
		low.v[slot] = state->probe_low.v[slot];
		high.v[slot] = state->probe_high.v[slot];
		if (!go_to(interp, &low, &move) || !go_to(interp, &high, &move))
			return false;
	}
	return true;
}

bool motion_commands_spindle_stops(struct interp *interp)
{
	if (interp->state.spindle == SPINDLE_STOPPED)
		return true;
	return motion_commands_emit(interp, &(struct canon_move){.kind = CANON_SPINDLE_STOP}) &&
	       motion_commands_cover_probed(interp, 1);
}

bool motion_commands_seconds(const struct interp *interp, char letter, double *seconds)
{
	const struct block *block = &interp->block;
	const struct dialect_traits *traits = traits_of(interp);
	double number = block_value(block, letter), increment = interp->config->controller.least_input;
	int column = block_column(block, letter);
	bool point = block->points & letter_bit(letter);

	if (letter == 'P' && !is_answered(interp, column, traits->dwell_p, "whether P of a dwell is in seconds"))
		return false;
	if (letter != 'P' && !point &&
	    !is_answered(interp, column, traits->whole_numbers, "what a number without a decimal point means"))
		return false;
	if (letter == 'P' && !point && traits->dwell_p == DWELL_P_MILLISECONDS)
		number /= 1000;
	else if (letter != 'P' && !point && increment > 0)
		number *= increment;
	*seconds = number;
	return true;
}

bool motion_commands_dwell(struct interp *interp)
{
	const struct block *block = &interp->block;
	char letter = '\0';
	double seconds = 0;

	for (const char *letters = traits_of(interp)->dwell_letters; *letters; letters++)
		letter = block_has(block, *letters) ? *letters : letter;
	/* block_check has found one of the letters. */
	assert(letter >= 'A');
	if (!motion_commands_seconds(interp, letter, &seconds))
		return false;
	if (seconds < 0)
		return fault(&interp->at, block_column(block, letter), "a dwell must not be negative");
	return motion_commands_emit(interp, &(struct canon_move){.kind = CANON_DWELL, .seconds = seconds});
}

/* A feed that no axis reaches, in mm or radians per second: the axes' rates limit moves at this feed. */
#define FASTEST_FEED 1e6

/*
 * A feed move before any F: Fanuc B-64484EN and Haas call this an alarm, but a program that is a part of a job uses the
 * F of the part before. The path is the same.
 */
static bool keep_feed(struct interp *interp, struct canon_feed *feed)
{
	const int column = block_motion_column(&interp->block);
	const double code = interp->block.motion / 10.0;

	if (traits_of(interp)->feed_missing != FEED_MISSING_KEPT)
		return fault(&interp->at, column, "G%g without a feed rate (F)", code);
	if (!interp->cautioned_feed)
		caution(&interp->at, column,
			"G%g without a feed rate (F): the control uses an earlier feed rate or stops with an alarm; "
			"the path is checked at the largest speeds of the axes, here and further on",
			code);
	interp->cautioned_feed = true;
	feed->linear = FASTEST_FEED;
	feed->angular = FASTEST_FEED;
	return true;
}

double motion_commands_thread_feed(struct interp *interp, int column, double feed)
{
	if (feed > 0)
		return feed;
	if (!interp->cautioned_speed)
		caution(&interp->at, column,
			"a thread or a feed per revolution without a spindle speed (S), or without a pitch, where the "
			"control stops or waits; the path is checked at the largest speeds of the axes, here and "
			"further on");
	interp->cautioned_speed = true;
	return FASTEST_FEED;
}

static bool take_inverse_time(struct interp *interp, struct canon_feed *feed)
{
	const struct block *block = &interp->block;

	if (!block_has(block, 'F'))
		return fault(&interp->at, block_motion_column(block), "G%g without F in inverse time mode (G93)",
			     block->motion / 10.0);
	feed->inverse_time = true;
	feed->seconds = SECONDS_PER_MINUTE / block_value(block, 'F');
	return (block_value(block, 'F') > 0 && isfinite(feed->seconds)) ||
	       fault(&interp->at, block_column(block, 'F'), "F must be greater than 0 in inverse time mode (G93)");
}

/* LinuxCNC's manual, "Feed Rate" and "G93, G94, G95". */
bool motion_commands_feed(struct interp *interp, struct canon_feed *feed)
{
	const struct block *block = &interp->block;
	const struct state *state = &interp->state;
	double per_second = 1 / SECONDS_PER_MINUTE;

	*feed = (struct canon_feed){0};
	if (state->feed_mode == FEED_INVERSE_TIME)
		return take_inverse_time(interp, feed);
	if (!(state->feed_linear > 0))
		return keep_feed(interp, feed);
	if (state->feed_mode == FEED_PER_REVOLUTION) {
		const int column = block_motion_column(block);

		if (!(state->speed > 0) && traits_of(interp)->feed_missing != FEED_MISSING_KEPT)
			return fault(&interp->at, column,
				     "G%g in feed per revolution (G95) without a spindle speed (S)",
				     block->motion / 10.0);
		if (!(state->speed > 0)) {
			feed->linear = feed->angular = motion_commands_thread_feed(interp, column, 0);
			return true;
		}
		per_second *= state->speed;
	}
	feed->linear = state->feed_linear * per_second;
	feed->angular = radians(state->feed_angular) * per_second;
	/* F is the feed along the surface. */
	if (state->cylinder.on)
		feed->angular = feed->linear / state->cylinder.radius;
	return true;
}
