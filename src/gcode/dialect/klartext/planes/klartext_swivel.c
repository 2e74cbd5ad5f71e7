#include "gcode/dialect/klartext/planes/klartext_swivel.h"

#include <math.h>
#include <stdio.h>

#include "base/math/math_functions.h"
#include "base/units.h"
#include "gcode/dialect/klartext/frames/klartext_frame.h"
#include "gcode/dialect/klartext/moves/klartext_comp.h"
#include "gcode/dialect/klartext/moves/klartext_move.h"
#include "gcode/dialect/klartext/planes/klartext_free_axis.h"
#include "gcode/dialect/klartext/planes/klartext_orient.h"
#include "gcode/dialect/klartext/values/klartext_value.h"
#include "gcode/execute/motion_commands.h"
#include "gcode/execute/tool_length.h"
#include "geom/tolerance.h"

/* -------------------------------------------------------------- the choice */

static void write_axes(const struct interp *interp, const struct kinematics_solution *solution, char *text, size_t size)
{
	size_t length = 0;

	text[0] = '\0';
	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		if (!interp->config->has_axis[slot])
			continue;
		length += (size_t)snprintf(text + length, size - length, "%s%c%.6g", length ? " " : "",
					   AXIS_LETTERS[slot], degrees(solution->rotary.v[slot]) + 0.0);
		if (length >= size)
			return;
	}
}

static double angle_of(const struct interp *interp, const struct kinematics_solution *solution, int slot)
{
	return state_from_canonical(slot, solution->rotary.v[slot]) - interp->state.offset.v[slot];
}

/* "SEQ+": the first rotary axis, counted from the tool, has a positive angle; "SEQ-": a negative angle. */
static bool has_sign(const struct interp *interp, const struct kinematics_solutions *solutions, size_t i, int sign)
{
	double angle = angle_of(interp, &solutions->items[i], solutions->primary);

	return sign == 0 || fabs(angle) < degrees(TIE_TOLERANCE) || (angle > 0) == (sign > 0);
}

/*
 * "SYM": the sign counts from the angle about which the two positions are symmetrical. This angle is 0 on nearly all
 * machines.
 */
static bool check_symmetry(const struct interp *interp, const struct klartext_swivel *request,
			   const struct kinematics_solutions *solutions)
{
	if (!request->symmetric || solutions->count < 2 ||
	    fabs(remainder(angle_of(interp, &solutions->items[0], solutions->primary) +
			       angle_of(interp, &solutions->items[1], solutions->primary),
			   360)) <= SAME_DEGREES)
		return true;
	return fault(&interp->at, request->column,
		     "SYM where the positions of %c are not symmetrical about 0 is not supported; write SEQ+ or SEQ-",
		     AXIS_LETTERS[solutions->primary]);
}

/*
 * iTNC 530 user's manual, "Selection of alternate tilting possibilities": without SEQ the control takes the shorter way
 * within the limits. It is certain which of two ways is shorter only if no axis has a longer way to that position. If
 * both are equally long, the table of the manual has the position of SEQ+: from A+0 C+0 to A+45 C+90, not to A-45 C-90.
 * The ways begin at `from`.
 */
static bool choose(struct interp *interp, const struct klartext_swivel *request, const axis_values *from,
		   const struct kinematics_solutions *solutions, const struct kinematics_solution **chosen)
{
	size_t fitting[2] = {0, 0}, count = 0;
	bool first, second;
	char texts[2][64];

	if (!check_symmetry(interp, request, solutions))
		return false;
	for (size_t i = 0; i < solutions->count; i++) {
		if (solutions->items[i].within_limits && has_sign(interp, solutions, i, request->sign))
			fitting[count++] = i;
	}
	if (count == 0)
		return fault(
		    &interp->at, request->column,
		    solutions->count == 0 ? "the rotary axes of this machine cannot stand the tool on this plane"
		    : request->sign	  ? "no position of the rotary axes within their limits has the tool stand on "
					    "this plane with this SEQ"
				    : "within the limits of their travel, the rotary axes cannot stand the tool on "
				      "this plane");
	*chosen = &solutions->items[fitting[0]];
	if (count == 1)
		return true;
	first = klartext_orient_is_no_farther(from, &solutions->items[fitting[0]], &solutions->items[fitting[1]]);
	second = klartext_orient_is_no_farther(from, &solutions->items[fitting[1]], &solutions->items[fitting[0]]);
	if (first != second) {
		*chosen = &solutions->items[first ? fitting[0] : fitting[1]];
		return true;
	}
	write_axes(interp, &solutions->items[0], texts[0], sizeof(texts[0]));
	write_axes(interp, &solutions->items[1], texts[1], sizeof(texts[1]));
	if (request->from_zero)
		return fault(&interp->at, request->column,
			     "CYCL DEF 19 could turn to %s or to %s: which one the control takes is not known here; "
			     "write PLANE SPATIAL with SEQ+ or SEQ-",
			     texts[0], texts[1]);
	if (first) {
		const size_t positive = has_sign(interp, solutions, fitting[0], 1) ? 0 : 1;

		*chosen = &solutions->items[fitting[positive]];
		caution(&interp->at, request->column,
			"PLANE could turn to %s or to %s, which is as near: %s is taken, as SEQ+ does", texts[0],
			texts[1], texts[fitting[positive]]);
		return true;
	}
	return fault(&interp->at, request->column,
		     "PLANE could turn to %s or to %s: which one the control takes is not known here; write SEQ+ or "
		     "SEQ-, or turn the rotary axes towards the one that is meant before",
		     texts[0], texts[1]);
}

/*
 * Refuses turns whose way is not certain: half a turn, or a turn of an axis that counts whole turns. False: reported.
 */
static bool check_ways(struct interp *interp, const struct klartext_swivel *request,
		       const struct kinematics_solution *chosen)
{
	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		double to = state_from_canonical(slot, chosen->rotary.v[slot]);

		if (chosen->tie[slot])
			return fault(&interp->at, request->column,
				     "half a turn of %c: either way is as short; set half_turn=\"positive\" or "
				     "\"negative\" of this axis in the machine file",
				     AXIS_LETTERS[slot]);
		if (interp->config->wrap[slot] == WRAP_NONE && !chosen->free[slot] &&
		    fabs(to - interp->state.offset.v[slot]) > 180 + SAME_DEGREES)
			return fault(
			    &interp->at, request->column,
			    "PLANE turns %c to %.6g or to an angle whole turns away: which one the control takes "
			    "is not known here; turn %c towards 0 before, or set wrap=\"shortest\" of this axis in "
			    "the machine file",
			    AXIS_LETTERS[slot], to, AXIS_LETTERS[slot]);
	}
	return true;
}

/* The start of the ways to two positions: the present position for PLANE, the zero of the axes for cycle 19. */
static axis_values start_of_ways(const struct interp *interp, const struct klartext_swivel *request)
{
	axis_values start = interp->state.canonical;

	for (int slot = SLOT_A; request->from_zero && slot <= SLOT_C; slot++)
		start.v[slot] = radians(interp->state.offset.v[slot]);
	return start;
}

static bool find_rotary(struct interp *interp, const struct klartext_swivel *request, const mat3 *tilt,
			slot_values *rotary)
{
	struct klartext *klartext = klartext_of(interp);
	const axis_values from = start_of_ways(interp, request);
	const struct kinematics_orientation orientation = {
	    .direction = tilt->z, .rotary_zero = tool_length_rotary_zero(interp), .rotary = from, .command = "PLANE"};
	struct kinematics_solutions solutions;
	const struct kinematics_solution *chosen = NULL;
	const enum plane_rotation asked = request->table_rot   ? PLANE_ROTATION_TABLE
					  : request->coord_rot ? PLANE_ROTATION_COORDINATES
							       : PLANE_ROTATION_UNKNOWN;

	if (!interp->kinematics->orientations(interp->kinematics->context, line_loc(&interp->at, request->column),
					      &orientation, &solutions) ||
	    !choose(interp, request, &from, &solutions, &chosen) || !check_ways(interp, request, chosen))
		return false;
	*rotary = interp->state.position;
	klartext->stay.rotary = interp->state.canonical;
	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		klartext->stay.needed[slot] = interp->config->has_axis[slot];
		if (!interp->config->has_axis[slot])
			continue;
		if (!chosen->free[slot])
			rotary->v[slot] = state_from_canonical(slot, chosen->rotary.v[slot]);
		else if (!klartext_free_axis_turn(interp, request->column, asked, chosen, tilt, slot, &rotary->v[slot]))
			return false;
		klartext->stay.rotary.v[slot] = radians(rotary->v[slot]);
		/* Q120 to Q122 receive the angles that the control has computed. */
		klartext_q_set(klartext, 120 + slot - SLOT_A, rotary->v[slot] - interp->state.offset.v[slot]);
	}
	return true;
}

/* --------------------------------------------------------------- the motion */

static bool find_feed(struct interp *interp, const struct klartext_swivel *request, struct canon_move *move)
{
	struct state *state = &interp->state;
	double linear = request->feed * (state->scale > 1 ? state->scale / 10 : 1), angular = request->feed;

	if (request->rapid) {
		move->kind = CANON_RAPID;
		return true;
	}
	if (!(request->feed > 0)) {
		linear = state->feed_linear;
		angular = state->feed_angular;
	}
	if (!(linear > 0))
		return fault(&interp->at, request->column, "PLANE ... TURN and MOVE need F or FMAX");
	move->kind = CANON_FEED;
	move->feed.linear = linear / SECONDS_PER_MINUTE;
	move->feed.angular = radians(angular) / SECONDS_PER_MINUTE;
	return true;
}

/* Retracts the tool along its axis by MB. False: reported. */
static bool retract(struct interp *interp, const struct klartext_swivel *request)
{
	struct kinematics_retract way = request->retract;
	struct canon_move move = {.kind = CANON_RAPID};
	slot_values target = interp->state.position;

	if (!request->retracts)
		return true;
	way.position = interp->state.canonical;
	if (!interp->kinematics->retract(interp->kinematics->context, line_loc(&interp->at, request->column), &way))
		return false;
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++)
		target.v[slot] = way.position.v[slot];
	return motion_commands_go(interp, &target, &move);
}

/*
 * "TURN": only the rotary axes move. "MOVE": the linear axes move with them, so that a point DIST in front of the tip
 * keeps its place on the workpiece.
 */
static bool move_rotary(struct interp *interp, const struct klartext_swivel *request, const slot_values *rotary)
{
	struct state *state = &interp->state;
	struct canon_move move = {0};
	double length = state->length;
	slot_values target;
	bool good, turns = false;

	for (int slot = SLOT_A; slot <= SLOT_C; slot++)
		turns = turns || fabs(rotary->v[slot] - state->position.v[slot]) > degrees(TIE_TOLERANCE);
	if (!turns && request->retracts && !interp->config->controller.plane_retract)
		return fault(&interp->at, request->column,
			     "MB of PLANE where no rotary axis has to turn: it is not known whether the tool "
			     "retracts: set plane_retract=\"always\" or \"turning\" in the machine file's "
			     "<controller>, or write M140 in a block before");
	if (!turns && request->retracts && interp->config->controller.plane_retract == PLANE_RETRACT_TURNING)
		return true;
	klartext_of(interp)->tool.moved = true;
	klartext_of(interp)->last.known = false;
	if (!find_feed(interp, request, &move) || !retract(interp, request))
		return false;
	if (request->positioning == KLARTEXT_TURN_TURN) {
		/* The turn starts where the retraction has ended. */
		target = interp->state.position;
		for (int slot = SLOT_A; slot <= SLOT_C; slot++)
			target.v[slot] = rotary->v[slot];
		return motion_commands_go(interp, &target, &move);
	}
	if (!klartext_comp_check_known(interp, request->column, "PLANE ... MOVE"))
		return false;
	state->length += request->distance;
	if (!tool_length_switch_tcp(interp, request->column, TCP_BY_MCODE))
		return false;
	target = state->position;
	for (int slot = SLOT_A; slot <= SLOT_C; slot++)
		target.v[slot] = rotary->v[slot];
	good = motion_commands_go(interp, &target, &move) && tool_length_switch_tcp(interp, request->column, TCP_OFF);
	state->length = length;
	state_update_offset(state);
	return good;
}

/* Does the tool keep its direction when only this axis turns from the machine's zero? */
static bool find_free(struct interp *interp, int column, int slot, bool *is_free)
{
	const axis_values zero = tool_length_rotary_zero(interp);
	const struct srcloc loc = line_loc(&interp->at, column);
	axis_values turned = zero;
	vec3 before, after;

	turned.v[slot] += PI / 2;
	if (!interp->kinematics->direction(interp->kinematics->context, loc, &zero, &zero, &before) ||
	    !interp->kinematics->direction(interp->kinematics->context, loc, &zero, &turned, &after))
		return false;
	*is_free = vec3_norm(vec3_sub(after, before)) <= DIRECTION_REACHED;
	return true;
}

/* What remains of a datum shift from before the plane, if a shift in the plane has named the same axis. */
static void leave_shift(struct interp *interp)
{
	struct klartext *klartext = klartext_of(interp);
	const enum shift_behind_plane told = interp->config->controller.shift_behind_plane;
	double *const shift[] = {&klartext->frame.shift.x, &klartext->frame.shift.y, &klartext->frame.shift.z};

	for (int slot = SLOT_X; slot <= SLOT_Z; slot++) {
		if (told == SHIFT_BEHIND_PLANE_CANCELLED && klartext->shift.in_plane & 1U << slot)
			*shift[slot] = 0;
	}
	if (!told)
		klartext->shift.open |= klartext->shift.in_plane;
	klartext->shift.in_plane = 0;
}

/* Returns to coordinates that are not tilted; the axes do not move. False: reported. */
static bool leave(struct interp *interp, int column)
{
	struct klartext *klartext = klartext_of(interp);

	klartext_comp_turn_open(interp);
	if (interp->state.tcp == TCP_BY_PLANE && !tool_length_switch_tcp(interp, column, TCP_OFF))
		return false;
	klartext->frame.tilted = klartext->stay.waits = klartext->preset.in_plane = false;
	leave_shift(interp);
	klartext->frame.tilt = mat3_identity();
	klartext_frame_update(interp);
	return true;
}

/* The manuals do not say whether Q120 to Q122 hold the positions after PLANE RESET and PLANE AXIAL. */
static void forget_angles(struct klartext *klartext)
{
	for (int number = 120; number <= 122; number++)
		klartext_q_forget(klartext, number);
}

/* "PLANE RESET": with TURN or MOVE the rotary axes go to 0. */
bool klartext_swivel_reset(struct interp *interp, const struct klartext_swivel *request)
{
	slot_values rotary;

	if (!leave(interp, request->column))
		return false;
	forget_angles(klartext_of(interp));
	if (request->positioning == KLARTEXT_TURN_STAY)
		return true;
	rotary = interp->state.position;
	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		if (interp->config->has_axis[slot])
			rotary.v[slot] = klartext_free_axis_zero(interp, slot);
		if (fabs(rotary.v[slot] - interp->state.position.v[slot]) > 180 + SAME_DEGREES)
			return fault(&interp->at, request->column,
				     "whether PLANE RESET turns %c to 0 or to a whole turn is not known here; turn it "
				     "in a block before",
				     AXIS_LETTERS[slot]);
	}
	return move_rotary(interp, request, &rotary);
}

bool klartext_swivel_level(struct interp *interp, const struct klartext_swivel *request)
{
	struct klartext *klartext = klartext_of(interp);

	if (!klartext_swivel_reset(interp, request))
		return false;
	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		const double here = interp->state.position.v[slot] - interp->state.offset.v[slot];
		bool is_free = false;

		if (!interp->config->has_axis[slot])
			continue;
		if (fabs(here) > SAME_DEGREES && interp->config->controller.swivel_pole != SWIVEL_POLE_ZERO &&
		    !find_free(interp, request->column, slot, &is_free))
			return false;
		if (!is_free || interp->config->controller.plane_rotation == PLANE_ROTATION_TABLE)
			klartext_q_set(klartext, 120 + slot - SLOT_A, 0);
		else if (interp->config->controller.swivel_pole == SWIVEL_POLE_STAYS)
			klartext_q_set(klartext, 120 + slot - SLOT_A, here);
		else
			klartext->values.q[120 + slot - SLOT_A].pole = true;
	}
	return true;
}

/*
 * Finds the target of PLANE AXIAL: the named positions. Axes that are not named must stand at 0, because no rule for
 * them is known. False: reported.
 */
static bool find_named(struct interp *interp, const struct klartext_swivel *request, unsigned axes,
		       const double angle[SLOT_COUNT], slot_values *rotary)
{
	struct klartext *klartext = klartext_of(interp);

	*rotary = interp->state.position;
	klartext->stay.rotary = interp->state.canonical;
	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		const double here = interp->state.position.v[slot] - interp->state.offset.v[slot];

		klartext->stay.needed[slot] = interp->config->has_axis[slot];
		if (!interp->config->has_axis[slot])
			continue;
		if (!(axes & 1U << slot) && fabs(here) > SAME_DEGREES)
			return fault(
			    &interp->at, request->column,
			    "%c is not named here and stands at %.6g: what it does is not known here; name it, "
			    "too",
			    AXIS_LETTERS[slot], here);
		if (axes & 1U << slot)
			rotary->v[slot] = angle[slot] + interp->state.offset.v[slot];
		if (interp->config->wrap[slot] != WRAP_NONE &&
		    fabs(rotary->v[slot] - interp->state.position.v[slot]) > 180 - SAME_DEGREES)
			return fault(&interp->at, request->column,
				     "%c turns by 180 degrees or more: in which direction is not known here; turn it "
				     "towards %.6g in a block before",
				     AXIS_LETTERS[slot], angle[slot]);
		klartext->stay.rotary.v[slot] = radians(rotary->v[slot]);
	}
	forget_angles(klartext);
	return true;
}

static bool tilt_to(struct interp *interp, const struct klartext_swivel *request, const mat3 *tilt,
		    const slot_values *rotary)
{
	struct klartext *klartext = klartext_of(interp);

	if (request->positioning != KLARTEXT_TURN_STAY && !move_rotary(interp, request, rotary))
		return false;
	klartext->frame.tilted = true;
	klartext->frame.tilt = *tilt;
	klartext_frame_update(interp);
	klartext->stay.waits =
	    request->positioning == KLARTEXT_TURN_STAY && !klartext_move_in_plane(interp, &interp->state.position);
	return klartext->stay.waits || tool_length_switch_tcp(interp, request->column, TCP_BY_PLANE);
}

bool klartext_swivel_tilt(struct interp *interp, const struct klartext_swivel *request, const mat3 *tilt)
{
	slot_values rotary;

	return leave(interp, request->column) && find_rotary(interp, request, tilt, &rotary) &&
	       tilt_to(interp, request, tilt, &rotary);
}

/*
 * TNC 407 and 426 user's manuals, "WORKING PLANE (Cycle 19)": with a swivel head the coordinate system turns with the
 * tool; with a tilting table it does not turn relative to the machine. No manual was found for the assumption that
 * PLANE AXIAL does the same.
 */
bool klartext_swivel_axial(struct interp *interp, const struct klartext_swivel *request, unsigned axes,
			   const double angle[SLOT_COUNT])
{
	struct kinematics_turn turn = {.rotary_zero = tool_length_rotary_zero(interp)};
	slot_values rotary;

	if (!leave(interp, request->column) || !find_named(interp, request, axes, angle, &rotary))
		return false;
	turn.rotary = klartext_of(interp)->stay.rotary;
	if (!interp->kinematics->turn(interp->kinematics->context, line_loc(&interp->at, request->column), &turn))
		return false;
	if (vec3_norm(vec3_sub(turn.turn.z, turn.tool)) > DIRECTION_REACHED)
		return fault(
		    &interp->at, request->column,
		    "a plane by positions of the rotary axes where the spindle does not lie along Z while they "
		    "stand at 0 is not supported");
	return tilt_to(interp, request, &turn.turn, &rotary);
}
