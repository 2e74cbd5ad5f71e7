/* macro_b_operate.h - the operators of Fanuc's and Haas's macros, and what they make of vacant values. */
#ifndef FIVECHECK_GCODE_DIALECT_FANUC_MACRO_B_OPERATORS_H
#define FIVECHECK_GCODE_DIALECT_FANUC_MACRO_B_OPERATORS_H

#include <stdbool.h>

#include "gcode/text/lexer.h"

enum macro_b_operation {
	MACRO_NO_OPERATION, MACRO_EQ, MACRO_NE, MACRO_GT, MACRO_GE, MACRO_LT, MACRO_LE, MACRO_PLUS, MACRO_MINUS,
	MACRO_OR, MACRO_XOR, MACRO_TIMES, MACRO_DIVIDE, MACRO_AND, MACRO_MODULO
};

struct macro_b_operand {
	double number;	/* NAN: vacant */
	bool truth;	/* of a comparison: 1 or 0 */
};

/* 1 to 3, the greater the earlier; 0 of none. */
int macro_b_operation_rank(enum macro_b_operation operation);
bool macro_b_operation_is_logic(enum macro_b_operation operation);

/* *left becomes the result. False: reported at the column. */
bool macro_b_operate(struct lexer *lexer, int column, enum macro_b_operation operation, struct macro_b_operand *left,
		   struct macro_b_operand *right);

/* A vacant value becomes 0 on a Fanuc; on a Haas it is a fault, reported at the column. */
bool macro_b_operand_fill(struct lexer *lexer, int column, struct macro_b_operand *value);

/* Do they differ, but by so little that controls may disagree? */
bool macro_b_nearly_equal(double left, double right);

/* A whole number, below 2^31 in size. */
bool macro_b_is_whole(double value);

#endif
