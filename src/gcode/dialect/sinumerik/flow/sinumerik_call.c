#include "gcode/dialect/sinumerik/flow/sinumerik_call.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "gcode/dialect/sinumerik/builder/sinumerik_builder.h"
#include "gcode/dialect/sinumerik/flow/sinumerik_proc.h"
#include "gcode/dialect/sinumerik/flow/sinumerik_program.h"
#include "gcode/dialect/sinumerik/flow/sinumerik_save.h"
#include "gcode/dialect/sinumerik/values/sinumerik_expr.h"
#include "gcode/dialect/sinumerik/values/sinumerik_variables.h"
#include "gcode/dialect/sinumerik/words/sinumerik_name.h"
#include "gcode/eval/expr.h"
#include "gcode/program.h"

/* --------------------------------------------------------------- arguments */

/* The variable of the caller, if the argument is nothing else. A VAR parameter refers to this variable. */
static int variable_alone(struct interp *interp, struct lexer *lexer)
{
	const size_t position = lexer->position;
	char name[SINUMERIK_NAME + 1], byte;
	int found = sinumerik_name_read(lexer, name) ? sinumerik_variables_find(sinumerik_of(interp), name) : -1;

	byte = lexer_peek(lexer);
	lexer->position = position;
	return byte == ',' || byte == ')' ? found : -1;
}

static bool read_argument(struct interp *interp, struct lexer *lexer)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);
	const size_t i = sinumerik->passed.count;
	const char byte = lexer_peek(lexer);

	if (i == SINUMERIK_ARGUMENTS_MAX)
		return fault(lexer->at, lexer_next_column(lexer), "more than %d arguments", SINUMERIK_ARGUMENTS_MAX);
	sinumerik->passed.count++;
	sinumerik->passed.numbers[i] = NAN;
	sinumerik->passed.texts[i].bytes[0] = '\0';
	sinumerik->passed.is_text[i] = false;
	sinumerik->passed.variable[i] = -1;
	if (byte == ',' || byte == ')')
		return true;
	sinumerik->passed.variable[i] = variable_alone(interp, lexer);
	if (sinumerik->passed.variable[i] >= 0 &&
	    sinumerik->variables.items[sinumerik->passed.variable[i]].dimensions > 0) {
		char name[SINUMERIK_NAME + 1];

		sinumerik_name_read(lexer, name);
		return true;
	}
	sinumerik->passed.is_text[i] = sinumerik_expr_is_text(interp, lexer);
	return sinumerik->passed.is_text[i]
		   ? sinumerik_expr_text(interp, lexer, &sinumerik->passed.texts[i])
		   : sinumerik_expr_number(interp, lexer, &sinumerik->passed.numbers[i]);
}

bool sinumerik_call_arguments(struct interp *interp, struct lexer *lexer)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);

	sinumerik->passed.count = 0;
	if (!sinumerik_name_take_byte(lexer, '(') || sinumerik_name_take_byte(lexer, ')'))
		return true;
	do {
		if (!read_argument(interp, lexer))
			return false;
	} while (sinumerik_name_take_byte(lexer, ','));
	return sinumerik_name_need(lexer, ')', "the arguments");
}

/* ------------------------------------------------------------------ levels */

static bool enter(struct interp *interp, const struct position *entry, long last_line, int rounds, const char *title,
		  int column)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);
	struct sinumerik_call *call;

	if (sinumerik->calls.depth == SINUMERIK_LEVELS_MAX)
		return fault(&interp->at, column, "more than %d calls inside each other", SINUMERIK_LEVELS_MAX);
	call = &sinumerik->calls.items[sinumerik->calls.depth++];
	*call = (struct sinumerik_call){.back = source_next(interp->program.source), .entry = *entry,
					.last_line = last_line, .left = rounds - 1, .file = interp->at.file,
					.line = interp->at.line, .column = column, .loops = sinumerik->loops.count};
	snprintf(call->title, sizeof(call->title), "%s", title);
	return program_jump(&interp->program, entry, &interp->at, column);
}

bool sinumerik_call_run(struct interp *interp, const char *name, char type, int repeats, int column)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);
	struct position entry;

	if (sinumerik_builder_is_known(interp, name))
		return sinumerik_builder_run(interp, name, column);
	for (size_t i = 0; i < sinumerik->passed.count && repeats > 1; i++) {
		if (sinumerik->passed.is_text[i])
			return fault(&interp->at, column, "%s with P and a text among its arguments is not supported",
				     name);
	}
	if (!sinumerik_program_find(interp, name, type, column, &entry) ||
	    !enter(interp, &entry, 0, repeats, name, column))
		return false;
	sinumerik_top_call(sinumerik)->argument_count = sinumerik->passed.count;
	memcpy(sinumerik_top_call(sinumerik)->arguments, sinumerik->passed.numbers, sizeof(sinumerik->passed.numbers));
	sinumerik_top_call(sinumerik)->begun_count = 0;
	sinumerik->calls.level++;
	sinumerik->calls.entering = true;
	return true;
}

bool sinumerik_call_modal(struct interp *interp)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);
	struct sinumerik_modal *modal = &sinumerik->modal;

	sinumerik->passed.count = modal->argument_count;
	memcpy(sinumerik->passed.numbers, modal->arguments, sizeof(sinumerik->passed.numbers));
	for (size_t i = 0; i < modal->argument_count; i++) {
		sinumerik->passed.is_text[i] = false;
		sinumerik->passed.variable[i] = -1;
	}
	modal->running = true;
	modal->depth = sinumerik->calls.depth;
	return sinumerik_call_run(interp, modal->name, '\0', 1, 1);
}

bool sinumerik_call_is_inside(const struct interp *interp)
{
	return sinumerik_of(interp)->calls.level > 0;
}

/* Ends the repeated parts of the current program that are still active. */
static void leave_repeats(struct sinumerik *sinumerik)
{
	while (sinumerik->calls.depth && sinumerik_top_call(sinumerik)->last_line)
		sinumerik->calls.depth--;
}

/* Calls of the previous round have replaced the arguments. */
static void take_arguments(struct sinumerik *sinumerik, const struct sinumerik_call *call)
{
	sinumerik->passed.count = call->argument_count;
	memcpy(sinumerik->passed.numbers, call->arguments, sizeof(call->arguments));
	for (size_t i = 0; i < call->argument_count; i++) {
		sinumerik->passed.is_text[i] = false;
		sinumerik->passed.variable[i] = -1;
	}
}

bool sinumerik_call_return(struct interp *interp, int column)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);
	struct sinumerik_call *call;
	struct position to;

	leave_repeats(sinumerik);
	if (!sinumerik_call_is_inside(interp))
		return fault(&interp->at, column, "this returns, but no subprogram is being carried out");
	call = sinumerik_top_call(sinumerik);
	sinumerik->loops.count = call->loops;
	if (sinumerik->modal.on && sinumerik->modal.level == sinumerik->calls.level)
		return fault(&interp->at, column,
			     "the subprogram ends while its MCALL %s is in force: what then becomes of it is not "
			     "certain; MCALL before the end",
			     sinumerik->modal.name);
	if (call->saves && !sinumerik_save_restore(interp, &call->saved, column))
		return false;
	if (call->left > 0 && !sinumerik_proc_check_begun(interp, call, column))
		return false;
	sinumerik_variables_leave(sinumerik, sinumerik->calls.level - 1);
	to = call->left > 0 ? call->entry : call->back;
	if (call->left > 0) {
		call->left--;
		call->saves = false;
		take_arguments(sinumerik, call);
		sinumerik->calls.entering = true;
	} else {
		sinumerik->calls.depth--;
		sinumerik->calls.level--;
		sinumerik->modal.running = sinumerik->modal.running && sinumerik->calls.depth > sinumerik->modal.depth;
	}
	return program_jump(&interp->program, &to, &interp->at, column);
}

/* ----------------------------------------------------------------- repeats */

bool sinumerik_call_repeat(struct interp *interp, const struct position *entry, long last_line, int rounds, int column)
{
	return enter(interp, entry, last_line, rounds, "the repeated part", column);
}

bool sinumerik_call_part(struct interp *interp, const struct position *entry, long last_line, int column)
{
	if (!enter(interp, entry, last_line, 1, "the part that is called", column))
		return false;
	sinumerik_top_call(sinumerik_of(interp))->called = true;
	return true;
}

/* The current line is after the last line of the repeated part. */
static bool next_round(struct interp *interp)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);
	struct sinumerik_call *call = sinumerik_top_call(sinumerik);

	if (call->left-- > 0)
		return program_jump(&interp->program, &call->entry, &interp->at, 1);
	sinumerik->calls.depth--;
	return program_jump(&interp->program, &call->back, &interp->at, 1);
}

bool sinumerik_call_round(struct interp *interp, bool *left)
{
	const struct sinumerik_call *call = sinumerik_top_call(sinumerik_of(interp));

	*left = call && call->last_line && interp->at.line == call->last_line + 1 &&
		call->entry.source == interp->program.source;
	if (!*left)
		return true;
	/* This line is after the part, and was not executed. */
	if (interp->furthest == interp->at.line && interp->program.source == interp->program.sources.items[0])
		interp->furthest--;
	return next_round(interp);
}

bool sinumerik_call_jumped(struct interp *interp, long line, int column)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);

	while (sinumerik->calls.depth) {
		const struct sinumerik_call *call = sinumerik_top_call(sinumerik);

		if (!call->last_line || (line >= call->entry.line && line <= call->last_line))
			return true;
		if (call->called)
			return fault(&interp->at, column,
				     "this leaves the part that CALL BLOCK of line %ld calls: where it then goes back "
				     "from is not certain",
				     call->line);
		sinumerik->calls.depth--;
	}
	return true;
}

bool sinumerik_call_check_last(struct interp *interp, int column)
{
	const struct sinumerik_call *call = sinumerik_top_call(sinumerik_of(interp));

	return !call || !call->called || call->last_line != interp->at.line ||
	       call->entry.source != interp->program.source || call->entry.line == call->last_line ||
	       fault(&interp->at, column,
		     "words behind the label that ends the part of CALL BLOCK: whether they are carried out is not "
		     "certain; write the label in a line of its own");
}

bool sinumerik_call_check_end(struct interp *interp, int column)
{
	const struct sinumerik *sinumerik = sinumerik_of(interp);

	for (int i = sinumerik->calls.depth; i-- > 0 && sinumerik->calls.items[i].last_line;) {
		if (sinumerik->calls.items[i].called)
			return fault(&interp->at, column,
				     "the program ends in the part that CALL BLOCK of line %ld calls: whether it goes "
				     "back from here is not certain",
				     sinumerik->calls.items[i].line);
	}
	return true;
}

/* ------------------------------------------------------------------- hooks */

bool sinumerik_call_end_of_file(struct interp *interp)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);
	const struct srcloc loc = {interp->at.file, interp->program.source->reader.line, 0};
	const struct sinumerik_call *call = sinumerik_top_call(sinumerik);
	const size_t outside = call && call->last_line ? call->loops : 0;

	if (sinumerik->loops.count > outside &&
	    sinumerik->loops.items[sinumerik->loops.count - 1].level == sinumerik->calls.level) {
		diag_error(interp->diag, loc, "the loop of line %ld is not closed at the end of the file",
			   sinumerik->loops.items[sinumerik->loops.count - 1].start.line);
		return false;
	}
	if (sinumerik->soft.waits) {
		diag_error(interp->diag, loc,
			   "G%d of line %ld waits for the path that it touches, but the file ends here",
			   sinumerik->soft.words.code / 10, sinumerik->soft.first.at.line);
		return false;
	}
	/* The last line of the part is the last line of the file. */
	if (call && call->last_line)
		return next_round(interp);
	if (!sinumerik_call_is_inside(interp))
		return true;
	diag_error(interp->diag, loc, "the subprogram ends without M17 or RET");
	return false;
}

_Static_assert(SINUMERIK_LEVELS_MAX <= CALLS_MAX, "every call has its place in a chain");

bool sinumerik_call_caller(const struct interp *interp, size_t level, struct srcloc *at, struct strbuf *title)
{
	const struct sinumerik *sinumerik = sinumerik_of(interp);
	const struct sinumerik_call *call;

	if ((size_t)sinumerik->calls.depth <= level)
		return false;
	call = &sinumerik->calls.items[(size_t)sinumerik->calls.depth - 1 - level];
	*at = (struct srcloc){call->file, call->line, call->column};
	if (title)
		strbuf_addf(title, "%s", call->title);
	return true;
}
