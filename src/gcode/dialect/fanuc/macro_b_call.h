/* macro_b_call.h - calls of subprograms and macros: G65, G66, M97, M98, M99. */
#ifndef FIVECHECK_GCODE_DIALECT_FANUC_MACRO_B_CALL_H
#define FIVECHECK_GCODE_DIALECT_FANUC_MACRO_B_CALL_H

#include <stdbool.h>

#include "gcode/dialect/fanuc/macro_b_state.h"
#include "gcode/text/lexer.h"

/*
 * Carries out G65 and G66; the lexer is after the code; `column` is that of the G. *done is false if a block must be
 * carried out for a program of the machine builder (builder_macro.h). False: reported.
 */
bool macro_b_call_g65(struct interp *interp, struct lexer *lexer, int column, bool *done);
/* The same for a G-code that calls a program of the machine builder. */
bool macro_b_call_by_code(struct interp *interp, struct lexer *lexer, int column, const struct builder_macro *macro,
			  bool *done);
bool macro_b_call_g66(struct interp *interp, struct lexer *lexer, int column);

/* The name of a call, "O100" or "N10"; it is written into the buffer, which has MACRO_B_TITLE bytes. */
#define MACRO_B_TITLE 16
const char *macro_b_call_title(const struct macro_b_call *call, char *buffer);

/* Call after a block: carries out its M97, M98 and M99, or the call of G66. False: reported. */
bool macro_b_call_after_block(struct interp *interp);

/* Call at the end of the current file. False: it ends inside of a subprogram, which was reported. */
bool macro_b_call_end_of_file(struct interp *interp);

/* The active calls (struct dialect). */
bool macro_b_call_caller(const struct interp *interp, size_t level, struct srcloc *at, struct strbuf *title);

#endif
