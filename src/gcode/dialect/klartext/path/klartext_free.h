/* klartext_free.h - FK free contour programming: elements that are determined by their own block. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_PATH_KLARTEXT_FREE_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_PATH_KLARTEXT_FREE_H

#include <stdbool.h>

#include "gcode/text/lexer.h"

/*
 * FL and FLT (straight lines), FC and FCT (circles); T: tangential to the element before. The block and the element
 * before must determine the end uniquely. False: reported, or the sink wants no more.
 */
bool klartext_free_line(struct lexer *lexer);
bool klartext_free_line_tangential(struct lexer *lexer);
bool klartext_free_circle(struct lexer *lexer);
bool klartext_free_circle_tangential(struct lexer *lexer);

/* Carries out FPOL: the pole of PR, PA, CCPR and CCPA. False: reported. */
bool klartext_free_pole(struct lexer *lexer);

/* Carries out FSELECT: selects one of several solutions. False: reported. */
bool klartext_free_select(struct lexer *lexer);

#endif
