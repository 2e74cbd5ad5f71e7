/* sinumerik_macro.h - DEFINE name AS text: a text that stands for a name in the lines that follow. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_MACRO_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_MACRO_H

#include "gcode/dialect/sinumerik/sinumerik_state.h"

/* The line behind DEFINE. False: reported. */
bool sinumerik_macro_define(struct interp *interp, struct lexer *lexer);

/*
 * Puts the line in hand with every macro's name replaced in place of it, from `rest` on; strings and comments stay as
 * they are, and names in a macro's text, too. The text lives until the next call.
 */
void sinumerik_macro_expand(struct interp *interp, size_t rest);

void sinumerik_macro_release(struct sinumerik *sinumerik);

#endif
