/*
 * test_gcode_macro_values.c - expressions and conditions in macros of Fanuc and Haas.
 *
 * FM is the Fanuc Series 30i/31i/32i operator's manual (B-63944EN), custom macros; HM the Haas mill
 * operator's manual, chapter "Macros". Expected values are worked out by hand from the manuals' rules.
 */
#include "gcode_case.h"

#include "random.h"

enum { F = 1, H = 2, BOTH = F | H };

/* The value of an expression is where X goes. */
static const struct {
	int dialects;
	const char *expression;
	double value;
} values[] = {
	/* FM arithmetic and logic operation, priority of operations; HM "Arithmetic Operators" */
	{BOTH, "1+2*3", 7},
	{BOTH, "[1+2]*3", 9},
	{BOTH, "7-2-1", 4},
	{BOTH, "8/4/2", 1},
	{BOTH, "2*-3", -6},
	{BOTH, "-[1+2]", -3},
	{BOTH, "-.5+1", 0.5},
	{BOTH, "27 MOD 20", 7},
	{F, "-7 MOD 3", -1},
	{F, "1 + 2 AND 3", 3},	/* AND before + */
	{F, "1 OR 2 * 4", 9},	/* * before OR */
	{F, "4 - 1 XOR 1", 2},	/* - and XOR from left to right */
	{BOTH, "5 AND 3", 1},
	{BOTH, "1 OR 2", 3},
	{BOTH, "6 XOR 3", 5},
	{H, "5.7 AND 3.2", 1},	/* HM "Logical Operators": the integer portion */
	/* functions; angles in degrees */
	{BOTH, "SIN[30]*2", 1},
	{BOTH, "cos [ 60 ]", 0.5},
	{BOTH, "TAN[45]", 1},
	{BOTH, "ASIN[.5]", 30},
	{BOTH, "ACOS[-.5]", 120},
	{BOTH, "ATAN[1]", 45},
	{F, "ATAN[1]/[-1]", 135},
	{F, "ATAN[1,-1]", 135},
	{F, "[ATAN[1]]/3", 15},
	{BOTH, "SQRT[2+7]", 3},
	{BOTH, "ABS[-2.5]", 2.5},
	{F, "LN[EXP[2]]", 2},
	{F, "POW[2,3]+1", 9},
	{F, "POW[16.,.5]*POW[7,0]", 4},
	{F, "POW[1+1,-[1+1]]", 0.25},
	{F, "PO[2,4]", 16},
	/* FM rounding up and down to an integer: the manual's own four values */
	{F, "FUP[1.2]", 2},
	{F, "FIX[1.2]", 1},
	{F, "FUP[-1.2]", -2},
	{F, "FIX[-1.2]", -1},
	{H, "FIX[3.54]", 3},	/* HM "Fix vs. Round" */
	{BOTH, "ROUND[3.54]", 4},
	{BOTH, "ROUND[1.714]", 2},
	{BOTH, "ROUND[-1.4]", -1},
	/* FM abbreviation: two letters */
	{F, "RO[1.6]+FI[1.6]+SI[30]", 3.5},
	/* HM Boolean operators: 1.0 or 0.0 */
	{H, "[2 GT 1] + [1 EQ 1]", 2},
	{H, "[1 GT 2]", 0},
};

static void expect_value(const struct dialect *dialect, const char *expression, double value)
{
	char program[256], moves[128];
	struct gcode_case c;

	case_init(&c);
	c.config.dialect = dialect;
	snprintf(program, sizeof(program), "#1=%s\nG0 X#1\nM30\n", expression);
	snprintf(moves, sizeof(moves), "rapid %.9g 0 0 0 0\n", value);
	ck_assert_msg(case_run(&c, program), "%s: %s", expression, strbuf_text(&c.messages));
	ck_assert_msg(!strcmp(strbuf_text(&c.moves), moves) && !c.messages.length, "%s: %s%s", expression,
		      strbuf_text(&c.moves), strbuf_text(&c.messages));
	case_release(&c);
}

START_TEST(expressions)
{
	for (size_t i = 0; i < COUNT(values); i++) {
		if (values[i].dialects & F)
			expect_value(&dialect_fanuc, values[i].expression, values[i].value);
		if (values[i].dialects & H)
			expect_value(&dialect_haas, values[i].expression, values[i].value);
	}
}
END_TEST

/* Conditions; 1 goes to N1. */
static const struct {
	int dialects;
	const char *condition;
	bool holds;
} conditions[] = {
	{BOTH, "1 EQ 1.0", true},
	{BOTH, "1 NE 1", false},
	{BOTH, "2 GT 1", true},
	{BOTH, "1 GE 1", true},
	{BOTH, "1 LT 1", false},
	{BOTH, "1 LE 1", true},
	{BOTH, "1+1 EQ 2", true},
	{BOTH, "[1 EQ 1] AND [2 EQ 3]", false},
	{BOTH, "[1 EQ 1] OR [2 EQ 3]", true},
	/* FM undefined variable, the table of conditions: vacant is 0, but for EQ and NE */
	{BOTH, "#1 EQ #0", true},
	{BOTH, "#1 NE #0", false},
	{BOTH, "#2 EQ #0", false},
	{BOTH, "#2 NE #0", true},
	{F, "#1 EQ 0", false},
	{F, "#1 NE 0", true},
	{F, "#1 GE #0", true},
	{F, "#1 GE 0", true},
	{F, "#1 GT #0", false},
	{F, "#1 GT 0", false},
	{F, "#1 LE #0", true},
	{F, "#1 LT 0", false},
	/* HM "Conditional Expressions": any expression, 0 is false */
	{H, "#2 + 1", true},
	{H, "#2", false},
};

static void expect_condition(const struct dialect *dialect, const char *condition, bool holds)
{
	char program[256];
	struct gcode_case c;

	case_init(&c);
	c.config.dialect = dialect;
	snprintf(program, sizeof(program), "#2=0\nIF [%s] GOTO 1\nG0 X1.\nN1 M30\n", condition);
	ck_assert_msg(case_run(&c, program), "%s: %s", condition, strbuf_text(&c.messages));
	ck_assert_msg(c.count == (holds ? 0 : 1), "%s", condition);
	case_release(&c);
}

START_TEST(comparisons)
{
	for (size_t i = 0; i < COUNT(conditions); i++) {
		if (conditions[i].dialects & F)
			expect_condition(&dialect_fanuc, conditions[i].condition, conditions[i].holds);
		if (conditions[i].dialects & H)
			expect_condition(&dialect_haas, conditions[i].condition, conditions[i].holds);
	}
}
END_TEST

/*
 * A random expression of whole numbers, written with brackets only where the ranks need them; its value, while *valid.
 * The tree is the oracle: it needs no ranks to be evaluated.
 */
static long write_random(struct random *random, int depth, int rank, struct strbuf *out, bool *valid)
{
	static const struct {
		const char *name;
		int rank;
	} operations[] = {{"+", 2}, {"-", 2}, {" OR ", 2}, {" XOR ", 2}, {"*", 3}, {" AND ", 3}, {" MOD ", 3}};
	size_t i = random_bits(random) % COUNT(operations);
	bool brackets = operations[i].rank < rank || random_bits(random) % 8 == 0;
	long left, right;

	if (depth == 0 || random_bits(random) % 4 == 0) {
		left = (long)(random_bits(random) % 10);
		strbuf_addf(out, "%ld", left);
		return left;
	}
	strbuf_addf(out, "%s", brackets ? "[" : "");
	left = write_random(random, depth - 1, operations[i].rank, out, valid);
	strbuf_addf(out, "%s", operations[i].name);
	/* From left to right: what stands on the right binds more tightly. */
	right = write_random(random, depth - 1, operations[i].rank + 1, out, valid);
	strbuf_addf(out, "%s", brackets ? "]" : "");
	if (i >= 2 && i != 4 && (left < 0 || right < 0))
		*valid = false;
	if (i == 6 && right <= 0)
		*valid = false;
	if (!*valid)
		return 0;
	return i == 0	? left + right
	       : i == 1 ? left - right
	       : i == 2 ? (left | right)
	       : i == 3 ? (left ^ right)
	       : i == 4 ? left * right
	       : i == 5 ? (left & right)
			: left % right;
}

START_TEST(random_expressions)
{
	int tried = 0;

	for (long i = 0; i < 20000; i++) {
		struct random random = random_case(31, i);
		struct strbuf expression = {0};
		bool valid = true;
		long value = write_random(&random, 4, 1, &expression, &valid);

		/* The moves are written with nine digits. */
		if (valid && labs(value) < 100000 && expression.length < 200) {
			expect_value(&dialect_fanuc, expression.text, (double)value);
			tried++;
		}
		strbuf_release(&expression);
	}
	ck_assert_int_gt(tried, 2000);
}
END_TEST

int main(void)
{
	const TTest *const tests[] = {expressions, random_expressions, comparisons};

	return RUN_TESTS("gcode_macro_values", tests);
}
