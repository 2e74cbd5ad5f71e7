/* linuxcnc_expr.h - values in LinuxCNC's programs: numbers, parameters, functions, expressions in brackets. */
#ifndef FIVECHECK_GCODE_DIALECT_LINUXCNC_LINUXCNC_EXPR_H
#define FIVECHECK_GCODE_DIALECT_LINUXCNC_LINUXCNC_EXPR_H

#include <stdbool.h>

#include "gcode/text/lexer.h"

/*
 * LinuxCNC's manual, "Expressions", "Binary Operators", "Functions", "Parameters"; what the manual does not define is
 * as in rs274. All functions read at the lexer's position and move it past the text that they have read. False: the
 * fault was reported. The context of the lexer is the struct interp.
 */

/* The rules for blocks and for control flow. */
extern const struct lexer_rules linuxcnc_lexer_rules;

/* Reads a value in brackets; `what` names in the message the thing that lacks them. */
bool linuxcnc_expr_bracket(struct lexer *lexer, const char *what, double *value);

/* Reads a value within 0.0001 of a whole number. */
bool linuxcnc_expr_integer(struct lexer *lexer, int *value);

/*
 * False, reported at the column: the value is 0 except for LinuxCNC's rounding of pi in a sine, cosine or tangent.
 * Neither its sign nor whether it is 0 is known, and nothing may depend on these.
 */
bool linuxcnc_expr_sign_is_sure(const struct line_place *at, int column, double value);

/* Reads "<name>", in lower case and without blanks, into a buffer of PARAM_NAME_MAX + 1 bytes. */
bool linuxcnc_expr_name(struct lexer *lexer, char *name);

#endif
