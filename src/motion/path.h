/*
 * path.h - the motion of the machine's axes in one move: straight, along an arc, or with the tool point guided (TCP).
 */
#ifndef FIVECHECK_MOTION_PATH_H
#define FIVECHECK_MOTION_PATH_H

#include <stdbool.h>

#include "base/axes.h"
#include "gcode/canon.h"
#include "motion/tcp.h"

enum path_kind {
	PATH_STRAIGHT,	/* every axis linear in u */
	PATH_BOX,	/* a rapid whose path is not known: anywhere in the box between start and end */
	PATH_ARC,	/* arc or helix of X Y Z, the other axes linear */
	PATH_TCP	/* straight or circular in the workpiece, rotary axes linear, X Y Z follow */
};

/* Plain data. u runs from 0 to 1 and is proportional to time. */
struct path {
	enum path_kind kind;
	axis_values start, end;	/* controller positions (canon.h); without TCP, machine axes */
	bool circular;	/* ARC, and TCP of an arc */
	struct canon_arc arc;
	const struct tcp *tcp;	/* borrowed; PATH_TCP only */
	double seconds;
};

/* Is every axis linear in u, or considered linear? */
static inline bool path_is_straight(const struct path *path)
{
	return path->kind == PATH_STRAIGHT || path->kind == PATH_BOX;
}

/* Machine axis positions at u; for a box, on the straight line. */
axis_values path_position(const struct path *path, double u);

/*
 * A bound, for each axis, of |true position - chord| over [u0, u1], compared at equal u: (u1 - u0)^2 / 8 times a bound
 * of the second derivative, plus the rounding of the chord's ends. Straight paths and boxes: 0. With u0 == u1, the
 * rounding alone.
 */
axis_values path_chord_error(const struct path *path, double u0, double u1);

/* A bound on the second derivative of each axis by u, over [u0, u1]. */
axis_values path_second_derivative(const struct path *path, double u0, double u1);

/* mm: the length of the motion of X Y Z as the controller counts it: under TCP, that of the tip in the workpiece. */
double path_length(const struct path *path);

#endif
