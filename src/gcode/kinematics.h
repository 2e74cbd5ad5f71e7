/* kinematics.h - what an interpreter asks of the machine: how its rotary axes carry the tool and the workpiece. */
#ifndef FIVECHECK_GCODE_KINEMATICS_H
#define FIVECHECK_GCODE_KINEMATICS_H

#include <stdbool.h>
#include <stddef.h>

#include "base/axes.h"
#include "base/diag.h"
#include "geom/xform.h"

/* Lengths in mm, angles in radians. */

/* Tool centre point control (TCP) as it holds from now on. */
struct kinematics_tcp {
	bool on;
	double length;	/* the length compensation in force; it acts along the spindle */
	axis_values rotary_zero;	/* where "rotary zero" is; linear slots 0 */
};

/* How the rotary axes stand the tool on a tilted plane. */
struct kinematics_orientation {
	vec3 direction;	/* unit: from the tip to the spindle, as positions under TCP are meant */
	axis_values rotary_zero;
	axis_values rotary;	/* where the axes are; receives where the rotary ones go */
	const char *command;	/* for messages; NULL: G53.1 */
};

/* One way to stand the tool in a direction. */
struct kinematics_solution {
	/* of the axes of the chain, in the turn within the limits that is nearest; others as they are */
	axis_values rotary;
	bool within_limits;	/* some turn of it is */
	bool free[SLOT_COUNT];	/* this axis can stand anywhere; `rotary` has it where it is */
	bool tie[SLOT_COUNT];	/* another turn of this axis is as near */
};

/* All ways to stand the tool in a direction: the choice is the control's. */
struct kinematics_solutions {
	size_t count;	/* up to 2; 0: the machine cannot stand so */
	struct kinematics_solution items[2];
	int primary;	/* slot of the first rotary axis as seen from the tool */
};

/*
 * A piece of a turn of the tool in the plane of two directions, at a constant rate: s runs from 0 to 1 over all of it.
 */
struct kinematics_great_circle {
	vec3 from, to;	/* units, as directions of kinematics_orientation; not opposite */
	axis_values rotary_zero;
	double s0, s1;
	axis_values rotary;	/* where the axes are at s0; receives where they are at s1 */
	/* Receives how far the rotary axes can be from the straight way between, radians; INFINITY: halve the piece. */
	double beside[SLOT_COUNT];
};

/* How the rotary axes turn coordinates: with the head, and against the table. */
struct kinematics_turn {
	axis_values rotary_zero;
	axis_values rotary;	/* where the axes are */
	/* receives the directions of X Y Z, as positions under TCP are meant; identity at rotary zero */
	mat3 turn;
	vec3 tool;	/* receives the direction from the tip to the spindle, in the same coordinates; unit */
};

/* A retract along the tool's axis, from the tip to the spindle. */
struct kinematics_retract {
	bool to_limit;	/* as far as the first linear axis reaches the end of its travel */
	double distance;	/* mm, if not */
	axis_values position;	/* where the axes are, as positions are meant now; receives where they go */
};

/*
 * None of these moves an axis. Each returns false after it reported at loc why this machine cannot do it, and then
 * leaves its last argument untouched.
 */
struct kinematics {
	void *context;
	/*
	 * TCP goes on, off, or changes its length or zero. *position is the current position as it was meant before,
	 * and receives the same place as it is meant from now on.
	 */
	bool (*tcp)(void *context, const struct kinematics_tcp *tcp, struct srcloc loc, axis_values *position);
	/*
	 * Finds the rotary positions that give the tool this direction: within the limits, the nearest to where it
	 * is.
	 */
	bool (*orient)(void *context, struct srcloc loc, struct kinematics_orientation *orientation);
	/* The same with every choice, for controls that choose in another way. */
	bool (*orientations)(void *context, struct srcloc loc, const struct kinematics_orientation *orientation,
			     struct kinematics_solutions *solutions);
	/* The direction of the tool at these rotary positions, as kinematics_orientation means it. */
	bool (*direction)(void *context, struct srcloc loc, const axis_values *rotary_zero, const axis_values *rotary,
			  vec3 *direction);
	bool (*turn)(void *context, struct srcloc loc, struct kinematics_turn *turn);
	/* The way of the rotary axes while the tool turns on a great circle; it needs two of them. */
	bool (*great_circle)(void *context, struct srcloc loc, struct kinematics_great_circle *piece);
	bool (*retract)(void *context, struct srcloc loc, struct kinematics_retract *retract);
	/*
	 * Where turning the table takes a point of the workpiece. *place holds, for the linear axes, the position that
	 * brings the gauge point to it while every rotary axis is at the machine's zero, and for the rotary axes where
	 * they are now; X Y Z receive the position that brings the gauge point to it now.
	 */
	bool (*table_point)(void *context, struct srcloc loc, axis_values *place);
};

#endif
