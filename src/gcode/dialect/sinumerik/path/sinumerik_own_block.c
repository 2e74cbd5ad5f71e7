#include "gcode/dialect/sinumerik/path/sinumerik_own_block.h"

#include <math.h>

#include "base/units.h"
#include "gcode/dialect/sinumerik/block/sinumerik_way.h"
#include "gcode/dialect/sinumerik/frames/sinumerik_frame.h"
#include "gcode/dialect/sinumerik/path/sinumerik_move.h"
#include "gcode/dialect/sinumerik/path/sinumerik_polar.h"
#include "gcode/execute/motion_commands.h"
#include "gcode/execute/tool_length.h"

/* Addresses of a motion, without those of a pole. */
#define MOTION_ADDRESSES (SINUMERIK_DIRECTION_BITS | SINUMERIK_LINE_BIT | 1U << SINUMERIK_CR | 1U << SINUMERIK_AR | \
			  1U << SINUMERIK_TURN | 1U << SINUMERIK_I1 | 1U << SINUMERIK_J1 | 1U << SINUMERIK_K1 | \
			  1U << SINUMERIK_CHF | 1U << SINUMERIK_CHR | 1U << SINUMERIK_RND)

static bool is_pole(int once)
{
	return once >= SINUMERIK_G(110) && once <= SINUMERIK_G(112);
}

/* ------------------------------------------------------------------- check */

/* The column of the code that takes the words of this block; 0: only a motion takes them. */
static int taker_column(const struct sinumerik_block *block)
{
	const int once = block->code[SINUMERIK_ONCE];

	if (block->code[SINUMERIK_FRAME] != CODE_NONE)
		return block->code_column[SINUMERIK_FRAME];
	return once == CODE_NONE || once == SINUMERIK_G(63) ? 0 : block->code_column[SINUMERIK_ONCE];
}

static bool refuse(struct interp *interp, int column, int taker)
{
	return fault(&interp->at, column,
		     "the code at column %d takes the words of its block, and leaves none for this one: write two "
		     "blocks",
		     taker);
}

/* Words of a motion that no code takes. */
static bool check_left(struct interp *interp, const struct sinumerik_block *block, int taker)
{
	const uint32_t polar = is_pole(block->code[SINUMERIK_ONCE]) ? 0 : SINUMERIK_POLAR_BITS;

	for (const char *letter = "IJK"; *letter; letter++) {
		if (sinumerik_block_has(block, *letter))
			return refuse(interp, block->column[*letter - 'A'], taker);
	}
	for (int i = 0; i < SINUMERIK_ADDRESSES; i++) {
		if (block->addresses & (MOTION_ADDRESSES | polar) & 1U << i)
			return refuse(interp, block->address_column[i], taker);
	}
	return true;
}

bool sinumerik_own_block_check(struct interp *interp, const struct sinumerik_block *block)
{
	const int once = block->code[SINUMERIK_ONCE], motion = block->code[SINUMERIK_MOTION];
	const int taker = taker_column(block);

	if (once != CODE_NONE && block->code[SINUMERIK_FRAME] != CODE_NONE)
		return refuse(interp, block->code_column[SINUMERIK_ONCE], taker);
	if (taker == 0)
		return true;
	if (block->positions)
		return refuse(interp, block->positions_column, taker);
	/* G0 to G3 only select the next motion; threads, CIP and CT need words of their own. */
	if (motion > G3 || (motion != CODE_NONE && sinumerik_is_limit(once) && (block->letters & AXIS_BITS)))
		return refuse(interp, block->code_column[SINUMERIK_MOTION], taker);
	if (once == G4 && sinumerik_block_has(block, 'F') && sinumerik_block_has(block, 'S'))
		return refuse(interp, block->column['S' - 'A'], taker);
	return check_left(interp, block, taker);
}

/* ------------------------------------------------------------------ frames */

static bool run_frame(struct interp *interp, const struct sinumerik_block *block)
{
	const int code = block->code[SINUMERIK_FRAME], number = code - SINUMERIK_FRAME_CODES;
	const bool axial = code < SINUMERIK_FRAME_CODES;
	struct sinumerik_frame_words words = {
		.code = axial ? SINUMERIK_AXIAL : (enum sinumerik_frame_code)(number / 2),
		.added = axial ? code == SINUMERIK_G(59) : number % 2,
		.has_plane_angle = sinumerik_block_has_address(block, SINUMERIK_RPL),
		.plane_angle = block->address_value[SINUMERIK_RPL],
		.column = block->code_column[SINUMERIK_FRAME]};
	bool lengths = false;

	if (sinumerik_of(interp)->frames.tool_frame)
		return fault(&interp->at, words.column, "frames while TOROT or TOFRAME is in force; TOROTOF first");
	if (words.has_plane_angle && words.code != SINUMERIK_ROT)
		return fault(&interp->at, block->address_column[SINUMERIK_RPL], "RPL belongs to ROT and AROT");
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		const int index = AXIS_LETTERS[slot] - 'A';
		const char name[] = {AXIS_LETTERS[slot], '\0'};
		const bool scaled =
		    (words.code == SINUMERIK_TRANS || words.code == SINUMERIK_AXIAL) && !slot_is_rotary(slot);

		words.has[slot] = sinumerik_block_has(block, AXIS_LETTERS[slot]);
		if (!words.has[slot])
			continue;
		if (!sinumerik_way_fits(&interp->at, block->column[index], name, block->way[index], false))
			return false;
		lengths = lengths || scaled;
		words.value[slot] = block->value[index] * (scaled ? interp->state.scale : 1);
	}
	if (lengths && (interp->state.unknown_modes & 1U << G_UNITS))
		return fault(&interp->at, words.column,
			     "a parameter of the control decides whether lengths are mm or inches before any G70, "
			     "G71, G700 or G710: set power_on_units=\"mm\" or \"inch\" in the machine file's "
			     "<controller>");
	if (words.has_plane_angle && (interp->state.unknown_modes & 1U << G_PLANE))
		return fault(&interp->at, words.column,
			     "a parameter of the control decides which plane is in force before any G17, G18 or "
			     "G19: set power_on_plane=\"xy\", \"zx\" or \"yz\" in the machine file's <controller>");
	if (sinumerik_of(interp)->frames.unsure)
		return fault(&interp->at, words.column,
			     "frames after TRAORI or TRAFOOF: select the work offset again first");
	return sinumerik_frame_set(interp, &words);
}

/* ------------------------------------------------------------- G4, G74, G75 */

static bool run_dwell(struct interp *interp, const struct sinumerik_block *block)
{
	const int column = block->code_column[SINUMERIK_ONCE];
	double seconds = block->value['F' - 'A'];

	if (!sinumerik_block_has(block, 'F')) {
		if (!sinumerik_block_has(block, 'S'))
			return fault(&interp->at, column,
				     "G4 needs its time: F in seconds, or S in turns of the spindle");
		if (!(interp->state.speed > 0))
			return fault(&interp->at, column, "G4 S counts turns of the spindle, whose speed is not known");
		seconds = block->value['S' - 'A'] * SECONDS_PER_MINUTE / interp->state.speed;
	}
	if (seconds < 0)
		return fault(&interp->at, column, "a dwell cannot be negative");
	if (block->letters & AXIS_BITS)
		return fault(&interp->at, sinumerik_block_axis_column(block), "G4 stands in a block without motion");
	return motion_commands_emit(interp, &(struct canon_move){.kind = CANON_DWELL, .seconds = seconds});
}

/* G74: the reference point, <reference number="1">. G75 FP=n: fixed point n, <reference number="n+1">. */
static bool run_reference(struct interp *interp, const struct sinumerik_block *block)
{
	const int column = block->code_column[SINUMERIK_ONCE];
	const bool fixed = block->code[SINUMERIK_ONCE] == SINUMERIK_G(75);
	const double point = sinumerik_block_has_address(block, SINUMERIK_FP) ? block->address_value[SINUMERIK_FP] : 1;
	const int index = fixed ? (int)point : 0;
	struct canon_move move = {.kind = CANON_RAPID, .machine_coordinates = true};
	const struct control_place *place;
	struct suspended suspended;
	slot_values target;

	if (fixed && (!(point >= 1 && point < REFERENCES_MAX) || floor(point) < point))
		return fault(&interp->at, column, "G75 FP= must be a whole number from 1 to %d", REFERENCES_MAX - 1);
	if (!(block->letters & AXIS_BITS))
		return fault(&interp->at, column, "G%d needs the axes that it moves: X1=0 and the like",
			     fixed ? 75 : 74);
	if (interp->state.tcp == TCP_BY_LENGTH)
		return fault(&interp->at, column, "G%d while TRAORI is on; TRAFOOF first", fixed ? 75 : 74);
	place = &interp->config->controller.references[index];
	if (!tool_length_suspend(interp, column, &suspended))
		return false;
	target = interp->state.position;
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		if (!sinumerik_block_has(block, AXIS_LETTERS[slot]))
			continue;
		if (!place->given || !place->has[slot])
			return fault(&interp->at, column,
				     "it is not known where G%d moves %c: set <reference number=\"%d\" %c=\"\"/> "
				     "in the machine file's <controller>",
				     fixed ? 75 : 74, AXIS_LETTERS[slot], index + 1, AXIS_LETTERS[slot]);
		target.v[slot] = state_from_canonical(slot, place->value.v[slot]);
	}
	if (!motion_commands_go(interp, &target, &move) || !tool_length_resume(interp, column, &suspended))
		return false;
	sinumerik_frame_moved(interp);
	return true;
}

/* --------------------------------------------------------------------- block */

bool sinumerik_own_block_run(struct interp *interp, const struct sinumerik_block *block, bool *done)
{
	const int once = block->code[SINUMERIK_ONCE];

	*done = true;
	if (block->code[SINUMERIK_FRAME] != CODE_NONE)
		return run_frame(interp, block);
	if (once == G4)
		return run_dwell(interp, block);
	if ((once == SINUMERIK_G(63) || once == SINUMERIK_G(74) || once == SINUMERIK_G(75)) &&
	    sinumerik_modal_acts(sinumerik_of(interp)))
		return fault(&interp->at, block->code_column[SINUMERIK_ONCE],
			     "G%d while %s is called behind each motion; MCALL first",
			     once / 10, sinumerik_of(interp)->modal.name);
	if (once == SINUMERIK_G(63))
		return sinumerik_move_tap(interp, block);
	/* G25 and G26: limits; no axis moves. */
	if (sinumerik_is_limit(once))
		return true;
	if (once >= SINUMERIK_G(110) && sinumerik_of(interp)->frames.tool_frame)
		return fault(&interp->at, block->code_column[SINUMERIK_ONCE],
			     "a pole while TOROT or TOFRAME is in force; TOROTOF first");
	if (once >= SINUMERIK_G(110))
		return sinumerik_polar_set_pole(interp, block);
	if (once != CODE_NONE)
		return run_reference(interp, block);
	*done = false;
	return true;
}
