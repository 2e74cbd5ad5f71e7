/*
 * klartext_builder_cycle.h - cycles and programs of the machine builder, and probing cycles, whose effect the machine
 * file defines.
 */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_FLOW_KLARTEXT_BUILDER_CYCLE_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_FLOW_KLARTEXT_BUILDER_CYCLE_H

#include <stdbool.h>

#include "gcode/dialect/klartext/state/klartext_state.h"
#include "gcode/text/lexer.h"

/* Does the machine file define this cycle, by <macro program=""> with action="none" or "around"? */
bool klartext_builder_cycle_is_known(const struct interp *interp, int number);

/* Is this a cycle of the control that CYCL CALL carries out, and that is not supported here? */
bool klartext_builder_cycle_is_called(int number);

/* If the machine file does not define the cycle: reports the missing answer. Returns false. */
bool klartext_builder_cycle_refuse(const struct lexer *lexer, int number, int column);

/* Carries out the cycle at the end of its definition. False: reported, or the sink wants no more. */
bool klartext_builder_cycle_run(struct interp *interp, const struct klartext_cycle *cycle);

/*
 * Carries out CALL PGM and the like for a program without a file, according to <macro program="NAME"> of the machine
 * file; NAME is the file's name without folder and ending. False: reported, also if the machine file does not define
 * the program, or the sink wants no more.
 */
bool klartext_builder_program_run(struct interp *interp, const char *name, int column);

#endif
