/*
 * klartext_builder_cycle.h - cycles and programs of the machine's builder, and cycles of the probe: the machine file
 * says what they do.
 */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_BUILDER_CYCLE_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_BUILDER_CYCLE_H

#include <stdbool.h>

#include "gcode/dialect/klartext/klartext_state.h"
#include "gcode/text/lexer.h"

/* Does the machine file say what this cycle does, by <macro program=""> with action="none" or "around"? */
bool klartext_builder_cycle_is_known(const struct interp *interp, int number);

/* Is it a cycle of the control itself, which CYCL CALL carries out, and which is not followed here? */
bool klartext_builder_cycle_is_called(int number);

/* Where it does not: reports which answer is missing. Returns false. */
bool klartext_builder_cycle_refuse(const struct lexer *lexer, int number, int column);

/* Carries it out, where its definition ends. False: reported, or the sink wants no more. */
bool klartext_builder_cycle_run(struct interp *interp, const struct klartext_cycle *cycle);

/*
 * CALL PGM and the like of a program that has no file: as the machine file says by <macro program="NAME">, the file's
 * name without its folder and ending. False: reported, also that it says nothing, or the sink wants no more.
 */
bool klartext_builder_program_run(struct interp *interp, const char *name, int column);

#endif
