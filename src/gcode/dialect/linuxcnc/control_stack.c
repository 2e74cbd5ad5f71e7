#include "gcode/dialect/linuxcnc/control_stack.h"

#include <stdio.h>

bool control_stack_jump(struct interp *interp, const struct position *to, int column)
{
	return program_jump(&interp->program, to, &interp->at, column);
}

void control_stack_skip_to(struct interp *interp, enum skip skip, enum o_kind kind, const char *key, int column)
{
	struct control_flow *flow = &linuxcnc_of(interp)->flow;

	flow->skip = skip;
	flow->skip_kind = kind;
	snprintf(flow->skip_key, sizeof(flow->skip_key), "%s", key);
	flow->skip_from = line_loc(&interp->at, column);
}

bool control_stack_add_label(struct interp *interp, const struct oword *oword, const char *key, struct label **label)
{
	*label = labels_add(&linuxcnc_of(interp)->flow.labels, key, (int)oword->kind);
	if (!*label)
		return fault(&interp->at, oword->column, "more than %d o-words", LABELS_MAX);
	(*label)->at = source_here(interp->program.source);
	(*label)->body = source_next(interp->program.source);
	return true;
}

void control_stack_close(struct control_flow *flow, size_t count)
{
	flow->control_count = count;
}

struct control *control_stack_top(struct interp *interp)
{
	struct control_flow *flow = &linuxcnc_of(interp)->flow;

	if (flow->control_count == linuxcnc_call_in_hand(interp)->controls)
		return NULL;
	return &flow->controls[flow->control_count - 1];
}
