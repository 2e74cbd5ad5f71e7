/* klartext_pattern.h - one cycle at many points: PATTERN DEF with CYCL CALL PAT, and cycles 220 and 221. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_PATTERN_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_PATTERN_H

#include <stdbool.h>

#include "gcode/dialect/klartext/klartext_state.h"
#include "gcode/text/lexer.h"

/* No points so far; and one more of them. False: reported at the column. */
void klartext_pattern_begin(struct interp *interp);
bool klartext_pattern_add(struct interp *interp, int column, vec3 point);

/* Behind PATTERN; and a line that goes on with POS, ROW, PAT and the like, from this word on. False: reported. */
bool klartext_pattern_define(struct lexer *lexer);
bool klartext_pattern_go_on(struct lexer *lexer);

/*
 * CYCL CALL PAT: the cycle that was defined last at every point; the feed is that between the points, NULL a rapid.
 * False: reported, or the sink wants no more.
 */
bool klartext_pattern_call(struct interp *interp, int column, const struct canon_feed *feed);

/* Cycles 220 and 221 where they are defined. False: the same. */
bool klartext_pattern_circle(struct interp *interp, const struct klartext_cycle *cycle);
bool klartext_pattern_lines(struct interp *interp, const struct klartext_cycle *cycle);

#endif
