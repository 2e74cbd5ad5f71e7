/* interp.h - reads a g-code program block by block and carries it out as canonical moves. */
#ifndef FIVECHECK_GCODE_INTERP_H
#define FIVECHECK_GCODE_INTERP_H

#include <stdbool.h>
#include <stdio.h>

#include "base/diag.h"
#include "gcode/canon.h"
#include "gcode/config.h"
#include "gcode/kinematics.h"

struct interp;

/* All pointers are borrowed until interp_free. */
struct interp *interp_new(const struct gcode_config *config, const struct kinematics *kinematics,
			  const struct canon_sink *sink, struct diag *diag);
void interp_free(struct interp *interp);

/*
 * Carries out the program that `in` holds, to its end; `name` stands in the
 * messages, and its folder is where subprograms in files of their own are
 * looked for, unless it is "<stdin>". Memory does not grow with the length of
 * the program, but with its labels and named parameters, up to a limit. False:
 * a fault was reported, at its place and with the calls that led there, or the
 * sink said stop.
 */
bool interp_run(struct interp *interp, FILE *in, const char *name);

/* Lines of the program itself that have been read so far. */
long interp_lines(const struct interp *interp);

#endif
