/* restart.h - M99 and its like at the end of a main program: it begins again. */
#ifndef FIVECHECK_GCODE_RESTART_H
#define FIVECHECK_GCODE_RESTART_H

#include <stdbool.h>

#include "base/strbuf.h"

struct interp;

/*
 * Starts the program anew, or ends it where all further passes would be equal.
 * The dialect gives the bytes of its own variables, whose storage is taken over. False: reported at the M-code.
 */
bool restart_program(struct interp *interp, struct strbuf *variables);

#endif
