#include "gcode/dialect/klartext/values/klartext_value.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/ascii.h"
#include "base/same_double.h"
#include "gcode/dialect/klartext/text/klartext_lexis.h"
#include "gcode/text/number.h"
#include "geom/tolerance.h"

void klartext_q_set(struct klartext *klartext, int number, double value)
{
	klartext->values.q[number] = (struct klartext_q){.value = value, .given = true};
}

void klartext_q_forget(struct klartext *klartext, int number)
{
	klartext->values.q[number] = (struct klartext_q){.read = true};
}

bool klartext_q_get(const struct klartext *klartext, int number, double *value)
{
	*value = klartext->values.q[number].value;
	return klartext->values.q[number].given;
}

/* ------------------------------------------------------------- parameters */

/* Sets Q108, the tool radius with the DR of TOOL CALL. */
static void set_radius(struct interp *interp)
{
	struct klartext *klartext = klartext_of(interp);
	const struct tool *tool = tool_table_find(&interp->tools, interp->state.tool);
	const double radius = tool ? tool->diameter / 2 : 0;

	if (!(radius > 0) || (klartext->tool.defined == interp->state.tool &&
			      fabs(klartext->tool.defined_radius - radius) > TOOL_SUM_TOLERANCE))
		klartext_q_forget(klartext, 108);
	else
		klartext_q_set(klartext, 108, (radius + klartext->tool.delta_radius) / interp->state.scale);
}

/*
 * iTNC 530 user's manual, "Preassigned Q parameters": values that the control always knows. Before the first TOOL CALL
 * and M3 they are those from before the program. Q110 distinguishes M5 after M3 from M5 after M4.
 */
static void preassign(struct interp *interp, int number)
{
	struct klartext *klartext = klartext_of(interp);
	const struct state *state = &interp->state;

	if (number == 113)
		klartext_q_set(klartext, 113, klartext->inch);
	else if (number == 110 && state->spindle != SPINDLE_STOPPED)
		klartext_q_set(klartext, 110, state->spindle == SPINDLE_CLOCKWISE ? 0 : 1);
	else if (number == 110 || ((number == 108 || number == 109 || number == 114) && !klartext->tool.called))
		klartext_q_forget(klartext, number);
	else if (number == 108)
		set_radius(interp);
	else if (number == 109)
		klartext_q_set(klartext, 109, 2);
	else if (number == 114)
		klartext_q_set(klartext, 114, state->length / state->scale);
}

struct klartext_q *klartext_q_find(struct lexer *lexer, int *number)
{
	struct interp *interp = lexer->context;
	struct klartext *klartext = klartext_of(interp);
	const char *text = lexer->at->text;
	int column = lexer_next_column(lexer), count = KLARTEXT_Q_COUNT;
	char kind = 'Q';
	struct klartext_q *array = klartext->values.q;

	lexer_take(lexer);
	if (text[lexer->position] == 'L' || text[lexer->position] == 'l') {
		kind = 'L';
		array = klartext->values.ql[klartext->calls.programs];
	} else if (text[lexer->position] == 'R' || text[lexer->position] == 'r') {
		kind = 'R';
		array = klartext->values.qr;
	}
	if (kind != 'Q') {
		count = KLARTEXT_QL_COUNT;
		lexer_take(lexer);
	}
	for (*number = 0; ascii_is_digit(text[lexer->position]); lexer_take(lexer)) {
		*number = 10 * *number + (text[lexer->position] - '0');
		if (*number >= count) {
			fault_report(lexer->at, column, "Q parameters go from %s0 to %s%d",
				     kind == 'Q'   ? "Q"
				     : kind == 'L' ? "QL"
						   : "QR",
				     kind == 'Q'   ? "Q"
				     : kind == 'L' ? "QL"
						   : "QR",
				     count - 1);
			return NULL;
		}
	}
	if (kind == 'Q' && *number >= 100 && *number < 200)
		preassign(interp, *number);
	return &array[*number];
}

void klartext_query_name(const struct klartext_query *query, char *name, size_t size)
{
	const int length = snprintf(name, size, "ID%d NR%d", query->id, query->number);

	if (query->has_index)
		snprintf(name + length, size - (size_t)length, " IDX%d", query->index);
}

/* iTNC 530 technical manual, FN 18: tool table, pocket table, pocket of a tool, software limits, touch probe. */
bool klartext_query_is_table(const struct klartext_query *query)
{
	static const int tables[] = {50, 51, 52, 230, 350};

	for (size_t i = 0; i < sizeof(tables) / sizeof(tables[0]); i++) {
		if (query->id == tables[i])
			return true;
	}
	return false;
}

/* Further advice for the message that the value of a query is not known. */
static const char *other_answer(const struct klartext_query *query)
{
	switch (query->id) {
	case 20:
		return query->number == 1 ? ", or name the tool by initial_tool of the <setup>" : "";
	case 240:
	case 270:
		return ", or write FN 20: WAIT FOR SYNC before it";
	case 530:
		return ", or select the preset by CYCL DEF 247 before it";
	default:
		return "";
	}
}

/*
 * Reports that a value that was read from the control is not known. The machine file can give data of tables, but
 * neither positions nor data that the program itself changes. Always false.
 */
static bool ask_data(const struct lexer *lexer, int column, const char *name, int length,
		     const struct klartext_query *query)
{
	char data[48];

	klartext_query_name(query, data, sizeof(data));
	if (klartext_query_is_table(query))
		return fault(lexer->at, column,
			     "%.*s was read from a table of the control (FN 18), and what that holds is not known "
			     "here: set <variable name=\"%s\" value=\"\"/> in the machine file's <controller>",
			     length, name, data);
	return fault(lexer->at, column,
		     "%.*s was read from the control (FN 18, %s), and that value is not known here: to check the "
		     "program, assign the value by FN 0 behind it%s",
		     length, name, data,
		     other_answer(query));
}

/* Asks the machine file for the value that a parameter has before the program assigns it. */
static bool ask_kept(const struct lexer *lexer, int column, const char *name, int length)
{
	if (ascii_upper(name[1]) == 'L')
		return fault(lexer->at, column, "%.*s has no value: the program has not assigned one", length, name);
	return fault(lexer->at, column,
		     "%.*s has no value: the program has not assigned one; if the control holds one from before, "
		     "set <variable name=\"%.*s\" value=\"\"/> in the machine file's <controller>",
		     length, name, length, name);
}

bool klartext_q_read(struct lexer *lexer, double *value)
{
	int column = lexer_next_column(lexer), number;
	const char *name = lexer->at->text + lexer->position;
	const struct klartext_q *q = klartext_q_find(lexer, &number);
	int length = (int)(lexer->at->text + lexer->position - name);

	if (!q)
		return false;
	if (q->read && q->pole)
		return fault(lexer->at, column,
			     "%.*s is the angle of an axis that any angle suits: whether CYCL DEF 19 leaves it "
			     "where it is or turns it to 0 depends on the control: set swivel_pole=\"stays\" or "
			     "\"zero\" in the machine file's <controller>",
			     length, name);
	if (q->global)
		return fault(lexer->at, column,
			     "whether GLOBAL DEF also changes %.*s itself is not known: assign the value to another "
			     "parameter",
			     length, name);
	if (q->read && number >= 100 && number < 200)
		return fault(lexer->at, column,
			     "%.*s is a value of the control that is not known here: write the value in its place",
			     length, name);
	if (q->read && q->query.id > 0)
		return ask_data(lexer, column, name, length, &q->query);
	if (q->read)
		return fault(
		    lexer->at, column,
		    "%.*s was read from the control (FN 28), and that value is not known here: to check "
		    "the program, assign the value by FN 0 behind it",
		    length, name);
	if (!q->given)
		return ask_kept(lexer, column, name, length);
	*value = q->value;
	return true;
}

/* ------------------------------------------------------------------ values */

/* A parameter: "Q1", "QL2" */
static bool is_q(const char *text)
{
	return ascii_upper(text[0]) == 'Q' && (ascii_is_digit(text[1]) || (text[1] && strchr("LlRr", text[1])));
}

/*
 * "X + 10", "Z + Q13", as some posts write it: the position after the blanks that follow a sign; 0: there is no such
 * sign.
 */
static size_t behind_sign(struct lexer *lexer)
{
	const char byte = lexer_peek(lexer), *text = lexer->at->text;
	size_t position = lexer->position + 1;

	if (byte != '+' && byte != '-')
		return 0;
	while (text[position] == ' ' || text[position] == '\t')
		position++;
	if (position == lexer->position + 1)
		return 0;
	return ascii_is_digit(text[position]) || is_q(text + position) ? position : 0;
}

bool klartext_value_follows(struct lexer *lexer)
{
	char byte = lexer_peek(lexer);
	const char *text = lexer->at->text + lexer->position;

	if (byte == '+' || byte == '-')
		byte = *++text;
	return is_q(text) || ascii_is_digit(byte) || byte == '.' || byte == ',' || behind_sign(lexer);
}

/* Reads a value that number_take_usual() does not read. */
static bool read_value(struct lexer *lexer, double *value)
{
	char byte = lexer_peek(lexer);
	const size_t behind = behind_sign(lexer);
	bool negative = byte == '-';

	if (behind) {
		lexer->position = behind;
		if (!klartext_value(lexer, value))
			return false;
		*value = negative ? -*value : *value;
		return true;
	}
	switch (number_read_with_comma(lexer->at->text, &lexer->position, value)) {
	case NUMBER_OK:
		return true;
	case NUMBER_TOO_LONG:
		return fault(lexer->at, lexer_column(lexer), "a number of more than %d digits", NUMBER_LENGTH_MAX);
	case NUMBER_MISSING:
		break;
	}
	if (!klartext_value_follows(lexer))
		return fault(lexer->at, lexer_column(lexer), "a value is needed here");
	if (byte == '-' || byte == '+')
		lexer_take(lexer);
	if (!klartext_q_read(lexer, value))
		return false;
	*value = negative ? -*value : *value;
	return true;
}

bool klartext_value(struct lexer *lexer, double *value)
{
	const char *text = lexer->at->text, *end;
	bool point;

	lexer_peek(lexer);
	end = number_take_usual(text + lexer->position, true, value, &point);
	if (!end)
		return read_value(lexer, value);
	lexer->position = (size_t)(end - text);
	return true;
}

bool klartext_integer(struct lexer *lexer, const char *what, int least, int greatest, int *value)
{
	int column = lexer_next_column(lexer);
	double number;

	if (!klartext_value(lexer, &number))
		return false;
	if (!(number >= least && number <= greatest) || !same_double(floor(number), number))
		return fault(lexer->at, column, "%s is a whole number from %d to %d", what, least, greatest);
	*value = (int)number;
	return true;
}
