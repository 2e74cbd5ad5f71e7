#include "gcode/dialect/klartext/words/klartext_global.h"

#include <stdlib.h>
#include <string.h>

#include "base/same_double.h"
#include "gcode/dialect/klartext/values/klartext_value.h"

/*
 * TNC 640 user's manual, cycle programming, "Program defaults for cycles". The position in the second array is that in
 * the state.
 */
static const struct global_row {
	short number;
	short first, count;	/* of the parameters */
} rows[] = {{100, 0, 4}, {105, 4, 3}, {110, 7, 3}, {111, 10, 4}, {120, 14, 3}, {125, 17, 1}};

static const short parameters[KLARTEXT_GLOBALS] = {200, 204, 253, 208, 256, 210, 211, 370, 351,
						   366, 2,   6,	  7,   9,   320, 260, 301, 345};

static const struct global_row *find_row(int number)
{
	for (size_t i = 0; i < sizeof(rows) / sizeof(rows[0]); i++) {
		if (rows[i].number == number)
			return &rows[i];
	}
	return NULL;
}

/* The index of a parameter among `count` from `first` on; -1: it is not there. */
static int find_parameter(int number, int first, int count)
{
	for (int i = first; i < first + count; i++) {
		if (parameters[i] == number)
			return i;
	}
	return -1;
}

bool klartext_global_check(struct lexer *lexer, int number, int column)
{
	return find_row(number) || fault(lexer->at, column,
					 "GLOBAL DEF %d is not supported: 100, 105, 110, 111, 120 and 125 are", number);
}

bool klartext_global_take(struct interp *interp, const struct klartext_cycle *definition)
{
	struct klartext *klartext = klartext_of(interp);
	const struct global_row *row = find_row(definition->number);

	for (int i = 0; i < definition->count; i++) {
		const struct klartext_cycle_word *word = &definition->words[i];
		const struct line_place at = {interp->at.diag, interp->at.file, word->line, ""};
		const int number = (int)strtol(word->name + 1, NULL, 10);
		const int index = find_parameter(number, row->first, row->count);
		double now;

		if (index < 0)
			return fault(&at, word->column, "%s does not belong to GLOBAL DEF %d", word->name, row->number);
		if (!word->given)
			return fault(&at, word->column, "%s of GLOBAL DEF %d needs a value", word->name, row->number);
		if (number == 345 && !same_double(word->value, 0) && !same_double(word->value, 1))
			return fault(&at, word->column, "Q345 is 0 or 1");
		klartext->globals.given[index] = true;
		klartext->globals.value[index] = word->value;
		/* It is not documented whether the parameter itself changes here, or where a cycle takes its value. */
		if (!klartext_q_get(klartext, number, &now) || !same_double(now, word->value))
			klartext->values.q[number] = (struct klartext_q){.read = true, .global = true};
	}
	return true;
}

bool klartext_global_value(struct lexer *lexer, int column, int number, const char *text, double *value)
{
	const struct klartext_globals *globals = &klartext_of(lexer->context)->globals;
	const int index = find_parameter(number, 0, KLARTEXT_GLOBALS);

	if (strcmp(text, "PREDEF"))
		return fault(lexer->at, column, "Q%d=%s is not supported: give a number", number, text);
	if (klartext_of(lexer->context)->cycles.definition.global)
		return fault(lexer->at, column, "Q%d=PREDEF in GLOBAL DEF, which itself gives the value", number);
	if (index < 0 || !globals->given[index])
		return fault(lexer->at, column, "Q%d=PREDEF, but no GLOBAL DEF before it has given Q%d", number,
			     number);
	*value = globals->value[index];
	return true;
}

bool klartext_global_is(const struct klartext *klartext, int number, double value)
{
	const int index = find_parameter(number, 0, KLARTEXT_GLOBALS);

	return index >= 0 && klartext->globals.given[index] && same_double(klartext->globals.value[index], value);
}
