/* sinumerik_swivel_plane.h - the arguments of CYCLE800, and the plane that they define. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_CYCLES_SINUMERIK_SWIVEL_PLANE_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_CYCLES_SINUMERIK_SWIVEL_PLANE_H

#include "gcode/dialect/sinumerik/state/sinumerik_state.h"

/* 840D sl, "Swivel plane (CYCLE800)": the arguments in their order. */
enum { FR, TC, ST, MODE, X0, Y0, Z0, A, B, C, X1, Y1, Z1, DIR, FR_I, DMODE };

struct sinumerik_swivel {
	struct interp *interp;
	int column;
	const double *arguments;
	size_t count;
};

/* The value of an argument; an omitted one is 0. */
double sinumerik_swivel_value(const struct sinumerik_swivel *s, size_t i);

/* Does this MODE give positions of the rotary axes? */
bool sinumerik_swivel_is_direct(long mode);

/* The plane in the coordinates of the work offset; `added`: behind the active plane. False: reported. */
bool sinumerik_swivel_plane(const struct sinumerik_swivel *s, long mode, bool added, struct sinumerik_frame *plane);

#endif
