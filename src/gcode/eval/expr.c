#include "gcode/eval/expr.h"

#include <math.h>
#include <string.h>

#include "base/ascii.h"
#include "gcode/text/number.h"

/* Exponents must be below this. */
#define EXPONENT_MAX 100

static bool is_sign(char byte)
{
	return byte == '+' || byte == '-';
}

/* Does this byte start a variable? */
static bool starts_variable(const struct expr_rules *rules, char byte)
{
	for (const char *start = rules->variable_starts; *start; start++) {
		if (*start == byte)
			return true;
	}
	return false;
}

/* --------------------------------------------------------------- brackets */

bool expr_enter(struct expr *expr)
{
	if (expr->depth >= expr->rules->depth_max)
		return fault(expr->lexer->at, lexer_column(expr->lexer), "%s are nested deeper than %d levels",
			     expr->rules->nested, expr->rules->depth_max);
	expr->depth++;
	return true;
}

bool expr_open(struct expr *expr, const char *what)
{
	const struct expr_rules *rules = expr->rules;

	if (lexer_peek(expr->lexer) != rules->open)
		return fault(expr->lexer->at, lexer_column(expr->lexer), "%s needs a value in brackets, %c...%c", what,
			     rules->open, rules->close);
	if (!expr_enter(expr))
		return false;
	lexer_take(expr->lexer);
	return true;
}

bool expr_close(struct expr *expr)
{
	char byte = lexer_peek(expr->lexer);

	if (byte == '\0')
		return fault(expr->lexer->at, lexer_column(expr->lexer),
			     "this expression is not closed: '%c' is missing", expr->rules->close);
	if (byte != expr->rules->close)
		return fault(expr->lexer->at, lexer_column(expr->lexer), "an operator or '%c' is missing here",
			     expr->rules->close);
	lexer_take(expr->lexer);
	expr->depth--;
	return true;
}

bool expr_bracket(struct expr *expr, const char *what, struct expr_operand *value)
{
	return expr_open(expr, what) && expr_sum(expr, value) && expr_close(expr);
}

/* -------------------------------------------------------------- operators */

/* An operator that has been read, while its right operand has not; NULL: there is none. */
struct next_operator {
	const struct expr_operator *operator;
	int column;
	size_t position;
};

/* Consumes the operator's name if it comes next. */
static bool take_name(struct expr *expr, const char *name)
{
	const size_t position = expr->lexer->position, length = strlen(name);
	const char *text = expr->lexer->at->text + position;

	if (!lexer_keyword(expr->lexer, name))
		return false;
	if (!expr->rules->whole_words || !ascii_is_letter(*name) ||
	    (expr->lexer->position == position + length && !ascii_is_letter(text[length]) &&
	     !ascii_is_digit(text[length]) && text[length] != '_'))
		return true;
	expr->lexer->position = position;
	return false;
}

static void take_operator(struct expr *expr, struct next_operator *next)
{
	const struct expr_rules *rules = expr->rules;
	char byte = lexer_peek(expr->lexer);

	byte = ascii_lower(byte);
	*next = (struct next_operator){NULL, lexer_column(expr->lexer), expr->lexer->position};
	for (size_t i = 0; i < rules->operator_count && !next->operator; i++) {
		if (rules->operators[i].name[0] == byte && take_name(expr, rules->operators[i].name))
			next->operator = &rules->operators[i];
	}
}

static bool check_order(struct expr *expr, const struct expr_operator *first, const struct expr_operator *next,
			int column)
{
	if (first == next || (!first->unordered && !next->unordered))
		return true;
	return fault(expr->lexer->at, column, "%s", expr->rules->unordered);
}

/*
 * Computes operators of at least this rank, from left to right. *first is the first operator in this pair of brackets,
 * *next the operator after the value, whose rank is lower.
 */
static bool climb(struct expr *expr, int rank, const struct expr_operator **first, struct next_operator *next,
		  struct expr_operand *value)
{
	if (!expr_value(expr, value))
		return false;
	take_operator(expr, next);
	while (next->operator && next->operator->rank >= rank) {
		struct next_operator this = *next;
		struct expr_operand right;

		if (!*first)
			*first = this.operator;
		if (!check_order(expr, *first, this.operator, this.column) ||
		    !climb(expr, this.operator->rank + 1, first, next, &right) ||
		    !expr->rules->apply(expr, this.column, this.operator, value, &right))
			return false;
	}
	return true;
}

bool expr_sum(struct expr *expr, struct expr_operand *value)
{
	const struct expr_operator *first = NULL;
	struct next_operator next;

	return climb(expr, 1, &first, &next, value);
}

bool expr_part(struct expr *expr, int rank, struct expr_operand *value)
{
	const struct expr_operator *first = NULL;
	struct next_operator next;

	if (!climb(expr, rank, &first, &next, value))
		return false;
	if (next.operator)
		expr->lexer->position = next.position;
	return true;
}

/* ----------------------------------------------------------------- values */

/* Reads EX-3 directly after a number, which is then multiplied by this power of ten. */
static bool read_exponent(struct expr *expr, double *value)
{
	struct lexer *lexer = expr->lexer;
	const char *text = lexer->at->text + lexer->position;
	const bool negative = text[0] && text[1] && text[2] == '-';
	int exponent = 0;

	if ((text[0] != 'E' && text[0] != 'e') || (text[1] != 'X' && text[1] != 'x') || lexer->position == 0 ||
	    text[-1] == ' ' || text[-1] == '\t')
		return true;
	text += text[2] == '-' || text[2] == '+' ? 3 : 2;
	if (!ascii_is_digit(*text))
		return true;
	for (; ascii_is_digit(*text); text++)
		exponent = exponent < EXPONENT_MAX ? 10 * exponent + (*text - '0') : exponent;
	if (exponent >= EXPONENT_MAX)
		return fault(lexer->at, lexer_column(lexer), "an exponent has at most two digits");
	for (; exponent > 0; exponent--)
		*value = negative ? *value / 10 : *value * 10;
	lexer->position = (size_t)(text - lexer->at->text);
	return true;
}

bool expr_number(struct expr *expr, double *value)
{
	struct lexer *lexer = expr->lexer;
	size_t position = lexer->position;
	bool point;

	switch (expr->rules->decimal_comma ? number_read_with_comma(lexer->at->text, &position, value)
					   : number_read(lexer->at->text, &position, value, &point)) {
	case NUMBER_OK:
		if (expr->rules->whole_words && number_has_blank(lexer->at->text, lexer->position, position))
			return fault(lexer->at, lexer_column(lexer), "a blank inside a number");
		lexer->position = position;
		return !expr->rules->exponents || read_exponent(expr, value);
	case NUMBER_TOO_LONG:
		return fault(lexer->at, lexer_column(lexer), "a number of more than %d digits", NUMBER_LENGTH_MAX);
	case NUMBER_MISSING:
		break;
	}
	return fault(lexer->at, lexer_next_column(lexer), "a value is needed here");
}

static bool read_function(struct expr *expr, struct expr_operand *value)
{
	int column = lexer_column(expr->lexer);
	const struct function_name *function =
	    function_read(expr->lexer, expr->rules->functions, expr->rules->function_count);

	if (!function && expr->rules->abbreviations)
		function = function_read_short(expr->lexer, expr->rules->functions, expr->rules->function_count,
					       expr->rules->open);
	if (!function)
		return fault(expr->lexer->at, column, "a value is needed here");
	return expr->rules->function(expr, column, function, value);
}

/* Reads a value without a sign. */
static bool read_unsigned(struct expr *expr, struct expr_operand *value)
{
	const struct expr_rules *rules = expr->rules;
	char byte = lexer_peek(expr->lexer);
	int column = lexer_column(expr->lexer);

	*value = (struct expr_operand){0};
	if (ascii_is_digit(byte) || byte == '.' || (byte == ',' && rules->decimal_comma))
		return expr_number(expr, &value->number);
	if (starts_variable(rules, byte))
		return rules->variable(expr, value);
	if (byte != rules->open)
		return read_function(expr, value);
	if (!expr_bracket(expr, "this", value))
		return false;
	if (rules->has_vacant && isnan(value->number))
		return fault(expr->lexer->at, column,
			     "brackets around a variable without a value; remove the brackets");
	return true;
}

/* Reads the signs; *negative is their product. */
static bool read_signs(struct expr *expr, bool *negative, bool *any)
{
	char byte;

	*negative = *any = false;
	for (; is_sign(byte = lexer_peek(expr->lexer)); *any = true) {
		if (*any && !expr->rules->signs_repeat)
			return fault(expr->lexer->at, lexer_column(expr->lexer), "two signs in a row");
		*negative = *negative != (byte == '-');
		lexer_take(expr->lexer);
	}
	return true;
}

bool expr_value(struct expr *expr, struct expr_operand *value)
{
	int start = lexer_next_column(expr->lexer), column;
	bool negative, any;

	if (!read_signs(expr, &negative, &any))
		return false;
	column = lexer_column(expr->lexer);
	if (!read_unsigned(expr, value))
		return false;
	if (isnan(value->number) && expr->rules->has_vacant) {
		/* If #1 is vacant, X#1 is ignored; manuals do not say whether X-#1 is ignored or is X0. */
		return !any || fault(expr->lexer->at, start,
				     "a sign before a variable without a value: controls differ in whether the result "
				     "is 0 or has no value");
	}
	if (!isfinite(value->number))
		return fault(expr->lexer->at, column, "the result is %s",
			     isnan(value->number) ? "not a number" : "infinite");
	if (negative)
		value->number = -value->number;
	return true;
}

bool expr_follows(struct lexer *lexer, const struct expr_rules *rules)
{
	size_t position = lexer->position;
	bool sign = false, follows;
	char byte;

	for (; is_sign(byte = lexer_peek(lexer)); sign = true)
		lexer_take(lexer);
	follows = byte == rules->open || starts_variable(rules, byte) ||
		  (sign && rules->signs_repeat && (ascii_is_digit(byte) || byte == '.')) ||
		  function_read(lexer, rules->functions, rules->function_count);
	lexer->position = position;
	return follows;
}
