/* klartext_flow.h - LBL, CALL LBL, REP, CALL PGM, the jumps of FN 9 to FN 12, and the ends of programs. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_FLOW_KLARTEXT_FLOW_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_FLOW_KLARTEXT_FLOW_H

#include <stdbool.h>

#include "gcode/dialect/klartext/state/klartext_state.h"
#include "gcode/text/lexer.h"

/* Carries out the text after LBL. False: reported. */
bool klartext_flow_label(struct lexer *lexer);

/* The same after CALL: LBL or PGM. */
bool klartext_flow_call(struct lexer *lexer);

/* The same after the colon of FN 9 to FN 12. */
bool klartext_flow_jump(struct lexer *lexer, int number);

/* END PGM: the program ends, or its caller continues. */
bool klartext_flow_end(struct lexer *lexer);

/* Call if the current file has ended without END PGM. */
bool klartext_flow_end_of_file(struct interp *interp);

/* The active calls (struct dialect). */
bool klartext_flow_caller(const struct interp *interp, size_t level, struct srcloc *at, struct strbuf *title);

/* SEL PGM. False: reported. */
bool klartext_flow_select(struct lexer *lexer);

/* Calls another program, as CALL PGM does. False: reported at the column. */
bool klartext_flow_call_program(struct interp *interp, const char *name, int column);

#endif
