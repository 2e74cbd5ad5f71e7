/* motion_bound.h - bounds of the motion of one body in the frame of another, by the joints between their links. */
#ifndef FIVECHECK_MACHINE_MOTION_BOUND_H
#define FIVECHECK_MACHINE_MOTION_BOUND_H

#include "base/axes.h"
#include "machine/chain.h"

/*
 * Two views of one relative motion. In view 0 the chain's fixed link does not move and the moved link's body does; in
 * view 1 it is the other way round. Each view gives its own bounds, and both are valid for the distance of the bodies.
 */
enum { VIEWS = 2 };

/* A ball around a body at the zero pose, in machine coordinates, mm. */
struct ball {
	vec3 centre;
	double radius;
};

/* The chain at one position of the axes. */
struct chain_state {
	xform pose;	/* the moved link's zero-pose geometry in the fixed link's */
	double rho[VIEWS][SLOT_COUNT];	/* mm: farthest point of the moving body from the joint's axis; 0: linear */
	vec3 direction[SLOT_COUNT];	/* of each joint in the fixed link's zero-pose coordinates */
	vec3 location[SLOT_COUNT];	/* of each rotary joint's axis, in the same coordinates */
};

void chain_state_init(struct chain_state *state, const struct chain *chain, const axis_values *q,
		      const struct ball *fixed, const struct ball *moved);

/*
 * A motion in which every joint moves linearly from q0 to q1, with a chord error of at most `chord_error`. The control
 * may leave it by `tolerance` (NULL: no tolerance). Borrows everything.
 */
struct joint_chord {
	const struct chain *chain;
	const struct chain_state *start, *end;	/* at q0 and q1 */
	const axis_values *q0, *q1, *chord_error, *tolerance;
};

/*
 * Bounds for such a motion (fivecheck(7), "How far a point can move"). At the instant of the nominal position q, the
 * tolerance moves a point by at most its path displacement: the sum over the rotary joints of the tolerance times the
 * point's distance from the axis at q, plus the tolerances of the linear joints. This depends only on q, and not on how
 * the motion is divided into pieces.
 */
struct chord_bound {
	double length;	/* L: bounds the way of any point, without chord errors (the better of both views) */
	double chord_error[VIEWS];	/* k: bounds the distance of any point's path from the chord between its ends */
	double displacement[VIEWS];	/* d: bounds the displacement of any point by the chord errors */
	double path[VIEWS];	/* bounds any point's path displacement, at any instant */
	double path_growth[VIEWS];	/* bounds the growth of any point's path displacement over that at the ends */
};

void chord_bound_init(struct chord_bound *bound, const struct joint_chord *chord);

/*
 * The path displacement (mm) of a point at `x`, in the fixed link's coordinates: a moved point in view 0, a fixed point
 * in view 1.
 */
double path_displacement(const struct chain *chain, const struct chain_state *state, vec3 x,
			 const axis_values *tolerance);

/*
 * Bounds for joints that may be anywhere within `half` of the state's position (mm, radians). Starting at the state,
 * each linear joint moves a point by at most `half` along its direction, either way, and each rotary joint by at most
 * `turn` perpendicular to its axis. The directions are those at the state.
 */
struct box_bound {
	double turn[VIEWS][SLOT_COUNT];	/* mm, by joint; 0: linear */
	double reach[VIEWS];	/* mm, by all of them */
};

void box_bound_init(struct box_bound *bound, const struct chain *chain, const struct chain_state *state,
		    const axis_values *half);

/*
 * mm: an upper bound of the path displacement (chord_bound) of any point, for all positions at which each joint is
 * within `half` of the state's, in the better view.
 */
double box_path_displacement(const struct chain *chain, const struct chain_state *state, const axis_values *half,
			     const axis_values *tolerance);

/*
 * mm: an upper bound of the way of a point if each of the linear joints first..last-1 moves by at most amount[slot].
 * With signs s, |sum s a d|^2 <= sum over pairs of a_i a_j |d_i . d_j|, which is the vector norm for orthogonal
 * directions.
 */
double linear_displacement(const struct chain *chain, size_t first, size_t last, const axis_values *amount);

/* mm: how far the linear joints first..last-1 move a point from q0 to q1. */
double linear_way(const struct chain *chain, size_t first, size_t last, const axis_values *q0, const axis_values *q1);

/* The end of the run of linear joints that begins at `first`: the next rotary joint, or the chain's end. */
size_t linear_run_end(const struct chain *chain, size_t first);

#endif
