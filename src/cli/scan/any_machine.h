/* any_machine.h - reads programs for an assumed machine that can do everything that is requested. */
#ifndef FIVECHECK_CLI_SCAN_ANY_MACHINE_H
#define FIVECHECK_CLI_SCAN_ANY_MACHINE_H

#include <stdbool.h>
#include <stdio.h>

#include "base/diag.h"
#include "gcode/config.h"

/*
 * Reads the program from its beginning, without output of its moves. False: it has faults, or no block is carried out;
 * this was reported.
 */
bool any_machine_read(const struct gcode_config *config, FILE *in, const char *name, struct diag *diag);

#endif
