/* modal_state.h - M70 to M73: modes that a program saves and takes back. */
#ifndef FIVECHECK_GCODE_DIALECT_LINUXCNC_MODAL_STATE_H
#define FIVECHECK_GCODE_DIALECT_LINUXCNC_MODAL_STATE_H

#include <stdbool.h>

#include "gcode/state.h"

/* LinuxCNC's manual, "M70 Save Modal State". Each level of calls has its own. */
struct modal_state {
	bool saved;	/* by M70 or M73, and not made invalid by M71 */
	bool on_return;	/* M73: the end of the subprogram takes it back */
	struct state modes;	/* as they were; positions and tables in it mean nothing */
	int side;	/* of cutter compensation */
};

/* Carries out M70, M71, M72 or M73. False: reported at the column. */
bool modal_state_run(struct interp *interp, struct modal_state *modal, int code, int column);

/* The subprogram ends: M73 takes its modes back, and nothing is saved any more. False: reported at the column. */
bool modal_state_leave(struct interp *interp, struct modal_state *modal, int column);

#endif
