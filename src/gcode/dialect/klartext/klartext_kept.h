/* klartext_kept.h - what parameters and tables of the control hold before a program begins, from the machine file. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_KEPT_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_KEPT_H

#include "gcode/dialect/klartext/klartext_state.h"
#include "gcode/text/lexer.h"

/*
 * Gives Q, QR and QS parameters what the machine file says that they hold. False: it does not fit, which was reported.
 */
bool klartext_kept_load(struct lexer *lexer);

/*
 * Data of the control's tables that FN 18 reads, which no program changes: tools, pockets, limits, touch probes. False:
 * the machine file does not tell this one, or the data are others.
 */
bool klartext_kept_data(const struct interp *interp, const struct klartext_query *query, double *value);

#endif
