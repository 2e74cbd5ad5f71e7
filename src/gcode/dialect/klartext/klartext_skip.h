/* klartext_skip.h - blocks that begin with '/', which the control leaves out while block skip is on. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_SKIP_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_SKIP_H

#include <stdbool.h>

#include "gcode/dialect/klartext/klartext_state.h"
#include "gcode/text/lexer.h"

/* Takes the number of the block, if there is one. */
bool klartext_skip_number(struct lexer *lexer);

/* Takes the number of the block and the '/' behind or before it. Returns whether there is a number; *slash: a '/'. */
bool klartext_skip_head(struct lexer *lexer, bool *slash);

/* Is the line in hand left out as a definition with '/', or as a further line of one that was left out? */
bool klartext_skip_definition(struct interp *interp);

#endif
