/* sinumerik_text.h - text in expressions: strings, variables, <<, and the functions of text. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_VALUES_SINUMERIK_TEXT_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_VALUES_SINUMERIK_TEXT_H

#include "gcode/dialect/sinumerik/state/sinumerik_state.h"
#include "gcode/eval/expr.h"

/* `expr` reads the numbers in the text; its context is the interpreter. False: reported. */

/* Does text come next: a string, a variable of it, or a function that makes it? Nothing is taken. */
bool sinumerik_text_follows(struct interp *interp, struct lexer *lexer);

/* Pieces with << between them; numbers may stand among them. */
bool sinumerik_text_read(struct expr *expr, struct sinumerik_text *text);

/* Two texts and a comparison between them, which gives 1 or 0. */
bool sinumerik_text_compare(struct expr *expr, struct expr_operand *value);

/* Is this upper-case name a function that makes a number of text: STRLEN, INDEX, NUMBER ...? */
bool sinumerik_text_measures(const char *name);

/* Reads the arguments of one behind its name and computes it. */
bool sinumerik_text_measure(struct expr *expr, const char *name, double *value);

#endif
