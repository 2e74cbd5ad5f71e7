/* sinumerik_macro.h - DEFINE name AS text: a text that stands for a name in the lines that follow. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_VALUES_SINUMERIK_MACRO_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_VALUES_SINUMERIK_MACRO_H

#include "gcode/dialect/sinumerik/state/sinumerik_state.h"

/* Reads the rest of the line after DEFINE. False: reported. */
bool sinumerik_macro_define(struct interp *interp, struct lexer *lexer);

/*
 * Replaces the names of macros in the current line, from `rest` on. Strings and comments do not change, and names in
 * the text of a macro are not replaced. The new text lives until the next call.
 */
void sinumerik_macro_expand(struct interp *interp, size_t rest);

void sinumerik_macro_release(struct sinumerik *sinumerik);

#endif
