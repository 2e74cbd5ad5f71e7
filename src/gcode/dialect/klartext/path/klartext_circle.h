/* klartext_circle.h - circles and polar coordinates: CC, C, CR, CT, CP, CTP, LP. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_PATH_KLARTEXT_CIRCLE_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_PATH_KLARTEXT_CIRCLE_H

#include <stdbool.h>

#include "gcode/dialect/klartext/state/klartext_state.h"
#include "gcode/text/lexer.h"

/* Each function reads the text after its word and carries it out. False: reported, or the sink wants no more. */
bool klartext_circle_pole(struct lexer *lexer);
bool klartext_circle_about_pole(struct lexer *lexer); /* C */
bool klartext_circle_by_radius(struct lexer *lexer); /* CR */
bool klartext_circle_tangential(struct lexer *lexer); /* CT */
bool klartext_circle_polar(struct lexer *lexer); /* CP */
bool klartext_circle_tangential_polar(struct lexer *lexer); /* CTP */
bool klartext_circle_polar_line(struct lexer *lexer); /* LP */

/* Makes the path a circle in XY from its start to the end. False: reported at the column. */
bool klartext_circle_fill(struct interp *interp, struct klartext_path *path, vec3 end, vec3 centre, int direction,
			  int column);

#endif
