/* klartext_system.h - data that a program reads from the control: FN 18: SYSREAD and FN 28: TABREAD. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_MACHINE_KLARTEXT_SYSTEM_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_MACHINE_KLARTEXT_SYSTEM_H

#include <stdbool.h>

#include "gcode/state.h"
#include "gcode/text/lexer.h"

/*
 * Carry out the text after "FN 18:" and "FN 28:". A parameter gets the value that follows from the setup or the
 * program; without such a value it is marked, so that its first use is an error. False: reported.
 */
bool klartext_system_read(struct lexer *lexer);
bool klartext_system_read_table(struct lexer *lexer);

/* FN 20: WAIT FOR SYNC: until axes move again, the positions that FN 18 reads are known. */
void klartext_system_synchronise(struct interp *interp);

#endif
