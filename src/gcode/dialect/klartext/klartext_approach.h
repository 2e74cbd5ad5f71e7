/* klartext_approach.h - APPR and DEP: to a contour under radius compensation, and away from it. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_APPROACH_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_APPROACH_H

#include <stdbool.h>

#include "gcode/dialect/klartext/klartext_move.h"

/* APPR: its words come next. It waits for the first path of the contour. False: reported. */
bool klartext_approach_read(struct lexer *lexer);

/* The line in hand is that of APPR: its end is told when it has been carried out. */
void klartext_approach_keep_line(struct interp *interp);

/* Carries out the APPR that waits in front of this path. False: reported, or the sink wants no more. */
bool klartext_approach_make(struct interp *interp, const struct klartext_path *first);

/* None may wait here. False: reported. */
bool klartext_approach_check_none(struct interp *interp);

/* DEP: its words come next. */
bool klartext_approach_depart(struct lexer *lexer);

#endif
