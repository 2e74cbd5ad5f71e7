#include "gcode/dialect/klartext/values/klartext_kept.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "control/control_variable.h"
#include "gcode/dialect/klartext/values/klartext_string.h"
#include "gcode/dialect/klartext/values/klartext_value.h"

/*
 * The number after the letters of "Q12", "QR5" or "QS7"; only one spelling is valid. -1: not a number, or not below
 * `count`.
 */
static long number_behind(const char *name, size_t letters, long count)
{
	const char *digits = name + letters;
	const size_t length = strspn(digits, "0123456789");
	const bool spelt = length > 0 && length < 6 && !digits[length] && (*digits != '0' || length == 1);
	const long number = spelt ? strtol(digits, NULL, 10) : -1;

	return number < count ? number : -1;
}

/*
 * iTNC 530 user's manual, "Preassigned Q parameters": does the control change this parameter (tool, spindle, coolant,
 * unit, angles of PLANE)?
 */
static bool changes(long number)
{
	return (number >= 108 && number <= 111) || number == 113 || number == 114 || (number >= 120 && number <= 122);
}

static bool load(struct lexer *lexer, const struct control_variable *variable)
{
	struct klartext_values *values = &klartext_of(lexer->context)->values;
	const char *name = variable->name;
	const bool text = name[1] == 'S';
	const size_t letters = text || name[1] == 'R' ? 2 : 1;
	const long number = number_behind(name, letters, name[1] == 'R' ? KLARTEXT_QL_COUNT : KLARTEXT_Q_COUNT);

	if (number < 0)
		return fault(lexer->at, 0,
			     "<variable name=\"%s\"> is no parameter that is kept: Q, QR or QS and its "
			     "number, or data of FN 18, such as ID50 NR3 IDX1",
			     name);
	if (letters == 1 && changes(number))
		return fault(lexer->at, 0, "<variable name=\"%s\">: the control itself changes this "
					   "parameter while the program runs", name);
	if (text)
		return klartext_string_set(lexer, 0, (int)number, variable->text);
	if (isnan(variable->number))
		return fault(lexer->at, 0, "%s: the value of its <variable> is no number", name);
	(name[1] == 'R' ? values->qr : values->q)[number] =
	    (struct klartext_q){.value = variable->number, .given = true};
	return true;
}

/*
 * Takes a word and its number, which has one spelling and at most six digits, and returns the text after them. NULL:
 * the text does not begin so.
 */
static const char *take_numbered(const char *text, const char *word, int *number)
{
	const char *digits = text + strlen(word);
	size_t length;

	if (strncmp(text, word, strlen(word)) != 0)
		return NULL;
	length = strspn(digits, "0123456789");
	if (length < 1 || length > 6 || (*digits == '0' && length > 1))
		return NULL;
	*number = (int)strtol(digits, NULL, 10);
	return digits + length;
}

/* Checks data such as "ID50NR3IDX1", which FN 18 reads from a table that no program changes. False: reported. */
static bool check_data(struct lexer *lexer, const struct control_variable *variable)
{
	const char *name = variable->name;
	struct klartext_query query = {0};
	const char *at = take_numbered(name, "ID", &query.id);

	at = at ? take_numbered(at, "NR", &query.number) : NULL;
	query.has_index = at && *at != '\0';
	if (query.has_index)
		at = take_numbered(at, "IDX", &query.index);
	if (!at || *at != '\0' || !klartext_query_is_table(&query))
		return fault(lexer->at, 0,
			     "<variable name=\"%s\"> is no data of a table that FN 18 reads (ID 50, 51, 52, "
			     "230, 350), such as ID50 NR3 IDX1",
			     name);
	return !isnan(variable->number) ||
	       fault(lexer->at, 0, "%s: the value of its <variable> is no number", name);
}

bool klartext_kept_load(struct lexer *lexer)
{
	const struct interp *interp = lexer->context;
	const struct controller *controller = &interp->config->controller;

	for (size_t i = 0; i < controller->variable_count; i++) {
		const struct control_variable *variable = &controller->variables[i];
		const struct line_place place = fault_place(lexer->at, variable->at);
		struct lexer there = *lexer;

		there.at = &place;
		if (variable->text && !(strncmp(variable->name, "ID", 2) ? load(&there, variable)
									 : check_data(&there, variable)))
			return false;
	}
	return true;
}

bool klartext_kept_data(const struct interp *interp, const struct klartext_query *query, double *value)
{
	const struct control_variable *variable;
	char name[CONTROL_VARIABLE_NAME];

	if (!klartext_query_is_table(query))
		return false;
	klartext_query_name(query, name, sizeof(name));
	control_variable_name_normalise(name, name);
	variable = control_variable_find(&interp->config->controller, name);
	if (!variable || !variable->text || isnan(variable->number))
		return false;
	*value = variable->number;
	return true;
}
