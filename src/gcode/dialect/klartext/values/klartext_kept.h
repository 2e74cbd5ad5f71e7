/* klartext_kept.h - values of the control's parameters and tables before a program starts, from the machine file. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_VALUES_KLARTEXT_KEPT_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_VALUES_KLARTEXT_KEPT_H

#include "gcode/dialect/klartext/state/klartext_state.h"
#include "gcode/text/lexer.h"

/*
 * Sets Q, QR and QS parameters to the values of the machine file. False: a value does not fit, which was reported.
 */
bool klartext_kept_load(struct lexer *lexer);

/*
 * Reads data of the control's tables for FN 18 that no program changes: tools, pockets, limits, touch probes. False:
 * the machine file does not have this value, or the query is for other data.
 */
bool klartext_kept_data(const struct interp *interp, const struct klartext_query *query, double *value);

#endif
