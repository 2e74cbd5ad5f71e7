/* klartext_label.h - the labels of a file: LBL 5, LBL "NAME". */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_FLOW_KLARTEXT_LABEL_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_FLOW_KLARTEXT_LABEL_H

#include <stdbool.h>

#include "gcode/dialect/klartext/state/klartext_state.h"
#include "gcode/text/label.h"
#include "gcode/text/lexer.h"

/* A label's name: digits or a text in quotes. Leading zeros of a number do not count. False: reported. */
bool klartext_label_read_name(struct lexer *lexer, char name[KLARTEXT_NAME]);

/*
 * Finds a label of the current file, which is read to its end for its first label. The text of the current line stays
 * readable. NULL, reported at the column: there is none, there are two, or it is LBL 0.
 */
const struct label *klartext_label_find(struct interp *interp, const char *name, int column);

/*
 * Calls `line` for each line from LBL <name> to LBL 0, with its place, until a call returns false. The position in the
 * program does not change. False: reported, or a call returned false.
 */
typedef bool (*klartext_label_line)(void *context, struct lexer *lexer);
bool klartext_label_read_section(struct interp *interp, const char *name, int column, klartext_label_line line,
				 void *context);

#endif
