/*
 * expr.h - reads and computes expressions. There is one climber for all dialects: a dialect's operators and functions
 * are tables, and its variables are a hook.
 */
#ifndef FIVECHECK_GCODE_EVAL_EXPR_H
#define FIVECHECK_GCODE_EVAL_EXPR_H

#include <stdbool.h>
#include <stddef.h>

#include "gcode/eval/function.h"
#include "gcode/text/lexer.h"

struct expr;

/* A value. A variable can be vacant: it exists, and has no value. */
struct expr_operand {
	double number;	/* NAN: vacant */
	bool truth;	/* the result of a comparison, which is 1 or 0 */
};

enum expr_operation {
	EXPR_EQ, EXPR_NE, EXPR_GT, EXPR_GE, EXPR_LT, EXPR_LE, EXPR_PLUS, EXPR_MINUS, EXPR_TIMES, EXPR_DIVIDE,
	EXPR_MODULO, EXPR_POWER, EXPR_AND, EXPR_OR, EXPR_XOR, EXPR_INTEGER_DIVIDE, EXPR_BIT_AND, EXPR_BIT_OR,
	EXPR_BIT_XOR
};

struct expr_operator {
	const char *name;	/* as lexer_keyword takes it */
	enum expr_operation operation;
	int rank;	/* from 1; of two operators the one with the greater rank is computed first */
	bool unordered;	/* the manual gives no rank among other operators: brackets are needed */
};

/* What a dialect makes of expressions. Constant data. False from a hook: the fault was reported. */
struct expr_rules {
	char open, close;	/* brackets */
	const char *variable_starts;	/* bytes that start a variable */
	/*
	 * A name of an operator is a word without blanks in it, which no letter, digit or '_' follows; no blanks in
	 * numbers.
	 */
	bool whole_words;
	const struct expr_operator *operators;	/* a name comes after every name that starts with it */
	size_t operator_count;
	const char *unordered;	/* the message where operators without a rank are mixed with others */
	const struct function_name *functions;
	size_t function_count;
	bool abbreviations;	/* the first two letters of a function's name will do */
	bool decimal_comma;	/* numbers may have one in place of the point, and have no blanks inside */
	bool exponents;	/* 1.5EX-3 is a number */
	bool signs_repeat;	/* --1 is a value; else it is a fault */
	bool has_vacant;	/* variables can be vacant; else a value that is no number is a fault */
	int depth_max;
	const char *nested;	/* what must not be nested deeper, for the message */

	/* Computes left = left operation right. */
	bool (*apply)(struct expr *expr, int column, const struct expr_operator *operator, struct expr_operand *left,
		      struct expr_operand *right);
	/* Reads the arguments behind the function's name and computes it. */
	bool (*function)(struct expr *expr, int column, const struct function_name *function,
			 struct expr_operand *value);
	/* Reads a variable; its first byte comes next. */
	bool (*variable)(struct expr *expr, struct expr_operand *value);
};

/* One expression that is being read. Borrows everything. */
struct expr {
	struct lexer *lexer;
	const struct expr_rules *rules;
	void *context;	/* of the hooks */
	int depth;
};

/*
 * All functions read at the lexer's position and leave it behind what they have
 * read. False: the fault was reported.
 */

/* Is the next value one that is no plain number? Nothing is taken. */
bool expr_follows(struct lexer *lexer, const struct expr_rules *rules);

/* One value: -1.5, [1+2], #3, SIN[30], -#3 */
bool expr_value(struct expr *expr, struct expr_operand *value);

/* Values with operators between them: 1+2*#3 */
bool expr_sum(struct expr *expr, struct expr_operand *value);

/* The same in brackets; `what` says in the message what lacks them. */
bool expr_bracket(struct expr *expr, const char *what, struct expr_operand *value);

/* The brackets alone, for functions of two arguments. */
bool expr_open(struct expr *expr, const char *what);
bool expr_close(struct expr *expr);

/* Counts one level of nesting; `expr->depth--` ends it. False: there are too many. */
bool expr_enter(struct expr *expr);

/* A plain number. */
bool expr_number(struct expr *expr, double *value);

/* Column of the next byte that is no blank. */
int expr_column(struct lexer *lexer);

#endif
