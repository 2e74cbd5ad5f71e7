#include "gcode/dialect/linuxcnc/control_flow.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "gcode/dialect/linuxcnc/control_flow_parts.h"

void control_flow_release(struct control_flow *flow)
{
	labels_release(&flow->labels);
	free(flow->controls);
	strbuf_release(&flow->last_pass);
}

bool control_flow_jump(struct interp *interp, const struct position *to, int column)
{
	if (!reader_seek(&to->source->reader, to->offset, to->line))
		return fault(&interp->at, column,
			     "this jumps to line %ld of %s, which a pipe can no longer deliver: it keeps the last %zu "
			     "MiB; give the program as a file",
			     to->line, to->source->name, READER_WINDOW >> 20);
	interp->source = to->source;
	return true;
}

void control_flow_skip_to(struct interp *interp, enum skip skip, enum o_kind kind, const char *key, int column)
{
	struct control_flow *flow = &interp->flow;

	flow->skip = skip;
	flow->skip_kind = kind;
	snprintf(flow->skip_key, sizeof(flow->skip_key), "%s", key);
	flow->skip_from = line_loc(&interp->at, column);
}

/* Labels of branches and loops belong to the subprogram that is being carried out. */
static void make_key(const struct interp *interp, const struct oword *oword, char *key)
{
	const struct call *call = &interp->flow.calls[interp->params.level];

	snprintf(key, 2 * PARAM_NAME_MAX + 2, "%s#%s", call->name, oword->name);
}

void control_flow_close_controls(struct control_flow *flow, size_t count)
{
	flow->control_count = count;
}

bool control_flow_add_label(struct interp *interp, const struct oword *oword, const char *key, struct label **label)
{
	*label = labels_add(&interp->flow.labels, key, oword->kind);
	if (!*label)
		return fault(&interp->at, oword->column, "more than %d o-words", LABELS_MAX);
	(*label)->at = source_here(interp->source);
	(*label)->body = source_next(interp->source);
	return true;
}

static bool is_of_calls(enum o_kind kind)
{
	return kind == O_SUB || kind == O_ENDSUB || kind == O_CALL || kind >= O_RETURN;
}

static bool carry_out(struct interp *interp, struct lexer *lexer, const struct oword *oword)
{
	char key[2 * PARAM_NAME_MAX + 2];

	if (is_of_calls(oword->kind))
		return control_flow_call_line(interp, lexer, oword);
	make_key(interp, oword, key);
	return control_flow_loop_line(interp, lexer, oword, key);
}

static bool skip_line(struct interp *interp, struct lexer *lexer, const struct oword *oword)
{
	struct control_flow *flow = &interp->flow;
	char key[2 * PARAM_NAME_MAX + 2];

	if (flow->skip == SKIP_DEFINITION || flow->skip == SKIP_SEARCH)
		return control_flow_call_skip(interp, lexer, oword);
	if (is_of_calls(oword->kind))
		return true;
	make_key(interp, oword, key);
	return strcmp(key, flow->skip_key) || control_flow_loop_skip(interp, lexer, oword);
}

/* ------------------------------------------------------------------- lines */

/* Labels that must be computed cannot be where a subprogram is looked for: its parameters do not exist yet. */
static bool is_computed(const struct interp *interp, const char *text)
{
	enum skip skip = interp->flow.skip;

	if (skip != SKIP_DEFINITION && skip != SKIP_SEARCH)
		return false;
	text += strspn(text, "oO \t");
	return *text == '#' || *text == '[';
}

bool control_flow_line(struct interp *interp, bool *done)
{
	struct control_flow *flow = &interp->flow;
	const char *text = interp->at.text + strspn(interp->at.text, " \t");
	struct lexer lexer;
	struct oword oword;

	*done = flow->skip != SKIP_NOTHING;
	if (*text == '\0' || !strchr("oOmMnN/", *text))
		return true;
	if ((*text == '/' && interp->config->read.block_delete) || is_computed(interp, text))
		return true;
	lexer_init(&lexer, &interp->at, false);
	lexer.interp = interp;
	switch (oword_read(&lexer, interp->params.level > 0, &oword)) {
	case OWORD_NONE:
		return true;
	case OWORD_FAULT:
		return false;
	case OWORD_READ:
		break;
	}
	*done = true;
	return flow->skip != SKIP_NOTHING ? skip_line(interp, &lexer, &oword) : carry_out(interp, &lexer, &oword);
}

bool control_flow_end_of_file(struct interp *interp)
{
	struct control_flow *flow = &interp->flow;
	const struct call *call = &flow->calls[interp->params.level];
	struct control *top = control_flow_top_control(interp);
	struct srcloc end = {interp->source->name, interp->source->reader.line, 0};
	char title[OWORD_TITLE];

	if (flow->skip == SKIP_SEARCH) {
		diag_error(interp->diag, flow->skip_from,
			   "the subprogram %s is neither in %s nor in a file %s.ngc beside the program or in an "
			   "--include folder",
			   oword_title(call->name, title), end.file, call->name);
		params_leave(&interp->params);	/* the call itself is to blame, not one more caller */
	} else if (flow->skip == SKIP_DEFINITION)
		diag_error(interp->diag, flow->skip_from, "this sub is not closed: its endsub is missing");
	else if (flow->skip != SKIP_NOTHING)
		diag_error(interp->diag, flow->skip_from, "the end of this %s is missing",
			   oword_keyword(flow->skip_kind));
	else if (interp->params.level > 0)
		diag_error(interp->diag, end, "the file ends inside of the subprogram %s: its %s is missing",
			   oword_title(call->name, title), call->by_m98 ? "M99" : "endsub");
	else if (top)
		diag_error(interp->diag, end, "the end of the %s of line %ld is missing", oword_keyword(top->kind),
			   top->label->at.line);
	else
		return true;
	return false;
}

bool control_flow_count(struct interp *interp)
{
	struct control_flow *flow = &interp->flow;
	long long limit = interp->config->read.max_blocks > 0 ? interp->config->read.max_blocks : FLOW_BLOCKS_MAX;

	if (flow->control_count == 0 && interp->params.level == 0 && !flow->repeated && !interp->macro.jumped)
		return true;
	if (++flow->steps <= limit)
		return true;
	return fault(&interp->at, 1,
		     "%lld blocks of loops and subprograms have been carried out: is this loop endless? --max-blocks "
		     "sets another limit",
		     limit);
}

void control_flow_note_callers(struct interp *interp)
{
	char title[OWORD_TITLE];

	for (int level = interp->params.level; level > 0; level--) {
		const struct call *call = &interp->flow.calls[level];

		diag_note(interp->diag, (struct srcloc){call->file, call->line, call->column}, "%s is called from here",
			  oword_title(call->name, title));
	}
}

/* ------------------------------------------------------------ the whole anew */

static void add_names(struct strbuf *out, const struct named_params *set)
{
	for (size_t i = 0; i < set->count; i++) {
		strbuf_add(out, set->items[i].name, strlen(set->items[i].name) + 1);
		strbuf_add(out, (const char *)&set->items[i].value, sizeof(set->items[i].value));
	}
	strbuf_add(out, "\n", 1);
}

/*
 * LinuxCNC starts anew for ever. A pass that begins with the same state and
 * parameters as the one before makes the same moves, and so do all that follow.
 * (Bytes of padding may differ for nothing: that costs a pass.)
 */
bool control_flow_restart(struct interp *interp)
{
	struct control_flow *flow = &interp->flow;
	struct params *params = &interp->params;
	struct source *main = interp->sources.items[0];
	const struct position start = {main, interp->first_offset, interp->first_line};
	struct strbuf pass = {0};

	if (interp->comp.side != 0)
		return fault(&interp->at, interp->block.m_column[M_STOP],
			     "M99 starts the program anew with cutter compensation on; switch it off with G40 first");
	strbuf_add(&pass, (const char *)&interp->state, sizeof(interp->state));
	strbuf_add(&pass, (const char *)&interp->macro.vars, sizeof(interp->macro.vars));
	strbuf_add(&pass, (const char *)&interp->macro.modal, sizeof(interp->macro.modal));
	strbuf_add(&pass, (const char *)params->numbered, sizeof(params->numbered));
	add_names(&pass, &params->global);
	add_names(&pass, &params->local[0]);
	strbuf_add(&pass, (const char *)&params->returned, sizeof(params->returned));
	interp->ended = pass.length == flow->last_pass.length &&
			!memcmp(pass.text, flow->last_pass.text, pass.length);
	strbuf_release(&flow->last_pass);
	flow->last_pass = pass;
	flow->repeated = true;
	flow->control_count = 0;
	interp->macro.calls[0].loop_count = 0;
	return interp->ended || control_flow_jump(interp, &start, 1);
}
