/* kinematics.h - the interpreter's questions to the machine: how rotary axes move the tool and the workpiece. */
#ifndef FIVECHECK_GCODE_KINEMATICS_H
#define FIVECHECK_GCODE_KINEMATICS_H

#include <stdbool.h>
#include <stddef.h>

#include "base/axes.h"
#include "base/diag.h"
#include "geom/xform.h"

/* Lengths in mm, angles in radians. */

/* The state of tool centre point control (TCP) from now on. */
struct kinematics_tcp {
	bool on;
	double length;	/* the active length compensation; it acts along the spindle */
	axis_values rotary_zero;	/* the positions that count as "rotary zero"; linear slots 0 */
};

/* Orients the tool perpendicular to a tilted plane. */
struct kinematics_orientation {
	vec3 direction;	/* unit vector from the tip to the spindle, in the coordinates of positions under TCP */
	axis_values rotary_zero;
	axis_values rotary;	/* the present positions; receives the new ones of the rotary axes */
	const char *command;	/* for messages; NULL: G53.1 */
};

/* One solution for a tool direction. */
struct kinematics_solution {
	/* axes of the chain: the nearest equivalent angle within the limits; other axes: their present positions */
	axis_values rotary;
	bool within_limits;	/* an equivalent angle within the limits exists */
	bool free[SLOT_COUNT];	/* any position of this axis will do; `rotary` has the present one */
	bool tie[SLOT_COUNT];	/* another equivalent angle of this axis is as near */
};

/* All solutions for a tool direction: the control chooses. */
struct kinematics_solutions {
	size_t count;	/* up to 2; 0: the machine cannot reach the direction */
	struct kinematics_solution items[2];
	int primary;	/* slot of the first rotary axis, counted from the tool */
};

/*
 * A piece of a tool motion that turns in the plane of two directions at a constant rate: s runs from 0 to 1 over the
 * whole motion.
 */
struct kinematics_great_circle {
	vec3 from, to;	/* unit vectors like kinematics_orientation.direction; not opposite */
	axis_values rotary_zero;
	double s0, s1;
	axis_values rotary;	/* the positions at s0; receives those at s1 */
	/* Receives how far the rotary axes can be from linear interpolation, radians; INFINITY: halve the piece. */
	double beside[SLOT_COUNT];
};

/* The rotation of the coordinates by the rotary axes: with the head, and against the table. */
struct kinematics_turn {
	axis_values rotary_zero;
	axis_values rotary;	/* the present positions */
	/* receives the directions of X Y Z in the coordinates of positions under TCP; identity at rotary zero */
	mat3 turn;
	vec3 tool;	/* receives the unit vector from the tip to the spindle, in the same coordinates */
};

/* A retract along the tool's axis, from the tip towards the spindle. */
struct kinematics_retract {
	bool to_limit;	/* until the first linear axis reaches the end of its travel */
	double distance;	/* mm, without to_limit */
	axis_values position;	/* the present position in the active coordinates; receives the retracted one */
};

/*
 * None of these moves an axis. If the machine cannot do what is asked, each reports the reason at loc, leaves its last
 * argument untouched and returns false.
 */
struct kinematics {
	void *context;
	/*
	 * Switches TCP on or off, or changes its length or zero. *position is the current position in the old
	 * coordinates; receives the same place in the new coordinates.
	 */
	bool (*tcp)(void *context, const struct kinematics_tcp *tcp, struct srcloc loc, axis_values *position);
	/*
	 * Finds the rotary positions that give the tool this direction: the nearest to the present ones within the
	 * limits.
	 */
	bool (*orient)(void *context, struct srcloc loc, struct kinematics_orientation *orientation);
	/* Finds all solutions, for controls that choose in another way. */
	bool (*orientations)(void *context, struct srcloc loc, const struct kinematics_orientation *orientation,
			     struct kinematics_solutions *solutions);
	/* The direction of the tool at these rotary positions, like kinematics_orientation.direction. */
	bool (*direction)(void *context, struct srcloc loc, const axis_values *rotary_zero, const axis_values *rotary,
			  vec3 *direction);
	bool (*turn)(void *context, struct srcloc loc, struct kinematics_turn *turn);
	/* The motion of the rotary axes while the tool turns on a great circle; two rotary axes are needed. */
	bool (*great_circle)(void *context, struct srcloc loc, struct kinematics_great_circle *piece);
	bool (*retract)(void *context, struct srcloc loc, struct kinematics_retract *retract);
	/*
	 * Computes where the turned table carries a point of the workpiece. The linear axes of *place hold the position
	 * at which the gauge point is at the workpiece point while every rotary axis is at the machine's zero; the
	 * rotary axes hold their present positions. X Y Z receive the position at which the gauge point is at the
	 * workpiece point now.
	 */
	bool (*table_point)(void *context, struct srcloc loc, axis_values *place);
};

#endif
