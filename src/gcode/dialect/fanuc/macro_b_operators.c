#include "gcode/dialect/fanuc/macro_b_operators.h"

#include <math.h>

#include "gcode/state.h"

/*
 * Controls compute with about nine digits (B-63944EN, operation error): of
 * numbers that are nearer to each other, but not equal, nobody knows the order.
 */
#define NEAR 1e-8
#define LARGEST_WHOLE 2147483647.0

static bool is_fanuc(const struct lexer *lexer)
{
	return lexer->interp->config->dialect->legacy == GCODE_FANUC;
}

/* B-63944EN, priority of operations: functions; * / AND MOD; + - OR XOR; and comparisons last. */
int macro_b_operation_rank(enum macro_b_operation operation)
{
	return operation >= MACRO_TIMES ? 3 : operation >= MACRO_PLUS ? 2 : operation != MACRO_NO_OPERATION ? 1 : 0;
}

bool macro_b_operation_is_logic(enum macro_b_operation operation)
{
	return operation == MACRO_AND || operation == MACRO_OR || operation == MACRO_XOR;
}

/* A vacant operand counts as 0 (B-63944EN, undefined variable); what Haas makes of one is not in its manual. */
bool macro_b_operand_fill(struct lexer *lexer, int column, struct macro_b_operand *value)
{
	if (!isnan(value->number))
		return true;
	if (!is_fanuc(lexer))
		return fault(lexer->at, column, "a variable without a value: what Haas's control computes with it is "
						"not in its manual");
	value->number = 0;
	return true;
}

bool macro_b_nearly_equal(double left, double right)
{
	double most = fmax(1, fmax(fabs(left), fabs(right))), difference = fabs(left - right);

	return difference > 0 && difference <= NEAR * most;
}

static bool holds(enum macro_b_operation operation, double left, double right)
{
	switch (operation) {
	case MACRO_EQ:
		return !(left < right) && !(left > right);
	case MACRO_NE:
		return left < right || left > right;
	case MACRO_GT:
		return left > right;
	case MACRO_GE:
		return left >= right;
	case MACRO_LT:
		return left < right;
	default:
		return left <= right;
	}
}

/* B-63944EN, undefined variable: in conditions a vacant value differs from 0 for EQ and NE only. */
static bool compare(struct lexer *lexer, int column, enum macro_b_operation operation, struct macro_b_operand *left,
		    struct macro_b_operand *right)
{
	bool vacant = isnan(left->number), other = isnan(right->number);

	if (left->truth || right->truth)
		return fault(lexer->at, column, "the result of a comparison cannot be compared; use AND or OR");
	/* A Haas program asks "#1 EQ #0" for a variable without a value; the number that #1 holds is not #0. */
	if ((operation == MACRO_EQ || operation == MACRO_NE) && (other || (vacant && is_fanuc(lexer)))) {
		*left = (struct macro_b_operand){(vacant == other) == (operation == MACRO_EQ), true};
		return true;
	}
	if (!macro_b_operand_fill(lexer, column, left) || !macro_b_operand_fill(lexer, column, right))
		return false;
	if (macro_b_nearly_equal(left->number, right->number))
		return fault(lexer->at, column,
			     "these numbers differ by %.2g only, less than a control computes with; compare with a "
			     "margin",
			     fabs(left->number - right->number));
	*left = (struct macro_b_operand){holds(operation, left->number, right->number), true};
	return true;
}

bool macro_b_is_whole(double value)
{
	return fabs(value) <= LARGEST_WHOLE && !(floor(value) < value);
}

/* Bit by bit (B-63944EN, logical operations; Haas, "Logical operators": of the integer portion). */
static bool apply_logic(struct lexer *lexer, int column, enum macro_b_operation operation, struct macro_b_operand *left,
			struct macro_b_operand *right)
{
	double numbers[2] = {left->number, right->number};
	unsigned long a, b;

	for (int i = 0; i < 2; i++) {
		if (!is_fanuc(lexer))
			numbers[i] = trunc(numbers[i]);
		if (numbers[i] < 0 || !macro_b_is_whole(numbers[i]))
			return fault(lexer->at, column,
				     "AND, OR and XOR work on whole numbers that are not negative, not on %.15g",
				     numbers[i]);
	}
	if (is_fanuc(lexer) && left->truth != right->truth)
		return fault(lexer->at, column, "one of the operands is a comparison, and the other is none");
	a = (unsigned long)numbers[0];
	b = (unsigned long)numbers[1];
	left->number = (double)(operation == MACRO_AND ? a & b : operation == MACRO_OR ? a | b : a ^ b);
	left->truth = left->truth && right->truth;
	return true;
}

/* B-63944EN, MOD: of whole numbers, with the sign of the first; other controls differ in both. */
static bool apply_modulo(struct lexer *lexer, int column, struct macro_b_operand *left, double right)
{
	bool negative = right < 0 || (left->number < 0 && !is_fanuc(lexer));

	if (negative || !macro_b_is_whole(left->number) || !macro_b_is_whole(right))
		return fault(lexer->at, column, "MOD of %.15g and %.15g: controls agree on whole numbers only%s",
			     left->number, right, is_fanuc(lexer) ? "" : " that are not negative");
	left->number = fmod(left->number, right);
	return true;
}

static bool apply_arithmetic(struct lexer *lexer, int column, enum macro_b_operation operation,
			     struct macro_b_operand *left,
			     struct macro_b_operand *right)
{
	if (is_fanuc(lexer) && (left->truth || right->truth))
		return fault(lexer->at, column, "the result of a comparison is no number here");
	left->truth = false;
	if ((operation == MACRO_DIVIDE || operation == MACRO_MODULO) && fpclassify(right->number) == FP_ZERO)
		return fault(lexer->at, column, "division by zero");
	switch (operation) {
	case MACRO_PLUS:
		left->number += right->number;
		break;
	case MACRO_MINUS:
		left->number -= right->number;
		break;
	case MACRO_TIMES:
		left->number *= right->number;
		break;
	case MACRO_DIVIDE:
		left->number /= right->number;
		break;
	default:
		return apply_modulo(lexer, column, left, right->number);
	}
	if (isfinite(left->number))
		return true;
	return fault(lexer->at, column, "the result is infinite");
}

bool macro_b_operate(struct lexer *lexer, int column, enum macro_b_operation operation, struct macro_b_operand *left,
		  struct macro_b_operand *right)
{
	if (macro_b_operation_rank(operation) == 1)
		return compare(lexer, column, operation, left, right);
	if (!macro_b_operand_fill(lexer, column, left) || !macro_b_operand_fill(lexer, column, right))
		return false;
	if (macro_b_operation_is_logic(operation))
		return apply_logic(lexer, column, operation, left, right);
	return apply_arithmetic(lexer, column, operation, left, right);
}
