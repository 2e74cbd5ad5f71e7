/*
 * test_gcode_eval.c - the expression evaluator and the lexer with rules of no real control: parentheses, words as
 * operators, a variable of two letters. A new dialect needs only data.
 */
#include "gcode_case.h"

#include "gcode/eval/expr.h"

static const struct expr_operator operators[] = {
	{"div", EXPR_DIVIDE, 3, false}, {"*", EXPR_TIMES, 3, false}, {"+", EXPR_PLUS, 2, false},
	{"-", EXPR_MINUS, 2, false},	{"^", EXPR_POWER, 4, false}, {"max", EXPR_OR, 1, true},
};

static const struct function_name functions[] = {
	{"sqrt", "SQRT", FUNCTION_SQRT, false},
	{"sin", "SIN", FUNCTION_SIN, false},
	{"pot", "POT", FUNCTION_FIX, false},	/* the square */
};

static bool apply(struct expr *expr, int column, const struct expr_operator *operator, struct expr_operand *left,
		  struct expr_operand *right)
{
	double a = left->number, b = right->number;

	if (operator->operation == EXPR_DIVIDE && b == 0)
		return fault(expr->lexer->at, column, "division by zero");
	left->number = operator->operation == EXPR_DIVIDE  ? a / b
		       : operator->operation == EXPR_TIMES ? a * b
		       : operator->operation == EXPR_PLUS  ? a + b
		       : operator->operation == EXPR_MINUS ? a - b
		       : operator->operation == EXPR_POWER ? pow(a, b)
							   : fmax(a, b);
	return true;
}

static bool function(struct expr *expr, int column, const struct function_name *name, struct expr_operand *value)
{
	if (!expr_bracket(expr, name->upper, value))
		return false;
	if (name->function != FUNCTION_FIX)
		return function_compute(expr->lexer->at, column, name, &value->number);
	value->number *= value->number;
	return true;
}

/* Q1 holds 1, and so on. */
static bool variable(struct expr *expr, struct expr_operand *value)
{
	lexer_take(expr->lexer);
	return expr_number(expr, &value->number);
}

static const struct expr_rules rules = {
	.open = '(', .close = ')', .variable_starts = "Q",
	.operators = operators, .operator_count = COUNT(operators),
	.unordered = "MAX needs brackets",
	.functions = functions, .function_count = COUNT(functions),
	.depth_max = 3, .nested = "brackets",
	.apply = apply, .function = function, .variable = variable,
};

static bool evaluate(struct gcode_case *c, const char *text, double *value)
{
	const struct line_place at = {.diag = &c->diag, .file = "p.nc", .line = 1, .text = text};
	struct expr_operand operand;
	struct lexer lexer;
	struct expr expr = {.lexer = &lexer, .rules = &rules};
	bool good;

	case_init(c);
	c->diag.context = c;
	lexer_init(&lexer, &at, &(const struct lexer_rules){0}, NULL);
	good = expr_sum(&expr, &operand);
	*value = good ? operand.number : NAN;
	return good && lexer_peek(&lexer) == '\0';
}

static const struct {
	const char *text;
	double value;
} values[] = {
	{"1+2*3", 7},
	{"(1+2)*3", 9},
	{"8 DIV 2 div 2", 2},
	{"7-2-1", 4},
	{"2*3^2", 18},
	{"2^3^2", 64},	/* from left to right */
	{"-Q3+Q 1 0", 7},
	{"SQRT(POT(5)-9)", 4},
	{"sin(30)*2", 1},
	{"1 MAX 2 MAX 3", 3},
	{"(1 MAX 2)+1", 3},
};

START_TEST(values_by_other_rules)
{
	struct gcode_case c;
	double value;

	ck_assert_msg(evaluate(&c, values[_i].text, &value), "%s: %s", values[_i].text, strbuf_text(&c.messages));
	ck_assert_double_eq_tol(value, values[_i].value, 1e-12);
	case_release(&c);
}
END_TEST

static const struct {
	const char *text;
	int column;
	const char *message;
} faults[] = {
	{"1+", 3, "a value is needed here"},
	{"(1+2", 5, "this expression is not closed: ')' is missing"},
	{"(1 2", 5, "this expression is not closed: ')' is missing"},	/* blanks may stand inside of a number: 12 */
	{"(1 X", 4, "an operator or ')' is missing here"},
	{"SQRT 4", 6, "SQRT needs a value in brackets, (...)"},
	{"[1]", 1, "a value is needed here"},
	{"--1", 2, "two signs in a row"},
	{"1 div 0", 3, "division by zero"},
	{"1 max 2+1", 8, "MAX needs brackets"},
	{"((((1))))", 4, "brackets are nested deeper than 3 levels"},
	{"(10^999)", 1, "the result is infinite"},
	{"-(10^999)", 2, "the result is infinite"},
};

START_TEST(faults_by_other_rules)
{
	char expected[256] = "";
	struct gcode_case c;
	double value;

	evaluate(&c, faults[_i].text, &value);
	snprintf(expected, sizeof(expected), "p.nc:1:%d: error: %s\n    %s\n    %*s\n", faults[_i].column,
		 faults[_i].message, faults[_i].text, faults[_i].column, "^");
	ck_assert_str_eq(strbuf_text(&c.messages), expected);
	case_release(&c);
}
END_TEST

/* A lexer without hooks reads plain numbers only, and evaluates nothing. */
START_TEST(lexer_without_evaluator)
{
	static const struct lexer_refusal refusals[] = {{'$', "no spindle here"}};
	static const struct lexer_rules plain = {.refusals = refusals, .refusal_count = 1};
	struct gcode_case c;
	struct line_place at = {.diag = &c.diag, .file = "p.nc", .line = 1, .text = "G1 (PY, x) X-2.5 Y#1"};
	struct lexer lexer;
	struct word word;

	case_init(&c);
	c.diag.context = &c;
	lexer_init(&lexer, &at, &plain, NULL);
	ck_assert(lexer_next(&lexer, &word) == LEXER_WORD && word.letter == 'G' && !word.point);
	ck_assert(lexer_next(&lexer, &word) == LEXER_WORD && word.letter == 'X' && word.point && word.column == 12);
	ck_assert_double_eq(word.value, -2.5);
	ck_assert_int_eq(lexer_next(&lexer, &word), LEXER_FAULT);
	ck_assert_ptr_nonnull(strstr(strbuf_text(&c.messages), "p.nc:1:18: error: Y without a number\n"));
	at.text = "X1 $2";
	lexer_init(&lexer, &at, &plain, NULL);
	ck_assert_int_eq(lexer_next(&lexer, &word), LEXER_WORD);
	ck_assert_int_eq(lexer_next(&lexer, &word), LEXER_FAULT);
	ck_assert_ptr_nonnull(strstr(strbuf_text(&c.messages), "p.nc:1:4: error: no spindle here\n"));
	case_release(&c);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("gcode_eval");

	tcase_add_loop_test(tcase, values_by_other_rules, 0, COUNT(values));
	tcase_add_loop_test(tcase, faults_by_other_rules, 0, COUNT(faults));
	tcase_add_test(tcase, lexer_without_evaluator);
	return run_suite("gcode_eval", tcase);
}
