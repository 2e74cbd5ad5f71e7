#include "gcode/dialect/fanuc/macro_b_kept.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "control/control_variable.h"
#include "gcode/dialect/fanuc/macro_b_state.h"

static const struct control_variable *find(const struct interp *interp, int number, char name[16])
{
	const struct control_variable *variable;

	snprintf(name, 16, "#%d", number);
	variable = control_variable_find(&interp->config->controller, name);
	return variable && variable->text ? variable : NULL;
}

bool macro_b_kept_tells(const struct interp *interp, int number)
{
	char name[16];

	return find(interp, number, name) != NULL;
}

bool macro_b_kept_read(struct interp *interp, int number, int column, const char *why, double *value)
{
	char name[16];
	const struct control_variable *variable = find(interp, number, name);

	if (!variable)
		return fault(&interp->at, column,
			     "%s %s: set <variable name=\"%s\" value=\"\"/> in the machine file's <controller>",
			     name, why, name);
	*value = !strcmp(variable->text, "vacant") ? macro_b_vacant() : variable->number;
	return !isnan(variable->number) || !strcmp(variable->text, "vacant") ||
	       fault(&interp->at, column, "%s: the value=\"%s\" of its <variable> must be a number or \"vacant\"",
		     name, variable->text);
}
