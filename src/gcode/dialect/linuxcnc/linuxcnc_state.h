/* linuxcnc_state.h - what LinuxCNC remembers of a program beside the modes: parameters and open control flow. */
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

/* The call in hand; the program itself is the first. */
static inline struct call *linuxcnc_call_in_hand(const struct interp *interp)
{
	struct linuxcnc *linuxcnc = linuxcnc_of(interp);

	return &linuxcnc->flow.calls[linuxcnc->params.level];
}

/* A struct linuxcnc for a program that begins. */
void *linuxcnc_state_new(void);
void linuxcnc_state_free(void *state);

#endif
