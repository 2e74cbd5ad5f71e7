#include "gcode/dialect/fanuc/builder_macro.h"

#include <math.h>

#include "gcode/dialect/fanuc/macro_b_vars.h"
#include "gcode/execute/moves_around.h"

const struct builder_macro *builder_macro_of_program(const struct interp *interp, int number)
{
	const struct controller *controller = &interp->config->controller;

	for (size_t i = 0; i < controller->macro_count; i++) {
		if (controller->macros[i].program == number)
			return &controller->macros[i];
	}
	return NULL;
}

const struct builder_macro *builder_macro_of_code(const struct interp *interp, double code)
{
	const struct controller *controller = &interp->config->controller;

	for (size_t i = 0; i < controller->macro_count; i++) {
		if (controller->macros[i].code > 0 && fabs(controller->macros[i].code - code) < 1e-9)
			return &controller->macros[i];
	}
	return NULL;
}

static void set_word(struct block *block, char letter, double value, int column)
{
	if (isnan(value))
		return;
	block->letters |= letter_bit(letter);
	/* The arguments have been scaled already. */
	block->points |= letter_bit(letter);
	block->value[letter - 'A'] = value;
	block->column[letter - 'A'] = column;
}

void builder_macro_begin(struct interp *interp)
{
	struct builder_call *call = &macro_b_of(interp)->builder;
	const double *arguments = call->arguments;
	struct block *block = &interp->block;

	macro_b_vars_doubt(interp);
	block_clear(block);
	block->words = 1;
	call->motion = interp->state.motion;
	call->path_motion = interp->state.path_motion;
	call->feed = interp->state.feed_linear;
	if (call->macro->action != MACRO_MOVE)
		return;
	/* B-63944EN, argument specification I: #24 to #26 are X, Y and Z, #9 is F. */
	set_word(block, 'X', arguments[24], call->column);
	set_word(block, 'Y', arguments[25], call->column);
	set_word(block, 'Z', arguments[26], call->column);
	set_word(block, 'F', arguments[9], call->column);
	if (block->letters & AXIS_BITS) {
		block->g[G_MOTION] = G1;
		block->g_column[G_MOTION] = call->column;
	}
}

bool builder_macro_end(struct interp *interp)
{
	struct builder_call *call = &macro_b_of(interp)->builder;
	const struct builder_macro *macro = call->macro;

	if (!macro)
		return true;
	call->macro = NULL;
	interp->state.motion = call->motion;
	interp->state.path_motion = call->path_motion;
	if (interp->state.feed_mode != FEED_INVERSE_TIME)
		interp->state.feed_linear = call->feed;
	return macro->action != MACRO_AROUND || builder_macro_around(interp, macro, call->column);
}

bool builder_macro_around(struct interp *interp, const struct builder_macro *macro, int column)
{
	const struct state *state = &interp->state;

	macro_b_vars_doubt(interp);
	if (state->tcp != TCP_OFF || interp->comp.side != 0)
		return fault(&interp->at, column,
			     "%c%g with action=\"around\" is not supported under tool centre point control or cutter "
			     "compensation",
			     macro->program == MACRO_OF_CODE ? 'G' : 'O',
			     macro->program == MACRO_OF_CODE ? macro->code : macro->program);
	return moves_around_go(interp, macro->around, column);
}
