#include "gcode/dialect/linuxcnc/control_flow.h"

#include <stdio.h>
#include <string.h>

#include "base/apart.h"
#include "gcode/dialect/linuxcnc/control_flow_call.h"
#include "gcode/dialect/linuxcnc/control_flow_loop.h"
#include "gcode/dialect/linuxcnc/control_stack.h"
#include "gcode/dialect/linuxcnc/linuxcnc_expr.h"
#include "gcode/restart.h"

/* The key of a label: labels of branches and loops are local to the current subprogram. */
static void make_key(const struct interp *interp, const struct oword *oword, char *key)
{
	const struct call *call = linuxcnc_call_in_hand(interp);

	snprintf(key, CONTROL_KEY_MAX, "%s#%s", call->name, oword->name);
}

static bool is_of_calls(enum o_kind kind)
{
	return kind == O_SUB || kind == O_ENDSUB || kind == O_CALL || kind >= O_RETURN;
}

static bool carry_out(struct interp *interp, struct lexer *lexer, const struct oword *oword)
{
	char key[CONTROL_KEY_MAX];

	if (is_of_calls(oword->kind))
		return control_flow_call_line(interp, lexer, oword);
	make_key(interp, oword, key);
	return control_flow_loop_line(interp, lexer, oword, key);
}

static bool skip_line(struct interp *interp, struct lexer *lexer, const struct oword *oword)
{
	struct control_flow *flow = &linuxcnc_of(interp)->flow;
	char key[CONTROL_KEY_MAX];

	if (flow->skip == SKIP_DEFINITION || flow->skip == SKIP_SEARCH)
		return control_flow_call_skip(interp, lexer, oword);
	if (is_of_calls(oword->kind))
		return true;
	make_key(interp, oword, key);
	return strcmp(key, flow->skip_key) || control_flow_loop_skip(interp, lexer, oword);
}

/* ------------------------------------------------------------------- lines */

/* During the search for a subprogram its parameters do not exist yet: a label that must be computed is not read. */
static bool is_computed(const struct interp *interp, const char *text)
{
	enum skip skip = linuxcnc_of(interp)->flow.skip;

	if (skip != SKIP_DEFINITION && skip != SKIP_SEARCH)
		return false;
	text += strspn(text, "oO \t");
	return *text == '#' || *text == '[';
}

/* Are blocks counted, so that an endless loop ends? */
static bool in_loop_or_call(const struct interp *interp)
{
	const struct linuxcnc *linuxcnc = linuxcnc_of(interp);

	return linuxcnc->flow.control_count > 0 || linuxcnc->params.level > 0 || interp->program.repeated;
}

/* Can a line of an o-word, M98 or M99 start with this byte? */
static bool may_begin(char byte)
{
	switch (byte) {
	case 'o':
	case 'O':
	case 'm':
	case 'M':
	case 'n':
	case 'N':
	case '/':
		return true;
	default:
		return false;
	}
}

/* Carries out a line that is no plain block. */
static APART bool take_line(struct interp *interp, bool *done)
{
	struct control_flow *flow = &linuxcnc_of(interp)->flow;
	const char *text = line_start(&interp->at);
	struct lexer lexer;
	struct oword oword;

	if (!may_begin(*text))
		return true;
	if ((*text == '/' && interp->config->read.block_delete) || is_computed(interp, text))
		return true;
	lexer_init(&lexer, &interp->at, &linuxcnc_lexer_rules, interp);
	switch (oword_read(&lexer, linuxcnc_of(interp)->params.level > 0, &oword)) {
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

bool control_flow_line(struct interp *interp, bool *done)
{
	if (in_loop_or_call(interp) && !program_count(&interp->program, interp->config->read.max_blocks, &interp->at))
		return false;
	*done = linuxcnc_of(interp)->flow.skip != SKIP_NOTHING;
	return interp->block.plain || take_line(interp, done);
}

bool control_flow_end_of_file(struct interp *interp)
{
	struct control_flow *flow = &linuxcnc_of(interp)->flow;
	const struct call *call = &flow->calls[linuxcnc_of(interp)->params.level];
	struct control *top = control_stack_top(interp);
	struct srcloc end = {interp->program.source->name, interp->program.source->reader.line, 0};
	char title[OWORD_TITLE];

	if (flow->skip == SKIP_SEARCH) {
		diag_error(interp->diag, flow->skip_from,
			   "the subprogram %s is neither in %s nor in a file %s.ngc beside the program or in an "
			   "--include folder",
			   oword_title(call->name, title), end.file, call->name);
		/* The message is about the call itself; therefore the call is not listed again as a caller. */
		params_leave(&linuxcnc_of(interp)->params);
	} else if (flow->skip == SKIP_DEFINITION)
		diag_error(interp->diag, flow->skip_from, "this sub is not closed: endsub is missing");
	else if (flow->skip != SKIP_NOTHING)
		diag_error(interp->diag, flow->skip_from, "this %s is not closed",
			   oword_keyword(flow->skip_kind));
	else if (linuxcnc_of(interp)->params.level > 0)
		diag_error(interp->diag, end, "the subprogram %s is not closed at the end of the file: %s is missing",
			   oword_title(call->name, title), call->by_m98 ? "M99" : "endsub");
	else if (top)
		diag_error(interp->diag, end, "the %s in line %ld is not closed", oword_keyword(top->kind),
			   top->label->at.line);
	else
		return true;
	return false;
}

_Static_assert(PARAM_LEVELS - 1 <= CALLS_MAX, "every call has its place in a chain");

bool control_flow_caller(const struct interp *interp, size_t level, struct srcloc *at, struct strbuf *title)
{
	const struct linuxcnc *linuxcnc = linuxcnc_of(interp);
	const struct call *call;
	char buffer[OWORD_TITLE];

	if ((size_t)linuxcnc->params.level <= level)
		return false;
	call = &linuxcnc->flow.calls[linuxcnc->params.level - (int)level];
	*at = (struct srcloc){call->file, call->line, call->column};
	if (title)
		strbuf_addf(title, "%s", oword_title(call->name, buffer));
	return true;
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

static bool start_anew(struct interp *interp)
{
	struct linuxcnc *linuxcnc = linuxcnc_of(interp);
	const struct params *params = &linuxcnc->params;
	struct strbuf variables = {0};

	strbuf_add(&variables, (const char *)params->numbered, sizeof(params->numbered));
	add_names(&variables, &params->global);
	add_names(&variables, &params->local[0]);
	strbuf_add(&variables, (const char *)&params->returned, sizeof(params->returned));
	control_stack_close(&linuxcnc->flow, 0);
	return restart_program(interp, &variables);
}

/* Carries out M70 to M73 and M99. */
static APART bool run_m(struct interp *interp)
{
	int column = interp->block.m_column[M_STOP], modes = interp->block.m[M_MODES];

	if (modes != CODE_NONE && interp->block.words > 1)
		return fault(&interp->at, interp->block.m_column[M_MODES],
			     "M%d needs a block of its own, because its order among other words is not known", modes);
	if (modes != CODE_NONE)
		return modal_state_run(interp, &linuxcnc_call_in_hand(interp)->modal, modes,
				       interp->block.m_column[M_MODES]);
	if (interp->block.m[M_STOP] != 99)
		return true;
	if (linuxcnc_of(interp)->params.level > 0)
		return fault(&interp->at, column, "M99 in a subprogram needs a block of its own");
	return start_anew(interp);
}

bool control_flow_after_block(struct interp *interp)
{
	return interp->block.plain || run_m(interp);
}
