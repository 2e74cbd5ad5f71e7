/* klartext_approach.h - APPR and DEP: approach to a contour under radius compensation, and departure from it. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_PATH_KLARTEXT_APPROACH_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_PATH_KLARTEXT_APPROACH_H

#include <stdbool.h>

#include "gcode/dialect/klartext/moves/klartext_move.h"

/* Reads the words of APPR, which waits for the first path of the contour. False: reported. */
bool klartext_approach_read(struct lexer *lexer);

/* The current line is that of APPR: its end is sent to the sink after APPR was carried out. */
void klartext_approach_keep_line(struct interp *interp);

/* Carries out the waiting APPR before this path. False: reported, or the sink wants no more. */
bool klartext_approach_make(struct interp *interp, const struct klartext_path *first);

/* Checks that no APPR waits. False: reported. */
bool klartext_approach_check_none(struct interp *interp);

/* Reads the words of DEP and carries it out. */
bool klartext_approach_depart(struct lexer *lexer);

#endif
