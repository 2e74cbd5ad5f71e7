/* restart.h - restarts a main program that ends with M99 or the like. */
#ifndef FIVECHECK_GCODE_RESTART_H
#define FIVECHECK_GCODE_RESTART_H

#include <stdbool.h>

#include "base/strbuf.h"

struct interp;

/*
 * Restarts the program, or ends it if all further passes would be equal. `variables` has the bytes of the dialect's own
 * variables; its storage is taken over. False: reported at the M-code.
 */
bool restart_program(struct interp *interp, struct strbuf *variables);

#endif
