/* klartext_cycle.h - CYCL DEF: definitions of cycles; CYCL CALL, M99 and M89, which carry them out. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_CYCLES_KLARTEXT_CYCLE_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_CYCLES_KLARTEXT_CYCLE_H

#include <stdbool.h>

#include "gcode/dialect/klartext/words/klartext_words.h"
#include "gcode/text/lexer.h"

/* Carries out the last defined cycle at the present position. False: reported at the column, or the sink ... */
bool klartext_cycle_call(struct interp *interp, int column);

/* The same, shifted by `shift` mm along the tool. */
bool klartext_cycle_call_shifted(struct interp *interp, int column, double shift);

/* Sets a parameter of a cycle ("Q203"), for a call that changes it. */
void klartext_cycle_set(struct klartext_cycle *cycle, const char *name, double value);

/* The same without a check of the parameters, at each point of a pattern. */
bool klartext_cycle_carry_out(struct interp *interp, int column);

/*
 * Are the parameters of the cycle unchanged since its definition? Without `heights` Q200, Q203 and Q204 may have
 * changed. False: reported.
 */
bool klartext_cycle_check_values(struct interp *interp, int column, bool heights);

/* The height of the set-up clearance above the workpiece, mm; false: the cycle has none. */
bool klartext_cycle_start(struct interp *interp, double *height);

/*
 * M89: calls the cycle after its own block and after every further block that `moves` axes, until M99 or another
 * definition. False: reported.
 */
bool klartext_cycle_call_modal(struct interp *interp, const struct klartext_words *words, bool moves);

#endif
