#include "gcode/dialect/klartext/klartext_plane.h"

#include <math.h>
#include <stdio.h>

#include "base/same_double.h"
#include "base/units.h"
#include "gcode/dialect/klartext/klartext_comp.h"
#include "gcode/dialect/klartext/klartext_frame.h"
#include "gcode/dialect/klartext/klartext_lexis.h"
#include "gcode/dialect/klartext/klartext_orient.h"
#include "gcode/dialect/klartext/klartext_tilt.h"
#include "gcode/dialect/klartext/klartext_value.h"
#include "gcode/execute/motion_commands.h"
#include "gcode/execute/tool_length.h"
#include "geom/tolerance.h"

enum positioning { POSITION_UNKNOWN, POSITION_MOVE, POSITION_TURN, POSITION_STAY };

/* The words behind the plane itself. */
struct request {
	enum positioning positioning;
	double distance; /* DIST of MOVE, mm */
	bool rapid;
	double feed; /* bare; 0: that in force */
	int sign; /* SEQ+ 1, SEQ- -1, 0: none */
	bool table_rot, coord_rot;
	bool retracts; /* MB: along the tool before the rotary axes turn */
	struct kinematics_retract retract;
	int column;
};

/* ------------------------------------------------------------------- words */

static bool read_feed(struct lexer *lexer, struct request *request)
{
	if (klartext_take(lexer, "MAX")) {
		request->rapid = true;
		return true;
	}
	if (klartext_take(lexer, "AUTO"))
		return true;
	return klartext_value(lexer, &request->feed);
}

/* "PLANE ... TURN MB": how far the tool retracts along its axis before it turns; MAX: up to the limit of travel. */
static bool read_retract(struct lexer *lexer, struct request *request)
{
	const struct interp *interp = lexer->context;
	int column = klartext_column(lexer);

	request->retracts = true;
	request->retract.to_limit = klartext_take(lexer, "MAX");
	if (request->retract.to_limit)
		return true;
	if (!klartext_value(lexer, &request->retract.distance))
		return false;
	request->retract.distance *= interp->state.scale;
	return request->retract.distance >= 0 || fault(lexer->at, column, "the way of MB cannot be negative");
}

static bool read_option(struct lexer *lexer, struct request *request)
{
	const struct interp *interp = lexer->context;
	int column = klartext_column(lexer);

	if (klartext_take(lexer, "MOVE"))
		request->positioning = POSITION_MOVE;
	else if (klartext_take(lexer, "TURN"))
		request->positioning = POSITION_TURN;
	else if (klartext_take(lexer, "STAY"))
		request->positioning = POSITION_STAY;
	else if (klartext_take(lexer, "SEQ+"))
		request->sign = 1;
	else if (klartext_take(lexer, "SEQ-"))
		request->sign = -1;
	else if (klartext_take(lexer, "FMAX"))
		request->rapid = true;
	else if (klartext_take(lexer, "F"))
		return read_feed(lexer, request);
	else if (klartext_take(lexer, "DIST") || klartext_take(lexer, "ABST")) {
		if (!klartext_value(lexer, &request->distance))
			return false;
		request->distance *= interp->state.scale;
	} else if (klartext_take(lexer, "TABLE") && klartext_take(lexer, "ROT"))
		request->table_rot = true;
	else if (klartext_take(lexer, "COORD") && klartext_take(lexer, "ROT"))
		request->coord_rot = true;
	else if (klartext_take(lexer, "MB"))
		return read_retract(lexer, request);
	else if (klartext_take(lexer, "SYM"))
		return fault(lexer->at, column, "SYM is not supported yet: write SEQ+ or SEQ-");
	else
		return fault(lexer->at, column, "this is no word of PLANE");
	return true;
}

static bool read_options(struct lexer *lexer, struct request *request)
{
	while (!klartext_ends(lexer)) {
		if (!read_option(lexer, request))
			return false;
	}
	if (request->retracts && request->positioning == POSITION_STAY)
		return fault(lexer->at, request->column, "MB of PLANE needs TURN or MOVE");
	return request->positioning != POSITION_UNKNOWN ||
	       fault(lexer->at, request->column, "PLANE needs MOVE, TURN or STAY: what the rotary axes do");
}

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

/* "SEQ+": the first rotary axis as seen from the tool stands at a positive angle; "SEQ-": at a negative one. */
static bool has_sign(const struct interp *interp, const struct kinematics_solutions *solutions, size_t i, int sign)
{
	double angle = angle_of(interp, &solutions->items[i], solutions->primary);

	return sign == 0 || fabs(angle) < degrees(TIE_TOLERANCE) || (angle > 0) == (sign > 0);
}

/*
 * iTNC 530 user's manual, "Selection of alternate tilting possibilities": without SEQ the shorter way is taken, of
 * those within the limits. Which of two ways is shorter is certain only where no axis has a longer one.
 */
static bool choose(struct interp *interp, const struct request *request, const struct kinematics_solutions *solutions,
		   const struct kinematics_solution **chosen)
{
	size_t fitting[2] = {0, 0}, count = 0;
	char texts[2][64];

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
	if (klartext_orient_is_no_farther(interp, &solutions->items[fitting[0]], &solutions->items[fitting[1]]) !=
	    klartext_orient_is_no_farther(interp, &solutions->items[fitting[1]], &solutions->items[fitting[0]])) {
		*chosen = &solutions->items[klartext_orient_is_no_farther(interp, &solutions->items[fitting[0]],
									  &solutions->items[fitting[1]])
						? fitting[0]
						: fitting[1]];
		return true;
	}
	write_axes(interp, &solutions->items[0], texts[0], sizeof(texts[0]));
	write_axes(interp, &solutions->items[1], texts[1], sizeof(texts[1]));
	return fault(&interp->at, request->column,
		     "PLANE could turn to %s or to %s: which one the control takes is not known here; write SEQ+ or "
		     "SEQ-, or turn "
		     "the rotary axes towards the one that is meant before",
		     texts[0], texts[1]);
}

/*
 * A rotary axis that any angle suits, and other turns of an axis. COORD ROT leaves a free axis where it is on some
 * controls and takes it to 0 on others; TABLE ROT turns it: all agree where nothing is to be turned.
 */
static bool check_free(struct interp *interp, const struct request *request, const struct kinematics_solution *chosen,
		       const mat3 *tilt)
{
	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		double here = interp->state.position.v[slot] - interp->state.offset.v[slot];
		double to = state_from_canonical(slot, chosen->rotary.v[slot]);

		if (chosen->free[slot] && fabs(remainder(here, 360)) > SAME_DEGREES &&
		    !interp->config->controller.swivel_pole)
			return fault(&interp->at, request->column,
				     "any angle of %c suits this plane, and it stands at %.6g: whether the control "
				     "leaves it there or turns it to 0 depends on its generation: "
				     "swivel_pole=\"stays\" or \"zero\" of the machine's <controller> says it, or turn "
				     "%c to 0 in a block before",
				     AXIS_LETTERS[slot], here, AXIS_LETTERS[slot]);
		if (chosen->free[slot] && interp->config->controller.swivel_pole == SWIVEL_POLE_ZERO &&
		    fabs(here) > 180 + SAME_DEGREES)
			return fault(&interp->at, request->column,
				     "PLANE turns %c to 0 or to a whole turn: which one the control takes is not known "
				     "here; turn %c towards 0 in a block before",
				     AXIS_LETTERS[slot], AXIS_LETTERS[slot]);
		if (chosen->free[slot] && request->table_rot && fabs(tilt->x.y) + fabs(tilt->x.z) > DIRECTION_REACHED)
			return fault(
			    &interp->at, request->column,
			    "TABLE ROT where any angle of %c suits the plane is not supported yet; write COORD ROT",
			    AXIS_LETTERS[slot]);
		if (chosen->free[slot] && !request->coord_rot && fabs(tilt->x.y) + fabs(tilt->x.z) > DIRECTION_REACHED)
			return fault(
			    &interp->at, request->column,
			    "any angle of %c suits this plane: write COORD ROT, which turns the coordinates alone",
			    AXIS_LETTERS[slot]);
		if (chosen->tie[slot])
			return fault(&interp->at, request->column,
				     "half a turn of %c: either way is as short; half_turn=\"positive\" or "
				     "\"negative\" of this axis in "
				     "the machine file says which one the control takes",
				     AXIS_LETTERS[slot]);
		if (interp->config->wrap[slot] == WRAP_NONE && !chosen->free[slot] &&
		    fabs(to - interp->state.offset.v[slot]) > 180 + SAME_DEGREES)
			return fault(
			    &interp->at, request->column,
			    "PLANE turns %c to %.6g or to an angle whole turns away: which one the control takes is "
			    "not known "
			    "here; turn %c towards 0 before, or say wrap=\"shortest\" of this axis in the machine file",
			    AXIS_LETTERS[slot], to, AXIS_LETTERS[slot]);
	}
	return true;
}

static bool find_rotary(struct interp *interp, const struct request *request, const mat3 *tilt, slot_values *rotary)
{
	struct klartext *klartext = klartext_of(interp);
	const struct kinematics_orientation orientation = {.direction = tilt->z,
							   .rotary_zero = tool_length_rotary_zero(interp),
							   .rotary = interp->state.canonical,
							   .command = "PLANE"};
	struct kinematics_solutions solutions;
	const struct kinematics_solution *chosen = NULL;

	if (!interp->kinematics->orientations(interp->kinematics->context, line_loc(&interp->at, request->column),
					      &orientation, &solutions) ||
	    !choose(interp, request, &solutions, &chosen) || !check_free(interp, request, chosen, tilt))
		return false;
	*rotary = interp->state.position;
	klartext->rotary = interp->state.canonical;
	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		klartext->rotary_needed[slot] = interp->config->has_axis[slot];
		if (!interp->config->has_axis[slot])
			continue;
		rotary->v[slot] = state_from_canonical(slot, chosen->rotary.v[slot]);
		if (chosen->free[slot] && interp->config->controller.swivel_pole == SWIVEL_POLE_ZERO)
			rotary->v[slot] = interp->state.offset.v[slot];
		klartext->rotary.v[slot] = radians(rotary->v[slot]);
		/* Q120 to Q122: the angles that the control has computed. */
		klartext_q_set(klartext, 120 + slot - SLOT_A, rotary->v[slot] - interp->state.offset.v[slot]);
	}
	return true;
}

/* --------------------------------------------------------------- the motion */

static bool find_feed(struct interp *interp, const struct request *request, struct canon_move *move)
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

/* MB. */
static bool retract(struct interp *interp, const struct request *request)
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
 * "TURN": the rotary axes alone; "MOVE": the linear axes with them, so that a point DIST in front of the tip keeps its
 * place on the workpiece.
 */
static bool move_rotary(struct interp *interp, const struct request *request, const slot_values *rotary)
{
	struct state *state = &interp->state;
	struct canon_move move = {0};
	double length = state->length;
	slot_values target;
	bool good, turns = false;

	for (int slot = SLOT_A; slot <= SLOT_C; slot++)
		turns = turns || fabs(rotary->v[slot] - state->position.v[slot]) > degrees(TIE_TOLERANCE);
	if (!turns && request->retracts)
		return fault(
		    &interp->at, request->column,
		    "MB of PLANE where no rotary axis has to turn: whether the tool retracts is not known here; "
		    "write M140 in a block before");
	klartext_of(interp)->moved = true;
	klartext_of(interp)->last.known = false;
	if (!find_feed(interp, request, &move) || !retract(interp, request))
		return false;
	if (request->positioning == POSITION_TURN) {
		/* From where the retraction has ended. */
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

/* Back to coordinates that are not tilted; the axes stand still. */
static bool leave_plane(struct interp *interp, int column)
{
	struct klartext *klartext = klartext_of(interp);

	klartext_comp_turn_open(interp);
	if (interp->state.tcp == TCP_BY_PLANE && !tool_length_switch_tcp(interp, column, TCP_OFF))
		return false;
	klartext->frame.tilted = klartext->waits = klartext->preset_in_plane = false;
	klartext->frame.tilt = mat3_identity();
	klartext_frame_update(&klartext->frame);
	return true;
}

/* "PLANE RESET": with TURN or MOVE the rotary axes go to 0. */
static bool reset(struct interp *interp, const struct request *request)
{
	slot_values rotary;

	if (!leave_plane(interp, request->column))
		return false;
	if (request->positioning == POSITION_STAY)
		return true;
	rotary = interp->state.position;
	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		if (interp->config->has_axis[slot])
			rotary.v[slot] = interp->state.offset.v[slot];
		if (fabs(rotary.v[slot] - interp->state.position.v[slot]) > 180 + SAME_DEGREES)
			return fault(&interp->at, request->column,
				     "whether PLANE RESET turns %c to 0 or to a whole turn is not known here; turn it "
				     "in a block before",
				     AXIS_LETTERS[slot]);
	}
	return move_rotary(interp, request, &rotary);
}

static bool tilt_plane(struct interp *interp, const struct request *request, const mat3 *tilt)
{
	struct klartext *klartext = klartext_of(interp);
	slot_values rotary;
	bool there = true;

	if (!leave_plane(interp, request->column) || !find_rotary(interp, request, tilt, &rotary))
		return false;
	for (int slot = SLOT_A; slot <= SLOT_C; slot++)
		there = there && fabs(rotary.v[slot] - interp->state.position.v[slot]) <= degrees(TIE_TOLERANCE);
	if (request->positioning != POSITION_STAY && !move_rotary(interp, request, &rotary))
		return false;
	klartext->frame.tilted = true;
	klartext->frame.tilt = *tilt;
	klartext_frame_update(&klartext->frame);
	klartext->waits = request->positioning == POSITION_STAY && !there;
	return klartext->waits || tool_length_switch_tcp(interp, request->column, TCP_BY_PLANE);
}

static bool check(struct interp *interp, int column)
{
	const struct klartext *klartext = klartext_of(interp);

	if (interp->state.tcp == TCP_BY_MCODE)
		return fault(&interp->at, column, "PLANE while M128 is in force is not supported; M129 first");
	if (klartext_frame_is_inner(&klartext->frame))
		return fault(&interp->at, column,
			     "PLANE while a mirror image, a rotation, a scaling or a shift of tilted coordinates is in "
			     "force: cancel "
			     "it first, the last one first");
	return true;
}

bool klartext_plane_run(struct lexer *lexer)
{
	struct interp *interp = lexer->context;
	struct klartext *klartext = klartext_of(interp);
	struct request request = {.column = klartext_column(lexer)};
	bool is_reset;
	mat3 tilt;

	if (!klartext_tilt_read(lexer, &klartext->frame.tilt, &tilt, &is_reset) || !read_options(lexer, &request) ||
	    !check(interp, request.column) || !klartext_frame_check_preset(interp, request.column))
		return false;
	return is_reset ? reset(interp, &request) : tilt_plane(interp, &request, &tilt);
}

/* The angles of cycle 19, and whether any of them is not 0. False: reported. */
static bool read_cycle(struct interp *interp, const struct klartext_cycle *cycle, double angle[3], bool *any)
{
	*any = false;
	for (int i = 0; i < cycle->count; i++) {
		const struct klartext_cycle_word *word = &cycle->words[i];
		int slot = word->name[1] == '\0' ? slot_of_letter(word->name[0]) : -1;

		if (slot >= SLOT_A && slot <= SLOT_C && word->given) {
			angle[slot - SLOT_A] = word->value;
			*any = *any || !same_double(word->value, 0);
		} else if (word->given) {
			return fault(
			    &interp->at, word->column,
			    "F and a clearance of CYCL DEF 19 let the control turn the rotary axes itself: that is not "
			    "supported yet; turn them by Q120 to Q122");
		}
	}
	return true;
}

/*
 * "WORKING PLANE (Cycle 19)": a machine parameter says whether its angles are spatial angles or positions of the
 * rotary axes. Without angles, or with 0 alone, it takes the tilting back. No axis moves: the program turns the rotary
 * axes to Q120 to Q122.
 */
bool klartext_plane_cycle(struct interp *interp, const struct klartext_cycle *cycle)
{
	const struct request request = {.positioning = POSITION_STAY, .coord_rot = true, .column = cycle->column};
	double angle[3] = {0, 0, 0};
	mat3 tilt;
	bool any;

	if (!read_cycle(interp, cycle, angle, &any) || !check(interp, cycle->column))
		return false;
	if (!any)
		return leave_plane(interp, cycle->column);
	if (interp->config->controller.cycle_19_angles == CYCLE_19_ANGLES_AXES)
		return fault(&interp->at, cycle->column,
			     "CYCL DEF 19 by positions of the rotary axes is not supported yet; write PLANE SPATIAL");
	if (interp->config->controller.cycle_19_angles == CYCLE_19_ANGLES_UNKNOWN)
		return fault(&interp->at, cycle->column,
			     "a machine parameter says what the angles of CYCL DEF 19 are: cycle_19_angles=\"spatial\" "
			     "or \"axes\" of "
			     "the machine's <controller> says it, or write PLANE SPATIAL");
	tilt = klartext_tilt_spatial(angle);
	return klartext_frame_check_preset(interp, cycle->column) && tilt_plane(interp, &request, &tilt);
}
