#include "gcode/restart.h"

#include "gcode/state.h"

/*
 * Controls restart without end. A pass that starts with the same state and variables as the one before makes the same
 * moves, and so do all further passes. (Bytes of padding may differ without a reason: this costs one more pass.)
 */
bool restart_program(struct interp *interp, struct strbuf *variables)
{
	int column = interp->block.m_column[M_STOP];

	if (interp->comp.side != 0) {
		strbuf_release(variables);
		return fault(&interp->at, column,
			     "M99 restarts the program with cutter compensation on; write G40 first");
	}
	strbuf_add(variables, (const char *)&interp->state, sizeof(interp->state));
	return program_restart(&interp->program, variables, &interp->at, 1, &interp->ended);
}
