/* modal_state.h - M70 to M73: modes that a program saves and restores. */
#ifndef FIVECHECK_GCODE_DIALECT_LINUXCNC_MODAL_STATE_H
#define FIVECHECK_GCODE_DIALECT_LINUXCNC_MODAL_STATE_H

#include <stdbool.h>

#include "gcode/state.h"

/* LinuxCNC's manual, "M70 Save Modal State". Each level of calls has its own state. */
struct modal_state {
	bool saved;	/* by M70 or M73, and not made invalid by M71 */
	bool on_return;	/* M73: the end of the subprogram restores the modes */
	struct state modes;	/* the saved modes; its positions and tables are not used */
	int side;	/* of cutter compensation */
};

/* Carries out M70, M71, M72 or M73. False: reported at the column. */
bool modal_state_run(struct interp *interp, struct modal_state *modal, int code, int column);

/* At the end of the subprogram: M73 restores its modes; the saved state is dropped. False: reported at the column. */
bool modal_state_leave(struct interp *interp, struct modal_state *modal, int column);

#endif
