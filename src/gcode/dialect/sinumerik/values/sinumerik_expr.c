#include "gcode/dialect/sinumerik/values/sinumerik_expr.h"

#include <math.h>

#include "gcode/dialect/sinumerik/values/sinumerik_operand.h"
#include "gcode/dialect/sinumerik/values/sinumerik_text.h"
#include "gcode/eval/expr.h"

/* 840D sl, job planning, "Comparison operations": REAL values are equal within this part of them. */
#define SAME_PART 1e-12

/* INT has 32 bits. */
#define LARGEST_WHOLE 2147483647.0

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

	sinumerik->logic.compares = sinumerik->logic.compares || operation <= EXPR_LE;
	sinumerik->logic.joins =
	    sinumerik->logic.joins || operation == EXPR_AND || operation == EXPR_OR || operation == EXPR_XOR;
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

/* The order that people mean if they omit the parentheses: comparisons before AND, XOR and OR. */
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

/* All rules except the operators. */
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
	.variable = sinumerik_operand_read, \
	.operators = (table), .operator_count = sizeof(table) / sizeof((table)[0])

static const struct expr_rules rules = {RULES(operators)};
static const struct expr_rules meant_rules = {RULES(meant)};

/*
 * In the table of the manual, AND, XOR and OR come before comparisons. A program without parentheses hardly means
 * this. If both orders give the same value, that value is used; else the program must write parentheses.
 */
static bool check_meant(struct interp *interp, struct lexer *lexer, size_t start, double value)
{
	struct lexer again = {.at = lexer->at, .position = start};
	struct expr expr = {.lexer = &again, .rules = &meant_rules, .context = interp};
	struct expr_operand operand;
	const int column = lexer_next_column(&again);

	if (!expr_sum(&expr, &operand))
		return false;
	return (again.position == lexer->position && same(value, operand.number)) ||
	       fault(lexer->at, column,
		     "the control takes AND, OR and XOR before ==, < and the like, which comes to something else here "
		     "than the other order: put the comparisons into parentheses");
}

static struct expr plain(struct interp *interp, struct lexer *lexer)
{
	return (struct expr){.lexer = lexer, .rules = &rules, .context = interp};
}

bool sinumerik_expr_number(struct interp *interp, struct lexer *lexer, double *value)
{
	struct expr expr = plain(interp, lexer);
	struct sinumerik *sinumerik = sinumerik_of(interp);
	const bool compares = sinumerik->logic.compares, joins = sinumerik->logic.joins;
	const size_t start = lexer->position;
	struct expr_operand operand;
	bool both;

	sinumerik->logic.compares = sinumerik->logic.joins = false;
	if (!expr_sum(&expr, &operand))
		return false;
	both = sinumerik->logic.compares && sinumerik->logic.joins;
	sinumerik->logic.compares = compares || sinumerik->logic.compares;
	sinumerik->logic.joins = joins || sinumerik->logic.joins;
	*value = operand.number;
	return !both || check_meant(interp, lexer, start, operand.number);
}

bool sinumerik_expr_whole(struct interp *interp, struct lexer *lexer, const char *what, int least, int most,
			  int *value)
{
	struct expr expr = plain(interp, lexer);

	return sinumerik_operand_whole(&expr, what, least, most, value);
}

bool sinumerik_expr_is_text(struct interp *interp, struct lexer *lexer)
{
	return sinumerik_text_follows(interp, lexer);
}

bool sinumerik_expr_text(struct interp *interp, struct lexer *lexer, struct sinumerik_text *text)
{
	struct expr expr = plain(interp, lexer);

	return sinumerik_text_read(&expr, text);
}

bool sinumerik_expr_element(struct interp *interp, struct lexer *lexer, const struct sinumerik_variable *variable,
			    size_t *element)
{
	struct expr expr = plain(interp, lexer);

	return sinumerik_operand_element(&expr, variable, element);
}

bool sinumerik_expr_r_number(struct interp *interp, struct lexer *lexer, const char *name, int *number)
{
	struct expr expr = plain(interp, lexer);

	return sinumerik_operand_r_number(&expr, name, number);
}

bool sinumerik_expr_axis(struct interp *interp, struct lexer *lexer, int *slot)
{
	struct expr expr = plain(interp, lexer);

	return sinumerik_operand_axis(&expr, slot);
}
