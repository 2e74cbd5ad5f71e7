#include "gcode/dialect/sinumerik/sinumerik_expr.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/units.h"
#include "control/control_variable.h"
#include "gcode/dialect/sinumerik/sinumerik_functions.h"
#include "gcode/dialect/sinumerik/sinumerik_gud.h"
#include "gcode/dialect/sinumerik/sinumerik_name.h"
#include "gcode/dialect/sinumerik/sinumerik_system.h"
#include "gcode/dialect/sinumerik/sinumerik_text.h"
#include "gcode/dialect/sinumerik/sinumerik_variables.h"
#include "gcode/eval/expr.h"

/* 840D sl, job planning, "Comparison operations": REAL values are equal within this part of them. */
#define SAME_PART 1e-12

#define LARGEST_WHOLE 2147483647.0

static const struct expr_rules rules;

/* ------------------------------------------------------------------- text */

bool sinumerik_expr_is_text(struct interp *interp, struct lexer *lexer)
{
	return sinumerik_text_follows(interp, lexer);
}

bool sinumerik_expr_text(struct interp *interp, struct lexer *lexer, struct sinumerik_text *text)
{
	struct expr expr = {.lexer = lexer, .rules = &rules, .context = interp};

	return sinumerik_text_read(&expr, text);
}

/* -------------------------------------------------------------- variables */

bool sinumerik_expr_whole(struct interp *interp, struct lexer *lexer, const char *what, int least, int most,
			  int *value)
{
	const int column = expr_column(lexer);
	double number;

	if (!sinumerik_expr_number(interp, lexer, &number))
		return false;
	if (number < least || number > most || floor(number) < number)
		return fault(lexer->at, column, "%s must be a whole number from %d to %d, not %.15g", what, least, most,
			     number);
	*value = (int)number;
	return true;
}

bool sinumerik_expr_element(struct interp *interp, struct lexer *lexer, const struct sinumerik_variable *variable,
			    size_t *element)
{
	int index;

	*element = 0;
	if (variable->dimensions == 0)
		return true;
	if (!sinumerik_name_need(lexer, '[', variable->name))
		return false;
	for (int i = 0; i < variable->dimensions; i++) {
		if ((i > 0 && !sinumerik_name_need(lexer, ',', "an index")) ||
		    !sinumerik_expr_whole(interp, lexer, "an index", 0, variable->size[i] - 1, &index))
			return false;
		*element = *element * (size_t)variable->size[i] + (size_t)index;
	}
	return sinumerik_name_need(lexer, ']', "the indices");
}

bool sinumerik_expr_r_number(struct interp *interp, struct lexer *lexer, const char *name, int *number)
{
	const int column = expr_column(lexer);

	if (name[1] == '\0')
		return sinumerik_name_need(lexer, '[', "R") &&
		       sinumerik_expr_whole(interp, lexer, "the number of an R parameter", 0, SINUMERIK_R_COUNT - 1,
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

/* A variable of the type AXIS names the axis; else `slot` stays. */
static bool axis_of_variable(struct interp *interp, struct lexer *lexer, const char *name, int column, int *slot)
{
	const struct sinumerik *sinumerik = sinumerik_of(interp);
	const int found = name[0] ? sinumerik_variables_find(sinumerik, name) : -1;
	size_t element;

	if (found < 0 || sinumerik->variables[found].type != SINUMERIK_AXIS)
		return true;
	if (!sinumerik_expr_element(interp, lexer, &sinumerik->variables[found], &element) ||
	    !sinumerik_variables_check(lexer->at, &sinumerik->variables[found], element, column))
		return false;
	*slot = (int)sinumerik->variables[found].numbers[element];
	return true;
}

bool sinumerik_expr_axis(struct interp *interp, struct lexer *lexer, int *slot)
{
	const int column = expr_column(lexer);
	char name[SINUMERIK_NAME + 1] = "";

	*slot = -1;
	if (sinumerik_name_read(lexer, name) == 1)
		*slot = slot_of_letter(name[0]);
	else if (!axis_of_variable(interp, lexer, name, column, slot))
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
	       sinumerik_expr_whole(interp, expr->lexer, "the number of a tool", 1, 32000, &tool) &&
	       sinumerik_name_need(expr->lexer, ',', "the tool") &&
	       sinumerik_expr_whole(interp, expr->lexer, "the number of an edge", 1, 32000, &edge) &&
	       sinumerik_name_need(expr->lexer, ']', "the edge") &&
	       sinumerik_system_edge(interp, name, tool, edge, column, value);
}

/* $P_UIFR[n, axis, component]: of a settable work offset. */
static bool offset_value(struct expr *expr, int column, double *value)
{
	struct interp *interp = expr->context;
	char component[SINUMERIK_NAME + 1] = "";
	int n, slot;

	if (!sinumerik_name_need(expr->lexer, '[', "$P_UIFR") ||
	    !sinumerik_expr_whole(interp, expr->lexer, "the number of $P_UIFR", 1, 99, &n) ||
	    !sinumerik_name_need(expr->lexer, ',', "the number of $P_UIFR") ||
	    !sinumerik_expr_axis(interp, expr->lexer, &slot) || !sinumerik_name_need(expr->lexer, ',', "the axis"))
		return false;
	sinumerik_name_read(expr->lexer, component);
	return sinumerik_name_need(expr->lexer, ']', "the component") &&
	       sinumerik_system_offset(interp, n, slot, component, column, value);
}

/* Is the index of a system variable, which comes next, the name of an axis and nothing else? */
static bool index_is_axis(struct lexer *lexer)
{
	const size_t position = lexer->position;
	char name[SINUMERIK_NAME + 1];
	const bool is = sinumerik_name_take_byte(lexer, '[') && sinumerik_name_read(lexer, name) == 1 &&
			lexer_peek(lexer) == ']';

	lexer->position = position;
	return is;
}

/* "[1,X]": numbers and axes, as they are now. */
static bool read_indices(struct interp *interp, struct lexer *lexer, char *text, size_t size)
{
	int length = 0;

	text[0] = '\0';
	if (!sinumerik_name_take_byte(lexer, '['))
		return true;
	do {
		const size_t position = lexer->position;
		const int column = expr_column(lexer);
		char name[SINUMERIK_NAME + 1];
		double value;

		length += snprintf(text + length, size - (size_t)length, "%c", length > 0 ? ',' : '[');
		if (sinumerik_name_read(lexer, name) == 1 && (lexer_peek(lexer) == ']' || lexer_peek(lexer) == ',')) {
			length += snprintf(text + length, size - (size_t)length, "%s", name);
			continue;
		}
		lexer->position = position;
		if (!sinumerik_expr_number(interp, lexer, &value))
			return false;
		length += snprintf(text + length, size - (size_t)length, "%.12g", value);
		if (length > (int)size - 24)
			return fault(lexer->at, column, "too many indices");
	} while (sinumerik_name_take_byte(lexer, ','));
	snprintf(text + length, size - (size_t)length, "]");
	return sinumerik_name_need(lexer, ']', "an index");
}

static bool control_value(struct expr *expr, const char *name, int column, double *value)
{
	char indices[CONTROL_VARIABLE_NAME - SINUMERIK_NAME], whole[CONTROL_VARIABLE_NAME];

	if (!read_indices(expr->context, expr->lexer, indices, sizeof(indices)))
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
		       sinumerik_expr_whole(expr->context, expr->lexer, "the number of a length", 1, 3, &index) &&
		       sinumerik_name_need(expr->lexer, ']', "the number of a length") &&
		       sinumerik_system_tool(expr->context, index, column, &value->number);
	if (!strcmp(name, "$P_TOOLR"))
		return sinumerik_system_tool(expr->context, 0, column, &value->number);
	if (!sinumerik_system_follows(name, index_is_axis(expr->lexer)))
		return control_value(expr, name, column, &value->number);
	if (sinumerik_name_take_byte(expr->lexer, '[') &&
	    (!sinumerik_expr_axis(expr->context, expr->lexer, &slot) ||
	     !sinumerik_name_need(expr->lexer, ']', "the axis")))
		return false;
	return sinumerik_system_read(expr->context, name, slot, column, &value->number);
}

/* R1, R[R2], a variable of DEF, a system variable, a function, or one of the constants. */
static bool named(struct expr *expr, const char *name, int column, struct expr_operand *value)
{
	struct interp *interp = expr->context;
	const struct sinumerik *sinumerik = sinumerik_of(interp);
	const struct sinumerik_variable *variable;
	size_t element = 0;
	int found = sinumerik_variables_find(sinumerik, name);

	if (found >= 0) {
		variable = &sinumerik->variables[found];
		if (!sinumerik_expr_element(interp, expr->lexer, variable, &element))
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

/* 'H1F', 'B101': whole numbers to the base of 16 or 2. */
static bool constant_value(struct lexer *lexer, double *value)
{
	static const char digits[] = "0123456789ABCDEF";
	const int column = expr_column(lexer);
	const char *text = lexer->at->text + lexer->position + 1;
	const int base = sinumerik_upper(*text) == 'H' ? 16 : sinumerik_upper(*text) == 'B' ? 2 : 0;

	*value = 0;
	if (base == 0 || text[1] == '\'')
		return fault(lexer->at, column, "'H' or 'B' and digits stand between such quotes: 'H1F', 'B101'");
	for (text++; *text && *text != '\''; text++) {
		const char *digit = strchr(digits, sinumerik_upper(*text));

		if (!digit || digit - digits >= base)
			return fault(lexer->at, column, "this is no whole number to the base of %d", base);
		*value = *value * base + (double)(digit - digits);
		/* INT has 32 bits: with the first one the number might be negative. */
		if (*value > LARGEST_WHOLE)
			return fault(lexer->at, column, "a number of more than 31 bits");
	}
	if (*text != '\'')
		return fault(lexer->at, column, "this quote is not closed");
	lexer->position = (size_t)(text - lexer->at->text) + 1;
	return true;
}

/* 840D sl operating manual, "R variables": they keep their values, also while the control is off. */
static bool r_value(struct interp *interp, struct lexer *lexer, const char *name, int column, double *value)
{
	double *r;
	int number;

	if (!sinumerik_expr_r_number(interp, lexer, name, &number))
		return false;
	r = &sinumerik_of(interp)->r[number];
	if (isnan(*r))
		*r = sinumerik_gud_r(interp, number);
	*value = *r;
	if (!isnan(*r))
		return true;
	/* Told once. */
	*r = 0;
	return fault(lexer->at, column,
		     "R%d keeps its value from one program to the next, and this one has given it none so far: "
		     "<variable name=\"R%d\" value=\"\"/> in the machine's <controller> says what it holds",
		     number, number);
}

static bool variable_value(struct expr *expr, struct expr_operand *value)
{
	struct interp *interp = expr->context;
	struct lexer *lexer = expr->lexer;
	const int column = expr_column(lexer);
	char name[SINUMERIK_NAME + 1];

	if (sinumerik_text_follows(interp, lexer))
		return sinumerik_text_compare(expr, value);
	if (lexer_peek(lexer) == '\'')
		return constant_value(lexer, &value->number);
	if (!sinumerik_name_read(lexer, name))
		return fault(lexer->at, column, "a value is needed here");
	if (!is_r(name) || (name[1] == '\0' && lexer_peek(lexer) != '['))
		return named(expr, name, column, value);
	return r_value(interp, lexer, name, column, &value->number);
}

/* -------------------------------------------------------------- operators */

static bool same(double left, double right)
{
	return fabs(left - right) <= SAME_PART * fmax(fabs(left), fabs(right));
}

static bool holds(enum expr_operation operation, double left, double right)
{
	switch (operation) {
	case EXPR_EQ:
		return same(left, right);
	case EXPR_NE:
		return !same(left, right);
	case EXPR_GT:
		return left > right && !same(left, right);
	case EXPR_GE:
		return left >= right || same(left, right);
	case EXPR_LT:
		return left < right && !same(left, right);
	default:
		return left <= right || same(left, right);
	}
}

static bool apply_bits(struct expr *expr, int column, enum expr_operation operation, double *left, double right)
{
	const double numbers[2] = {*left, right};
	long a, b;

	for (int i = 0; i < 2; i++) {
		if (fabs(numbers[i]) > LARGEST_WHOLE || floor(numbers[i]) < numbers[i])
			return fault(expr->lexer->at, column, "B_AND, B_OR and B_XOR need whole numbers, not %.15g",
				     numbers[i]);
	}
	a = (long)numbers[0];
	b = (long)numbers[1];
	*left = (double)(operation == EXPR_BIT_AND ? a & b : operation == EXPR_BIT_OR ? a | b : a ^ b);
	return true;
}

static bool divide(struct expr *expr, int column, enum expr_operation operation, double *left, double right)
{
	if (fpclassify(right) == FP_ZERO)
		return fault(expr->lexer->at, column, "division by zero");
	*left = operation == EXPR_MODULO ? fmod(*left, right) : *left / right;
	if (operation == EXPR_INTEGER_DIVIDE)
		*left = trunc(*left);
	return true;
}

static bool apply(struct expr *expr, int column, const struct expr_operator *operator, struct expr_operand *left,
		  struct expr_operand *right)
{
	const enum expr_operation operation = operator->operation;
	const bool a = fpclassify(left->number) != FP_ZERO, b = fpclassify(right->number) != FP_ZERO;
	struct sinumerik *sinumerik = sinumerik_of(expr->context);

	sinumerik->compares = sinumerik->compares || operation <= EXPR_LE;
	sinumerik->joins =
	    sinumerik->joins || operation == EXPR_AND || operation == EXPR_OR || operation == EXPR_XOR;
	if (operation <= EXPR_LE) {
		left->number = holds(operation, left->number, right->number);
	} else if (operation == EXPR_AND || operation == EXPR_OR || operation == EXPR_XOR) {
		left->number = operation == EXPR_AND ? a && b : operation == EXPR_OR ? a || b : a != b;
	} else if (operation >= EXPR_BIT_AND) {
		return apply_bits(expr, column, operation, &left->number, right->number);
	} else if (operation == EXPR_PLUS) {
		left->number += right->number;
	} else if (operation == EXPR_MINUS) {
		left->number -= right->number;
	} else if (operation == EXPR_TIMES) {
		left->number *= right->number;
	} else if (!divide(expr, column, operation, &left->number, right->number)) {
		return false;
	}
	return isfinite(left->number) || fault(expr->lexer->at, column, "the result is infinite");
}

/* 840D sl, job planning, "Priority of the operations": comparisons come last. */
static const struct expr_operator operators[] = {
	{"==", EXPR_EQ, 1, false},   {"<>", EXPR_NE, 1, false},	      {">=", EXPR_GE, 1, false},
	{"<=", EXPR_LE, 1, false},   {">", EXPR_GT, 1, false},	      {"<", EXPR_LT, 1, false},
	{"or", EXPR_OR, 2, false},   {"xor", EXPR_XOR, 3, false},     {"and", EXPR_AND, 4, false},
	{"b_or", EXPR_BIT_OR, 5, false}, {"b_xor", EXPR_BIT_XOR, 6, false}, {"b_and", EXPR_BIT_AND, 7, false},
	{"+", EXPR_PLUS, 8, false},  {"-", EXPR_MINUS, 8, false},     {"*", EXPR_TIMES, 9, false},
	{"/", EXPR_DIVIDE, 9, false}, {"div", EXPR_INTEGER_DIVIDE, 9, false}, {"mod", EXPR_MODULO, 9, false},
};

/* As people mean it who leave the parentheses out: comparisons before AND, XOR and OR. */
static const struct expr_operator meant[] = {
	{"or", EXPR_OR, 1, false},   {"xor", EXPR_XOR, 2, false},     {"and", EXPR_AND, 3, false},
	{"==", EXPR_EQ, 4, false},   {"<>", EXPR_NE, 4, false},	      {">=", EXPR_GE, 4, false},
	{"<=", EXPR_LE, 4, false},   {">", EXPR_GT, 4, false},	      {"<", EXPR_LT, 4, false},
	{"b_or", EXPR_BIT_OR, 5, false}, {"b_xor", EXPR_BIT_XOR, 6, false}, {"b_and", EXPR_BIT_AND, 7, false},
	{"+", EXPR_PLUS, 8, false},  {"-", EXPR_MINUS, 8, false},     {"*", EXPR_TIMES, 9, false},
	{"/", EXPR_DIVIDE, 9, false}, {"div", EXPR_INTEGER_DIVIDE, 9, false}, {"mod", EXPR_MODULO, 9, false},
};

static bool no_function(struct expr *expr, int column, const struct function_name *function,
			struct expr_operand *value)
{
	(void)function;
	(void)value;
	return fault(expr->lexer->at, column, "a value is needed here");
}

/* All but the operators. */
#define RULES(table) \
	.open = '(', \
	.close = ')', \
	.variable_starts = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_$\"'", \
	.whole_words = true, \
	.signs_repeat = true, \
	.exponents = true, \
	.depth_max = 64, \
	.nested = "brackets", \
	.apply = apply, \
	.function = no_function, \
	.variable = variable_value, \
	.operators = (table), .operator_count = sizeof(table) / sizeof((table)[0])

static const struct expr_rules rules = {RULES(operators)};
static const struct expr_rules meant_rules = {RULES(meant)};

/*
 * The manual's table has AND, XOR and OR before comparisons, which a program without parentheses hardly means: where
 * both orders come to the same, that holds, and else the program must say it.
 */
static bool check_meant(struct interp *interp, struct lexer *lexer, size_t start, double value)
{
	struct lexer again = {.at = lexer->at, .position = start};
	struct expr expr = {.lexer = &again, .rules = &meant_rules, .context = interp};
	struct expr_operand operand;
	const int column = expr_column(&again);

	if (!expr_sum(&expr, &operand))
		return false;
	return (again.position == lexer->position && same(value, operand.number)) ||
	       fault(lexer->at, column,
		     "the control takes AND, OR and XOR before ==, < and the like, which comes to something else here "
		     "than the other order: put the comparisons into parentheses");
}

bool sinumerik_expr_number(struct interp *interp, struct lexer *lexer, double *value)
{
	struct expr expr = {.lexer = lexer, .rules = &rules, .context = interp};
	struct sinumerik *sinumerik = sinumerik_of(interp);
	const bool compares = sinumerik->compares, joins = sinumerik->joins;
	const size_t start = lexer->position;
	struct expr_operand operand;
	bool both;

	sinumerik->compares = sinumerik->joins = false;
	if (!expr_sum(&expr, &operand))
		return false;
	both = sinumerik->compares && sinumerik->joins;
	sinumerik->compares = compares || sinumerik->compares;
	sinumerik->joins = joins || sinumerik->joins;
	*value = operand.number;
	return !both || check_meant(interp, lexer, start, operand.number);
}
