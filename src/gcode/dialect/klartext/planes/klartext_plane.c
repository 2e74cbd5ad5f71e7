#include "gcode/dialect/klartext/planes/klartext_plane.h"

#include <math.h>
#include <string.h>

#include "base/same_double.h"
#include "gcode/dialect/klartext/frames/klartext_frame.h"
#include "gcode/dialect/klartext/frames/klartext_preset.h"
#include "gcode/dialect/klartext/planes/klartext_swivel.h"
#include "gcode/dialect/klartext/planes/klartext_tilt.h"
#include "gcode/dialect/klartext/text/klartext_lexis.h"
#include "gcode/dialect/klartext/values/klartext_value.h"
#include "geom/tolerance.h"

/* ------------------------------------------------------------------- words */

static bool read_feed(struct lexer *lexer, struct klartext_swivel *request)
{
	if (klartext_take(lexer, "MAX")) {
		request->rapid = true;
		return true;
	}
	if (klartext_take(lexer, "AUTO"))
		return true;
	return klartext_value(lexer, &request->feed);
}

/*
 * "PLANE ... TURN MB": how far the tool retracts along its axis before the rotary axes turn; MAX: up to the limit of
 * travel.
 */
static bool read_retract(struct lexer *lexer, struct klartext_swivel *request)
{
	const struct interp *interp = lexer->context;
	int column = lexer_next_column(lexer);

	request->retracts = true;
	request->retract.to_limit = klartext_take(lexer, "MAX");
	if (request->retract.to_limit)
		return true;
	if (!klartext_value(lexer, &request->retract.distance))
		return false;
	request->retract.distance *= interp->state.scale;
	return request->retract.distance >= 0 || fault(lexer->at, column, "the way of MB cannot be negative");
}

/* What is excluded by another word of the block, as TURN is by STAY. */
static bool exclude(struct lexer *lexer, int column, bool given)
{
	return !given || fault(lexer->at, column, "another word of this PLANE excludes this one");
}

static bool set_positioning(struct lexer *lexer, int column, struct klartext_swivel *request,
			    enum klartext_turning value)
{
	const bool given = request->positioning != KLARTEXT_TURN_UNKNOWN;

	request->positioning = value;
	return exclude(lexer, column, given);
}

static bool set_sign(struct lexer *lexer, int column, struct klartext_swivel *request, bool symmetric)
{
	const bool given = request->sign != 0;

	request->symmetric = symmetric;
	request->sign = lexer->at->text[lexer->position - 1] == '+' ? 1 : -1;
	return exclude(lexer, column, given);
}

static bool read_option(struct lexer *lexer, struct klartext_swivel *request)
{
	const struct interp *interp = lexer->context;
	int column = lexer_next_column(lexer);

	if (klartext_take(lexer, "MOVE"))
		return set_positioning(lexer, column, request, KLARTEXT_TURN_MOVE);
	if (klartext_take(lexer, "TURN"))
		return set_positioning(lexer, column, request, KLARTEXT_TURN_TURN);
	if (klartext_take(lexer, "STAY"))
		return set_positioning(lexer, column, request, KLARTEXT_TURN_STAY);
	if (klartext_take(lexer, "SEQ+") || klartext_take(lexer, "SEQ-"))
		return set_sign(lexer, column, request, false);
	if (klartext_take(lexer, "SYM+") || klartext_take(lexer, "SYM-"))
		return set_sign(lexer, column, request, true);
	if (klartext_take(lexer, "FMAX"))
		request->rapid = true;
	else if (klartext_take(lexer, "F"))
		return read_feed(lexer, request);
	else if (klartext_take(lexer, "DIST") || klartext_take(lexer, "ABST") || klartext_take(lexer, "SETUP") ||
		 klartext_take(lexer, "SET-UP")) {
		if (!klartext_value(lexer, &request->distance))
			return false;
		request->distance *= interp->state.scale;
	} else if (klartext_take(lexer, "TABLE") && klartext_take(lexer, "ROT")) {
		request->table_rot = true;
		return exclude(lexer, column, request->coord_rot);
	} else if (klartext_take(lexer, "COORD") && klartext_take(lexer, "ROT")) {
		request->coord_rot = true;
		return exclude(lexer, column, request->table_rot);
	} else if (klartext_take(lexer, "MB"))
		return read_retract(lexer, request);
	else
		return fault(lexer->at, column, "this is no word of PLANE");
	return true;
}

static bool read_options(struct lexer *lexer, struct klartext_swivel *request)
{
	while (!klartext_ends(lexer)) {
		if (!read_option(lexer, request))
			return false;
	}
	if (request->retracts && request->positioning == KLARTEXT_TURN_STAY)
		return fault(lexer->at, request->column, "MB of PLANE needs TURN or MOVE");
	return request->positioning != KLARTEXT_TURN_UNKNOWN ||
	       fault(lexer->at, request->column, "PLANE needs MOVE, TURN or STAY: what the rotary axes do");
}

/* --------------------------------------------------------------- PLANE, 19 */

static bool check_allowed(struct interp *interp, int column)
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
	struct klartext_swivel request = {.column = lexer_next_column(lexer)};
	struct klartext_tilt tilt;

	if (!klartext_tilt_read(lexer, &klartext->frame.tilt, &tilt) || !read_options(lexer, &request) ||
	    !check_allowed(interp, request.column) || !klartext_preset_check(interp, request.column))
		return false;
	klartext->cycle_19.counts = false;
	if (tilt.reset)
		return klartext_swivel_reset(interp, &request);
	if (!klartext_frame_check_zero(interp, request.column))
		return false;
	return tilt.axes ? klartext_swivel_axial(interp, &request, tilt.axes, tilt.angle)
			 : klartext_swivel_tilt(interp, &request, &tilt.turn);
}

/*
 * Reads the angles of cycle 19. With F the control turns the rotary axes itself as PLANE ... MOVE does; the fixed point
 * lies the set-up clearance (ABST) in front of the tool's tip. False: reported.
 */
static bool read_cycle(struct interp *interp, const struct klartext_cycle *cycle, struct klartext_tilt *tilt,
		       struct klartext_swivel *request)
{
	for (int i = 0; i < cycle->count; i++) {
		const struct klartext_cycle_word *word = &cycle->words[i];
		int slot = word->name[1] == '\0' ? slot_of_letter(word->name[0]) : -1;

		if (!strcmp(word->name, "FMAX")) {
			/* A clearance that follows F has been read as its value. */
			request->positioning = KLARTEXT_TURN_MOVE;
			request->rapid = true;
			request->distance = word->given ? word->value * interp->state.scale : request->distance;
		}
		if (!word->given || !strcmp(word->name, "FMAX"))
			continue;
		if (slot >= SLOT_A && slot <= SLOT_C) {
			tilt->angle[slot] = word->value;
			tilt->axes |= 1U << slot;
		} else if (!strcmp(word->name, "F")) {
			request->positioning = KLARTEXT_TURN_MOVE;
			request->feed = word->value;
		} else {
			request->distance = word->value * interp->state.scale;
		}
	}
	return request->positioning == KLARTEXT_TURN_MOVE || same_double(request->distance, 0) ||
	       fault(&interp->at, cycle->column, "a set-up clearance of CYCL DEF 19 needs F beside it");
}

/*
 * TNC 640 cycle user's manual, "WORKING PLANE (Cycle 19)": an angle that is left out keeps its value, so the manual
 * asks for all three. False: reported.
 */
static bool complete(struct interp *interp, const struct klartext_cycle *cycle, struct klartext_tilt *tilt)
{
	struct klartext *klartext = klartext_of(interp);
	const bool counts = klartext->cycle_19.counts;

	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		double *kept = &klartext->cycle_19.angle[slot - SLOT_A];

		if (tilt->axes & 1U << slot) {
			*kept = tilt->angle[slot];
			continue;
		}
		if (!counts && (klartext->frame.tilted || !same_double(*kept, 0)))
			return fault(
			    &interp->at, cycle->column,
			    "CYCL DEF 19 without %c behind PLANE or an empty CYCL DEF 19: which angle it keeps "
			    "is not known here; name A, B and C",
			    AXIS_LETTERS[slot]);
		tilt->angle[slot] = *kept;
	}
	for (int slot = SLOT_A; slot <= SLOT_C; slot++)
		tilt->axes |= same_double(tilt->angle[slot], 0) ? 0 : 1U << slot;
	klartext->cycle_19.counts = true;
	return true;
}

static bool is_level(const struct klartext_tilt *tilt)
{
	return same_double(tilt->angle[SLOT_A], 0) && same_double(tilt->angle[SLOT_B], 0) &&
	       same_double(tilt->angle[SLOT_C], 0);
}

/* Tilts the plane by positions of the rotary axes. The machine must have each named axis unless its position is 0. */
static bool tilt_by_axes(struct interp *interp, const struct klartext_swivel *request, const struct klartext_tilt *tilt)
{
	unsigned axes = tilt->axes;

	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		if (interp->config->has_axis[slot])
			continue;
		if (!same_double(tilt->angle[slot], 0))
			return fault(&interp->at, request->column, "the machine has no %c axis", AXIS_LETTERS[slot]);
		axes &= ~(1U << slot);
	}
	return klartext_swivel_axial(interp, request, axes, tilt->angle);
}

/*
 * "WORKING PLANE (Cycle 19)": a machine parameter says whether the angles are spatial angles or positions of the rotary
 * axes. Without angles, or with all of them 0, the cycle cancels the tilting. Without F no axis moves; the program then
 * turns the rotary axes to Q120 to Q122. Of two positions the cycle takes the one that is nearer to the zero of the
 * axes.
 */
bool klartext_plane_cycle(struct interp *interp, const struct klartext_cycle *cycle)
{
	struct klartext_swivel request = {
	    .positioning = KLARTEXT_TURN_STAY, .column = cycle->column};
	const enum cycle_19_angles angles = interp->config->controller.cycle_19_angles;
	struct klartext_tilt tilt = {.axes = 0};

	if (!read_cycle(interp, cycle, &tilt, &request) || !check_allowed(interp, cycle->column))
		return false;
	if (!tilt.axes && cycle->count)
		return fault(&interp->at, cycle->column,
			     "CYCL DEF 19 without angles has neither F nor a set-up clearance");
	if (!tilt.axes) {
		klartext_of(interp)->cycle_19.counts = false;
		return klartext_swivel_reset(interp, &request);
	}
	if (!complete(interp, cycle, &tilt))
		return false;
	if (is_level(&tilt))
		return klartext_swivel_level(interp, &request);
	if (angles == CYCLE_19_ANGLES_UNKNOWN)
		return fault(&interp->at, cycle->column,
			     "a machine parameter says what the angles of CYCL DEF 19 are: set "
			     "cycle_19_angles=\"spatial\" or \"axes\" in the machine file's <controller>, or write "
			     "PLANE SPATIAL");
	if (!klartext_preset_check(interp, cycle->column) || !klartext_frame_check_zero(interp, cycle->column))
		return false;
	if (angles == CYCLE_19_ANGLES_AXES)
		return tilt_by_axes(interp, &request, &tilt);
	request.from_zero = true;
	tilt.turn = klartext_tilt_spatial(&tilt.angle[SLOT_A]);
	return klartext_swivel_tilt(interp, &request, &tilt.turn);
}
