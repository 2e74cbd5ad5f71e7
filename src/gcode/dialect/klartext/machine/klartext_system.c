#include "gcode/dialect/klartext/machine/klartext_system.h"

#include "base/ascii.h"
#include "base/same_double.h"
#include "gcode/dialect/klartext/frames/klartext_frame.h"
#include "gcode/dialect/klartext/moves/klartext_comp.h"
#include "gcode/dialect/klartext/text/klartext_lexis.h"
#include "gcode/dialect/klartext/values/klartext_kept.h"
#include "gcode/dialect/klartext/values/klartext_string.h"
#include "gcode/dialect/klartext/values/klartext_value.h"

/* L and R of the tool table, without DL and DR. */
static double tool_value(const struct interp *interp, const struct klartext_query *query, bool *known)
{
	const int number = query->has_index && query->index > 0 ? query->index : interp->state.tool;
	const struct tool *tool = tool_table_find(&interp->tools, number);

	*known = tool && interp->config->has_setup && !tool->deltas && (query->number == 1 || tool->diameter > 0);
	if (!*known)
		return 0;
	return query->number == 1 ? tool->length_offset : tool->diameter / 2;
}

static double axis_of(vec3 v, int index)
{
	return index == 1 ? v.x : index == 2 ? v.y : v.z;
}

static double frame_value(const struct klartext_frame *frame, const struct klartext_query *query, bool *known)
{
	const bool axis = query->has_index && query->index >= 1 && query->index <= 3;

	*known = true;
	if (query->id == 210 && query->number == 2)
		return frame->rotation;
	if (query->id == 210 && query->number == 3)
		return frame->mirror[0] + 2 * frame->mirror[1] + 4 * frame->mirror[2];
	if (query->id == 210 && query->number == 4 && axis)
		return axis_of(frame->factor, query->index);
	if (query->id == 210 && query->number == 6)
		return frame->tilted ? -1 : 0;
	*known = query->id == 220 && query->number == 2 && axis && !frame->tilted;
	return *known ? axis_of(frame->shift, query->index) : 0;
}

static bool is_length(const struct klartext_query *query)
{
	static const int lengths[] = {50, 60, 200, 220, 240, 270};

	for (size_t i = 0; i < sizeof(lengths) / sizeof(lengths[0]); i++) {
		if (query->id == lengths[i])
			return true;
	}
	return false;
}

/*
 * Machine status. Before the first M3 or S the values are those from before the program, which are not known; before
 * the first TOOL CALL the spindle holds initial_tool of the setup.
 */
static double status_value(const struct interp *interp, const struct klartext_query *query, bool *known)
{
	const struct state *state = &interp->state;
	const bool called = klartext_of(interp)->tool.called;

	switch (query->number) {
	case 1:
		*known = called || state->tool > 0;
		return state->tool;
	case 3:
		*known = called;
		return 2; /* Z */
	case 4:
		*known = state->speed > 0 || state->speed_is_zero;
		return state->speed;
	case 5:
		*known = state->spindle != SPINDLE_STOPPED;
		return state->spindle == SPINDLE_CLOCKWISE ? 0 : 1;
	default:
		*known = false;
		return 0;
	}
}

/* Data of the last TOOL CALL. */
static double called_value(const struct interp *interp, const struct klartext_query *query, bool *known)
{
	const struct klartext_tool *tool = &klartext_of(interp)->tool;

	*known = tool->called && query->number != 3 && query->number < 6;
	switch (query->number) {
	case 1:
		return interp->state.tool;
	case 2:
		return 2; /* Z */
	case 4:
		return tool->delta_length;
	case 5:
		return tool->delta_radius;
	default:
		*known = false;
		return 0;
	}
}

/* The tool compensation in force. Both values include the oversizes of the tool table and of TOOL CALL. */
static double compensation_value(const struct interp *interp, const struct klartext_query *query, bool *known)
{
	const struct klartext *klartext = klartext_of(interp);
	const struct tool *tool = tool_table_find(&interp->tools, interp->state.tool);
	const bool radius = query->number == 1;

	*known = klartext->tool.called && (radius || query->number == 2) && (!query->has_index || query->index == 3) &&
		 (!radius || (tool && tool->diameter > 0 && klartext->tool.defined != interp->state.tool));
	if (!*known)
		return 0;
	return radius ? tool->diameter / 2 + klartext->tool.delta_radius : interp->state.length;
}

void klartext_system_synchronise(struct interp *interp)
{
	struct klartext_sync *sync = &klartext_of(interp)->sync;

	sync->holds = true;
	sync->position = interp->state.position;
}

/* Have all blocks been carried out, and is the position of every axis known? */
static bool stands_still(const struct interp *interp)
{
	const struct klartext *klartext = klartext_of(interp);
	const double *loose = interp->comp.loose;
	bool still = klartext->sync.holds && !klartext->open.height && !klartext->stay.waits &&
		     !klartext->corner.waits && !klartext->approach.waits && !klartext_comp_is_selected(interp) &&
		     !(loose[SLOT_X] + loose[SLOT_Y] + loose[SLOT_Z] > 0);

	for (int slot = 0; slot < SLOT_COUNT; slot++)
		still = still && !interp->state.probed[slot] &&
			same_double(klartext->sync.position.v[slot], interp->state.position.v[slot]);
	return still;
}

/*
 * "FN 20: WAIT FOR SYNC": without it the control may read a position before the axes have reached it. ID 240: positions
 * in machine coordinates; ID 270: in the coordinates of the program. IDX counts X Y Z A B C U V W from 1.
 */
static double position_value(const struct interp *interp, const struct klartext_query *query, bool *known)
{
	const struct state *state = &interp->state;
	const int slot = query->index - 1;

	*known = query->number == 1 && query->has_index && slot >= 0 && slot < SLOT_COUNT &&
		 interp->config->has_axis[slot] && interp->config->wrap[slot] == WRAP_NONE && stands_still(interp);
	if (!*known)
		return 0;
	if (query->id == 270 && slot <= SLOT_Z)
		return axis_of(klartext_frame_point(interp), query->index);
	if (query->id == 270)
		return state->position.v[slot] - state->offset.v[slot];
	*known = state->tcp == TCP_OFF || slot_is_rotary(slot);
	return state->position.v[slot];
}

/*
 * iTNC 530 HSCI technical manual, "Data transfer NC > NC program (FN18: SYSREAD)". On newer controls lengths are in mm,
 * whatever unit the program has (TNC7 user's manual, "System data"). So they stay unknown in a program in inches.
 */
static double find_value(const struct interp *interp, const struct klartext_query *query, bool *known)
{
	const struct klartext *klartext = klartext_of(interp);
	const bool m128 = interp->state.tcp == TCP_BY_MCODE;

	*known = false;
	if (is_length(query) && klartext->inch)
		return 0;
	switch (query->id) {
	case 10:
		*known = query->number == 1;
		return klartext->inch;
	case 20:
		return status_value(interp, query, known);
	case 50:
		return query->number == 1 || query->number == 2 ? tool_value(interp, query, known) : 0;
	case 60:
		return called_value(interp, query, known);
	case 200:
		return compensation_value(interp, query, known);
	case 210:
	case 220:
		return frame_value(&klartext->frame, query, known);
	case 240:
	case 270:
		return position_value(interp, query, known);
	case 280:
		*known = query->number == 1;
		return m128 ? -1 : 0;
	case 530:
		*known = query->number == 1 && klartext->preset.row > 0;
		return klartext->preset.row;
	default:
		return 0;
	}
}

/* A name and the whole number behind it, which may be a parameter: "ID50", "IDX Q11". */
static bool read_number(struct lexer *lexer, const char *name, int *value)
{
	return klartext_integer(lexer, name, -1, 100000, value);
}

static bool read_query(struct lexer *lexer, struct klartext_query *query)
{
	if (!klartext_take(lexer, "ID"))
		return fault(lexer->at, lexer_next_column(lexer), "SYSREAD needs ID and its number");
	if (!read_number(lexer, "ID", &query->id))
		return false;
	if (klartext_take(lexer, "NR") && !read_number(lexer, "NR", &query->number))
		return false;
	query->has_index = klartext_take(lexer, "IDX");
	return !query->has_index || read_number(lexer, "IDX", &query->index);
}

/* Without an index, the data of the tool table are those of the called tool. */
static void name_tool(const struct interp *interp, struct klartext_query *query)
{
	if (query->id != 50 || (query->has_index && query->index > 0) || !klartext_of(interp)->tool.called)
		return;
	query->index = interp->state.tool;
	query->has_index = true;
}

/* "Q10 =" */
static struct klartext_q *read_target(struct lexer *lexer, int *number)
{
	struct klartext_q *q;

	if (ascii_upper(lexer_peek(lexer)) != 'Q') {
		fault_report(lexer->at, lexer_next_column(lexer), "a Q parameter is needed here");
		return NULL;
	}
	q = klartext_q_find(lexer, number);
	if (q && lexer_peek(lexer) != '=') {
		fault_report(lexer->at, lexer_column(lexer), "'=' is needed here");
		return NULL;
	}
	if (q)
		lexer_take(lexer);
	return q;
}

bool klartext_system_read(struct lexer *lexer)
{
	struct klartext_query query = {0};
	struct klartext_q *q;
	double value;
	bool known;
	int number;

	if (!klartext_take(lexer, "SYSREAD"))
		return fault(lexer->at, lexer_next_column(lexer), "FN 18 needs SYSREAD here");
	q = read_target(lexer, &number);
	if (!q || !read_query(lexer, &query) || !klartext_expect_end(lexer))
		return false;
	value = find_value(lexer->context, &query, &known);
	name_tool(lexer->context, &query);
	known = known || klartext_kept_data(lexer->context, &query, &value);
	*q = known ? (struct klartext_q){.value = value, .given = true}
		   : (struct klartext_q){.read = true, .query = query};
	return true;
}

/* "TABREAD Q10 = +5/"X,Y,D"": each column is read into one of several successive parameters. */
bool klartext_system_read_table(struct lexer *lexer)
{
	struct klartext_values *values = &klartext_of(lexer->context)->values;
	const char *text = lexer->at->text;
	struct klartext_q *q;
	int number;

	if (!klartext_take(lexer, "TABREAD"))
		return fault(lexer->at, lexer_next_column(lexer), "FN 28 needs TABREAD here");
	/* A text is read into a string parameter, whose value then is unknown. */
	if (klartext_take(lexer, "QS")) {
		klartext_string_forget(klartext_of(lexer->context));
		return true;
	}
	q = read_target(lexer, &number);
	if (!q)
		return false;
	*q = (struct klartext_q){.read = true};
	for (size_t i = lexer->position; text[i]; i++) {
		if (text[i] != ',' || q < values->q || q >= values->q + KLARTEXT_Q_COUNT - 1)
			continue;
		*++q = (struct klartext_q){.read = true};
	}
	return true;
}
