#include "gcode/execute/g10_tool_table.h"

#include <limits.h>
#include <math.h>

#include "gcode/execute/work_offset_use.h"
#include "geom/tolerance.h"

/* G59.3, the fixture of L11. */
#define FIXTURE_SYSTEM (SYSTEM_COUNT - 1)

/* The tool's offset in the slot for the block's word `value`. */
static double offset_of(const struct interp *interp, int mode, int slot, double value)
{
	const struct state *state = &interp->state;
	double word = value * (slot_is_rotary(slot) ? 1 : state->scale);

	if (mode == 1)
		return word;
	if (mode == 11)
		return state->position.v[slot] - state->work[FIXTURE_SYSTEM].v[slot] - word;
	/* LinuxCNC uses the shift in its parameters here. */
	return state->position.v[slot] - state->work[state->system].v[slot] -
	       (state->shift_applied ? state->saved_shift.v[slot] : 0) - word;
}

static bool find_tool(struct interp *interp, int *number)
{
	int column = block_column(&interp->block, 'P');

	if (!block_integer(&interp->block, &interp->at, 'P', 1, INT_MAX, number))
		return false;
	if (tool_table_find(&interp->tools, *number))
		return true;
	if (!interp->config->has_setup)
		return fault(&interp->at, column, "P%d: no tools are defined, because there is no setup", *number);
	return fault(&interp->at, column,
		     "the setup defines no tool T%d: add <tool number=\"%d\" length=\"\"/> with its shape",
		     *number, *number);
}

static bool check_words(struct interp *interp, int mode)
{
	const struct block *block = &interp->block;

	for (const char *letter = "IJQ"; *letter; letter++) {
		if (block_has(block, *letter))
			return fault(&interp->at, block_column(block, *letter),
				     "%c: angles and orientation of lathe tools are not supported",
				     *letter);
	}
	if (!(block->letters & (AXIS_BITS | letter_bit('R'))))
		return fault(&interp->at, block->g_column[G_NONMODAL],
			     "G10 L%d without effect: give Z (tool length) or R (tool radius)", mode);
	return true;
}

/* Under TCP a position already contains the tool's length, which L10 and L11 measure. */
static bool check_position(struct interp *interp, int mode)
{
	int column = interp->block.g_column[G_NONMODAL];

	if (interp->state.tcp != TCP_OFF)
		return fault(&interp->at, column,
			     "G10 L%d measures the tool at the machine position, which is not supported under TCP; "
			     "cancel TCP first", mode);
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		if (interp->state.probed[slot])
			return fault(&interp->at, column,
				     "G10 L%d measures the tool at the probed position of %c, which is not known "
				     "before the program runs; give the length in the setup or by G10 L1",
				     mode, AXIS_LETTERS[slot]);
	}
	return true;
}

static bool check_offsets(struct interp *interp, int mode, int number)
{
	const struct block *block = &interp->block;

	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		char letter = AXIS_LETTERS[slot];
		double offset;

		if (!block_has(block, letter))
			continue;
		offset = offset_of(interp, mode, slot, block_value(block, letter));
		if (slot != SLOT_Z && fabs(offset) > SAME_POINT)
			return fault(&interp->at, block_column(block, letter),
				     "G10 L%d gives T%d an offset of %.9g %s in %c, which G43 would apply; only tool "
				     "offsets in Z are supported",
				     mode, number, offset, slot_is_rotary(slot) ? "degrees" : "mm", letter);
	}
	return true;
}

/* LinuxCNC's manual, "G10 L1", "G10 L10", "G10 L11". */
bool g10_tool_table_write(struct interp *interp, int mode)
{
	const struct block *block = &interp->block;
	int number;

	if (!check_words(interp, mode) || !find_tool(interp, &number))
		return false;
	if (mode != 1 && (block->letters & AXIS_BITS) && !check_position(interp, mode))
		return false;
	if (mode == 11 && (block->letters & AXIS_BITS) &&
	    !work_offset_use_require(interp, FIXTURE_SYSTEM, block_column(block, 'L')))
		return false;
	if (!check_offsets(interp, mode, number))
		return false;
	if (block_has(block, 'Z'))
		tool_table_set_length(&interp->tools, number, offset_of(interp, mode, SLOT_Z, block_value(block, 'Z')));
	if (block_has(block, 'R'))
		tool_table_set_diameter(&interp->tools, number, 2 * block_value(block, 'R') * interp->state.scale);
	return true;
}
