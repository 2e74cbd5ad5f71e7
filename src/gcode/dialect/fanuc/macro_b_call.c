#include "gcode/dialect/fanuc/macro_b_call.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "gcode/dialect/fanuc/builder_macro.h"
#include "gcode/dialect/fanuc/macro_b_request.h"
#include "gcode/dialect/fanuc/macro_b_seek.h"
#include "gcode/execute/pocket_milling.h"
#include "gcode/restart.h"

const char *macro_b_call_title(const struct macro_b_call *call, char *buffer)
{
	snprintf(buffer, MACRO_B_TITLE, call->kind == MACRO_B_M97 ? "N%d" : "O%d", call->number);
	return buffer;
}

static bool is_macro_call(enum macro_b_call_kind kind)
{
	return kind == MACRO_B_G65 || kind == MACRO_B_G66;
}

/* -------------------------------------------------------------- the levels */

static bool enter(struct interp *interp, enum macro_b_call_kind kind, int number, int repeats, int column,
		  const struct position *entry)
{
	struct macro_b *macro = macro_b_of(interp);
	const struct position back = source_next(interp->program.source);
	const struct position program = kind == MACRO_B_M97 ? macro_b_call_in_hand(interp)->program : *entry;
	struct macro_b_call *call;

	if (macro->level == MACRO_B_CALLS_MAX)
		return fault(&interp->at, column, "more than %d nested calls", MACRO_B_CALLS_MAX);
	if (is_macro_call(kind) && macro->macro_calls == macro->rules->macro_calls_max)
		return fault(&interp->at, column, "more than %d nested macro calls",
			     macro->rules->macro_calls_max);
	macro->level++;
	macro->macro_calls += is_macro_call(kind);
	macro->vars.level += is_macro_call(kind);
	macro->jumped = true;
	call = macro_b_call_in_hand(interp);
	*call = (struct macro_b_call){.kind = kind, .number = number, .program = program, .entry = *entry, .back = back,
				    .left = repeats - 1, .file = interp->at.file, .line = interp->at.line,
				    .column = column};
	return macro_b_seek_jump(interp, entry, column);
}

static bool leave_call(struct interp *interp, int column)
{
	struct macro_b *macro = macro_b_of(interp);
	struct macro_b_call *call = macro_b_call_in_hand(interp);

	if (call->left > 0) {
		call->left--;
		call->loop_count = 0;
		return macro_b_seek_jump(interp, &call->entry, column);
	}
	macro->level--;
	macro->macro_calls -= is_macro_call(call->kind);
	macro->vars.level -= is_macro_call(call->kind);
	return macro_b_seek_jump(interp, &call->back, column);
}

/* --------------------------------------------------------------- G65, G66 */

/* B-63944EN, simple call (G65): the call has its own local variables, all vacant except its arguments. */
static bool call_macro(struct interp *interp, enum macro_b_call_kind kind, const struct macro_b_request *request,
		       int column)
{
	struct macro_b_vars *vars = &macro_b_of(interp)->vars;
	struct position entry;

	if (!macro_b_seek_program(interp, request->number, column, &entry) ||
	    !enter(interp, kind, request->number, request->repeats, column, &entry))
		return false;
	memcpy(vars->local[vars->level], request->arguments, sizeof(request->arguments));
	return true;
}

/*
 * Haas: "the arguments are set only on the first repetition", so the next repetition finds the variables as the macro
 * left them. Fanuc's manual does not say this.
 */
static bool check_repeats(struct interp *interp, const struct macro_b_request *request, int column)
{
	if (request->repeats == 1 || macro_b_of(interp)->rules->repeats_keep_arguments)
		return true;
	for (int i = 1; i <= MACRO_B_LOCALS; i++) {
		if (!isnan(request->arguments[i]))
			return fault(&interp->at, column,
				     "L with arguments is not supported, because it is not known whether each "
				     "repetition starts with the same arguments; call the macro in a loop");
	}
	return true;
}

/* Calls a program of the machine builder: no effect, or a block that run_block carries out instead of this line. */
static void call_builder(struct interp *interp, const struct builder_macro *macro,
			 const struct macro_b_request *request, int column, bool *done)
{
	struct builder_call *call = &macro_b_of(interp)->builder;

	*done = macro->action == MACRO_NONE;
	if (*done)
		return;
	call->macro = macro;
	call->column = column;
	memcpy(call->arguments, request->arguments, sizeof(request->arguments));
}

bool macro_b_call_g65(struct interp *interp, struct lexer *lexer, int column, bool *done)
{
	const struct builder_macro *macro;
	struct macro_b_request request;

	if (!macro_b_request_read(interp, lexer, column, 0, &request) || !check_repeats(interp, &request, column))
		return false;
	macro = builder_macro_of_program(interp, request.number);
	if (!macro)
		return call_macro(interp, MACRO_B_G65, &request, column);
	call_builder(interp, macro, &request, column, done);
	return true;
}

bool macro_b_call_by_code(struct interp *interp, struct lexer *lexer, int column, const struct builder_macro *macro,
			  bool *done)
{
	struct macro_b_request request;

	if (!macro_b_request_read(interp, lexer, column, macro->program, &request))
		return false;
	call_builder(interp, macro, &request, column, done);
	return true;
}

/* B-63944EN, modal call (G66): after each following block that moves; the block of G66 itself calls nothing. */
bool macro_b_call_g66(struct interp *interp, struct lexer *lexer, int column)
{
	struct macro_b *macro = macro_b_of(interp);
	const struct builder_macro *builder;
	struct macro_b_request request;
	struct position entry;

	if (!macro_b_request_read(interp, lexer, column, 0, &request) || !check_repeats(interp, &request, column))
		return false;
	builder = builder_macro_of_program(interp, request.number);
	if (builder && builder->action != MACRO_NONE)
		return fault(&interp->at, column,
			     "G66 is not supported with a builder's macro that moves axes");
	if (builder)
		return true;
	if (macro->modal)
		return fault(&interp->at, column, "G66 inside another G66 is not supported; cancel the first by G67");
	if (!macro_b_seek_program(interp, request.number, column, &entry))
		return false;
	macro->modal = true;
	macro->modal_number = request.number;
	macro->modal_repeats = request.repeats;
	macro->modal_level = macro->level;
	memcpy(macro->modal_arguments, request.arguments, sizeof(request.arguments));
	return true;
}

/* May G66 call its macro after this block? Moves of the macro itself call nothing. */
static bool modal_heeds(const struct interp *interp)
{
	const struct macro_b *macro = macro_b_of(interp);

	if (!macro->modal || !(interp->block.letters & AXIS_BITS) || interp->block.g[G_NONMODAL] == G4)
		return false;
	for (int level = macro->level; level > macro->modal_level; level--) {
		if (macro->calls[level].kind == MACRO_B_G66)
			return false;
	}
	return true;
}

/*
 * Calls the macro of G66 after a block. The manual does not say whether a move in a subprogram calls the macro if G66
 * is outside of the subprogram: this is refused.
 */
static bool call_modal(struct interp *interp)
{
	const struct macro_b *macro = macro_b_of(interp);
	const struct block *block = &interp->block;
	struct macro_b_request request = {.number = macro->modal_number, .repeats = macro->modal_repeats};
	const int column = block_motion_column(block);

	if (block->m[M_STOP] >= 2)
		return fault(&interp->at, block->m_column[M_STOP],
			     "M%d in a block with motion while G66 is active; write G67 first", block->m[M_STOP]);
	if (macro->level != macro->modal_level)
		return fault(&interp->at, column, "a move in a subprogram while G66 is active is not supported");
	if (block->g[G_NONMODAL] != CODE_NONE || block->motion == CODE_NONE || code_is_cycle(block->motion))
		return fault(&interp->at, column,
			     "axis words in a block without a plain move while G66 is active; write G67 first");
	memcpy(request.arguments, macro->modal_arguments, sizeof(request.arguments));
	return call_macro(interp, MACRO_B_G66, &request, column);
}

/* ------------------------------------------------------------ M97, M98, M99 */

/*
 * B-64484EN, "Subprogram (M98, M99)", call by a sequence number: M98 Q calls the current program from its block N up to
 * M99, like M97 P of Haas. With P, Q would be a block of program P.
 */
static bool take_local(struct interp *interp, int *number)
{
	const struct block *block = &interp->block;

	if (block_has(block, 'P'))
		return fault(&interp->at, block_column(block, 'Q'), "M98 with both P and Q is not supported");
	return block_integer(block, &interp->at, 'Q', 1, 99999999, number);
}

/* A P of five to eight digits, without L: repetitions and program, or, by parameter 11304#3, only a program. */
static bool split_p(struct interp *interp, int *number, int *repeats)
{
	const int column = block_column(&interp->block, 'P'), program = *number % 10000, count = *number / 10000;
	bool whole, part;

	if (program == 0)
		return fault(&interp->at, column, "the program number (the last four digits of P) is 0");
	if (!macro_b_seek_has_program(interp, *number, column, &whole) ||
	    (whole && !macro_b_seek_has_program(interp, program, column, &part)))
		return false;
	if (whole && (part || builder_macro_of_program(interp, program)))
		return fault(&interp->at, column,
			     "P%d is ambiguous: O%d once or O%d %d times (both programs exist); write L1, or P%d and "
			     "L%d",
			     *number, *number, program, count, program, count);
	*repeats = whole ? 1 : count;
	*number = whole ? *number : program;
	return true;
}

/*
 * B-63944EN, subprogram call: P is the number of the program. Without L, the last four digits of a longer P are the
 * program, and the digits before them the repetitions. Haas, M98: P and L.
 */
static bool read_m98(struct interp *interp, int *number, int *repeats)
{
	const struct block *block = &interp->block;
	const struct macro_b_rules *rules = macro_b_of(interp)->rules;
	int column = block->m_column[M_STOP];

	*repeats = 1;
	if (block_has(block, 'Q') && !take_local(interp, number))
		return false;
	if (block_has(block, 'Q'))
		return !block_has(block, 'L') || block_integer(block, &interp->at, 'L', 1, 9999, repeats);
	if (!block_has(block, 'P'))
		return fault(&interp->at, column, "M%d needs P, the number of the %s", block->m[M_STOP],
			     block->m[M_STOP] == 97 ? "block" : "program");
	if (!block_integer(block, &interp->at, 'P', 1, rules->m98_program_max, number))
		return false;
	if (block_has(block, 'L'))
		return block_integer(block, &interp->at, 'L', 1, 9999, repeats);
	return !rules->m98_repeats_in_p || *number <= 9999 || split_p(interp, number, repeats);
}

static bool do_m98(struct interp *interp, int column)
{
	int number, repeats;
	struct position entry;
	bool by_block = block_has(&interp->block, 'Q'), local = interp->block.m[M_STOP] == 97 || by_block;
	const struct builder_macro *macro;

	if (!read_m98(interp, &number, &repeats))
		return false;
	macro = local ? NULL : builder_macro_of_program(interp, number);
	if (macro && macro->action == MACRO_MOVE)
		return fault(&interp->at, column, "M98 calls O%d, which needs the X, Y and Z of a G65 call", number);
	if (macro)
		return macro->action == MACRO_NONE || builder_macro_around(interp, macro, column);
	if (local ? !macro_b_seek_only(interp, number, block_column(&interp->block, by_block ? 'Q' : 'P'), &entry)
		  : !macro_b_seek_program(interp, number, column, &entry))
		return false;
	return enter(interp, local ? MACRO_B_M97 : MACRO_B_M98, number, repeats, column, &entry);
}

static bool start_anew(struct interp *interp)
{
	struct macro_b *macro = macro_b_of(interp);
	struct strbuf variables = {0};

	strbuf_add(&variables, (const char *)&macro->vars, sizeof(macro->vars));
	strbuf_add(&variables, (const char *)&macro->modal, sizeof(macro->modal));
	macro->calls[0].loop_count = 0;
	return restart_program(interp, &variables);
}

/* The subprogram may have been the outline of a pocket. */
static bool end_outline(struct interp *interp, int column)
{
	const bool good = pocket_milling_finish(interp);

	return leave_call(interp, column) && good;
}

/*
 * M99 P: Fanuc continues at this block of the caller (B-63944EN, subprogram), Haas at a block of the subprogram itself
 * (operator's manual, "Conditional Expressions").
 */
static bool do_m99(struct interp *interp, int column)
{
	const struct block *block = &interp->block;
	struct macro_b_call *call = macro_b_call_in_hand(interp);
	int number, p = block_has(block, 'P') ? block_column(block, 'P') : 0;
	struct position target;

	if (block_has(block, 'L'))
		return fault(&interp->at, block_column(block, 'L'), "M99 with L is not supported");
	if (macro_b_of(interp)->level == 0 && !p)
		return start_anew(interp);
	if (!p)
		return end_outline(interp, column);
	if (!block_integer(block, &interp->at, 'P', 1, 99999999, &number))
		return false;
	if (macro_b_of(interp)->level == 0 || macro_b_of(interp)->rules->m99_own_block)
		return macro_b_seek_goto(interp, number, p);
	if (call->left > 0)
		return fault(&interp->at, p, "M99 P before the last repetition of a call is not supported");
	if (call->kind == MACRO_B_G66)
		return fault(&interp->at, p, "M99 P in a macro that G66 calls is not supported");
	return leave_call(interp, column) && macro_b_seek_only(interp, number, p, &target) &&
	       macro_b_seek_jump(interp, &target, p);
}

/* Haas, "G150": P is a block N of the current program, or else a program. */
static bool call_outline(struct interp *interp)
{
	struct diag *heard = interp->at.diag, unheard = {0};
	const int column = block_column(&interp->block, 'P');
	struct position entry;
	int number;
	bool local;

	if (!block_integer(&interp->block, &interp->at, 'P', 1, 99999999, &number))
		return false;
	interp->at.diag = &unheard;
	local = macro_b_seek_only(interp, number, column, &entry);
	interp->at.diag = heard;
	if (!local && !macro_b_seek_program(interp, number, column, &entry))
		return false;
	return enter(interp, local ? MACRO_B_M97 : MACRO_B_M98, number, 1, column, &entry);
}

/*
 * B-63944EN, "Macro Statements and NC Statements": for cutter compensation, macro statements are no blocks without
 * movement; nor are blocks of M98 or M99 without addresses other than O, N, P and L.
 */
static bool is_like_statement(const struct interp *interp)
{
	const struct block *block = &interp->block;

	for (int group = 0; group < G_GROUPS; group++) {
		if (block->g[group] != CODE_NONE)
			return false;
	}
	return macro_b_of(interp)->rules->calls_are_statements && block->m_count == 1 &&
	       !(block->letters & ~letter_bits("PL"));
}

bool macro_b_call_after_block(struct interp *interp)
{
	int code = interp->block.m[M_STOP], column = interp->block.m_column[M_STOP];

	if (macro_b_of(interp)->builder.macro)
		return builder_macro_end(interp);
	if (modal_heeds(interp) && !call_modal(interp))
		return false;
	if (interp->block.g[G_NONMODAL] == G150)
		return call_outline(interp);
	if (code < 97)
		return true;
	interp->comp.moved = interp->comp.moved || is_like_statement(interp);
	return code == 99 ? do_m99(interp, column) : do_m98(interp, column);
}

/* -------------------------------------------------------------- the reports */

bool macro_b_call_end_of_file(struct interp *interp)
{
	const struct macro_b_call *call = macro_b_call_in_hand(interp);
	char title[MACRO_B_TITLE];

	if (macro_b_of(interp)->level == 0)
		return true;
	diag_error(interp->diag, (struct srcloc){interp->program.source->name, interp->program.source->reader.line, 0},
		   "the subprogram %s is not closed at the end of the file: M99 is missing",
		   macro_b_call_title(call, title));
	return false;
}

_Static_assert(MACRO_B_CALLS_MAX <= CALLS_MAX, "every call has its place in a chain");

bool macro_b_call_caller(const struct interp *interp, size_t level, struct srcloc *at, struct strbuf *title)
{
	const struct macro_b *macro = macro_b_of(interp);
	const struct macro_b_call *call;
	char buffer[MACRO_B_TITLE];

	if ((size_t)macro->level <= level)
		return false;
	call = &macro->calls[macro->level - (int)level];
	*at = (struct srcloc){call->file, call->line, call->column};
	if (title)
		strbuf_addf(title, "%s", macro_b_call_title(call, buffer));
	return true;
}
