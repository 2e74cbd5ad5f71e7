/* klartext_corner.h - RND and CHF: corners of the path that are rounded or chamfered. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_CORNER_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_CORNER_H

#include <stdbool.h>

#include "gcode/dialect/klartext/klartext_move.h"

/* Does the next line of the program begin a corner? Nothing is taken. */
bool klartext_corner_follows(struct interp *interp);

/* Keeps back the block in hand, which leads to the corner: the program counts as being at its end. False: reported. */
bool klartext_corner_hold(struct interp *interp, const struct klartext_words *words,
			  const struct klartext_target *target, const struct klartext_path *path);

/* The line in hand is that of the block kept back, or of its corner: its end is told later. */
void klartext_corner_keep_line(struct interp *interp);

/* RND or CHF; the words come next. False: reported. */
bool klartext_corner_read(struct lexer *lexer, bool chamfer);

/*
 * Makes what was kept back, and the corner in front of the path, whose start becomes the corner's end. False:
 * reported, or the sink wants no more.
 */
bool klartext_corner_make(struct interp *interp, const struct klartext_words *words, struct klartext_path *path);

/* No corner may wait here. False: reported. */
bool klartext_corner_check_none(struct interp *interp);

#endif
