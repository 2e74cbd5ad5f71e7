/* klartext_skip.h - blocks that start with '/', which the control skips while block skip is on. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_TEXT_KLARTEXT_SKIP_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_TEXT_KLARTEXT_SKIP_H

#include <stdbool.h>

#include "gcode/dialect/klartext/state/klartext_state.h"
#include "gcode/text/lexer.h"

/* Reads the number of the block, if there is one. */
bool klartext_skip_number(struct lexer *lexer);

/* Reads the number of the block and a '/' after or before it. True: there is a number; *slash: there is a '/'. */
bool klartext_skip_head(struct lexer *lexer, bool *slash);

/* Is the current line skipped, as a definition with '/' or as a further line of such a definition? */
bool klartext_skip_definition(struct interp *interp);

#endif
