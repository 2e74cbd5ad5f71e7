/*
 * expr.h - reads and computes expressions by precedence climbing, for all dialects: a dialect's operators and functions
 * are tables, and its variables are a hook.
 */
#ifndef FIVECHECK_GCODE_EVAL_EXPR_H
#define FIVECHECK_GCODE_EVAL_EXPR_H

#include <stdbool.h>
#include <stddef.h>

#include "gcode/eval/function.h"
#include "gcode/text/lexer.h"

struct expr;

/* A value. A variable can be vacant: it exists but has no value. */
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
	const char *name;	/* for lexer_keyword */
	enum expr_operation operation;
	int rank;	/* precedence, from 1; the operator of the greater rank is computed first */
	bool unordered;	/* the manual gives no precedence: among other operators, brackets are needed */
};

/* The expressions of a dialect. Constant data. A hook reports a fault before it returns false. */
struct expr_rules {
	char open, close;	/* brackets */
	const char *variable_starts;	/* the bytes that can start a variable */
	/*
	 * The name of an operator has no blanks inside, and no letter, digit or '_' follows it; numbers have no blanks
	 * inside.
	 */
	bool whole_words;
	const struct expr_operator *operators;	/* a name follows all names that start with it */
	size_t operator_count;
	const char *unordered;	/* the message if an operator without a precedence is mixed with others */
	const struct function_name *functions;
	size_t function_count;
	bool abbreviations;	/* the first two letters of a function's name are enough */
	bool decimal_comma;	/* numbers may have a decimal comma, and have no blanks inside */
	bool exponents;	/* 1.5EX-3 is a number */
	bool signs_repeat;	/* --1 is a value; else it is a fault */
	bool has_vacant;	/* variables can be vacant; else a value that is no number is a fault */
	int depth_max;
	const char *nested;	/* the name of what is nested too deeply, for the message */

	/* Computes left = left operation right. */
	bool (*apply)(struct expr *expr, int column, const struct expr_operator *operator, struct expr_operand *left,
		      struct expr_operand *right);
	/* Reads the arguments after the function's name and computes the function. */
	bool (*function)(struct expr *expr, int column, const struct function_name *function,
			 struct expr_operand *value);
	/* Reads a variable; the lexer is at its first byte. */
	bool (*variable)(struct expr *expr, struct expr_operand *value);
};

/* The expression that is being read. Borrows everything. */
struct expr {
	struct lexer *lexer;
	const struct expr_rules *rules;
	void *context;	/* of the hooks */
	int depth;
};

/*
 * All functions read at the lexer's position and move it past the text that they have read. False: the fault was
 * reported.
 */

/* Is the next value other than a plain number? Nothing is consumed. */
bool expr_follows(struct lexer *lexer, const struct expr_rules *rules);

/* One value: -1.5, [1+2], #3, SIN[30], -#3 */
bool expr_value(struct expr *expr, struct expr_operand *value);

/* Values with operators between them: 1+2*#3 */
bool expr_sum(struct expr *expr, struct expr_operand *value);

/* The same with operators of at least this rank only; an operator of a lower rank is left to the caller. */
bool expr_part(struct expr *expr, int rank, struct expr_operand *value);

/* The same in brackets; `what` names in the message the thing that lacks them. */
bool expr_bracket(struct expr *expr, const char *what, struct expr_operand *value);

/* Only the opening or the closing bracket, for functions of two arguments. */
bool expr_open(struct expr *expr, const char *what);
bool expr_close(struct expr *expr);

/* Enters a level of nesting; `expr->depth--` leaves it. False: there are too many. */
bool expr_enter(struct expr *expr);

/* A plain number. */
bool expr_number(struct expr *expr, double *value);

#endif
