/* klartext_contour.h - contours in subprograms, and the cycles that clear their inside: CYCL DEF 14 and 20 to 24. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_CYCLES_KLARTEXT_CONTOUR_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_CYCLES_KLARTEXT_CONTOUR_H

#include <stdbool.h>

#include "gcode/dialect/klartext/cycles/klartext_parameter.h"
#include "gcode/text/lexer.h"

/* After CONTOUR: reads "DEF P1 = LBL 1 I2 = LBL 2". False: reported. */
bool klartext_contour_define(struct lexer *lexer);

/* After CYCL DEF 14.1: reads the labels of the subprograms. False: reported. */
bool klartext_contour_labels(struct lexer *lexer);

/* Takes CYCL DEF 20, the data of the contour cycles. */
bool klartext_contour_data(struct interp *interp, const struct klartext_cycle *cycle);

/* Is the cycle one of 21 to 24? */
static inline bool klartext_contour_is(int number)
{
	return number >= 21 && number <= 24;
}

/*
 * Carries out one of these cycles: the tool may be anywhere in the box of the contours, minus its radius, between the
 * depth and the clearance height. False: reported, or the sink wants no more.
 */
bool klartext_contour_make(const struct klartext_call_of *call);

#endif
