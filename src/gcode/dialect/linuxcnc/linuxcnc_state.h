/* linuxcnc_state.h - LinuxCNC's state of a program besides the modes: parameters and open control flow. */
#ifndef FIVECHECK_GCODE_DIALECT_LINUXCNC_LINUXCNC_STATE_H
#define FIVECHECK_GCODE_DIALECT_LINUXCNC_LINUXCNC_STATE_H

#include "gcode/dialect/linuxcnc/control_flow_state.h"
#include "gcode/dialect/linuxcnc/params.h"
#include "gcode/state.h"

struct linuxcnc {
	struct params params;
	struct control_flow flow;
};

static inline struct linuxcnc *linuxcnc_of(const struct interp *interp)
{
	return interp->dialect_state;
}

/* The current call; the first one is the main program. */
static inline struct call *linuxcnc_call_in_hand(const struct interp *interp)
{
	struct linuxcnc *linuxcnc = linuxcnc_of(interp);

	return &linuxcnc->flow.calls[linuxcnc->params.level];
}

/* A struct linuxcnc for the start of a program. */
void *linuxcnc_state_new(void);
void linuxcnc_state_free(void *state);

#endif
