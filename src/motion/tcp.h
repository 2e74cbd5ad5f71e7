/* tcp.h - tool centre point control (TCP): the positions of X Y Z at which the tip keeps its place. */
#ifndef FIVECHECK_MOTION_TCP_H
#define FIVECHECK_MOTION_TCP_H

#include <stdbool.h>

#include "base/axes.h"
#include "base/diag.h"
#include "gcode/kinematics.h"
#include "geom/xform.h"
#include "machine/chain.h"
#include "machine/machine.h"

/*
 * With M the directions of X Y Z and N those of the other linear axes u (head
 * minus table), T(theta) and H(theta) the pose maps of the table's and the
 * head's rotary axes, t the tip (gauge point + compensated length along the
 * spindle) at the zero pose, and theta0 "rotary zero", a controller position p
 * means the workpiece point
 *     w = T(theta0)^-1 (M p' + N u + H(theta0) t),   M p' = M p - length H(theta0) direction
 * and the linear axes q solve  M q = T(theta) w - H(theta) t - N u.
 * The length cancels in w: w = T(theta0)^-1 (M p + N u + H(theta0) gauge).
 */
struct tcp {
	struct chain table, head;	/* rotary joints only, the outermost first */
	mat3 matrix;	/* M */
	vec3 rows[3];	/* of its inverse */
	bool has_others;	/* there are U V W; then: */
	vec3 others[SLOT_COUNT];	/* N: directions on the slots of U V W, else 0 */
	xform table_zero_inverse;	/* T(theta0)^-1 */
	vec3 gauge_zero;	/* H(theta0) gauge */
	vec3 tip;	/* t */
	/* What tcp_bend and tcp_rounding need for every move: */
	double row_norms[3], condition;	/* of M^-1, and their sum */
	double axis_norms[SLOT_COUNT];	/* of the columns of M and N; rotary slots 0 */
	double lengths;	/* mm: the constant part of the lengths for the rounding bound */
	vec3 spindle;	/* direction of the spindle at the zero pose, towards the tip */
	struct kinematics_tcp state;
};

/*
 * Derives the chains from the machine. False, with an error at loc that gives the reason: a linear axis is carried by a
 * rotary one, X Y Z do not span space, no spindle, no workholding.
 */
bool tcp_init(struct tcp *tcp, const struct machine *machine, const struct kinematics_tcp *state, struct srcloc loc,
	      struct diag *diag);

/* Controller position -> machine axes, and back. Slots other than X Y Z are the same in both. */
axis_values tcp_to_machine(const struct tcp *tcp, const axis_values *position);
axis_values tcp_from_machine(const struct tcp *tcp, const axis_values *machine);

/*
 * A bound of the second derivative of X Y Z for a move that passes through the controller position `middle` at the
 * velocity `rate` (per unit of its parameter), valid for `half` units to either side. The rotary and the other linear
 * axes are linear; |M p''| <= acceleration. Slots other than X Y Z are 0.
 */
axis_values tcp_bend(const struct tcp *tcp, const axis_values *middle, const axis_values *rate, double acceleration,
		     double half);

/*
 * The largest motion of X Y Z that keeps the tip in its place if the rotary axes are off by at most this much (radians,
 * A B C), anywhere on a straight path between two controller positions. Other slots are 0.
 */
axis_values tcp_follow(const struct tcp *tcp, const axis_values *start, const axis_values *end, const double turn[3]);

/*
 * The largest motion of X Y Z if a controller position is off by at most this much in each of X, Y and Z (mm), on a
 * path from `start` to `end`, of which only the rotary slots count. Other slots are 0.
 */
axis_values tcp_spread(const struct tcp *tcp, const axis_values *start, const axis_values *end, const double spread[3]);

/* Implements kinematics.turn for positions of the rotary axes; the length does not matter. */
void tcp_turn(const struct tcp *tcp, struct kinematics_turn *turn);

/* The rounding bound of X Y Z from tcp_to_machine, for positions whose values are at most `reach`. */
axis_values tcp_rounding(const struct tcp *tcp, const axis_values *reach);

#endif
