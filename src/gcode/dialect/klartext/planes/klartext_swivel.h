/* klartext_swivel.h - PLANE and cycle 19 for a known plane: moves of the rotary axes, and the tilted coordinates. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_PLANES_KLARTEXT_SWIVEL_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_PLANES_KLARTEXT_SWIVEL_H

#include <stdbool.h>

#include "gcode/kinematics.h"
#include "gcode/state.h"

enum klartext_turning { KLARTEXT_TURN_UNKNOWN, KLARTEXT_TURN_MOVE, KLARTEXT_TURN_TURN, KLARTEXT_TURN_STAY };

/* The words after those of the plane. */
struct klartext_swivel {
	enum klartext_turning positioning;
	double distance; /* DIST of MOVE, mm */
	bool rapid;
	double feed; /* without conversion; 0: the active feed */
	int sign; /* SEQ+ and SYM+ 1, SEQ- and SYM- -1, 0: none */
	bool symmetric; /* by SYM */
	bool table_rot, coord_rot;
	bool from_zero; /* of two solutions, the one nearer to the zero of the rotary axes counts */
	bool retracts; /* MB: along the tool before the rotary axes turn */
	struct kinematics_retract retract;
	int column;
};

/* Tilts the plane and turns the rotary axes according to the words. False: reported. */
bool klartext_swivel_tilt(struct interp *interp, const struct klartext_swivel *request, const mat3 *tilt);

/*
 * The same for given positions of the rotary axes, degrees, of the slots whose bits are in `axes` (PLANE AXIAL, cycle
 * 19): the coordinates turn with the head, but not with the table.
 */
bool klartext_swivel_axial(struct interp *interp, const struct klartext_swivel *request, unsigned axes,
			   const double angle[SLOT_COUNT]);

/* "PLANE RESET": coordinates are not tilted; with TURN or MOVE the rotary axes move to 0. False: reported. */
bool klartext_swivel_reset(struct interp *interp, const struct klartext_swivel *request);

/*
 * Cycle 19 with angles of 0: like klartext_swivel_reset; Q120 to Q122 become the angles of the plane that is not
 * tilted: 0, except for an axis whose angle is arbitrary and which stays at its position (swivel_pole).
 */
bool klartext_swivel_level(struct interp *interp, const struct klartext_swivel *request);

#endif
