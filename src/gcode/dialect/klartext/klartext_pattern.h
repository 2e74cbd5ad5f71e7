/* klartext_pattern.h - a cycle at many points: PATTERN DEF with CYCL CALL PAT, and cycles 220 and 221. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_PATTERN_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_PATTERN_H

#include <stdbool.h>

#include "gcode/dialect/klartext/klartext_state.h"
#include "gcode/text/lexer.h"

/* Start without points; and add a point. False: reported at the column. */
void klartext_pattern_begin(struct interp *interp);
bool klartext_pattern_add(struct interp *interp, int column, vec3 point);

/* Read the text after PATTERN; and a continuation line from its POS, ROW, PAT and the like on. False: reported. */
bool klartext_pattern_define(struct lexer *lexer);
bool klartext_pattern_go_on(struct lexer *lexer);

/*
 * CYCL CALL PAT: carries out the last defined cycle at every point; `feed` is that between the points, NULL a rapid.
 * False: reported, or the sink wants no more.
 */
bool klartext_pattern_call(struct interp *interp, int column, const struct canon_feed *feed);

/* Carry out cycles 220 and 221 at their definition. False: the same. */
bool klartext_pattern_circle(struct interp *interp, const struct klartext_cycle *cycle);
bool klartext_pattern_lines(struct interp *interp, const struct klartext_cycle *cycle);

#endif
