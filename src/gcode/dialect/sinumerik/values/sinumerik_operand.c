#include "gcode/dialect/sinumerik/values/sinumerik_operand.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/ascii.h"
#include "base/units.h"
#include "control/control_variable.h"
#include "gcode/dialect/sinumerik/builder/sinumerik_gud.h"
#include "gcode/dialect/sinumerik/values/sinumerik_functions.h"
#include "gcode/dialect/sinumerik/values/sinumerik_system.h"
#include "gcode/dialect/sinumerik/values/sinumerik_text.h"
#include "gcode/dialect/sinumerik/values/sinumerik_variables.h"
#include "gcode/dialect/sinumerik/words/sinumerik_name.h"
#include "gcode/execute/tool_table.h"

/* INT has 32 bits. */
#define LARGEST_WHOLE 2147483647.0

bool sinumerik_operand_whole(struct expr *expr, const char *what, int least, int most, int *value)
{
	const int column = lexer_next_column(expr->lexer);
	struct expr_operand operand;

	if (!expr_sum(expr, &operand))
		return false;
	if (operand.number < least || operand.number > most || floor(operand.number) < operand.number)
		return fault(expr->lexer->at, column, "%s must be a whole number from %d to %d, not %.15g", what, least,
			     most, operand.number);
	*value = (int)operand.number;
	return true;
}

bool sinumerik_operand_element(struct expr *expr, const struct sinumerik_variable *variable, size_t *element)
{
	struct lexer *lexer = expr->lexer;
	int index;

	*element = 0;
	if (variable->dimensions == 0)
		return true;
	if (!sinumerik_name_need(lexer, '[', variable->name))
		return false;
	for (int i = 0; i < variable->dimensions; i++) {
		if ((i > 0 && !sinumerik_name_need(lexer, ',', "an index")) ||
		    !sinumerik_operand_whole(expr, "an index", 0, variable->size[i] - 1, &index))
			return false;
		*element = *element * (size_t)variable->size[i] + (size_t)index;
	}
	return sinumerik_name_need(lexer, ']', "the indices");
}

bool sinumerik_operand_r_number(struct expr *expr, const char *name, int *number)
{
	struct lexer *lexer = expr->lexer;
	const int column = lexer_next_column(lexer);

	if (name[1] == '\0')
		return sinumerik_name_need(lexer, '[', "R") &&
		       sinumerik_operand_whole(expr, "the number of an R parameter", 0, SINUMERIK_R_COUNT - 1,
					       number) &&
		       sinumerik_name_need(lexer, ']', "the number of an R parameter");
	*number = 0;
	for (const char *digit = name + 1; *digit; digit++) {
		*number = 10 * *number + (*digit - '0');
		if (*number >= SINUMERIK_R_COUNT)
			return fault(lexer->at, column, "R parameters have numbers up to %d", SINUMERIK_R_COUNT - 1);
	}
	return true;
}

/* Takes the axis from a variable of the type AXIS; else `slot` does not change. */
static bool axis_of_variable(struct expr *expr, const char *name, int column, int *slot)
{
	const struct sinumerik *sinumerik = sinumerik_of(expr->context);
	const int found = name[0] ? sinumerik_variables_find(sinumerik, name) : -1;
	size_t element;

	if (found < 0 || sinumerik->variables.items[found].type != SINUMERIK_AXIS)
		return true;
	if (!sinumerik_operand_element(expr, &sinumerik->variables.items[found], &element) ||
	    !sinumerik_variables_check(expr->lexer->at, &sinumerik->variables.items[found], element, column))
		return false;
	*slot = (int)sinumerik->variables.items[found].numbers[element];
	return true;
}

bool sinumerik_operand_axis(struct expr *expr, int *slot)
{
	const struct interp *interp = expr->context;
	struct lexer *lexer = expr->lexer;
	const int column = lexer_next_column(lexer);
	char name[SINUMERIK_NAME + 1] = "";

	*slot = -1;
	if (sinumerik_name_read(lexer, name) == 1)
		*slot = slot_of_letter(name[0]);
	else if (!axis_of_variable(expr, name, column, slot))
		return false;
	if (*slot < 0 || !interp->config->has_axis[*slot])
		return fault(lexer->at, column, "an axis of the machine is needed here");
	return true;
}

/* $TC_DP6[T, D] and the like: data of a tool's edge. */
static bool tool_value(struct expr *expr, const char *name, int column, double *value)
{
	struct interp *interp = expr->context;
	int tool, edge;

	return sinumerik_name_need(expr->lexer, '[', name) &&
	       sinumerik_operand_whole(expr, "the number of a tool", 1, 32000, &tool) &&
	       sinumerik_name_need(expr->lexer, ',', "the tool") &&
	       sinumerik_operand_whole(expr, "the number of an edge", 1, 32000, &edge) &&
	       sinumerik_name_need(expr->lexer, ']', "the edge") &&
	       sinumerik_system_edge(interp, name, tool, edge, column, value);
}

/* $P_UIFR[n, axis, component]: a value of a settable work offset. */
static bool offset_value(struct expr *expr, int column, double *value)
{
	struct interp *interp = expr->context;
	char component[SINUMERIK_NAME + 1] = "";
	int n, slot;

	if (!sinumerik_name_need(expr->lexer, '[', "$P_UIFR") ||
	    !sinumerik_operand_whole(expr, "the number of $P_UIFR", 1, 99, &n) ||
	    !sinumerik_name_need(expr->lexer, ',', "the number of $P_UIFR") ||
	    !sinumerik_operand_axis(expr, &slot) || !sinumerik_name_need(expr->lexer, ',', "the axis"))
		return false;
	sinumerik_name_read(expr->lexer, component);
	return sinumerik_name_need(expr->lexer, ']', "the component") &&
	       sinumerik_system_offset(interp, n, slot, component, column, value);
}

/* Is the index of a system variable, which comes next, only the name of an axis? */
static bool index_is_axis(struct lexer *lexer)
{
	const size_t position = lexer->position;
	char name[SINUMERIK_NAME + 1];
	const bool is = sinumerik_name_take_byte(lexer, '[') && sinumerik_name_read(lexer, name) == 1 &&
			lexer_peek(lexer) == ']';

	lexer->position = position;
	return is;
}

/* Writes "[1,X]" with the present values of the indices. */
static bool read_indices(struct expr *expr, char *text, size_t size)
{
	struct lexer *lexer = expr->lexer;
	int length = 0;

	text[0] = '\0';
	if (!sinumerik_name_take_byte(lexer, '['))
		return true;
	do {
		const size_t position = lexer->position;
		const int column = lexer_next_column(lexer);
		char name[SINUMERIK_NAME + 1];
		struct expr_operand value;

		length += snprintf(text + length, size - (size_t)length, "%c", length > 0 ? ',' : '[');
		if (sinumerik_name_read(lexer, name) == 1 && (lexer_peek(lexer) == ']' || lexer_peek(lexer) == ',')) {
			length += snprintf(text + length, size - (size_t)length, "%s", name);
			continue;
		}
		lexer->position = position;
		if (!expr_sum(expr, &value))
			return false;
		length += snprintf(text + length, size - (size_t)length, "%.12g", value.number);
		if (length > (int)size - 24)
			return fault(lexer->at, column, "too many indices");
	} while (sinumerik_name_take_byte(lexer, ','));
	snprintf(text + length, size - (size_t)length, "]");
	return sinumerik_name_need(lexer, ']', "an index");
}

static bool control_value(struct expr *expr, const char *name, int column, double *value)
{
	char indices[CONTROL_VARIABLE_NAME - SINUMERIK_NAME], whole[CONTROL_VARIABLE_NAME];

	if (!read_indices(expr, indices, sizeof(indices)))
		return false;
	snprintf(whole, sizeof(whole), "%s%s", name, indices);
	return sinumerik_gud_system(expr->context, whole, column, value);
}

static bool system_value(struct expr *expr, const char *name, int column, struct expr_operand *value)
{
	int slot = -1, index;

	if (!strcmp(name, "$TC_DP3") || !strcmp(name, "$TC_DP6"))
		return tool_value(expr, name, column, &value->number);
	if (!strcmp(name, "$P_UIFR"))
		return offset_value(expr, column, &value->number);
	if (!strcmp(name, "$P_TOOLL"))
		return sinumerik_name_need(expr->lexer, '[', name) &&
		       sinumerik_operand_whole(expr, "the number of a length", 1, 3, &index) &&
		       sinumerik_name_need(expr->lexer, ']', "the number of a length") &&
		       sinumerik_system_tool(expr->context, index, column, &value->number);
	if (!strcmp(name, "$P_TOOLR"))
		return sinumerik_system_tool(expr->context, 0, column, &value->number);
	if (!sinumerik_system_follows(name, index_is_axis(expr->lexer)))
		return control_value(expr, name, column, &value->number);
	if (sinumerik_name_take_byte(expr->lexer, '[') &&
	    (!sinumerik_operand_axis(expr, &slot) ||
	     !sinumerik_name_need(expr->lexer, ']', "the axis")))
		return false;
	return sinumerik_system_read(expr->context, name, slot, column, &value->number);
}

/* GETT("NAME", 1), tool management: the number of a tool. Setups know no replacement tools (the second argument). */
static bool tool_number(struct expr *expr, int column, double *value)
{
	const struct interp *interp = expr->context;
	const struct line_place *at = expr->lexer->at;
	const struct tool *tool;
	struct sinumerik_text name;
	int copy;

	if (!expr_enter(expr) || !expr_open(expr, "GETT") || !sinumerik_text_read(expr, &name))
		return false;
	expr->depth--;
	if (sinumerik_name_take_byte(expr->lexer, ',') &&
	    !sinumerik_operand_whole(expr, "the number of a replacement tool", 1, 1, &copy))
		return false;
	if (!expr_close(expr))
		return false;
	if (!interp->config->has_setup)
		return fault(at, column, "the number of the tool \"%s\" is not known without a setup", name.bytes);
	if (!tool_table_find_name(&interp->tools, at, column, name.bytes, true, &tool))
		return false;
	*value = tool->number;
	return true;
}

/* A variable of DEF, a system variable, a function, or a constant. */
static bool named(struct expr *expr, const char *name, int column, struct expr_operand *value)
{
	struct interp *interp = expr->context;
	const struct sinumerik *sinumerik = sinumerik_of(interp);
	const struct sinumerik_variable *variable;
	size_t element = 0;
	int found = sinumerik_variables_find(sinumerik, name);

	if (found >= 0) {
		variable = &sinumerik->variables.items[found];
		if (!sinumerik_operand_element(expr, variable, &element))
			return false;
		value->number = variable->numbers[element];
		if (variable->type == SINUMERIK_AXIS)
			return fault(expr->lexer->at, column, "%s is the name of an axis and no number", name);
		return sinumerik_variables_check(expr->lexer->at, variable, element, column);
	}
	if (sinumerik_system_constant(name, &value->number))
		return true;
	if (!strcmp(name, "PI") || !strcmp(name, "$PI")) {
		value->number = PI;
		return true;
	}
	if (name[0] == '$')
		return system_value(expr, name, column, value);
	if (!strcmp(name, "GETT"))
		return tool_number(expr, column, &value->number);
	if (sinumerik_text_measures(name))
		return sinumerik_text_measure(expr, name, &value->number);
	if (lexer_peek(expr->lexer) == '(' || !strcmp(name, "NOT") || !strcmp(name, "B_NOT"))
		return sinumerik_functions_compute(expr, name, column, &value->number);
	return sinumerik_gud_ask(expr->lexer, name, true, column);
}

static bool is_r(const char *name)
{
	if (name[0] != 'R')
		return false;
	return name[1 + strspn(name + 1, "0123456789")] == '\0';
}

/* 'H1F', 'B101': whole numbers to the base 16 or 2. */
static bool constant_value(struct lexer *lexer, double *value)
{
	static const char digits[] = "0123456789ABCDEF";
	const int column = lexer_next_column(lexer);
	const char *text = lexer->at->text + lexer->position + 1;
	const int base = ascii_upper(*text) == 'H' ? 16 : ascii_upper(*text) == 'B' ? 2 : 0;

	*value = 0;
	if (base == 0 || text[1] == '\'')
		return fault(lexer->at, column, "'H' or 'B' and digits stand between such quotes: 'H1F', 'B101'");
	for (text++; *text && *text != '\''; text++) {
		const char *digit = strchr(digits, ascii_upper(*text));

		if (!digit || digit - digits >= base)
			return fault(lexer->at, column, "this is no whole number to the base of %d", base);
		*value = *value * base + (double)(digit - digits);
		/* INT has 32 bits: a number with the first bit set might be negative. */
		if (*value > LARGEST_WHOLE)
			return fault(lexer->at, column, "a number of more than 31 bits");
	}
	if (*text != '\'')
		return fault(lexer->at, column, "this quote is not closed");
	lexer->position = (size_t)(text - lexer->at->text) + 1;
	return true;
}

/* 840D sl, operating manual, "R variables": they keep their values, also while the control is off. */
static bool r_value(struct expr *expr, const char *name, int column, double *value)
{
	struct interp *interp = expr->context;
	double *r;
	int number;

	if (!sinumerik_operand_r_number(expr, name, &number))
		return false;
	r = &sinumerik_of(interp)->variables.r[number];
	if (isnan(*r))
		*r = sinumerik_gud_r(interp, number);
	*value = *r;
	if (!isnan(*r))
		return true;
	/* Reported once. */
	*r = 0;
	return fault(expr->lexer->at, column,
		     "R%d keeps its value from one program to the next, and this program has not set it: set "
		     "<variable name=\"R%d\" value=\"\"/> in the machine file's <controller>",
		     number, number);
}

bool sinumerik_operand_read(struct expr *expr, struct expr_operand *value)
{
	struct interp *interp = expr->context;
	struct lexer *lexer = expr->lexer;
	const int column = lexer_next_column(lexer);
	char name[SINUMERIK_NAME + 1];

	if (sinumerik_text_follows(interp, lexer))
		return sinumerik_text_compare(expr, value);
	if (lexer_peek(lexer) == '\'')
		return constant_value(lexer, &value->number);
	if (!sinumerik_name_read(lexer, name))
		return fault(lexer->at, column, "a value is needed here");
	if (!is_r(name) || (name[1] == '\0' && lexer_peek(lexer) != '['))
		return named(expr, name, column, value);
	return r_value(expr, name, column, &value->number);
}
