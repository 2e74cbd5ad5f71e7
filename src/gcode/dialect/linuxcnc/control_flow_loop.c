#include "gcode/dialect/linuxcnc/control_flow_loop.h"

#include <math.h>
#include <string.h>

#include "base/mem.h"
#include "gcode/dialect/linuxcnc/control_stack.h"
#include "gcode/dialect/linuxcnc/linuxcnc_expr.h"

static void push_control(struct control_flow *flow, enum o_kind kind, struct label *label)
{
	flow->controls = mem_grow(flow->controls, &flow->control_capacity, flow->control_count + 1,
				  sizeof(*flow->controls));
	flow->controls[flow->control_count++] = (struct control){.kind = kind, .label = label};
}

/* The innermost open branch or loop must be this one. */
static struct control *expect_control(struct interp *interp, const struct oword *oword, const char *key,
				      enum o_kind kind)
{
	struct control *top = control_stack_top(interp);
	char title[OWORD_TITLE];

	if (top && top->kind == kind && !strcmp(top->label->key, key))
		return top;
	oword_title(oword->name, title);
	if (!top)
		fault_report(&interp->at, oword->column, "%s %s without %s", title, oword_keyword(oword->kind),
		      oword_keyword(kind));
	else
		fault_report(&interp->at, oword->column, "%s %s inside the %s of line %ld, which is not closed",
			     title, oword_keyword(oword->kind), oword_keyword(top->kind), top->label->at.line);
	return NULL;
}

/* Finds the label of the current line, which may be new; a label must be unique. */
static bool find_label(struct interp *interp, const struct oword *oword, const char *key, struct label **label)
{
	const struct control *top = control_stack_top(interp);
	char title[OWORD_TITLE];

	*label = labels_find(&linuxcnc_of(interp)->flow.labels, key);
	if (!*label)
		return control_stack_add_label(interp, oword, key, label);
	if ((*label)->kind == (int)oword->kind && (*label)->at.source == interp->program.source &&
	    (*label)->at.offset == interp->program.source->reader.start)
		return true;
	if ((*label)->kind == O_DO && oword->kind == O_WHILE && top)
		return expect_control(interp, oword, key, O_DO) != NULL;
	return fault(&interp->at, oword->column, "the label %s is already used for another %s in line %ld of %s",
		     oword_title(oword->name, title), oword_keyword((enum o_kind)(*label)->kind), (*label)->at.line,
		     (*label)->at.source->name);
}

/* Reads a condition or count; nothing else may follow. */
static bool read_test(struct lexer *lexer, const struct oword *oword, double *value)
{
	return linuxcnc_expr_bracket(lexer, oword_keyword(oword->kind), value) &&
	       linuxcnc_expr_sign_is_sure(lexer->at, oword->column, *value) && oword_end(lexer, oword);
}

static bool is_true(double value)
{
	return fpclassify(value) != FP_ZERO;
}

static bool do_if(struct interp *interp, struct lexer *lexer, const struct oword *oword, const char *key)
{
	struct label *label;
	double test;

	if (!read_test(lexer, oword, &test) || !find_label(interp, oword, key, &label))
		return false;
	push_control(&linuxcnc_of(interp)->flow, O_IF, label);
	if (!is_true(test))
		control_stack_skip_to(interp, SKIP_FALSE, O_IF, key, oword->column);
	return true;
}

/* elseif, else or endif ends the branch that was carried out. LinuxCNC computes the condition of elseif here, too. */
static bool leave_if(struct interp *interp, struct lexer *lexer, const struct oword *oword, const char *key)
{
	double test;

	if (!expect_control(interp, oword, key, O_IF))
		return false;
	if (oword->kind == O_ELSEIF ? !read_test(lexer, oword, &test) : !oword_end(lexer, oword))
		return false;
	if (oword->kind == O_ENDIF)
		linuxcnc_of(interp)->flow.control_count--;
	else
		control_stack_skip_to(interp, SKIP_DONE, O_IF, key, oword->column);
	return true;
}

static bool fault_stale(struct interp *interp, int column, const char *word, const char *what)
{
	return fault(&interp->at, column,
		     "in LinuxCNC, an earlier o-word %s still has an effect, which %s here; write the loops without %s",
		     word,
		     what, word);
}

/* The while at the end of a do. */
static bool end_do(struct interp *interp, struct lexer *lexer, const struct oword *oword, const char *key)
{
	struct control *control = expect_control(interp, oword, key, O_DO);
	struct control_flow *flow = &linuxcnc_of(interp)->flow;
	double test;

	if (!control || !read_test(lexer, oword, &test))
		return false;
	if (is_true(test) && flow->stale_break)
		return fault_stale(interp, oword->column, "break", "would end the loop");
	if (is_true(test))
		return control_stack_jump(interp, &control->label->body, oword->column);
	flow->stale_break = false;
	flow->control_count--;
	return true;
}

static bool do_while(struct interp *interp, struct lexer *lexer, const struct oword *oword, const char *key)
{
	struct control_flow *flow = &linuxcnc_of(interp)->flow;
	struct control *top = control_stack_top(interp);
	struct label *label;
	double test;

	if (top && top->kind == O_DO && !strcmp(top->label->key, key))
		return end_do(interp, lexer, oword, key);
	if (!find_label(interp, oword, key, &label) || !read_test(lexer, oword, &test))
		return false;
	if (!top || top->label != label)
		push_control(flow, O_WHILE, label);
	if (is_true(test))
		return true;
	flow->control_count--;
	control_stack_skip_to(interp, SKIP_LOOP, O_WHILE, key, oword->column);
	return true;
}

static bool do_do(struct interp *interp, struct lexer *lexer, const struct oword *oword, const char *key)
{
	struct label *label;

	if (!oword_end(lexer, oword) || !find_label(interp, oword, key, &label))
		return false;
	push_control(&linuxcnc_of(interp)->flow, O_DO, label);
	return true;
}

static bool do_repeat(struct interp *interp, struct lexer *lexer, const struct oword *oword, const char *key)
{
	struct control_flow *flow = &linuxcnc_of(interp)->flow;
	struct label *label;
	double count;

	if (!read_test(lexer, oword, &count) || !find_label(interp, oword, key, &label))
		return false;
	count = nearbyint(count);
	if (fabs(count) > 2147483647.0)
		return fault(&interp->at, oword->column, "%.15g is too large for the count of a repeat", count);
	if (label->counting)
		return fault(&interp->at, oword->column,
			     "this repeat was left by return or still runs in a caller: LinuxCNC would continue its "
			     "old count");
	if (count < 1) {
		control_stack_skip_to(interp, SKIP_LOOP, O_REPEAT, key, oword->column);
		return true;
	}
	push_control(flow, O_REPEAT, label);
	flow->controls[flow->control_count - 1].remaining = count - 1;
	label->counting = true;
	return true;
}

static bool end_loop(struct interp *interp, struct lexer *lexer, const struct oword *oword, const char *key)
{
	enum o_kind kind = oword->kind == O_ENDWHILE ? O_WHILE : O_REPEAT;
	struct control *control = expect_control(interp, oword, key, kind);
	struct control_flow *flow = &linuxcnc_of(interp)->flow;

	if (!control || !oword_end(lexer, oword))
		return false;
	if (kind == O_WHILE)
		return control_stack_jump(interp, &control->label->at, oword->column);
	if (control->remaining > 0) {
		control->remaining--;
		return control_stack_jump(interp, &control->label->body, oword->column);
	}
	if (flow->stale_continue)
		return fault_stale(interp, oword->column, "continue", "would repeat the loop again");
	control->label->counting = false;
	flow->control_count--;
	return true;
}

/* break and continue name the while or do to leave, which may be an outer loop. */
static bool leave_loop(struct interp *interp, struct lexer *lexer, const struct oword *oword, const char *key)
{
	struct control_flow *flow = &linuxcnc_of(interp)->flow;
	size_t base = linuxcnc_call_in_hand(interp)->controls, i = flow->control_count;
	char title[OWORD_TITLE];
	enum o_kind kind;

	while (i > base && strcmp(flow->controls[i - 1].label->key, key))
		i--;
	if (i == base || (flow->controls[i - 1].kind != O_WHILE && flow->controls[i - 1].kind != O_DO))
		return fault(&interp->at, oword->column, "%s %s without while or do",
			     oword_title(oword->name, title),
			     oword_keyword(oword->kind));
	if (!oword_end(lexer, oword))
		return false;
	kind = flow->controls[i - 1].kind;
	if (oword->kind == O_CONTINUE) {
		control_stack_close(flow, i);
		control_stack_skip_to(interp, SKIP_CONTINUE, kind, key, oword->column);
		return true;
	}
	if (kind == O_WHILE && flow->stale_continue)
		return fault_stale(interp, oword->column, "continue", "would continue the loop");
	flow->stale_break = kind == O_WHILE || flow->stale_break;
	control_stack_close(flow, i - 1);
	control_stack_skip_to(interp, SKIP_LOOP, kind, key, oword->column);
	return true;
}

bool control_flow_loop_line(struct interp *interp, struct lexer *lexer, const struct oword *oword, const char *key)
{
	switch (oword->kind) {
	case O_IF:
		return do_if(interp, lexer, oword, key);
	case O_ELSEIF:
	case O_ELSE:
	case O_ENDIF:
		return leave_if(interp, lexer, oword, key);
	case O_WHILE:
		return do_while(interp, lexer, oword, key);
	case O_DO:
		return do_do(interp, lexer, oword, key);
	case O_REPEAT:
		return do_repeat(interp, lexer, oword, key);
	case O_ENDWHILE:
	case O_ENDREPEAT:
		return end_loop(interp, lexer, oword, key);
	default:
		return leave_loop(interp, lexer, oword, key);
	}
}

/* ---------------------------------------------------------------- skipping */

static bool fault_label_again(struct interp *interp, const struct oword *oword)
{
	char title[OWORD_TITLE];

	return fault(&interp->at, oword->column,
		     "the label %s is already used for the %s of line %ld, which is not closed",
		     oword_title(oword->name, title), oword_keyword(linuxcnc_of(interp)->flow.skip_kind),
		     linuxcnc_of(interp)->flow.skip_from.line);
}

static bool skip_if(struct interp *interp, struct lexer *lexer, const struct oword *oword)
{
	struct control_flow *flow = &linuxcnc_of(interp)->flow;
	bool wanted = flow->skip == SKIP_FALSE;
	double test;

	switch (oword->kind) {
	case O_ELSEIF:
		if (!read_test(lexer, oword, &test))
			return false;
		if (wanted && is_true(test))
			flow->skip = SKIP_NOTHING;
		return true;
	case O_ELSE:
		if (wanted)
			flow->skip = SKIP_NOTHING;
		return oword_end(lexer, oword);
	case O_ENDIF:
		flow->skip = SKIP_NOTHING;
		flow->control_count--;
		return oword_end(lexer, oword);
	default:
		return fault_label_again(interp, oword);
	}
}

/* At the end of a loop whose rest was skipped. */
static bool skip_loop(struct interp *interp, struct lexer *lexer, const struct oword *oword)
{
	struct control_flow *flow = &linuxcnc_of(interp)->flow;
	enum o_kind end = flow->skip_kind == O_WHILE ? O_ENDWHILE : flow->skip_kind == O_DO ? O_WHILE : O_ENDREPEAT;
	bool again = flow->skip == SKIP_CONTINUE;
	double test;

	if (oword->kind == O_BREAK || oword->kind == O_CONTINUE)
		return true;
	if (oword->kind != end)
		return fault_label_again(interp, oword);
	flow->skip = SKIP_NOTHING;
	if (end == O_WHILE) {
		flow->stale_continue = flow->stale_continue || again;
		if (again)
			return end_do(interp, lexer, oword, flow->skip_key);
		flow->stale_break = false;
		return read_test(lexer, oword, &test);
	}
	flow->stale_continue = false;
	if (again)
		return end_loop(interp, lexer, oword, flow->skip_key);
	return oword_end(lexer, oword);
}

bool control_flow_loop_skip(struct interp *interp, struct lexer *lexer, const struct oword *oword)
{
	if (linuxcnc_of(interp)->flow.skip == SKIP_FALSE || linuxcnc_of(interp)->flow.skip == SKIP_DONE)
		return skip_if(interp, lexer, oword);
	return skip_loop(interp, lexer, oword);
}
