#include "gcode/dialect/klartext/flow/klartext_flow.h"

#include <stdio.h>
#include <string.h>

#include "gcode/dialect/klartext/flow/klartext_builder_cycle.h"
#include "gcode/dialect/klartext/flow/klartext_folder.h"
#include "gcode/dialect/klartext/flow/klartext_label.h"
#include "gcode/dialect/klartext/moves/klartext_comp.h"
#include "gcode/dialect/klartext/text/klartext_lexis.h"
#include "gcode/dialect/klartext/text/klartext_rest.h"
#include "gcode/dialect/klartext/values/klartext_formula.h"
#include "gcode/dialect/klartext/values/klartext_string.h"
#include "gcode/dialect/klartext/values/klartext_value.h"
#include "gcode/execute/motion_commands.h"

/* ------------------------------------------------------------------- levels */

static bool enter(struct interp *interp, enum klartext_call_kind kind, const char *title, const struct position *to,
		  int column)
{
	struct klartext *klartext = klartext_of(interp);
	struct klartext_call *call;
	const struct position back = source_next(interp->program.source);

	if (klartext->calls.level == KLARTEXT_CALLS_MAX)
		return fault(&interp->at, column, "more than %d calls inside each other", KLARTEXT_CALLS_MAX);
	call = &klartext->calls.items[++klartext->calls.level];
	*call = (struct klartext_call){
	    .kind = kind, .back = back, .file = interp->at.file, .line = interp->at.line, .column = column};
	snprintf(call->title, sizeof(call->title), "%s", title);
	klartext->calls.jumped = true;
	if (kind == KLARTEXT_PROGRAM) {
		klartext->calls.programs++;
		memset(klartext->values.ql[klartext->calls.programs], 0, sizeof(klartext->values.ql[0]));
	}
	return program_jump(&interp->program, to, &interp->at, column);
}

static bool leave(struct interp *interp, int column)
{
	struct klartext_calls *calls = &klartext_of(interp)->calls;
	const struct klartext_call *call = &calls->items[calls->level--];

	calls->programs -= call->kind == KLARTEXT_PROGRAM;
	while (calls->repeat_count && calls->repeats[calls->repeat_count - 1].level > calls->level)
		calls->repeat_count--;
	return program_jump(&interp->program, &call->back, &interp->at, column);
}

bool klartext_flow_label(struct lexer *lexer)
{
	struct interp *interp = lexer->context;
	const struct klartext_calls *calls = &klartext_of(interp)->calls;
	int column = lexer_next_column(lexer);
	char name[KLARTEXT_NAME];

	if (!klartext_label_read_name(lexer, name) || !klartext_expect_end(lexer))
		return false;
	if (strcmp(name, "0") != 0 || calls->level == 0 || calls->items[calls->level].kind != KLARTEXT_LABEL)
		return true;
	return leave(interp, column);
}

/* ------------------------------------------------------------------- CALL */

/*
 * "Program section repeats": CALL LBL n REP m runs the section from the label to the call m more times. The manuals do
 * not say what REP does if the label is behind the call.
 */
static bool repeat(struct interp *interp, const struct position here, const struct label *label, int count, int column)
{
	struct klartext_calls *calls = &klartext_of(interp)->calls;
	struct klartext_repeat *item = NULL;

	if (label->at.source == here.source && label->at.offset > here.offset)
		return fault(&interp->at, column,
			     "REP repeats the section from the label to this block, but the label stands behind it: a "
			     "subprogram is called without REP, once for each time that it runs");
	for (int i = 0; i < calls->repeat_count; i++) {
		if (calls->repeats[i].level == calls->level && position_is_same(&calls->repeats[i].at, &here))
			item = &calls->repeats[i];
	}
	if (!item && calls->repeat_count == KLARTEXT_REPEATS_MAX)
		return fault(&interp->at, column, "more than %d program section repeats at a time",
			     KLARTEXT_REPEATS_MAX);
	if (!item) {
		item = &calls->repeats[calls->repeat_count++];
		*item = (struct klartext_repeat){
		    .at = here, .level = calls->level, .left = count, .start = label->at.offset};
	}
	if (item->left_by_jump)
		return fault(&interp->at, column,
			     "a jump has left this program section before its repeats were done: whether they are "
			     "counted anew is "
			     "not known here");
	if (item->left == 0) {
		*item = calls->repeats[--calls->repeat_count];
		return true;
	}
	item->left--;
	calls->jumped = true;
	return program_jump(&interp->program, &label->body, &interp->at, column);
}

static bool call_label(struct lexer *lexer)
{
	struct interp *interp = lexer->context;
	/* Taken before the search for labels moves the reader. */
	const struct position here = source_here(interp->program.source);
	int column = lexer_next_column(lexer), count = 0;
	char name[KLARTEXT_NAME], title[KLARTEXT_NAME + 8];
	const struct label *label;
	bool repeats;

	if (!klartext_label_read_name(lexer, name))
		return false;
	repeats = klartext_take(lexer, "REP");
	if (repeats) {
		/* Older controls list "REP 5/5"; the second number is the count of repeats that are left. */
		if (!klartext_integer(lexer, "REP", 0, 65534, &count))
			return false;
		if (lexer_peek(lexer) == '/') {
			int left;

			lexer_take(lexer);
			if (!klartext_integer(lexer, "REP", 0, 65534, &left))
				return false;
		}
	}
	if (!klartext_expect_end(lexer) || !(label = klartext_label_find(interp, name, column)))
		return false;
	if (repeats)
		return repeat(interp, here, label, count, column);
	snprintf(title, sizeof(title), "LBL %s", name);
	return enter(interp, KLARTEXT_LABEL, title, &label->body, column);
}

bool klartext_flow_call_program(struct interp *interp, const char *name, int column)
{
	static const char *const endings[] = {"", ".h", ".H"};
	struct source *source;
	struct position start = {.line = 1};

	if (klartext_comp_is_selected(interp))
		return fault(&interp->at, column,
			     "CALL PGM under radius compensation is not supported; R0 comes first");
	if (!klartext_folder_find(interp, name, endings, column, &source))
		return false;
	if (!source)
		return klartext_builder_program_run(interp, name, column);
	start.source = source;
	return enter(interp, KLARTEXT_PROGRAM, source->name, &start, column);
}

static bool call_program(struct lexer *lexer)
{
	int column = lexer_next_column(lexer);
	char name[KLARTEXT_NAME];

	return klartext_string_name(lexer, "a program's name", name) && klartext_expect_end(lexer) &&
	       klartext_flow_call_program(lexer->context, name, column);
}

/* "SEL PGM" names the program that "CALL SELECTED PGM" calls. */
bool klartext_flow_select(struct lexer *lexer)
{
	struct interp *interp = lexer->context;

	if (!klartext_take(lexer, "PGM"))
		return fault(lexer->at, 1, "SEL other than SEL PGM, SEL TABLE and SEL PATTERN is not supported");
	return klartext_string_name(lexer, "a program's name", klartext_of(interp)->calls.selected) &&
	       klartext_expect_end(lexer);
}

static bool call_selected(struct lexer *lexer)
{
	struct interp *interp = lexer->context;
	int column = lexer_next_column(lexer);

	if (!klartext_take(lexer, "PGM") || !klartext_expect_end(lexer))
		return fault(lexer->at, column, "CALL SELECTED needs PGM");
	return klartext_of(interp)->calls.selected[0] != '\0'
		   ? klartext_flow_call_program(interp, klartext_of(interp)->calls.selected, column)
		   : fault(lexer->at, column, "CALL SELECTED PGM, but no SEL PGM has named a program");
}

bool klartext_flow_call(struct lexer *lexer)
{
	if (klartext_take(lexer, "LBL"))
		return call_label(lexer);
	if (klartext_take(lexer, "PGM"))
		return call_program(lexer);
	if (klartext_take(lexer, "SELECTED"))
		return call_selected(lexer);
	return fault(lexer->at, lexer_next_column(lexer), "CALL needs LBL or PGM");
}

/* ------------------------------------------------------------------- jumps */

/* Notes which program section repeats the jump leaves unfinished. */
static void leave_sections(struct klartext *klartext, const struct position *to)
{
	for (int i = 0; i < klartext->calls.repeat_count; i++) {
		struct klartext_repeat *item = &klartext->calls.repeats[i];
		bool inside =
		    to->source == item->at.source && to->offset >= item->start && to->offset <= item->at.offset;

		if (item->level == klartext->calls.level && !inside)
			item->left_by_jump = true;
	}
}

bool klartext_flow_jump(struct lexer *lexer, int number)
{
	struct interp *interp = lexer->context;
	char name[KLARTEXT_NAME];
	bool holds;
	int column;
	const struct label *label;

	if (!klartext_formula_condition(lexer, number, &holds))
		return false;
	if (!klartext_take(lexer, "GOTO") || !klartext_take(lexer, "LBL"))
		return fault(lexer->at, lexer_next_column(lexer), "FN %d needs GOTO LBL here", number);
	column = lexer_next_column(lexer);
	if (!klartext_label_read_name(lexer, name) || !klartext_expect_end(lexer))
		return false;
	if (!holds)
		return true;
	label = klartext_label_find(interp, name, column);
	if (!label)
		return false;
	klartext_of(interp)->calls.jumped = true;
	leave_sections(klartext_of(interp), &label->at);
	return program_jump(&interp->program, &label->body, &interp->at, column);
}

/* -------------------------------------------------------------------- ends */

bool klartext_flow_end(struct lexer *lexer)
{
	struct interp *interp = lexer->context;
	struct klartext *klartext = klartext_of(interp);
	const struct klartext_call *call = &klartext->calls.items[klartext->calls.level];

	if (klartext->lines.behind_end || klartext->calls.level == 0) {
		interp->ended = true;
		return klartext_comp_end(interp, 1) && motion_commands_spindle_stops(interp) &&
		       klartext_rest_check(interp);
	}
	if (call->kind == KLARTEXT_LABEL)
		return fault(lexer->at, 1, "the program ends inside of the subprogram %s: its LBL 0 is missing",
			     call->title);
	return leave(interp, 1);
}

bool klartext_flow_end_of_file(struct interp *interp)
{
	const struct klartext *klartext = klartext_of(interp);
	const struct srcloc loc = {interp->program.source->name, interp->program.source->reader.line, 0};

	if (klartext->lines.behind_end) {
		interp->ended = true;
		return true;
	}
	if (!klartext->lines.begun && klartext->calls.level == 0)
		return true;
	diag_error(interp->diag, loc, "the file ends without END PGM: is it complete?");
	return false;
}

_Static_assert(KLARTEXT_CALLS_MAX <= CALLS_MAX, "every call has its place in a chain");

bool klartext_flow_caller(const struct interp *interp, size_t level, struct srcloc *at, struct strbuf *title)
{
	const struct klartext_calls *calls = &klartext_of(interp)->calls;
	const struct klartext_call *call;

	if ((size_t)calls->level <= level)
		return false;
	call = &calls->items[calls->level - (int)level];
	*at = (struct srcloc){call->file, call->line, call->column};
	if (title)
		strbuf_addf(title, "%s", call->title);
	return true;
}
