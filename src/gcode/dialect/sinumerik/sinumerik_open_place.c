#include "gcode/dialect/sinumerik/sinumerik_open_place.h"

bool sinumerik_open_place_check(const struct interp *interp, int column, const char *what)
{
	const double *loose = interp->comp.loose;

	/* Cutter compensation, which leaves axes aside, too, does not begin before this has ended. */
	if (!sinumerik_of(interp)->left_open || !(loose[SLOT_X] > 0 || loose[SLOT_Y] > 0 || loose[SLOT_Z] > 0))
		return true;
	return fault(&interp->at, column,
		     "%s from where a milling cycle has left the tool: where it stands over its region is not known; "
		     "go to an absolute position in the plane first",
		     what);
}

void sinumerik_open_place_turned(struct interp *interp)
{
	double *loose = interp->comp.loose;
	const double most = vec3_norm((vec3){loose[SLOT_X], loose[SLOT_Y], loose[SLOT_Z]});

	for (int slot = SLOT_X; slot <= SLOT_Z; slot++)
		loose[slot] = most;
}
