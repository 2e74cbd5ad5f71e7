/* klartext_define.h - CYCL DEF: the lines of a definition, and the cycles that take effect at their definition. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_CYCLES_KLARTEXT_DEFINE_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_CYCLES_KLARTEXT_DEFINE_H

#include <stdbool.h>

#include "gcode/dialect/klartext/state/klartext_state.h"
#include "gcode/text/lexer.h"

/* After CYCL: reads DEF, or CALL with its words. False: reported. */
bool klartext_define_read(struct lexer *lexer);

/* After TCH PROBE: reads its number, name and parameters. False: reported. */
bool klartext_define_probe(struct lexer *lexer);

/* After GLOBAL: reads DEF, its number, name and parameters. False: reported. */
bool klartext_define_read_global(struct lexer *lexer);

/* Is a definition open that this line continues? `numbered`: the line has a block number. */
bool klartext_define_goes_on(struct lexer *lexer, bool numbered);

/* Reads a further line of the definition. False: reported. */
bool klartext_define_line(struct lexer *lexer);

/* Ends an open definition. False: reported. */
bool klartext_define_end(struct interp *interp);

#endif
