#include "gcode/dialect/klartext/machine/klartext_tool.h"

#include <math.h>
#include <string.h>

#include "base/same_double.h"
#include "gcode/dialect/klartext/moves/klartext_comp.h"
#include "gcode/dialect/klartext/state/klartext_state.h"
#include "gcode/dialect/klartext/text/klartext_lexis.h"
#include "gcode/dialect/klartext/values/klartext_string.h"
#include "gcode/dialect/klartext/values/klartext_value.h"
#include "gcode/dialect/klartext/words/klartext_words.h"
#include "gcode/execute/motion_commands.h"
#include "gcode/execute/reference_return.h"
#include "gcode/execute/tool_length.h"
#include "geom/tolerance.h"

/* The words of TOOL CALL. */
struct request {
	bool has_tool;
	int number;
	int column;
	bool has_speed, has_feed;
	bool per_revolution; /* FU, FZ */
	double speed, feed;
	double delta_length, delta_radius; /* DL, DR, mm */
	bool oversize, has_delta_length, has_delta_radius;
};

/* ----------------------------------------------------------------- numbers */

static bool find_by_name(struct lexer *lexer, const char *name, int column, int *number)
{
	const struct interp *interp = lexer->context;
	const struct tool *found;

	if (!tool_table_find_name(&interp->tools, lexer->at, column, name, false, &found))
		return false;
	*number = found->number;
	return true;
}

/* "5.2": the second set of data of a tool with several cutters. The setup gives it as a tool with this name. */
static bool read_index(struct lexer *lexer, char name[KLARTEXT_NAME])
{
	const char *text = lexer->at->text + lexer->position;
	const size_t digits = strspn(text, "0123456789"), length = digits + 2;

	if (digits == 0 || length >= KLARTEXT_NAME || (text[digits] != '.' && text[digits] != ',') ||
	    strspn(text + digits + 1, "0123456789") != 1 || text[digits + 1] == '0')
		return false;
	memcpy(name, text, length);
	name[digits] = '.';
	name[length] = '\0';
	lexer->position += length;
	return true;
}

/* Reads 5, 5.2 or "NAME". */
static bool read_tool(struct lexer *lexer, int *number, int *column)
{
	char byte = lexer_peek(lexer), name[KLARTEXT_NAME];

	*column = lexer_next_column(lexer);
	if (byte == '"' || byte == '\'' || klartext_string_follows(lexer))
		return klartext_string_name(lexer, "a tool's name", name) && find_by_name(lexer, name, *column, number);
	if (read_index(lexer, name))
		return find_by_name(lexer, name, *column, number);
	return klartext_integer(lexer, "a tool's number", 0, 32767, number);
}

/* -------------------------------------------------------------- definitions */

static bool check_length(struct lexer *lexer, int number, double length, int column)
{
	struct interp *interp = lexer->context;
	const struct tool *tool = tool_table_find(&interp->tools, number);

	if (!tool || tool == interp->config->any_tool || fabs(tool->length_offset - length) <= TOOL_SUM_TOLERANCE ||
	    interp->config->controller.tool_def == TOOL_DEF_IGNORED)
		return true;
	return fault(
	    lexer->at, column,
	    "TOOL DEF gives T%d a length of %.6g mm, and the setup %.6g mm: which of them the control takes "
	    "depends on whether its tool table is active; make them agree, or set tool_def=\"ignored\" in the "
	    "machine file's <controller> if the table counts",
	    number, length, tool->length_offset);
}

bool klartext_tool_define(struct lexer *lexer)
{
	struct interp *interp = lexer->context;
	int number, column;
	double value;

	if (!read_tool(lexer, &number, &column))
		return false;
	while (!klartext_ends(lexer)) {
		column = lexer_next_column(lexer);
		if (klartext_take(lexer, "L")) {
			if (!klartext_value(lexer, &value) ||
			    !check_length(lexer, number, value * interp->state.scale, column))
				return false;
		} else if (klartext_take(lexer, "R")) {
			if (!klartext_value(lexer, &value))
				return false;
			if (interp->config->controller.tool_def == TOOL_DEF_IGNORED)
				continue;
			klartext_of(interp)->tool.defined = number;
			klartext_of(interp)->tool.defined_radius = value * interp->state.scale;
		} else {
			return fault(lexer->at, column, "TOOL DEF has a number, L and R");
		}
	}
	return true;
}

/* -------------------------------------------------------------------- call */

/* Reads DL, DR or DR2. Only LN uses DR2, and LN with oversizes is refused. */
static bool read_oversize(struct lexer *lexer, struct request *request)
{
	struct interp *interp = lexer->context;
	const int column = lexer_next_column(lexer);
	const bool length = klartext_take(lexer, "DL");
	const bool corner = !length && (klartext_take(lexer, "DR2:") || klartext_take(lexer, "DR2"));
	double value;

	if (!length && !corner && !klartext_take(lexer, "DR"))
		return fault(lexer->at, column, "TOOL CALL has a tool, its axis, S, F, FU, FZ, DL, DR and DR2");
	if (!klartext_value(lexer, &value))
		return false;
	if (length) {
		request->delta_length = value * interp->state.scale;
		request->has_delta_length = true;
	} else if (!corner) {
		request->delta_radius = value * interp->state.scale;
		request->has_delta_radius = true;
	}
	request->oversize |= fabs(value) > 0;
	return true;
}

static bool read_word(struct lexer *lexer, struct request *request)
{
	const int column = lexer_next_column(lexer);

	if (klartext_take(lexer, "Z"))
		return true;
	if (klartext_take(lexer, "X") || klartext_take(lexer, "Y") || klartext_take(lexer, "U") ||
	    klartext_take(lexer, "V") || klartext_take(lexer, "W"))
		return fault(lexer->at, column, "another tool axis than Z is not supported");
	if (klartext_take(lexer, "S"))
		return request->has_speed = true, klartext_value(lexer, &request->speed);
	if (klartext_take(lexer, "FZ")) {
		klartext_words_caution_teeth(lexer, column);
		request->per_revolution = true;
	} else if (klartext_take(lexer, "FU")) {
		request->per_revolution = true;
	} else if (!klartext_take(lexer, "F")) {
		return read_oversize(lexer, request);
	}
	request->has_feed = true;
	return klartext_value(lexer, &request->feed);
}

static bool read_request(struct lexer *lexer, struct request *request)
{
	char byte = lexer_peek(lexer);

	*request = (struct request){.column = lexer_next_column(lexer)};
	if (byte == '"' || byte == '\'' || klartext_string_follows(lexer) || klartext_value_follows(lexer)) {
		request->has_tool = true;
		if (!read_tool(lexer, &request->number, &request->column))
			return false;
	}
	while (!klartext_ends(lexer)) {
		if (!read_word(lexer, request))
			return false;
	}
	if (request->speed < 0 || request->feed < 0)
		return fault(lexer->at, request->column, "S and F of TOOL CALL cannot be negative");
	return true;
}

static bool find_length(struct interp *interp, const struct request *request, double *length)
{
	const struct tool *tool = tool_table_find(&interp->tools, request->number);

	*length = request->delta_length;
	if (request->number == 0)
		return true;
	if (!tool && !interp->config->has_setup)
		return fault(&interp->at, request->column, "T%d: no setup was given that defines the tool's length",
			     request->number);
	if (!tool)
		return fault(
		    &interp->at, request->column,
		    "the setup defines no tool T%d: add <tool number=\"%d\" length=\"\"/> with what it is made of",
		    request->number, request->number);
	*length += tool->length_offset;
	return true;
}

/*
 * iTNC 530 user's manual, "Calling tool data": the new length is in force from TOOL CALL on; TOOL CALL itself moves no
 * axis. The machine file says where the builder's tool change moves the axes.
 */
static bool change(struct interp *interp, const struct request *request)
{
	struct klartext *klartext = klartext_of(interp);
	struct state *state = &interp->state;
	enum tcp_source tcp = state->tcp;
	double length;

	if (tcp == TCP_BY_MCODE)
		return fault(&interp->at, request->column,
			     "TOOL CALL while M128 is in force: the manual wants M129 first");
	if (klartext->corner.waits)
		return fault(&interp->at, request->column, "RND and CHF need a straight line behind them");
	if (!find_length(interp, request, &length))
		return false;
	if (!interp->config->controller.tool_change.given)
		return fault(
		    &interp->at, request->column,
		    "it is not known where TOOL CALL moves the axes: set <tool_change Z=\"\" .../>, or "
		    "<tool_change/> if it moves none, in the machine file's <controller>");
	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		if (klartext->frame.tilted && interp->config->controller.tool_change.has[slot])
			return fault(
			    &interp->at, request->column,
			    "TOOL CALL in a tilted plane, and <tool_change> turns %c away from it; PLANE RESET first",
			    AXIS_LETTERS[slot]);
	}
	interp->block.m_column[M_TOOL] = request->column;
	if (tcp != TCP_OFF)
		klartext_comp_turn_open(interp);
	if (!motion_commands_spindle_stops(interp) || !reference_return_change_tool(interp))
		return false;
	klartext->last.known = false;
	state->tool = request->number;
	state->spindle = SPINDLE_STOPPED;
	state->length = length;
	klartext->tool.oversize = request->oversize;
	klartext->tool.delta_radius = request->delta_radius;
	klartext->tool.delta_length = request->delta_length;
	klartext->tool.change_pending = true;
	klartext->tool.moved = false;
	klartext->tool.called = true;
	if (!motion_commands_emit(interp, &(struct canon_move){.kind = CANON_TOOL_CHANGE, .tool = state->tool}))
		return false;
	state_update_offset(state);
	return tcp == TCP_OFF || tool_length_switch_tcp(interp, request->column, tcp);
}

/*
 * "Calling tool data": without a tool, DL and DR are from now on those of the active tool; nothing moves. The manual
 * does not say whether an oversize of the previous call stays if this call does not give it.
 */
static bool change_oversize(struct interp *interp, struct request *request)
{
	struct klartext *klartext = klartext_of(interp);
	struct state *state = &interp->state;
	const enum tcp_source tcp = state->tcp;
	double length;

	if (!klartext->tool.called || state->tool == 0)
		return fault(&interp->at, request->column, "DL and DR without a tool: no TOOL CALL has named one");
	if ((!request->has_delta_length && !same_double(klartext->tool.delta_length, 0)) ||
	    (!request->has_delta_radius && !same_double(klartext->tool.delta_radius, 0)))
		return fault(&interp->at, request->column,
			     "%s was given before and is left out here: whether it still counts is not known here; "
			     "write it, too",
			     request->has_delta_length ? "DR" : "DL");
	if (tcp == TCP_BY_MCODE)
		return fault(&interp->at, request->column,
			     "TOOL CALL while M128 is in force: the manual wants M129 first");
	request->number = state->tool;
	if (klartext->corner.waits)
		return fault(&interp->at, request->column, "RND and CHF need a straight line behind them");
	if (!find_length(interp, request, &length))
		return false;
	klartext->tool.oversize = request->oversize;
	klartext->tool.delta_radius = request->delta_radius;
	klartext->tool.delta_length = request->delta_length;
	klartext->last.known = false;
	state->length = length;
	state_update_offset(state);
	return tcp == TCP_OFF || tool_length_switch_tcp(interp, request->column, tcp);
}

/*
 * TNC 430 user's manual, "Tool call": F is in force until a positioning block or another TOOL CALL gives a new one; F
 * AUTO refers to it. It is in mm/min or tenths of an inch a minute. FU and FZ are multiplied by the spindle speed.
 */
static void take_feed(struct interp *interp, double feed)
{
	struct klartext_tool *tool = &klartext_of(interp)->tool;
	const double linear = feed * (interp->state.scale > 1 ? interp->state.scale / 10 : 1);

	tool->feed_bare = feed;
	tool->feed = linear;
	interp->state.feed_linear = linear;
	interp->state.feed_angular = feed;
}

/* Takes a new tool, or new oversizes of the tool in the spindle. False: reported. */
static bool take_tool(struct interp *interp, struct request *request)
{
	const bool gives_oversize = request->has_delta_length || request->has_delta_radius || request->oversize;

	if ((request->has_tool || gives_oversize) && klartext_of(interp)->crossing.on_path)
		return fault(&interp->at, request->column,
			     "TOOL CALL under radius compensation, also with a radius of 0, is not supported; a block "
			     "with R0 comes first");
	if (request->has_tool)
		return change(interp, request);
	if (gives_oversize)
		return change_oversize(interp, request);
	return !klartext_of(interp)->tool.oversize ||
	       fault(&interp->at, request->column,
		     "TOOL CALL without the oversize (DL, DR) that the one before has given: whether it still counts "
		     "is not known here; write it, too");
}

bool klartext_tool_call(struct lexer *lexer)
{
	struct interp *interp = lexer->context;
	struct request request;
	bool good;

	if (!read_request(lexer, &request))
		return false;
	/* The speed and the feed hold even if the setup lacks the tool: later blocks are still checked for faults. */
	good = take_tool(interp, &request);
	if (request.has_speed) {
		interp->state.speed = request.speed;
		interp->state.speed_is_zero = !(request.speed > 0);
	}
	if (request.per_revolution && !(interp->state.speed > 0))
		return fault(lexer->at, request.column, "a feed per revolution (FU, FZ) without a spindle speed (S)");
	if (request.has_feed)
		take_feed(interp, request.per_revolution ? request.feed * interp->state.speed : request.feed);
	return good;
}

bool klartext_tool_m6(struct interp *interp, int column)
{
	struct klartext_tool *tool = &klartext_of(interp)->tool;

	if (interp->config->controller.m6 == M6_IGNORED) {
		if (!motion_commands_spindle_stops(interp))
			return false;
		interp->state.spindle = SPINDLE_STOPPED;
		return true;
	}
	if (!tool->change_pending)
		return fault(&interp->at, column,
			     "M6, but no TOOL CALL has named a tool: if TOOL CALL alone changes it, set "
			     "m6=\"ignored\" in the machine file's <controller>");
	if (tool->moved)
		return fault(&interp->at, column,
			     "axes have moved between TOOL CALL and M6: if TOOL CALL alone changes the tool, set "
			     "m6=\"ignored\" in the machine file's <controller>; else write M6 right behind TOOL "
			     "CALL");
	tool->change_pending = false;
	return true;
}
