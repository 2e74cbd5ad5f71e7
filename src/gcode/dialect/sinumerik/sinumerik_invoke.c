#include "gcode/dialect/sinumerik/sinumerik_invoke.h"

#include <math.h>
#include <string.h>

#include "base/ascii.h"
#include "gcode/dialect/sinumerik/builder/sinumerik_builder.h"
#include "gcode/dialect/sinumerik/builder/sinumerik_cycle_refused.h"
#include "gcode/dialect/sinumerik/cycles/sinumerik_contour.h"
#include "gcode/dialect/sinumerik/cycles/sinumerik_cycle.h"
#include "gcode/dialect/sinumerik/cycles/sinumerik_pattern.h"
#include "gcode/dialect/sinumerik/cycles/sinumerik_region.h"
#include "gcode/dialect/sinumerik/cycles/sinumerik_swivel.h"
#include "gcode/dialect/sinumerik/flow/sinumerik_call.h"
#include "gcode/dialect/sinumerik/path/sinumerik_path.h"
#include "gcode/dialect/sinumerik/values/sinumerik_expr.h"
#include "gcode/dialect/sinumerik/words/sinumerik_name.h"
#include "gcode/eval/expr.h"

static bool set_modal(struct interp *interp, const struct sinumerik_block *block)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);
	struct sinumerik_modal *modal = &sinumerik->modal;

	if (modal->running && sinumerik->calls.depth > modal->depth)
		return fault(&interp->at, block->modal_column, "MCALL in the subprogram %s, which MCALL calls",
			     modal->name);
	*modal = (struct sinumerik_modal){.on = block->call[0] != '\0', .level = sinumerik->calls.level};
	if (!modal->on)
		return true;
	modal->cycle = sinumerik_cycle_drills(block->call) || sinumerik_region_is(block->call);
	if (sinumerik_region_is(block->call) &&
	    !sinumerik_region_check_modal(interp, block->call, sinumerik->passed.numbers, sinumerik->passed.count,
					  block->call_column)) {
		modal->on = false;
		return false;
	}
	modal->on = modal->cycle || !sinumerik_cycle_refused(block->call);
	if (!modal->on)
		return sinumerik_builder_refuse(interp, block->call, sinumerik_cycle_refused(block->call),
						block->call_column);
	strcpy(modal->name, block->call);
	modal->argument_count = sinumerik->passed.count;
	memcpy(modal->arguments, sinumerik->passed.numbers, sizeof(modal->arguments));
	for (size_t i = 0; i < sinumerik->passed.count; i++) {
		if (!modal->cycle && (sinumerik->passed.is_text[i]))
			return fault(&interp->at, block->call_column,
				     "a modal call of a subprogram with text among its arguments is not supported");
	}
	return true;
}

/* P=3 after the arguments of a subprogram. */
static bool read_repeats(struct interp *interp, struct lexer *lexer, const struct sinumerik_block *block, int *repeats)
{
	const size_t position = lexer->position;
	char next;

	if (sinumerik_cycle_drills(block->call) || sinumerik_region_is(block->call) || block->modal ||
	    sinumerik_block_has(block, 'P') || ascii_upper(lexer_peek(lexer)) != 'P')
		return true;
	lexer_take(lexer);
	next = lexer->at->text[lexer->position];
	if (sinumerik_starts_name(next)) {
		lexer->position = position;
		return true;
	}
	sinumerik_name_take_byte(lexer, '=');
	return sinumerik_expr_whole(interp, lexer, "P", 1, 9999, repeats);
}

/* Cycles of the control that move axes. Drilling, patterns and regions have their own tables. */
static bool is_other_cycle(const char *name)
{
	return !strncmp(name, "CYCLE8", 6) || !strcmp(name, "CYCLE62") || !strcmp(name, "CYCLE72");
}

static bool run_call(struct interp *interp, struct lexer *lexer, const struct sinumerik_block *block)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);
	const char *name = block->call;
	const int column = block->call_column, index = 'P' - 'A';
	int repeats = 1;

	sinumerik->passed.count = 0;
	if (block->call_has_arguments && (!sinumerik_call_arguments(interp, lexer) ||
					  !read_repeats(interp, lexer, block, &repeats)))
		return false;
	if (lexer_peek(lexer) != '\0' && lexer_peek(lexer) != ';')
		return fault(lexer->at, lexer_next_column(lexer), "nothing can follow a call in its block");
	if (block->modal)
		return set_modal(interp, block);
	if (interp->comp.side != 0 && (sinumerik_cycle_drills(name) || sinumerik_pattern_is(name) ||
				       sinumerik_region_is(name) || is_other_cycle(name)))
		return fault(&interp->at, column, "%s while tool radius compensation is on; G40 first", name);
	if (sinumerik_modal_acts(sinumerik) && !strcmp(name, "CYCLE72"))
		return fault(&interp->at, column, "CYCLE72 while %s is called behind each motion; MCALL first",
			     sinumerik->modal.name);
	if (sinumerik_modal_acts(sinumerik) && sinumerik->modal.cycle &&
	    (sinumerik_cycle_drills(name) || sinumerik_region_is(name) || !strcmp(name, "CYCLE800")))
		return fault(&interp->at, column, "%s while %s is called behind each motion; MCALL first", name,
			     sinumerik->modal.name);
	if (sinumerik_block_has(block, 'P') &&
	    (sinumerik_cycle_drills(name) || sinumerik_pattern_is(name) || sinumerik_region_is(name) ||
	     is_other_cycle(name)))
		return fault(&interp->at, block->column[index], "P belongs to the call of a subprogram");
	if (sinumerik_cycle_drills(name))
		return sinumerik_cycle_drill(interp, name, sinumerik->passed.numbers, sinumerik->passed.count, column);
	if (sinumerik_pattern_is(name))
		return sinumerik_pattern_run(interp, name, column);
	if (sinumerik_region_is(name))
		return sinumerik_region_mill(interp, name, sinumerik->passed.numbers, sinumerik->passed.count, column);
	if (!strcmp(name, "CYCLE800"))
		return sinumerik_swivel_run(interp, column);
	if (!strcmp(name, "CYCLE62"))
		return sinumerik_contour_select(interp, column);
	if (!strcmp(name, "CYCLE72"))
		return sinumerik_contour_mill(interp, column);
	if (!strcmp(name, "CYCLE832"))
		return sinumerik_path_smooth(interp, column);
	if (sinumerik_cycle_refused(name) && !sinumerik_builder_is_known(interp, name))
		return sinumerik_builder_refuse(interp, name, sinumerik_cycle_refused(name), column);
	if (sinumerik_block_has(block, 'P')) {
		if (!(block->value[index] >= 1 && block->value[index] <= 9999) ||
		    floor(block->value[index]) < block->value[index])
			return fault(&interp->at, block->column[index], "P must be a whole number from 1 to 9999");
		repeats = (int)block->value[index];
	}
	return sinumerik_call_run(interp, name, '\0', repeats, column);
}

bool sinumerik_invoke_call(struct interp *interp, struct lexer *lexer, const struct sinumerik_block *block)
{
	return block->call[0] ? run_call(interp, lexer, block) : !block->modal || set_modal(interp, block);
}

bool sinumerik_invoke_modal(struct interp *interp)
{
	return !sinumerik_modal_acts(sinumerik_of(interp)) || sinumerik_pattern_modal(interp);
}

/*
 * 840D sl, job planning, "Modal subprogram call (MCALL)": the call is also executed without a motion, if the block
 * has F or S while G0 or G1 is active, or G0 or G1 without axes.
 */
bool sinumerik_invoke_check(struct interp *interp, const struct sinumerik_block *block)
{
	const struct sinumerik *sinumerik = sinumerik_of(interp);
	const int motion = interp->state.motion;
	const char letter = sinumerik_block_has(block, 'F') ? 'F' : 'S';

	if (!sinumerik_modal_acts(sinumerik) || block->call[0] || block->modal || (motion != G0 && motion != G1))
		return true;
	if (block->code[SINUMERIK_MOTION] == CODE_NONE && !sinumerik_block_has(block, letter))
		return true;
	return fault(&interp->at,
		     block->code[SINUMERIK_MOTION] != CODE_NONE ? block->code_column[SINUMERIK_MOTION]
								: block->column[letter - 'A'],
		     "F, S, G0 or G1 without axes while MCALL %s is in force: the control calls %s here, too; write it "
		     "before MCALL or beside the next position",
		     sinumerik->modal.name, sinumerik->modal.name);
}
