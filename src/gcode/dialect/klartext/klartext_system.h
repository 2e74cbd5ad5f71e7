/* klartext_system.h - what a program reads from the control: FN 18: SYSREAD and FN 28: TABREAD. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_SYSTEM_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_SYSTEM_H

#include <stdbool.h>

#include "gcode/state.h"
#include "gcode/text/lexer.h"

/*
 * Behind "FN 18:" and "FN 28:". A parameter whose value the setup or the program says gets it; any other one is marked,
 * so that its first use is an error. False: reported.
 */
bool klartext_system_read(struct lexer *lexer);
bool klartext_system_read_table(struct lexer *lexer);

/* FN 20: WAIT FOR SYNC: until axes move again, FN 18 reads positions that are known here. */
void klartext_system_synchronise(struct interp *interp);

#endif
