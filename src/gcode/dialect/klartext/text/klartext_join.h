/* klartext_join.h - joins a block that '~' continues in the next lines. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_TEXT_KLARTEXT_JOIN_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_TEXT_KLARTEXT_JOIN_H

#include "gcode/dialect/klartext/state/klartext_state.h"

/*
 * Joins the lines of a formula or a block that '~' continues; the further lines have no block numbers. Definitions of
 * cycles, patterns and touch probes, and comments, are read line by line and are not joined. False: reported; also '~'
 * in the middle of a line, a continuation line that starts another block, and a block without an end. begins_block: is
 * this the word of a block?
 */
bool klartext_join(struct interp *interp, bool (*begins_block)(const char *word));

#endif
