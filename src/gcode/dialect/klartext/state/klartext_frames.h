/* klartext_frames.h - presets, changes of coordinates, tilted planes and the rotary axes. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_STATE_KLARTEXT_FRAMES_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_STATE_KLARTEXT_FRAMES_H

#include <stdbool.h>

#include "base/axes.h"
#include "gcode/dialect/klartext/state/klartext_values.h"
#include "gcode/state.h"
#include "geom/xform.h"

struct klartext_preset {
	bool settled; /* the active preset is known */
	int row; /* that the program has selected; 0: none, or the datum that was set by hand */
	bool in_plane; /* CYCL DEF 247 in a tilted plane: it is not known whether the plane stays tilted */
	char table[KLARTEXT_NAME]; /* the datum table of SEL TABLE */
};

/*
 * The position of a point of the program is offset + origin + turn (scale point), for X, Y and Z. The parts, from the
 * inside: mirror, rotation, scaling and a shift of the tilted coordinates; the tilted plane; a datum shift.
 */
struct klartext_frame {
	vec3 shift; /* CYCL DEF 7, in coordinates that are not tilted, mm */
	bool tilted;
	mat3 tilt;
	vec3 inner; /* CYCL DEF 7 in tilted coordinates, mm */
	bool mirror[3];
	double rotation; /* degrees about Z */
	vec3 factor; /* of CYCL DEF 11 and 26 */
	vec3 centre; /* of CYCL DEF 26, mm */
	int scaled_by; /* the number of the last cycle that has set the factors */
	/* Derived: */
	bool any;
	mat3 turn; /* orthogonal; its determinant is -1 while mirrored */
	vec3 scale, origin;
};

/*
 * Bits of X, Y and Z: a shift in the tilted plane names an axis that an earlier shift moves, too; after the end of the
 * plane it is not known whether the earlier shift is still active.
 */
struct klartext_shift {
	unsigned in_plane; /* named in the plane that is still tilted */
	unsigned open; /* not known since the plane has ended */
};

/* PLANE ... STAY: linear axes must wait until the rotary axes are at the positions of the plane. */
struct klartext_stay {
	bool waits;
	bool needed[SLOT_COUNT]; /* the rotary axes that the plane has turned */
	axis_values rotary; /* their positions, radians */
};

/* The angles of CYCL DEF 19. */
struct klartext_cycle_19 {
	double angle[3]; /* A, B and C, degrees */
	bool counts; /* neither PLANE nor an empty CYCL DEF 19 was read since */
};

struct klartext_rotary {
	bool shortest; /* M126 */
	bool shifted[SLOT_COUNT]; /* CYCL DEF 7 shifted this axis, and no absolute word was read since */
	bool cautioned; /* the caution about a reduced display was given */
};

/* FUNCTION TCPM. */
struct klartext_tcpm {
	bool spatial; /* AXIS SPAT: A, B and C are spatial angles */
	bool by_vector; /* PATHCTRL VECTOR: the tool turns in the plane of its directions */
	bool given[3]; /* the spatial angle was programmed */
	double angle[3]; /* degrees */
};

#endif
