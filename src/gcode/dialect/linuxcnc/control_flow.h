/* control_flow.h - LinuxCNC's control flow, as the hooks of its dialect. */
#ifndef FIVECHECK_GCODE_DIALECT_LINUXCNC_CONTROL_FLOW_H
#define FIVECHECK_GCODE_DIALECT_LINUXCNC_CONTROL_FLOW_H

#include <stdbool.h>
#include <stddef.h>

#include "base/diag.h"
#include "base/strbuf.h"

struct interp;

/* Carries out the current line if it is control flow, or skips it: then *done is true. False: reported. */
bool control_flow_line(struct interp *interp, bool *done);

/* Call after a block: on M99 the main program restarts. False: reported. */
bool control_flow_after_block(struct interp *interp);

/* Call at the end of the current file. False: a statement is not closed, which was reported. */
bool control_flow_end_of_file(struct interp *interp);

/* The active calls (struct dialect). */
bool control_flow_caller(const struct interp *interp, size_t level, struct srcloc *at, struct strbuf *title);

#endif
