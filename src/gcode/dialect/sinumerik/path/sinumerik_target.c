#include "gcode/dialect/sinumerik/path/sinumerik_target.h"

#include <math.h>
#include <string.h>

#include "base/same_double.h"
#include "gcode/dialect/sinumerik/frames/sinumerik_frame.h"
#include "gcode/dialect/sinumerik/frames/sinumerik_open_place.h"
#include "gcode/dialect/sinumerik/frames/sinumerik_place_check.h"
#include "gcode/dialect/sinumerik/path/sinumerik_polar.h"
#include "gcode/dialect/sinumerik/path/sinumerik_tool_frame.h"
#include "gcode/execute/endpoint.h"
#include "geom/tolerance.h"

#define LINEAR_BITS (letter_bit('X') | letter_bit('Y') | letter_bit('Z'))

double sinumerik_target_length(const struct interp *interp, double value)
{
	return value * interp->state.scale;
}

static bool counts_from_here(const struct interp *interp, enum sinumerik_way way)
{
	return way == SINUMERIK_WAY_IC || (way == SINUMERIK_WAY_MODAL && interp->state.incremental);
}

double sinumerik_target_centre(const struct interp *interp, double value, enum sinumerik_way way, bool modal_absolute,
			       double start)
{
	const bool absolute = way == SINUMERIK_WAY_AC || (way == SINUMERIK_WAY_MODAL && modal_absolute);

	return sinumerik_target_length(interp, value) + (absolute ? 0 : start);
}

/* ---------------------------------------------------------------- questions */

static bool asks(const struct interp *interp, enum g_group group)
{
	return interp->state.unknown_modes & 1U << group;
}

static bool has_modal_word(const struct sinumerik_block *block)
{
	if (sinumerik_block_has_address(block, SINUMERIK_AP) && block->address_way[SINUMERIK_AP] == SINUMERIK_WAY_MODAL)
		return true;
	for (const char *letter = AXIS_LETTERS; *letter; letter++) {
		if (sinumerik_block_has(block, *letter) && block->way[*letter - 'A'] == SINUMERIK_WAY_MODAL)
			return true;
	}
	return false;
}

/* MD20150 sets the modes at power-on; a mode that the program sets itself needs no answer. */
static bool check_modes(const struct interp *interp, const struct sinumerik_block *block, bool arc, int column)
{
	const bool lengths = arc || (block->letters & LINEAR_BITS);

	if (lengths && asks(interp, G_UNITS))
		return fault(&interp->at, column,
			     "a parameter of the control decides whether lengths are mm or inches before any G70, "
			     "G71, G700 or G710: set power_on_units=\"mm\" or \"inch\" in the machine file's "
			     "<controller>");
	if (asks(interp, G_DISTANCE) && has_modal_word(block))
		return fault(
		    &interp->at, column,
		    "a parameter of the control decides whether coordinates are absolute before any G90 or G91: "
		    "set power_on_distance=\"absolute\" or \"incremental\" in the machine file's <controller>");
	if (arc && asks(interp, G_PLANE))
		return fault(&interp->at, column,
			     "a parameter of the control decides which plane is in force before any G17, G18 or "
			     "G19: set power_on_plane=\"xy\", \"zx\" or \"yz\" in the machine file's <controller>");
	return true;
}

/* SD42940: the direction in which the tool length acts with G18 and G19. */
static bool check_length_axis(const struct interp *interp, int column)
{
	const struct state *state = &interp->state;

	if (state->plane == G17 || state->tcp != TCP_OFF || same_double(state->length, 0) ||
	    interp->config->controller.length_along_z == ANSWER_YES)
		return true;
	return fault(
	    &interp->at, column,
	    "in the plane of G%d a parameter of the control (SD42940) decides along which axis the tool's length "
	    "acts: set tool_length_axis=\"z\" in the machine file's <controller> if it is Z in every plane; the "
	    "other way is not supported",
	    state->plane / 10);
}

/*
 * $MC_TRAFO5_ROT_OFFSET_FROM_FRAME_1: TRAORI takes the rotary values of the work offset as the zero of the axes, or
 * the zero of the machine. With "offset", the effect of TRANS on rotary axes is not certain.
 */
bool sinumerik_target_check_rotary_zero(const struct interp *interp, int column)
{
	const struct controller *controller = &interp->config->controller;
	const struct sinumerik *sinumerik = sinumerik_of(interp);

	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		const bool programmed = !same_double(sinumerik->frames.programmed.shift.v[slot], 0);

		if (!interp->config->has_axis[slot] || same_double(interp->state.offset.v[slot], 0))
			continue;
		if (controller->tcp_zero_given != ANSWER_YES)
			return fault(&interp->at, column,
				     "%c is offset, and a parameter of the control (TRAFO5_ROT_OFFSET_FROM_FRAME) "
				     "decides whether TRAORI and CYCLE800 count it from there: set "
				     "tcp_zero=\"machine\" or \"offset\" in the machine file's <controller>",
				     AXIS_LETTERS[slot]);
		if (controller->tcp_zero_offset && programmed)
			return fault(&interp->at, column,
				     "TRANS of %c with TRAORI or CYCLE800 is not supported where these count from the "
				     "work offset (tcp_zero=\"offset\")",
				     AXIS_LETTERS[slot]);
	}
	return true;
}

bool sinumerik_target_check(struct interp *interp, const struct sinumerik_block *block, bool machine, bool arc)
{
	const int column = sinumerik_block_axis_column(block);
	const bool linear = arc || (block->letters & LINEAR_BITS);

	if (interp->state.unknown_modes && !check_modes(interp, block, arc, column))
		return false;
	if (sinumerik_of(interp)->frames.tool_frame && !sinumerik_tool_frame_check(interp, block, arc))
		return false;
	if (interp->state.tcp != TCP_OFF && !sinumerik_target_check_rotary_zero(interp, column))
		return false;
	if (linear && (!sinumerik_place_check_edge(interp, column) || !check_length_axis(interp, column)))
		return false;
	return machine || ((!linear || sinumerik_place_check_tool(interp, column)) &&
			   sinumerik_place_check_frames(interp, block->letters, column));
}

bool sinumerik_target_check_cycle(struct interp *interp, int column)
{
	struct sinumerik_block block = {.letters = LINEAR_BITS, .axis_column = column};

	for (const char *letter = "XYZ"; *letter; letter++) {
		block.column[*letter - 'A'] = column;
		block.way[*letter - 'A'] = SINUMERIK_WAY_AC;
	}
	return sinumerik_target_check(interp, &block, false, true);
}

/* -------------------------------------------------------------- coordinates */

/* SD42440 and SD42442: is an increment after a change of offsets relative to the program coordinate of before? */
static bool start_increment(struct interp *interp, int slot, int column, double *coordinate)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);

	if (!sinumerik->place.shifted[slot])
		return true;
	if (sinumerik->frames.tool_frame)
		return fault(&interp->at, column,
			     "%c by an increment after TOROT, and a change of frames, offsets or the tool before it: "
			     "settings of the control decide whether the change is traversed, too; write an absolute "
			     "position first",
			     AXIS_LETTERS[slot]);
	switch (interp->config->controller.increments_after_shift) {
	case INCREMENTS_TRAVERSE_SHIFT:
		if (isnan(sinumerik->place.programmed.v[slot]))
			return fault(&interp->at, column,
				     "%c by an increment after TOROTOF: which coordinate it counts from is not known; "
				     "write an absolute position first",
				     AXIS_LETTERS[slot]);
		*coordinate = sinumerik->place.programmed.v[slot];
		break;
	case INCREMENTS_FROM_POSITION:
		break;
	default:
		return fault(
		    &interp->at, column,
		    "%c by an increment after a change of frames, offsets or the tool: settings of the control "
		    "(SD42440, SD42442) decide whether the change is traversed, too: set "
		    "increments_after_shift=\"traverse\" or \"stay\" in the machine file's <controller>",
		    AXIS_LETTERS[slot]);
	}
	sinumerik->place.shifted[slot] = false;
	return true;
}

/* DC, ACP, ACN: within one turn, degrees from the present position of the axis. */
static bool way_of_turn(struct interp *interp, int slot, enum sinumerik_way sort, double from, double aim, int column,
			double *way)
{
	const double shortest = remainder(aim - from, 360);
	const int half_turn = interp->config->half_turn[slot];

	if (sort == SINUMERIK_WAY_DC && fabs(shortest) >= 180 - SAME_DEGREES) {
		if (!half_turn)
			return fault(
			    &interp->at, column,
			    "half a turn of %c: either way is as short; set half_turn=\"positive\" or \"negative\" "
			    "of this axis in the machine file",
			    AXIS_LETTERS[slot]);
		*way = half_turn * fabs(shortest);
	} else if (fabs(shortest) <= SAME_DEGREES || sort == SINUMERIK_WAY_DC) {
		*way = shortest;
	} else if (sort == SINUMERIK_WAY_ACP) {
		*way = shortest < 0 ? shortest + 360 : shortest;
	} else {
		*way = shortest > 0 ? shortest - 360 : shortest;
	}
	return true;
}

static bool find_turned(struct interp *interp, int slot, enum sinumerik_way way, double value, int column,
			double *coordinate)
{
	double turn;

	if (!slot_is_rotary(slot) || interp->config->wrap[slot] == WRAP_NONE)
		return fault(&interp->at, column,
			     "DC, ACP and ACN are for rotary axes that count modulo 360 degrees; wrap=\"shortest\" of "
			     "this axis in the machine file says that %c is one, and rotary_way=\"plain\" or "
			     "\"shorter\" of <controller> how it turns without them",
			     AXIS_LETTERS[slot]);
	if (value < 0 || value > 360)
		return fault(&interp->at, column, "DC, ACP and ACN take positions from 0 to 360 degrees, not %.15g",
			     value);
	if (!way_of_turn(interp, slot, way, *coordinate, value, column, &turn))
		return false;
	*coordinate += turn;
	return true;
}

/* An angle of at least 0 and below 360; a value that rounding puts just below a full turn is 0. */
static double reduced(double angle)
{
	const double rest = angle - 360 * floor(angle / 360);

	return rest >= 360 - SAME_DEGREES ? 0 : rest;
}

/*
 * Function manual R2, "Modulo rotary axes", AC and G90: the axis turns forward to a larger displayed position and
 * backward to a smaller one, so it never passes 0. False: because of an offset, or of a position outside the display,
 * the comparison is not certain.
 */
static bool find_plain_way(const struct interp *interp, int slot, double value, double offset, double *way)
{
	const double here = interp->state.position.v[slot];
	const double of_program = reduced(value) - reduced(here - offset);

	*way = reduced(value + offset) - reduced(here);
	return fabs(*way - of_program) < SAME_DEGREES && value >= 0 && value < 360;
}

/*
 * MD30455, bit 2: the direction in which the axis turns if the program writes neither DC, ACP nor ACN.
 * wrap="shortest" means the shorter way, but a machine file may mean it for DC only: without rotary_way the verdict
 * has a caution if the plain way is a different one.
 */
static bool check_rotary_way(struct interp *interp, int slot, double shortest, double plain, bool sure, int column)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);

	if (sure && fabs(remainder(shortest, 360)) < 180 - SAME_DEGREES && fabs(plain - shortest) < SAME_DEGREES)
		return true;
	if (interp->config->controller.rotary_way == ROTARY_WAY_PLAIN)
		return sure ||
		       fault(&interp->at, column,
			     "which way %c turns to this absolute position is not certain: it lies outside of 0 to 360 "
			     "degrees, or an offset shifts it; write DC, ACP or ACN",
			     AXIS_LETTERS[slot]);
	if (interp->config->controller.rotary_way == ROTARY_WAY_UNKNOWN && !sinumerik->cautioned_rotary_way)
		caution(&interp->at, column,
			"%c turns the shorter way here, because its wrap=\"shortest\" says so; a control as "
			"delivered (bit 2 of MD30455 is 0) turns without passing 0: set rotary_way=\"plain\" or "
			"\"shorter\" in the machine file's <controller>",
			AXIS_LETTERS[slot]);
	sinumerik->cautioned_rotary_way |= interp->config->controller.rotary_way == ROTARY_WAY_UNKNOWN;
	return true;
}

/* An absolute position of a modulo rotary axis; `offset` is the difference to the axis' own position. */
static bool find_wrapped(struct interp *interp, int slot, double value, double offset, int column, double *target)
{
	const double here = interp->state.position.v[slot], shortest = remainder(value + offset - here, 360);
	double plain;
	bool sure;

	if (interp->config->wrap[slot] == WRAP_SIGN)
		return fault(
		    &interp->at, column,
		    "a parameter of the control (MD30455) decides which way %c turns to an absolute position: "
		    "write DC, ACP or ACN, or set wrap=\"shortest\" or \"none\" of this axis in the machine file",
		    AXIS_LETTERS[slot]);
	sure = find_plain_way(interp, slot, value, offset, &plain);
	if (!check_rotary_way(interp, slot, shortest, plain, sure, column))
		return false;
	if (interp->config->controller.rotary_way != ROTARY_WAY_PLAIN)
		return endpoint_absolute(interp, slot, value, offset, column, target);
	*target = value + offset + 360 * round((here + plain - value - offset) / 360);
	return true;
}

static bool find_wrapped_coordinate(struct interp *interp, int slot, double value, int column, double *coordinate)
{
	const double offset = interp->state.offset.v[slot];
	double target;

	if (!find_wrapped(interp, slot, value, offset, column, &target))
		return false;
	*coordinate = target - offset;
	return true;
}

static bool find_coordinate(struct interp *interp, const struct sinumerik_block *block, int slot, double *coordinate)
{
	const int index = AXIS_LETTERS[slot] - 'A', column = block->column[index];
	const enum sinumerik_way way = (enum sinumerik_way)block->way[index];
	const double value = slot_is_rotary(slot) ? block->value[index] : block->value[index] * interp->state.scale;
	struct sinumerik *sinumerik = sinumerik_of(interp);

	if (way >= SINUMERIK_WAY_DC) {
		sinumerik->place.shifted[slot] = false;
		return find_turned(interp, slot, way, value, column, coordinate);
	}
	if (counts_from_here(interp, way)) {
		if (!slot_is_rotary(slot) && !sinumerik_open_place_check(interp, column, "an increment"))
			return false;
		if (!start_increment(interp, slot, column, coordinate))
			return false;
		*coordinate += value;
		return true;
	}
	sinumerik->place.shifted[slot] = false;
	if (slot_is_rotary(slot) && interp->config->wrap[slot] != WRAP_NONE)
		return find_wrapped_coordinate(interp, slot, value, column, coordinate);
	*coordinate = value;
	return true;
}

bool sinumerik_target_find(struct interp *interp, const struct sinumerik_block *block, slot_values *target)
{
	const bool line = block->addresses & SINUMERIK_LINE_BIT;
	const bool shifted = line && sinumerik_polar_is_shifted(interp);
	uint32_t left = block->letters & AXIS_BITS;

	*target = *sinumerik_frame_place(interp);
	for (int slot = 0; left; slot++) {
		const uint32_t bit = letter_bit(AXIS_LETTERS[slot]);

		if ((left & bit) && !find_coordinate(interp, block, slot, &target->v[slot]))
			return false;
		left &= ~bit;
	}
	if (line && !sinumerik_polar_find_line(interp, block, shifted, target))
		return false;
	return !(block->addresses & SINUMERIK_POLAR_BITS) || sinumerik_polar_find(interp, block, target);
}

bool sinumerik_target_find_machine(struct interp *interp, const struct sinumerik_block *block, slot_values *target)
{
	const struct state *state = &interp->state;

	*target = state->position;
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		const int index = AXIS_LETTERS[slot] - 'A', column = block->column[index];
		const enum sinumerik_way way = (enum sinumerik_way)block->way[index];
		const double length = slot == SLOT_Z && state->tcp == TCP_OFF ? state->length : 0;
		double value;

		if (!sinumerik_block_has(block, AXIS_LETTERS[slot]))
			continue;
		value = block->value[index] * (slot_is_rotary(slot) ? 1 : state->scale);
		if (way == SINUMERIK_WAY_IC || way == SINUMERIK_WAY_ACP || way == SINUMERIK_WAY_ACN ||
		    (way == SINUMERIK_WAY_MODAL && state->incremental))
			return fault(
			    &interp->at, column,
			    "positions of the machine's axes are absolute; an increment beside SUPA, G53 or G153 "
			    "is not supported");
		if (way == SINUMERIK_WAY_DC) {
			if (!find_turned(interp, slot, way, value, column, &target->v[slot]))
				return false;
			continue;
		}
		if (slot_is_rotary(slot) && interp->config->wrap[slot] != WRAP_NONE
			? !find_wrapped(interp, slot, value, 0, column, &target->v[slot])
			: !endpoint_absolute(interp, slot, value, length, column, &target->v[slot]))
			return false;
	}
	return true;
}
