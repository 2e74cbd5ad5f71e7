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
 * Carries out the whole program in `in`. Messages call the program `name`; its subprograms in separate files are
 * searched in the folder of `name`, unless `name` is "<stdin>". Memory grows with the labels and named parameters of
 * the program, up to a limit, but not with its length. False: a fault was reported, with its place and the calls that
 * led there, or the sink stopped the interpreter.
 */
bool interp_run(struct interp *interp, FILE *in, const char *name);

/* The error if interp_run has sent no block: the file is what is left of a program that was not written completely. */
#define INTERP_NO_BLOCK \
	"no block of the program is carried out: the file is empty, or has only comments, subprograms or deleted " \
	"blocks (/); was it written and copied completely?"

/* Lines of the program itself that have been read so far. */
long interp_lines(const struct interp *interp);

#endif
