#include "gcode/dialect/fanuc/macro_b_operators.h"

#include <math.h>

#include "base/same_double.h"

/*
 * Controls compute with about nine digits (B-63944EN, operation error): the order of numbers that are closer than this,
 * but not equal, is not known.
 */
#define NEAR 1e-8
#define LARGEST_WHOLE 2147483647.0

/* A vacant operand counts as 0 (B-63944EN, undefined variable); Haas's manual does not define this case. */
bool macro_b_operators_fill(const struct macro_b_rules *rules, const struct line_place *at, int column,
			    struct expr_operand *value)
{
	if (!isnan(value->number))
		return true;
	if (!rules->vacant_counts)
		return fault(at, column,
			     "a variable without a value: %s's manual does not say what the control computes",
			     rules->control);
	value->number = 0;
	return true;
}

bool macro_b_operators_nearly_equal(double left, double right)
{
	double most = fmax(1, fmax(fabs(left), fabs(right))), difference = fabs(left - right);

	return difference > 0 && difference <= NEAR * most;
}

static bool holds(enum expr_operation operation, double left, double right)
{
	switch (operation) {
	case EXPR_EQ:
		return same_double(left, right);
	case EXPR_NE:
		return !same_double(left, right);
	case EXPR_GT:
		return left > right;
	case EXPR_GE:
		return left >= right;
	case EXPR_LT:
		return left < right;
	default:
		return left <= right;
	}
}

/* B-63944EN, undefined variable: in conditions a vacant value differs from 0 only for EQ and NE. */
static bool compare(const struct macro_b_rules *rules, const struct line_place *at, int column,
		    enum expr_operation operation, struct expr_operand *left, struct expr_operand *right)
{
	bool vacant = isnan(left->number), other = isnan(right->number);

	if (left->truth || right->truth)
		return fault(at, column, "the result of a comparison cannot be compared again; use AND or OR");
	/* A Haas program tests for a variable without a value by "#1 EQ #0"; any number in #1 differs from #0. */
	if ((operation == EXPR_EQ || operation == EXPR_NE) && (other || (vacant && rules->vacant_counts))) {
		*left = (struct expr_operand){(vacant == other) == (operation == EXPR_EQ), true};
		return true;
	}
	if (!macro_b_operators_fill(rules, at, column, left) || !macro_b_operators_fill(rules, at, column, right))
		return false;
	if (macro_b_operators_nearly_equal(left->number, right->number))
		return fault(at, column,
			     "these numbers differ by only %.2g, which is less than the precision of a control; "
			     "compare with a margin",
			     fabs(left->number - right->number));
	*left = (struct expr_operand){holds(operation, left->number, right->number), true};
	return true;
}

bool macro_b_operators_is_whole(double value)
{
	return fabs(value) <= LARGEST_WHOLE && !(floor(value) < value);
}

/* Bit by bit (B-63944EN, logical operations; Haas, "Logical operators": of the integer portion). */
static bool apply_logic(const struct macro_b_rules *rules, const struct line_place *at, int column,
			enum expr_operation operation, struct expr_operand *left, struct expr_operand *right)
{
	double numbers[2] = {left->number, right->number};
	unsigned long a, b;

	for (int i = 0; i < 2; i++) {
		if (rules->logic_truncates)
			numbers[i] = trunc(numbers[i]);
		if (numbers[i] < 0 || !macro_b_operators_is_whole(numbers[i]))
			return fault(at, column,
				     "AND, OR and XOR need whole numbers that are not negative, not %.15g",
				     numbers[i]);
	}
	if (!rules->truth_is_number && left->truth != right->truth)
		return fault(at, column, "AND, OR and XOR need two comparisons or two numbers, not one of each");
	a = (unsigned long)numbers[0];
	b = (unsigned long)numbers[1];
	left->number = (double)(operation == EXPR_AND ? a & b : operation == EXPR_OR ? a | b : a ^ b);
	left->truth = left->truth && right->truth;
	return true;
}

/* B-63944EN, MOD: for whole numbers, with the sign of the first; other controls differ in both points. */
static bool apply_modulo(const struct macro_b_rules *rules, const struct line_place *at, int column,
			 struct expr_operand *left, double right)
{
	bool negative = right < 0 || (left->number < 0 && !rules->modulo_signed);

	if (negative || !macro_b_operators_is_whole(left->number) || !macro_b_operators_is_whole(right))
		return fault(at, column, "MOD of %.15g and %.15g: controls agree only for whole numbers%s",
			     left->number, right, rules->modulo_signed ? "" : " that are not negative");
	left->number = fmod(left->number, right);
	return true;
}

static bool apply_arithmetic(const struct macro_b_rules *rules, const struct line_place *at, int column,
			     enum expr_operation operation, struct expr_operand *left, struct expr_operand *right)
{
	if (!rules->truth_is_number && (left->truth || right->truth))
		return fault(at, column, "a comparison cannot be used as a number here");
	left->truth = false;
	if ((operation == EXPR_DIVIDE || operation == EXPR_MODULO) && fpclassify(right->number) == FP_ZERO)
		return fault(at, column, "division by zero");
	switch (operation) {
	case EXPR_PLUS:
		left->number += right->number;
		break;
	case EXPR_MINUS:
		left->number -= right->number;
		break;
	case EXPR_TIMES:
		left->number *= right->number;
		break;
	case EXPR_DIVIDE:
		left->number /= right->number;
		break;
	default:
		return apply_modulo(rules, at, column, left, right->number);
	}
	if (isfinite(left->number))
		return true;
	return fault(at, column, "the result is infinite");
}

bool macro_b_operators_apply(const struct macro_b_rules *rules, const struct line_place *at, int column,
			     enum expr_operation operation, struct expr_operand *left, struct expr_operand *right)
{
	if (operation <= EXPR_LE)
		return compare(rules, at, column, operation, left, right);
	if (!macro_b_operators_fill(rules, at, column, left) || !macro_b_operators_fill(rules, at, column, right))
		return false;
	if (operation >= EXPR_AND)
		return apply_logic(rules, at, column, operation, left, right);
	return apply_arithmetic(rules, at, column, operation, left, right);
}
