#include "gcode/dialect/fanuc/macro_b_expr.h"

#include <math.h>
#include <string.h>

#include "base/ascii.h"
#include "base/math/math_functions.h"
#include "gcode/dialect/fanuc/macro_b_operators.h"
#include "gcode/dialect/fanuc/macro_b_state.h"
#include "gcode/dialect/fanuc/macro_b_vars.h"
#include "gcode/state.h"
#include "gcode/text/number.h"

/* The context of an expression. */
struct macro_reader {
	struct interp *interp;
	const struct macro_b_rules *rules;
	bool argument;	/* of a macro call */
	double steps;	/* ROUND rounds to this number of steps per unit */
};

/* The expression at the lexer's position. */
static struct expr begin(struct macro_reader *reader, struct lexer *lexer)
{
	*reader = (struct macro_reader){
	    .interp = lexer->context, .rules = macro_b_of(lexer->context)->rules, .steps = 1};
	return (struct expr){.lexer = lexer, .rules = reader->rules->expr, .context = reader};
}

/* -------------------------------------------------------------- variables */

static bool read_variable_number(struct expr *expr, int *number)
{
	struct lexer *lexer = expr->lexer;
	int column = lexer_next_column(lexer);
	struct expr_operand operand;
	size_t position;
	bool point;

	lexer_take(lexer);
	switch (lexer_peek(lexer)) {
	case '[':
		if (!expr_bracket(expr, "#", &operand))
			return false;
		break;
	case '#':
		return fault(lexer->at, column, "## is not allowed; write #[#...]");
	case '<':
		return fault(lexer->at, column, "named variables are not supported");
	default:
		position = lexer->position;
		if (!ascii_is_digit(lexer_peek(lexer)) ||
		    number_read(lexer->at->text, &position, &operand.number, &point) != NUMBER_OK || point)
			return fault(lexer->at, column,
				     "# needs a variable number or an expression in brackets");
		lexer->position = position;
		break;
	}
	if (isnan(operand.number) || operand.number < 0 || !macro_b_operators_is_whole(operand.number))
		return fault(lexer->at, column, "the number of a variable must be a whole number that is not negative");
	*number = (int)operand.number;
	return true;
}

bool macro_b_expr_variable(struct expr *expr, struct expr_operand *value)
{
	const struct macro_reader *reader = expr->context;
	int column = lexer_column(expr->lexer), number;

	return read_variable_number(expr, &number) &&
	       macro_b_vars_read(reader->interp, number, column, &value->number);
}

/* -------------------------------------------------- operators and functions */

bool macro_b_expr_apply(struct expr *expr, int column, const struct expr_operator *operator, struct expr_operand *left,
			struct expr_operand *right)
{
	const struct macro_reader *reader = expr->context;

	return macro_b_operators_apply(reader->rules, expr->lexer->at, column, operator->operation, left, right);
}

/* FIX towards zero, FUP away from it (B-63944EN, rounding up and down to an integer; Haas, FIX: truncates). */
static bool compute_fix(const struct line_place *at, int column, const struct function_name *function, double *value)
{
	double nearest = round(*value);

	if (macro_b_operators_nearly_equal(*value, nearest))
		return fault(at, column,
			     "%s of a number that differs from %.15g by only %.2g, which is less than the precision of "
			     "a control",
			     function->upper, nearest, fabs(*value - nearest));
	if (function->function == FUNCTION_FIX)
		*value = trunc(*value);
	else
		*value = *value < 0 ? floor(*value) : ceil(*value);
	return true;
}

/* Rounds to a whole number, or after an address to its increment (B-63944EN, ROUND function; Haas, ROUND). */
static bool compute_round(struct expr *expr, int column, double *value)
{
	const struct macro_reader *reader = expr->context;
	double scaled;

	if (reader->argument)
		return fault(expr->lexer->at, column,
			     "ROUND in an argument: controls round to different digits; assign the value to a variable "
			     "first");
	scaled = *value * reader->steps;
	if (scaled < 0 && !(fabs(scaled - trunc(scaled)) < 0.5) && !(fabs(scaled - trunc(scaled)) > 0.5))
		return fault(expr->lexer->at, column,
			     "ROUND of %.15g: controls round halves of negative numbers differently",
			     *value);
	*value = round(scaled) / reader->steps;
	return true;
}

/*
 * B-63944EN, ASIN and ATAN: with parameter NAT (No. 6004#0) = 0, the default, angles are from 0 to 360, and those of
 * ASIN from 270 to 90; with NAT = 1 they are from -180 to 180, and from -90 to 90.
 */
static void wrap_angle(struct expr *expr, int column, double *value)
{
	const struct macro_reader *reader = expr->context;
	struct macro_b *macro = macro_b_of(reader->interp);

	if (!reader->rules->angle_by_nat || !(*value < 0))
		return;
	if (!macro->cautioned_angle)
		caution(expr->lexer->at, column,
			"the control returns %.9g degrees, or %.9g if parameter 6004#0 (NAT) is 1; NAT is assumed to "
			"be 0, here and further on",
			*value + 360, *value);
	macro->cautioned_angle = true;
	*value += 360;
}

/* Reads "/[b]" after ATAN[...], if it is there; then *given is set. */
static bool read_divisor(struct expr *expr, struct expr_operand *second, bool *given)
{
	const struct macro_reader *reader = expr->context;
	struct lexer *lexer = expr->lexer;
	int column;

	if (lexer_peek(lexer) != '/')
		return true;
	column = lexer_column(lexer);
	lexer_take(lexer);
	if (lexer_peek(lexer) != '[')
		return fault(lexer->at, column,
			     "ATAN[...]/ needs a value in brackets; for a division write [ATAN[...]]/");
	if (!reader->rules->atan_pairs)
		return fault(lexer->at, column,
			     "ATAN[...]/[...]: in %s's manual ATAN has one value; for a division write [ATAN[...]]/",
			     reader->rules->control);
	*given = true;
	return expr_bracket(expr, "ATAN[...]/", second);
}

/* ATAN[a]/[b] and ATAN[a,b]; ATAN[a] is the same as with b = 1. */
static bool read_arc_tangent(struct expr *expr, int column, struct expr_operand *value)
{
	const struct macro_reader *reader = expr->context;
	const struct line_place *at = expr->lexer->at;
	struct expr_operand second = {1, false};
	bool pair;

	if (!expr_open(expr, "ATAN") || !expr_sum(expr, value))
		return false;
	pair = lexer_peek(expr->lexer) == ',' && reader->rules->atan_pairs;
	if (pair) {
		lexer_take(expr->lexer);
		if (!expr_sum(expr, &second))
			return false;
	}
	if (!expr_close(expr) || (!pair && !read_divisor(expr, &second, &pair)))
		return false;
	if (!macro_b_operators_fill(reader->rules, at, column, value) ||
	    !macro_b_operators_fill(reader->rules, at, column, &second))
		return false;
	*value = (struct expr_operand){function_arc_tangent(value->number, second.number), false};
	if (pair)
		wrap_angle(expr, column, &value->number);
	return true;
}

/* POW[a,b], a to the power of b (B-64484EN, arithmetic and logic operation). */
static bool read_power(struct expr *expr, int column, struct expr_operand *value)
{
	const struct macro_b_rules *rules = ((const struct macro_reader *)expr->context)->rules;
	const struct line_place *at = expr->lexer->at;
	struct expr_operand exponent;

	if (!expr_open(expr, "POW") || !expr_sum(expr, value))
		return false;
	if (lexer_peek(expr->lexer) != ',')
		return fault(at, lexer_column(expr->lexer), "POW needs two values, POW[a,b]");
	lexer_take(expr->lexer);
	if (!expr_sum(expr, &exponent) || !expr_close(expr) || !macro_b_operators_fill(rules, at, column, value) ||
	    !macro_b_operators_fill(rules, at, column, &exponent))
		return false;
	if (value->truth || exponent.truth)
		return fault(at, column, "a comparison cannot be used as a number here");
	if (value->number < 0 || (fpclassify(value->number) == FP_ZERO && !(exponent.number > 0)))
		return fault(at, column, "POW of %.15g and %.15g may be undefined: the base must be greater than 0",
			     value->number, exponent.number);
	value->number = math_pow(value->number, exponent.number);
	return isfinite(value->number) || fault(at, column, "the result is infinite");
}

bool macro_b_expr_function(struct expr *expr, int column, const struct function_name *function,
			   struct expr_operand *value)
{
	const struct macro_b_rules *rules = ((const struct macro_reader *)expr->context)->rules;
	const struct line_place *at = expr->lexer->at;

	if (function->refused)
		return fault(at, column, "%s has no function %s", rules->control, function->upper);
	if (function->function == FUNCTION_ATAN)
		return read_arc_tangent(expr, column, value);
	if (function->function == FUNCTION_POWER)
		return read_power(expr, column, value);
	if (!expr_bracket(expr, function->upper, value) || !macro_b_operators_fill(rules, at, column, value))
		return false;
	if (!rules->truth_is_number && value->truth)
		return fault(at, column, "a comparison cannot be used as a number here");
	value->truth = false;
	if (function->function == FUNCTION_FIX || function->function == FUNCTION_FUP)
		return compute_fix(at, column, function, &value->number);
	if (function->function == FUNCTION_ROUND)
		return compute_round(expr, column, &value->number);
	if (!function_compute(at, column, function, &value->number))
		return false;
	if (function->function == FUNCTION_ASIN)
		wrap_angle(expr, column, &value->number);
	return true;
}

/* ------------------------------------------------------------------- words */

/*
 * Steps per unit of the address's least increment: without an entry in the machine file those of IS-B, 0.001 mm and
 * degrees or 0.0001 inch (B-63944EN, variable reference; Haas, address substitution). 0: not rounded.
 */
static double steps_of(const struct interp *interp, char letter)
{
	double increment = interp->config->controller.least_input;
	double steps = increment > 0 && increment < 1 ? round(1 / increment) : 1000;

	if (letter >= 'A' && letter <= 'C')
		return steps;
	if (strchr("XYZUVWIJKQR", letter))
		return interp->state.scale > 1 ? steps * 10 : steps;
	return 0;
}

static bool fault_truth(const struct lexer *lexer, int column)
{
	return fault(lexer->at, column, "a comparison cannot be used as a number here");
}

/* Reads the value after the address word->letter: #1, -#1, [#1+2]. */
static enum lexer_result read_word(struct lexer *lexer, struct word *word, bool argument)
{
	struct macro_reader reader;
	struct expr expr = begin(&reader, lexer);
	double steps = argument ? 0 : steps_of(reader.interp, word->letter);
	int column = lexer_next_column(lexer);
	struct expr_operand value;
	char byte = lexer_peek(lexer);

	if (!expr_follows(lexer, expr.rules))
		return LEXER_END;
	reader.argument = argument;
	reader.steps = steps > 0 ? steps : 1;
	if (byte != '#' && byte != '[' && byte != '-' && byte != '+') {
		fault_report(lexer->at, column, "a function after an address needs brackets: %c[...]", word->letter);
		return LEXER_FAULT;
	}
	if (!expr_value(&expr, &value))
		return LEXER_FAULT;
	if (value.truth && !reader.rules->truth_is_number)
		return fault_truth(lexer, column) ? LEXER_WORD : LEXER_FAULT;
	word->point = true;
	word->vacant = isnan(value.number);
	word->value = word->vacant ? 0 : steps > 0 ? round(value.number * steps) / steps : value.number;
	return LEXER_WORD;
}

static enum lexer_result read_block_word(struct lexer *lexer, struct word *word)
{
	return read_word(lexer, word, false);
}

static enum lexer_result read_argument(struct lexer *lexer, struct word *word)
{
	return read_word(lexer, word, true);
}

static const struct lexer_refusal refusals[] = {
	{'#', "an assignment needs a block of its own"},
	{'[', "an expression is allowed only after a letter or after '='"},
};

#define REFUSALS .refusals = refusals, .refusal_count = sizeof(refusals) / sizeof(*refusals)

#define WORD_RULES(does) \
	{.semicolon = (does), .comments_nest = true, .comma_words = true, .value = read_block_word, REFUSALS}
#define ARGUMENT_RULES(does) {.semicolon = (does), .comments_nest = true, .value = read_argument, REFUSALS}

static bool has_comments(const struct interp *interp)
{
	return interp->config->controller.semicolon == SEMICOLON_STARTS_COMMENT;
}

const struct lexer_rules *macro_b_word_rules(const struct interp *interp)
{
	static const struct lexer_rules ends = WORD_RULES(SEMICOLON_ENDS_BLOCK);
	static const struct lexer_rules comments = WORD_RULES(SEMICOLON_STARTS_COMMENT);

	return has_comments(interp) ? &comments : &ends;
}

const struct lexer_rules *macro_b_argument_rules(const struct interp *interp)
{
	static const struct lexer_rules ends = ARGUMENT_RULES(SEMICOLON_ENDS_BLOCK);
	static const struct lexer_rules comments = ARGUMENT_RULES(SEMICOLON_STARTS_COMMENT);

	return has_comments(interp) ? &comments : &ends;
}

/* -------------------------------------------------------------- statements */

bool macro_b_expr_variable_number(struct lexer *lexer, int *number)
{
	struct macro_reader reader;
	struct expr expr = begin(&reader, lexer);

	return read_variable_number(&expr, number);
}

bool macro_b_expr_sum(struct lexer *lexer, double *value)
{
	struct macro_reader reader;
	struct expr expr = begin(&reader, lexer);
	int column = lexer_next_column(lexer);
	struct expr_operand operand;

	if (!expr_sum(&expr, &operand))
		return false;
	if (operand.truth && !reader.rules->truth_is_number)
		return fault_truth(lexer, column);
	*value = operand.number;
	return true;
}

bool macro_b_expr_condition(struct lexer *lexer, const char *what, bool *is_true)
{
	struct macro_reader reader;
	struct expr expr = begin(&reader, lexer);
	int column = lexer_next_column(lexer);
	struct expr_operand operand;

	if (!expr_bracket(&expr, what, &operand))
		return false;
	if (!reader.rules->truth_is_number && !operand.truth)
		return fault(lexer->at, column, "%s needs a comparison (EQ, NE, GT, GE, LT or LE)", what);
	if (!macro_b_operators_fill(reader.rules, lexer->at, column, &operand))
		return false;
	*is_true = fpclassify(operand.number) != FP_ZERO;
	return true;
}

bool macro_b_expr_integer(struct lexer *lexer, const char *what, int *value)
{
	struct macro_reader reader;
	struct expr expr = begin(&reader, lexer);
	int column = lexer_next_column(lexer);
	struct expr_operand operand;

	if (!expr_value(&expr, &operand))
		return false;
	if (isnan(operand.number) || operand.number < 0 || !macro_b_operators_is_whole(operand.number))
		return fault(lexer->at, column, "%s must be a whole number that is not negative", what);
	*value = (int)operand.number;
	return true;
}
