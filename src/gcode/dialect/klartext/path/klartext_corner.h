/* klartext_corner.h - RND and CHF: rounded and chamfered corners of the path. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_PATH_KLARTEXT_CORNER_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_PATH_KLARTEXT_CORNER_H

#include <stdbool.h>

#include "gcode/dialect/klartext/moves/klartext_move.h"

/* Is the next line of the program a corner? Nothing is consumed. */
bool klartext_corner_follows(struct interp *interp);

/* Holds the current block, which ends at the corner; the state already has its end position. False: reported. */
bool klartext_corner_hold(struct interp *interp, const struct klartext_words *words,
			  const struct klartext_target *target, const struct klartext_path *path);

/* The current line is that of the held block, or of its corner: its end is sent to the sink later. */
void klartext_corner_keep_line(struct interp *interp);

/* Reads the words of RND or CHF. False: reported. */
bool klartext_corner_read(struct lexer *lexer, bool chamfer);

/*
 * Makes the moves of the held block and of the corner before the path; the path then starts at the corner's end.
 * False: reported, or the sink wants no more.
 */
bool klartext_corner_make(struct interp *interp, const struct klartext_words *words, struct klartext_path *path);

/* Checks that no corner waits. False: reported. */
bool klartext_corner_check_none(struct interp *interp);

#endif
