/* klartext_join.h - a block that '~' continues in the next lines. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_JOIN_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_JOIN_H

#include "gcode/dialect/klartext/klartext_state.h"

/*
 * Makes one line of a formula or a block that '~' continues, and of the lines behind it, which have no block numbers.
 * Definitions of cycles, patterns and touch probes, and comments, are read line by line: they stay as they are. False:
 * reported; so are '~' in the middle of a line, a line that begins a block of its own, and a block without end.
 * begins_block: is this the word of a block?
 */
bool klartext_join(struct interp *interp, bool (*begins_block)(const char *word));

#endif
