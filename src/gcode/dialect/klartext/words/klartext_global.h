/* klartext_global.h - GLOBAL DEF: values of parameters that cycles take over by PREDEF. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_WORDS_KLARTEXT_GLOBAL_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_WORDS_KLARTEXT_GLOBAL_H

#include <stdbool.h>

#include "gcode/dialect/klartext/state/klartext_state.h"
#include "gcode/text/lexer.h"

/* Is there a GLOBAL DEF with this number? False: reported. */
bool klartext_global_check(struct lexer *lexer, int number, int column);

/* Takes over the parameters of a definition that has been read. False: reported. */
bool klartext_global_take(struct interp *interp, const struct klartext_cycle *definition);

/* The value of a parameter that `text` stands for behind '=', PREDEF. False: it stands for none, which was reported. */
bool klartext_global_value(struct lexer *lexer, int column, int number, const char *text, double *value);

/* Has GLOBAL DEF given this value to the parameter? */
bool klartext_global_is(const struct klartext *klartext, int number, double value);

#endif
