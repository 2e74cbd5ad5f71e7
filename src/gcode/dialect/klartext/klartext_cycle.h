/* klartext_cycle.h - CYCL DEF: definitions of cycles; CYCL CALL, M99 and M89, which carry them out. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_CYCLE_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_CYCLE_H

#include <stdbool.h>

#include "gcode/dialect/klartext/klartext_words.h"
#include "gcode/text/lexer.h"

/* Carries out the cycle that was defined last, where the tool stands. False: reported at the column, or the sink ... */
bool klartext_cycle_call(struct interp *interp, int column);

/* The same, shifted by so many mm along the tool. */
bool klartext_cycle_call_shifted(struct interp *interp, int column, double shift);

/* Sets a parameter of a cycle ("Q203"), for a call that changes it. */
void klartext_cycle_set(struct klartext_cycle *cycle, const char *name, double value);

/* The same without a look at the parameters, at each point of a pattern. */
bool klartext_cycle_carry_out(struct interp *interp, int column);

/*
 * Has the program left the parameters of the cycle alone since its definition? Without `heights` Q200, Q203 and Q204
 * may be others. False: reported.
 */
bool klartext_cycle_check_values(struct interp *interp, int column, bool heights);

/* The height of the set-up clearance over the workpiece, mm; false: the cycle has none. */
bool klartext_cycle_start(struct interp *interp, double *height);

/*
 * M89: calls the cycle behind its own block and every further one that `moves` axes, until M99 or another definition.
 * False: reported.
 */
bool klartext_cycle_call_modal(struct interp *interp, const struct klartext_words *words, bool moves);

#endif
