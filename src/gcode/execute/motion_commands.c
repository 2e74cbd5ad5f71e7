#include "gcode/execute/motion_commands.h"

#include <limits.h>
#include <math.h>

#include "base/units.h"
#include "gcode/execute/arc.h"
#include "gcode/execute/canned_cycle.h"
#include "gcode/execute/cutter_comp/cutter_comp.h"
#include "gcode/execute/dynamic_work_offset.h"
#include "gcode/execute/endpoint.h"
#include "gcode/execute/feedback_moves.h"
#include "gcode/execute/length_change.h"
#include "gcode/execute/rotated_frame.h"
#include "gcode/execute/tool_length.h"

/* mm and radians: ends of an arc that are so close are the same point, and the arc a full circle. */
#define SAME_POINT 1e-9
/* LinuxCNC's min_arc_angle (emccanon.cc). */
#define SAME_ANGLE 1e-12

void motion_commands_fill(struct interp *interp, struct canon_move *move)
{
	const struct state *state = &interp->state;

	move->file = interp->at.file;
	move->line = interp->at.line;
	move->number = ++interp->moves;
	move->tcp = state->tcp != TCP_OFF;
	move->plane = state->tcp == TCP_BY_PLANE;
	move->blend = state->blend;
	move->blend_tolerance = state->blend_tolerance;
	move->spindle_turns |= state->spindle != SPINDLE_STOPPED;
}

bool motion_commands_emit(struct interp *interp, const struct canon_move *move)
{
	struct canon_move full = *move;

	motion_commands_fill(interp, &full);
	return cutter_comp_emit(interp, &full);
}

bool motion_commands_go(struct interp *interp, const slot_values *target, struct canon_move *move)
{
	struct state *state = &interp->state;
	slot_values position = rotated_frame_position(state, target);

	if (!dynamic_work_offset_check_turn(interp, &position))
		return false;
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		double here = state->position.v[slot], there = position.v[slot];

		if (here < there || here > there)
			state_set_position(state, slot, there);
	}
	move->end = state->canonical;
	return motion_commands_emit(interp, move);
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
	const char *letters = traits_of(interp)->dwell_letters;
	char letter = *letters;
	double seconds = 0;

	for (; *letters; letters++)
		letter = block_has(block, *letters) ? *letters : letter;
	if (!motion_commands_seconds(interp, letter, &seconds))
		return false;
	if (seconds < 0)
		return fault(&interp->at, block_column(block, letter), "a dwell cannot be negative");
	return motion_commands_emit(interp, &(struct canon_move){.kind = CANON_DWELL, .seconds = seconds});
}

/* LinuxCNC's manual, "Feed Rate" and "G93, G94, G95". */
bool motion_commands_feed(struct interp *interp, struct canon_feed *feed)
{
	const struct block *block = &interp->block;
	const struct state *state = &interp->state;
	int column = block_motion_column(block), code = block->motion / 10;
	double per_second = 1 / SECONDS_PER_MINUTE;

	*feed = (struct canon_feed){0};
	if (state->feed_mode == FEED_INVERSE_TIME) {
		if (!block_has(block, 'F'))
			return fault(&interp->at, column, "G%d without F in inverse time mode (G93)", code);
		feed->inverse_time = true;
		feed->seconds = SECONDS_PER_MINUTE / block_value(block, 'F');
		if (!(block_value(block, 'F') > 0) || !isfinite(feed->seconds))
			return fault(&interp->at, block_column(block, 'F'),
				     "F must be greater than 0 in inverse time mode (G93)");
		return true;
	}
	if (!(state->feed_linear > 0))
		return fault(&interp->at, column, "G%d without a feed rate (F)", code);
	if (state->feed_mode == FEED_PER_REVOLUTION) {
		if (!(state->speed > 0))
			return fault(&interp->at, column,
				     "G%d in feed per revolution (G95) without a spindle speed (S)", code);
		per_second *= state->speed;
	}
	feed->linear = state->feed_linear * per_second;
	feed->angular = radians(state->feed_angular) * per_second;
	return true;
}

/* G53 suspends work offsets, turned coordinates, length compensation and TCP for one block. */
static bool go_straight(struct interp *interp, bool machine)
{
	const struct block *block = &interp->block;
	const struct dialect_traits *traits = traits_of(interp);
	struct canon_move move = {.kind = block->motion == G0 ? CANON_RAPID : CANON_FEED};
	struct suspended suspended;
	slot_values target;
	bool named[SLOT_COUNT];
	int column;

	if (machine && move.kind == CANON_FEED &&
	    !is_answered(interp, block->g_column[G_NONMODAL], traits->g53_rate, "whether G53 with G1 moves at the feed"))
		return false;
	if (machine && traits->g53_rate == G53_RATE_RAPID)
		move.kind = CANON_RAPID;
	if (move.kind == CANON_FEED && !(block->letters & AXIS_BITS)) {
		if (!is_answered(interp, block_motion_column(block), traits->empty_feed_move,
				 "whether G1 without an axis word needs a feed rate"))
			return false;
		if (traits->empty_feed_move == EMPTY_FEED_MOVE_IGNORED)
			return true;
	}
	if (move.kind == CANON_FEED && !motion_commands_feed(interp, &move.feed))
		return false;
	interp->comp.arc_refused = false;
	if (!machine && cutter_comp_is_on(interp))
		return endpoint_find(interp, false, &target) && cutter_comp_line(interp, &target, &move);
	if (!machine)
		return endpoint_find(interp, false, &target) && motion_commands_go(interp, &target, &move);
	column = block->g_column[G_NONMODAL];
	if (!tool_length_suspend(interp, column, &suspended) || !endpoint_find(interp, true, &target) ||
	    !motion_commands_go(interp, &target, &move) || !tool_length_resume(interp, column, &suspended))
		return false;
	for (int slot = 0; slot < SLOT_COUNT; slot++)
		named[slot] = block_has(block, AXIS_LETTERS[slot]);
	tool_length_after_machine(interp, G53, named);
	return true;
}

/* The axes of an arc's plane, and the letters of its centre. */
struct arc_plane {
	int code;
	enum axis_slot a, b;
	char centre_a, centre_b, not_used;
	vec3 normal;
};

static const struct arc_plane *find_plane(int code)
{
	static const struct arc_plane planes[] = {{G17, SLOT_X, SLOT_Y, 'I', 'J', 'K', {0, 0, 1}},
						  {G18, SLOT_Z, SLOT_X, 'K', 'I', 'J', {0, 1, 0}},
						  {G19, SLOT_Y, SLOT_Z, 'J', 'K', 'I', {1, 0, 0}}};

	return &planes[code == G17 ? 0 : code == G18 ? 1 : 2];
}

/* One coordinate of the centre: as an offset from the start (G91.1), or in program coordinates (G90.1). */
static bool centre_word(struct interp *interp, char letter, enum axis_slot slot, double start, double *value)
{
	const struct block *block = &interp->block;
	const struct state *state = &interp->state;

	if (state->arc_absolute && !block_has(block, letter))
		return fault(&interp->at, block_motion_column(block),
			     "an arc with an absolute centre (G90.1) needs both its words; %c is missing", letter);
	*value = block_has(block, letter) ? block_value(block, letter) * state->scale : 0;
	*value += state->arc_absolute ? state->offset.v[slot] : start;
	return true;
}

static bool find_arc_by_centre(struct interp *interp, const struct arc_plane *plane, struct plane_point start,
			       struct plane_point end, struct plane_point *centre)
{
	const struct state *state = &interp->state;
	const struct arc_tolerance *tolerance = state->scale > 1 ? &arc_tolerance_inch : &arc_tolerance_mm;
	int column = block_motion_column(&interp->block);
	double r0, r1;

	if (block_has(&interp->block, plane->not_used))
		return fault(&interp->at, block_column(&interp->block, plane->not_used),
			     "%c does not belong to the centre of an arc in the plane of G%d", plane->not_used,
			     plane->code / 10);
	if (!centre_word(interp, plane->centre_a, plane->a, start.a, &centre->a) ||
	    !centre_word(interp, plane->centre_b, plane->b, start.b, &centre->b))
		return false;
	switch (arc_check_centre(start, end, *centre, tolerance, &r0, &r1)) {
	case ARC_ZERO_RADIUS:
		return fault(&interp->at, column, "an arc of radius 0: %.6g mm at its start, %.6g mm at its end", r0,
			     r1);
	case ARC_RADII_DIFFER:
		return fault(&interp->at, column,
			     "the radius of the arc is %.6g mm at its start and %.6g mm at its end", r0, r1);
	default:
		return true;
	}
}

static bool find_arc_by_radius(struct interp *interp, const struct arc_plane *plane, struct plane_point start,
			       struct plane_point end, struct plane_point *centre)
{
	const struct block *block = &interp->block;
	const struct arc_tolerance *tolerance = interp->state.scale > 1 ? &arc_tolerance_inch : &arc_tolerance_mm;
	double radius = block_value(block, 'R') * interp->state.scale;
	int column = block_column(block, 'R');
	char a = AXIS_LETTERS[plane->a], b = AXIS_LETTERS[plane->b];

	if (block->letters & (letter_bit('I') | letter_bit('J') | letter_bit('K')))
		return fault(&interp->at, column, "an arc has a radius (R) or a centre (I, J, K), not both");
	if (!block_has(block, a) && !block_has(block, b))
		return fault(&interp->at, column, "an arc by its radius needs %c or %c", a, b);
	switch (arc_find_centre(start, end, radius, block->motion == G2, tolerance, centre)) {
	case ARC_NO_CHORD:
		return fault(&interp->at, column,
			     "an arc by its radius (R) cannot end where it starts; a full circle has a centre "
			     "(I, J, K)");
	case ARC_RADIUS_TOO_SMALL:
		return fault(&interp->at, column,
			     "a radius of %.6g mm does not reach from the start of the arc to its end", fabs(radius));
	default:
		return true;
	}
}

static vec3 centre_in_space(const struct state *state, const slot_values *start, const struct arc_plane *plane,
			    struct plane_point centre)
{
	double xyz[3] = {start->v[SLOT_X], start->v[SLOT_Y], start->v[SLOT_Z]};

	xyz[plane->a] = centre.a;
	xyz[plane->b] = centre.b;
	return rotated_frame_point(state, (vec3){xyz[0], xyz[1], xyz[2]});
}

/* The full turns that the block's P adds to, if it does. */
static bool find_turns(struct interp *interp, int *turns)
{
	enum answer has_turns = traits_of(interp)->arcs_have_turns;

	return is_answered(interp, block_column(&interp->block, 'P'), has_turns,
			   "whether P of G2 and G3 is a number of turns") &&
	       (has_turns == ANSWER_NO || block_integer(&interp->block, &interp->at, 'P', 1, INT_MAX, turns));
}

/* LinuxCNC's manual, "G2, G3 Arc Move". */
static bool go_arc(struct interp *interp)
{
	const struct block *block = &interp->block;
	const struct state *state = &interp->state;
	const struct arc_plane *plane = find_plane(state->plane);
	const uint32_t offsets = letter_bit('I') | letter_bit('J') | letter_bit('K');
	const bool *has_axis = interp->config->has_axis;
	struct canon_move move = {.kind = CANON_ARC};
	struct plane_point start, end, centre;
	slot_values here = rotated_frame_straight(state), target;
	int turns = 1;

	if (!has_axis[plane->a] || !has_axis[plane->b])
		return fault(&interp->at, block_motion_column(block),
			     "the machine has no %c axis, which an arc in the plane of G%d needs",
			     AXIS_LETTERS[has_axis[plane->a] ? plane->b : plane->a], plane->code / 10);
	if (!block_has(block, 'R') && !(block->letters & offsets))
		return fault(&interp->at, block_motion_column(block),
			     "an arc needs a centre (I, J, K) or a radius (R)");
	if (!motion_commands_feed(interp, &move.feed) || !endpoint_find(interp, false, &target))
		return false;
	/* LinuxCNC gives P to the arc and to a G64 of the block. */
	if (block_has(block, 'P') && !find_turns(interp, &turns))
		return false;
	start = (struct plane_point){here.v[plane->a], here.v[plane->b]};
	end = (struct plane_point){target.v[plane->a], target.v[plane->b]};
	if (block_has(block, 'R') ? !find_arc_by_radius(interp, plane, start, end, &centre)
				  : !find_arc_by_centre(interp, plane, start, end, &centre))
		return false;
	if (interp->comp.arc_refused)
		return fault(&interp->at, block_motion_column(block),
			     "the move after cutter compensation (G40) must be straight, not an arc");
	if (cutter_comp_is_on(interp))
		return cutter_comp_arc(interp, &target, centre, turns, &move);
	move.arc.centre = centre_in_space(state, &here, plane, centre);
	move.arc.normal = rotated_frame_direction(state, plane->normal);
	move.arc.sweep = arc_sweep(start, end, centre, block->motion == G2, turns,
				   fmax(SAME_ANGLE, SAME_POINT / hypot(start.a - centre.a, start.b - centre.b)));
	return motion_commands_go(interp, &target, &move);
}

bool motion_commands_motion(struct interp *interp)
{
	const struct block *block = &interp->block;
	struct state *state = &interp->state;

	if (!dynamic_work_offset_check_cut(interp) || !length_change_go(interp))
		return false;
	if (block->motion == CODE_NONE)
		return true;
	if (code_is_cycle(block->motion))
		return canned_cycle_run(interp);
	state->cycle.has_level = false;
	switch (block->motion) {
	case G80:
		state->motion = CODE_NONE;
		return true;
	case G0:
	case G1:
		state->motion = block->motion;
		return go_straight(interp, block->g[G_NONMODAL] == G53);
	case G2:
	case G3:
		state->motion = block->motion;
		return go_arc(interp);
	default:
		return feedback_moves_run(interp);
	}
}
