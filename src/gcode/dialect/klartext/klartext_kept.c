#include "gcode/dialect/klartext/klartext_kept.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "control/control_variable.h"
#include "gcode/dialect/klartext/klartext_string.h"
#include "gcode/dialect/klartext/klartext_value.h"

/* "Q12", "QR5", "QS7": the number behind the letters; -1: it is none, or there are no so many. */
static long number_behind(const char *name, size_t letters, long count)
{
	const char *digits = name + letters;
	const size_t length = strspn(digits, "0123456789");
	const long number = length > 0 && length < 6 && !digits[length] ? strtol(digits, NULL, 10) : -1;

	return number < count ? number : -1;
}

/* iTNC 530 user's manual, "Preassigned Q parameters": tool, spindle, coolant, unit, and the angles of PLANE. */
static bool changes(long number)
{
	return (number >= 108 && number <= 111) || number == 113 || number == 114 || (number >= 120 && number <= 122);
}

static bool load(struct lexer *lexer, const struct control_variable *variable)
{
	struct klartext *klartext = klartext_of(lexer->context);
	const char *name = variable->name;
	const bool text = name[1] == 'S';
	const size_t letters = text || name[1] == 'R' ? 2 : 1;
	const long number = number_behind(name, letters, name[1] == 'R' ? KLARTEXT_QL_COUNT : KLARTEXT_Q_COUNT);

	if (number < 0)
		return fault(lexer->at, 1,
			     "<variable name=\"%s\"> of the machine file is no parameter that is kept: Q, QR or QS and its "
			     "number, or data of FN 18, such as ID50 NR3 IDX1",
			     name);
	if (letters == 1 && changes(number))
		return fault(lexer->at, 1, "<variable name=\"%s\"> of the machine file: the control itself changes this "
					   "parameter while the program runs", name);
	if (text)
		return klartext_string_set(lexer, 1, (int)number, variable->text);
	if (isnan(variable->number))
		return fault(lexer->at, 1, "%s: the value of the machine file is no number", name);
	(name[1] == 'R' ? klartext->qr : klartext->q)[number] =
	    (struct klartext_q){.value = variable->number, .given = true};
	return true;
}

bool klartext_kept_load(struct lexer *lexer)
{
	const struct interp *interp = lexer->context;
	const struct controller *controller = &interp->config->controller;

	for (size_t i = 0; i < controller->variable_count; i++) {
		if (strncmp(controller->variables[i].name, "ID", 2) != 0 && controller->variables[i].text &&
		    !load(lexer, &controller->variables[i]))
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
