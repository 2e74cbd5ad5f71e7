#include "gcode/dialect/linuxcnc/control_flow_call.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "gcode/dialect/linuxcnc/control_stack.h"
#include "gcode/dialect/linuxcnc/linuxcnc_expr.h"

/* ------------------------------------------------------------ definitions */

/* A sub that is reached without a call is remembered, and its body is skipped. */
static bool define(struct interp *interp, struct lexer *lexer, const struct oword *oword)
{
	struct label *label = labels_find(&linuxcnc_of(interp)->flow.labels, oword->name);
	const struct source *source = interp->program.source;
	char title[OWORD_TITLE];

	oword_title(oword->name, title);
	if (linuxcnc_of(interp)->params.level > 0)
		return fault(&interp->at, oword->column, "%s sub inside a running subprogram",
			     title);
	if (label && label->at.source == source && label->at.offset == source->reader.start)
		return fault(&interp->at, oword->column,
			     "%s sub is reached again after its call, or in a loop, where LinuxCNC stops; define it "
			     "once, before its first call",
			     title);
	if (label)
		return fault(&interp->at, oword->column, "%s is already defined in line %ld of %s", title,
			     label->at.line, label->at.source->name);
	if (!oword_end(lexer, oword) || !control_stack_add_label(interp, oword, oword->name, &label))
		return false;
	control_stack_skip_to(interp, SKIP_DEFINITION, O_SUB, oword->name, oword->column);
	return true;
}

/* The current line is the subprogram for which a call searches. */
static bool found(struct interp *interp, struct lexer *lexer, const struct oword *oword)
{
	struct control_flow *flow = &linuxcnc_of(interp)->flow;
	struct label *label;
	char title[OWORD_TITLE];

	oword_title(oword->name, title);
	if (linuxcnc_call_in_hand(interp)->by_m98 != (oword->kind == O_PROGRAM))
		return fault(&interp->at, oword->column,
			     oword->kind == O_PROGRAM ? "%s is a subprogram for M98; for a call, define it by %s sub"
						      : "%s sub is a subprogram for %s call, not for M98",
			     title, title);
	if (!oword_end(lexer, oword) || !control_stack_add_label(interp, oword, oword->name, &label))
		return false;
	flow->skip = SKIP_NOTHING;
	return true;
}

bool control_flow_call_skip(struct interp *interp, struct lexer *lexer, const struct oword *oword)
{
	struct control_flow *flow = &linuxcnc_of(interp)->flow;
	bool same = !strcmp(oword->name, flow->skip_key);

	if (flow->skip == SKIP_SEARCH)
		return (oword->kind != O_SUB && oword->kind != O_PROGRAM) || !same || found(interp, lexer, oword);
	if (oword->kind == O_SUB || oword->kind == O_PROGRAM)
		return fault(&interp->at, oword->column,
			     "a subprogram inside the sub of line %ld; close that sub first",
			     flow->skip_from.line);
	if (oword->kind != O_ENDSUB || !same)
		return true;
	flow->skip = SKIP_NOTHING;
	/* LinuxCNC computes the value of endsub here, with parameters that do not exist yet. */
	linuxcnc_of(interp)->params.returned = 0;
	linuxcnc_of(interp)->params.value_returned = false;
	linuxcnc_of(interp)->params.value_unclear = lexer_peek(lexer) == '[';
	return true;
}

/* ------------------------------------------------------------------- calls */

/*
 * Finds the file <name>.ngc in the folder of the program or else in the folders of the options; *source is NULL if
 * there is none. False: reported.
 */
static bool find_file(struct interp *interp, const char *name, int column, struct source **source)
{
	struct strbuf file = {0};
	bool good;

	if (strpbrk(name, "/\\") || strstr(name, "..") || name[0] == '.' || name[0] == '\0')
		return fault(&interp->at, column,
			     "the name of a subprogram's file must not contain a folder: '%s'", name);
	strbuf_addf(&file, "%s.ngc", name);
	good = sources_find(&interp->program.sources, &interp->config->read, strbuf_text(&file), &interp->at, column,
			    source);
	strbuf_release(&file);
	return good;
}

/* Jumps to a subprogram that was read before, or to the start of its own file, or searches this file forward. */
static bool go_to(struct interp *interp, const char *name, int column)
{
	struct label *label = labels_find(&linuxcnc_of(interp)->flow.labels, name);
	bool by_m98 = linuxcnc_call_in_hand(interp)->by_m98;
	char title[OWORD_TITLE];
	struct source *source;

	if (label && (label->kind == O_PROGRAM) != by_m98)
		return fault(&interp->at, column,
			     by_m98 ? "%s is a sub for call, not for M98" : "%s is a subprogram for M98, not for call",
			     oword_title(name, title));
	if (label)
		return control_stack_jump(interp, &label->body, column);
	if (!find_file(interp, name, column, &source))
		return false;
	control_stack_skip_to(interp, SKIP_SEARCH, O_SUB, name, column);
	return !source || control_stack_jump(interp, &(struct position){source, 0, 1}, column);
}

static bool enter(struct interp *interp, const char *name, int column, bool by_m98, const struct position *back)
{
	struct params *params = &linuxcnc_of(interp)->params;
	struct call *call;

	if (params->level + 1 >= PARAM_LEVELS)
		return fault(&interp->at, column, "more than %d nested calls", PARAM_LEVELS - 1);
	params_enter(params);
	call = linuxcnc_call_in_hand(interp);
	snprintf(call->name, sizeof(call->name), "%s", name);
	call->by_m98 = by_m98;
	call->back = *back;
	call->file = interp->at.file;
	call->line = interp->at.line;
	call->column = column;
	call->controls = linuxcnc_of(interp)->flow.control_count;
	call->m98_left = 0;
	call->modal.saved = call->modal.on_return = false;
	memcpy(call->saved, &params->numbered[1], sizeof(call->saved));
	if (go_to(interp, name, column))
		return true;
	/* The message is about the call itself: no callers are listed. */
	params_leave(params);
	return false;
}

/* o<name> call [1] [2] */
static bool do_call(struct interp *interp, struct lexer *lexer, const struct oword *oword)
{
	const struct position back = source_next(interp->program.source);
	double arguments[PARAM_ARGUMENTS] = {0};
	int count = 0;

	for (;;) {
		if (!lexer_skip_comments(lexer))
			return false;
		if (lexer_peek(lexer) != '[')
			break;
		if (count == PARAM_ARGUMENTS)
			return fault(&interp->at, lexer_column(lexer), "a call can have at most %d arguments",
				     PARAM_ARGUMENTS);
		if (!linuxcnc_expr_bracket(lexer, "call", &arguments[count++]))
			return false;
	}
	if (!oword_end(lexer, oword) || !enter(interp, oword->name, oword->column, false, &back))
		return false;
	memcpy(&linuxcnc_of(interp)->params.numbered[1], arguments, sizeof(arguments));
	return true;
}

/* Reads P and L of M98; nothing else is allowed. */
static bool read_m98(struct interp *interp, struct lexer *lexer, int column, int *program, int *count)
{
	bool has_program = false, has_count = false;

	*count = 1;
	for (;;) {
		char byte;
		bool *has;

		if (!lexer_skip_comments(lexer))
			return false;
		byte = lexer_peek(lexer);
		if (byte == '\0')
			break;
		has = byte == 'p' || byte == 'P' ? &has_program : byte == 'l' || byte == 'L' ? &has_count : NULL;
		if (!has || *has)
			return fault(&interp->at, lexer_column(lexer), "M98 takes only P and L, once each");
		*has = true;
		lexer_take(lexer);
		if (!linuxcnc_expr_integer(lexer, has == &has_program ? program : count))
			return false;
	}
	if (!has_program)
		return fault(&interp->at, column, "M98 needs P (subprogram number)");
	if (*count < 1)
		return fault(&interp->at, column,
			     "M98 with L%d: LinuxCNC would continue as if it were inside the subprogram",
			     *count);
	return true;
}

/* M98 P100 L3: LinuxCNC reads the block again before each of its calls. */
static bool do_m98(struct interp *interp, struct lexer *lexer, const struct oword *oword)
{
	struct call *caller = linuxcnc_call_in_hand(interp);
	struct position back = source_next(interp->program.source);
	int program = 0, count;
	char name[16];

	if (!read_m98(interp, lexer, oword->column, &program, &count))
		return false;
	caller->m98_left = caller->m98_left > 0 ? caller->m98_left - 1 : count - 1;
	if (caller->m98_left > 0)
		back = source_here(interp->program.source);
	snprintf(name, sizeof(name), "%d", program);
	return enter(interp, name, oword->column, true, &back);
}

static bool leave_call(struct interp *interp, int column)
{
	struct params *params = &linuxcnc_of(interp)->params;
	struct call *call = linuxcnc_call_in_hand(interp);

	if (!modal_state_leave(interp, &call->modal, column))
		return false;
	if (!call->by_m98)
		memcpy(&params->numbered[1], call->saved, sizeof(call->saved));
	control_stack_close(&linuxcnc_of(interp)->flow, call->controls);
	params_leave(params);
	return control_stack_jump(interp, &call->back, column);
}

/* endsub and return, with or without a value. */
static bool do_return(struct interp *interp, struct lexer *lexer, const struct oword *oword)
{
	struct params *params = &linuxcnc_of(interp)->params;
	const struct call *call = linuxcnc_call_in_hand(interp);
	char title[OWORD_TITLE], other[OWORD_TITLE];
	double value = 0;
	bool given = lexer_peek(lexer) == '[';

	oword_title(oword->name, title);
	if (params->level == 0)
		return fault(&interp->at, oword->column, "%s %s outside of a sub", title,
			     oword_keyword(oword->kind));
	if (call->by_m98)
		return fault(&interp->at, oword->column, "a subprogram of M98 ends with M99, not with %s",
			     oword_keyword(oword->kind));
	if (strcmp(call->name, oword->name))
		return fault(&interp->at, oword->column, "%s %s inside the sub %s", title,
			     oword_keyword(oword->kind), oword_title(call->name, other));
	if ((given && !linuxcnc_expr_bracket(lexer, oword_keyword(oword->kind), &value)) || !oword_end(lexer, oword))
		return false;
	params->returned = value;
	params->value_returned = given;
	params->value_unclear = false;
	return leave_call(interp, oword->column);
}

static bool do_m99(struct interp *interp, struct lexer *lexer, const struct oword *oword)
{
	if (!linuxcnc_call_in_hand(interp)->by_m98)
		return fault(&interp->at, oword->column, "a sub ends with endsub or return, not with M99");
	if (!oword_end(lexer, oword))
		return false;
	linuxcnc_of(interp)->params.returned = 0;
	linuxcnc_of(interp)->params.value_returned = false;
	linuxcnc_of(interp)->params.value_unclear = false;
	return leave_call(interp, oword->column);
}

bool control_flow_call_line(struct interp *interp, struct lexer *lexer, const struct oword *oword)
{
	switch (oword->kind) {
	case O_SUB:
		return define(interp, lexer, oword);
	case O_ENDSUB:
	case O_RETURN:
		return do_return(interp, lexer, oword);
	case O_CALL:
		return do_call(interp, lexer, oword);
	case O_M98:
		return do_m98(interp, lexer, oword);
	case O_M99:
		return do_m99(interp, lexer, oword);
	default:
		break;
	}
	/* The number of a program is only a name for the following lines. */
	if (linuxcnc_of(interp)->params.level > 0 && !linuxcnc_call_in_hand(interp)->by_m98)
		return fault(&interp->at, oword->column, "a subprogram for M98 inside a sub");
	return oword_end(lexer, oword);
}
