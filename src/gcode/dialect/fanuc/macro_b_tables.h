/* macro_b_tables.h - the operators and functions of all controls with custom macro B. */
#ifndef FIVECHECK_GCODE_DIALECT_FANUC_MACRO_B_TABLES_H
#define FIVECHECK_GCODE_DIALECT_FANUC_MACRO_B_TABLES_H

#include "gcode/eval/expr.h"

/*
 * B-63944EN, priority of operations: functions; * / AND MOD; + - OR XOR; and comparisons last. `unordered`: the
 * control's manual does not define the precedence of AND, OR and XOR.
 */
#define MACRO_B_OPERATORS(unordered) \
	{"eq", EXPR_EQ, 1, false}, \
	{"ne", EXPR_NE, 1, false}, \
	{"gt", EXPR_GT, 1, false}, \
	{"ge", EXPR_GE, 1, false}, \
	{"lt", EXPR_LT, 1, false}, \
	{"le", EXPR_LE, 1, false}, \
	{"+", EXPR_PLUS, 2, false}, \
	{"-", EXPR_MINUS, 2, false}, \
	{"or", EXPR_OR, 2, unordered}, \
	{"xor", EXPR_XOR, 2, unordered}, \
	{"*", EXPR_TIMES, 3, false}, \
	{"/", EXPR_DIVIDE, 3, false}, \
	{"and", EXPR_AND, 3, unordered}, \
	{"mod", EXPR_MODULO, 3, false},

/* `refused`: for functions that are not in every manual. */
#define MACRO_B_FUNCTIONS(refused) \
	{"abs", "ABS", FUNCTION_ABS, false}, \
	{"acos", "ACOS", FUNCTION_ACOS, false}, \
	{"asin", "ASIN", FUNCTION_ASIN, false}, \
	{"atan", "ATAN", FUNCTION_ATAN, false}, \
	{"cos", "COS", FUNCTION_COS, false}, \
	{"exp", "EXP", FUNCTION_EXP, refused}, \
	{"fix", "FIX", FUNCTION_FIX, false}, \
	{"fup", "FUP", FUNCTION_FUP, refused}, \
	{"ln", "LN", FUNCTION_LN, refused}, \
	{"pow", "POW", FUNCTION_POWER, refused}, \
	{"round", "ROUND", FUNCTION_ROUND, false}, \
	{"sin", "SIN", FUNCTION_SIN, false}, \
	{"sqrt", "SQRT", FUNCTION_SQRT, false}, \
	{"tan", "TAN", FUNCTION_TAN, false},

#endif
