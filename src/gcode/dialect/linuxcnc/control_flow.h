/* control_flow.h - LinuxCNC's control flow, as the hooks of its dialect. */
#ifndef FIVECHECK_GCODE_DIALECT_LINUXCNC_CONTROL_FLOW_H
#define FIVECHECK_GCODE_DIALECT_LINUXCNC_CONTROL_FLOW_H

#include <stdbool.h>
#include <stddef.h>

#include "base/diag.h"
#include "base/strbuf.h"

struct interp;

/*
 * Carries out the line in hand if it is one of control flow, or skips it: then
 * *done is true. False: reported.
 */
bool control_flow_line(struct interp *interp, bool *done);

/* M99 of a block that has been carried out: the program itself starts anew. False: reported. */
bool control_flow_after_block(struct interp *interp);

/* The file in hand has ended. False: something is not closed, which was reported. */
bool control_flow_end_of_file(struct interp *interp);

/* The calls under way (struct dialect). */
bool control_flow_caller(const struct interp *interp, size_t level, struct srcloc *at, struct strbuf *title);

#endif
