/* expr.h - values as LinuxCNC's programs write them: numbers, parameters, functions, expressions in brackets. */
#ifndef FIVECHECK_GCODE_EVAL_EXPR_H
#define FIVECHECK_GCODE_EVAL_EXPR_H

#include <stdbool.h>

#include "gcode/text/lexer.h"

/* Brackets, signs, '#' and functions inside each other. */
#define EXPR_DEPTH_MAX 256

/*
 * All read at the lexer's position and leave it behind what they read. False:
 * reported. LinuxCNC's manual, "Expressions", "Binary Operators", "Functions",
 * "Parameters"; where the manual is silent, what rs274 does.
 */

/* Does a value come next that is no plain number? Nothing is taken. */
bool expr_follows(struct lexer *lexer);

/* A value: -1.5, [1+2], #3, #<name>, SIN[30], -#3 */
bool expr_value(struct lexer *lexer, double *value);

/* A value in brackets; `what` says in the message what lacks them. */
bool expr_bracket(struct lexer *lexer, const char *what, double *value);

/* A value within 0.0001 of a whole number. */
bool expr_integer(struct lexer *lexer, int *value);

/* "<name>", lower case and without blanks, into a buffer of PARAM_NAME_MAX + 1 bytes. */
bool expr_name(struct lexer *lexer, char *name);

/* "#3=6": remembered until the block has been read. */
bool expr_assignment(struct lexer *lexer);

#endif
