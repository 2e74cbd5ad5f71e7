#include "gcode/execute/dynamic_work_offset.h"

#include <math.h>

#include "base/same_double.h"
#include "gcode/execute/work_offset_use.h"
#include "geom/tolerance.h"

static bool is_zero(double value)
{
	return same_double(value, 0);
}

/* The manual does not say in which order the control carries out the codes of a block. */
static bool stands_alone(const struct block *block)
{
	bool still = block->motion == CODE_NONE || block->motion == G0 || block->motion == G1 || block->motion == G80;

	return still && !(block->letters & AXIS_BITS) && block->g[G_NONMODAL] == CODE_NONE &&
	       block->g[G_LENGTH] == CODE_NONE && block->g[G_SYSTEM] == CODE_NONE &&
	       block->g[G_ROTATION] == CODE_NONE && block->m[M_TOOL] == CODE_NONE && block->m[M_TCP] == CODE_NONE;
}

bool dynamic_work_offset_start_block(struct interp *interp)
{
	const struct block *block = &interp->block;
	int given = block->g[G_DYNAMIC], other = block->g[G_NONMODAL], column = block->g_column[G_NONMODAL];

	if (given != CODE_NONE && !stands_alone(block))
		return fault(&interp->at, block->g_column[G_DYNAMIC],
			     "G%d needs a block without axis words, offsets, tool length or tool change", given / 10);
	if (!interp->state.dynamic.on || given != CODE_NONE)
		return true;
	if (other == G10 || other == G52 || other == G92)
		return fault(&interp->at, column,
			     "a change of offsets while G254 is active is not supported; write G255 first");
	if (other == G30)
		return fault(&interp->at, column,
			     "G30 while G254 is active: it is not known whether the control ignores G254 on the way; "
			     "write G255 first");
	if (block->g[G_ROTATION] == G68)
		return fault(&interp->at, block->g_column[G_ROTATION], "G68 while G254 is active; write G255 first");
	if (block->g[G_LENGTH] == G43_4 || block->g[G_LENGTH] == G43_5 || block->g[G_LENGTH] == G234)
		return fault(&interp->at, block->g_column[G_LENGTH],
			     "tool centre point control while G254 is active; write G255 first");
	if (block->m[M_TCP] == MCODE_TCP_ON)
		return fault(&interp->at, block->m_column[M_TCP],
			     "tool centre point control while G254 is active; write G255 first");
	return true;
}

bool dynamic_work_offset_check_system(struct interp *interp, int system)
{
	const struct state *state = &interp->state;

	if (!state->dynamic.on || (system == state->system && !interp->state.work_assigned))
		return true;
	return fault(&interp->at, interp->block.g_column[G_SYSTEM],
		     "a change of the work offset while G254 is active: the control needs it before G254; write G255 "
		     "first");
}

/* Marks the coordinates that have changed without a move of the axes. */
static void mark_unsure(struct state *state, const slot_values *before, int code)
{
	struct dynamic_work_offset *dynamic = &state->dynamic;

	for (int slot = SLOT_X; slot <= SLOT_Z; slot++) {
		if (fabs(state->offset.v[slot] - before->v[slot]) > SAME_COORDINATE) {
			dynamic->unsure[slot] = true;
			dynamic->unsure_code = code;
		}
	}
}

/* The work offset must be that of the table at rotary zero. */
static bool check_offset(struct interp *interp, int column)
{
	const struct state *state = &interp->state;

	if (interp->state.work_assigned)
		return work_offset_use_fault(interp, column);
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		if (!is_zero(state->shift.v[slot]))
			return fault(&interp->at, column,
				     "G254 while G%d shifts %c: it is not known whether the shift moves with the "
				     "table; cancel the shift first",
				     state->shift_code / 10, AXIS_LETTERS[slot]);
		if (slot_is_rotary(slot) && !is_zero(state->offset.v[slot]))
			return fault(&interp->at, column,
				     "G254 with a work offset of %.9g degrees in %c: the control needs 0",
				     state->offset.v[slot], AXIS_LETTERS[slot]);
	}
	return true;
}

static bool switch_on(struct interp *interp, int column)
{
	struct state *state = &interp->state;
	axis_values zero = state->canonical;

	if (state->tcp != TCP_OFF)
		return fault(&interp->at, column,
			     "G254 under tool centre point control; cancel tool centre point control first");
	if (state->frame.on)
		return fault(&interp->at, column, "G254 while G68 is active; write G69 first");
	if (!check_offset(interp, column) || !work_offset_use_require(interp, state->system, column))
		return false;
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		if (!slot_is_rotary(slot))
			zero.v[slot] = state->work[state->system].v[slot];
	}
	if (!interp->kinematics->table_point(interp->kinematics->context, line_loc(&interp->at, column), &zero))
		return false;
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++)
		state->dynamic.zero.v[slot] = zero.v[slot];
	state->dynamic.on = true;
	return true;
}

bool dynamic_work_offset_switch(struct interp *interp)
{
	struct state *state = &interp->state;
	int code = interp->block.g[G_DYNAMIC];
	slot_values before = state->offset;

	if (code == CODE_NONE)
		return true;
	if (code == G255)
		state->dynamic.on = false;
	else if (!switch_on(interp, interp->block.g_column[G_DYNAMIC]))
		return false;
	state_update_offset(state);
	mark_unsure(state, &before, code);
	return true;
}

bool dynamic_work_offset_check_words(struct interp *interp)
{
	const struct block *block = &interp->block;
	struct dynamic_work_offset *dynamic = &interp->state.dynamic;
	bool by_machine = block->g[G_NONMODAL] != CODE_NONE;

	if (dynamic->unsure_code == CODE_NONE)
		return true;
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++) {
		bool named = block_has(block, AXIS_LETTERS[slot]);

		if (!named || !dynamic->unsure[slot])
			continue;
		if (interp->state.incremental && !is_zero(block_value(block, AXIS_LETTERS[slot])))
			return fault(&interp->at, block_column(block, AXIS_LETTERS[slot]),
				     "increment in %c after G%d: the start point of the increment is not known; move "
				     "the axis to an absolute coordinate first",
				     AXIS_LETTERS[slot], dynamic->unsure_code / 10);
		dynamic->unsure[slot] = by_machine || interp->state.incremental;
	}
	if (!dynamic->unsure[SLOT_X] && !dynamic->unsure[SLOT_Y] && !dynamic->unsure[SLOT_Z])
		dynamic->unsure_code = CODE_NONE;
	return true;
}

bool dynamic_work_offset_check_cut(struct interp *interp)
{
	const struct block *block = &interp->block;
	const struct dynamic_work_offset *dynamic = &interp->state.dynamic;
	bool still = block->motion == G1 && !(block->letters & AXIS_BITS);

	if (dynamic->unsure_code == CODE_NONE || block->motion == CODE_NONE || block->motion == G0 ||
	    block->motion == G80 || block->g[G_NONMODAL] == G53 || still)
		return true;
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++) {
		bool led = block_has(block, AXIS_LETTERS[slot]) && !interp->state.incremental;

		if (dynamic->unsure[slot] && dynamic->unsure_code == G254)
			return fault(&interp->at, block_motion_column(block),
				     "G%g after G254, but before G0 has moved %c to an absolute coordinate: the "
				     "control needs this for each of X, Y and Z before it cuts",
				     block->motion / 10.0, AXIS_LETTERS[slot]);
		if (dynamic->unsure[slot] && !led)
			return fault(&interp->at, block_motion_column(block),
				     "G%g after G255 without %c: it is not known whether the axis stays in place; "
				     "write its absolute coordinate",
				     block->motion / 10.0, AXIS_LETTERS[slot]);
	}
	return true;
}

/* The column of the word that turns the axis. */
static int turn_column(const struct block *block, int slot)
{
	if (block_has(block, AXIS_LETTERS[slot]))
		return block_column(block, AXIS_LETTERS[slot]);
	return block->m[M_TOOL] != CODE_NONE ? block->m_column[M_TOOL] : block->g_column[G_NONMODAL];
}

bool dynamic_work_offset_check_turn(struct interp *interp, const slot_values *position)
{
	const struct state *state = &interp->state;

	if (!state->dynamic.on)
		return true;
	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		if (!is_zero(position->v[slot] - state->position.v[slot]))
			return fault(&interp->at, turn_column(&interp->block, slot),
				     "%c turns while G254 is active: it is not known whether the work zero turns with "
				     "it; write G255 first",
				     AXIS_LETTERS[slot]);
	}
	return true;
}

bool dynamic_work_offset_check_read(struct interp *interp, int slot, int column)
{
	const struct dynamic_work_offset *dynamic = &interp->state.dynamic;

	if (dynamic->on)
		return fault(&interp->at, column,
			     "it is not known whether the position is relative to the work zero or to the one that "
			     "G254 has moved; write G255 first");
	if (slot > SLOT_Z || !dynamic->unsure[slot])
		return true;
	return fault(&interp->at, column,
		     "the position after G%d is not known; move the axis to an absolute coordinate first",
		     dynamic->unsure_code / 10);
}

void dynamic_work_offset_suspend(struct state *state, bool *suspended)
{
	*suspended = state->dynamic.on;
	state->dynamic.on = false;
	state_update_offset(state);
}

void dynamic_work_offset_resume(struct state *state, bool suspended)
{
	state->dynamic.on = suspended;
	state_update_offset(state);
}
