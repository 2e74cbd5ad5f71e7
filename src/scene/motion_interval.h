/*
 * motion_interval.h - a part of the relative motion of two bodies, with the data for a proof over it. It can be halved.
 */
#ifndef FIVECHECK_SCENE_MOTION_INTERVAL_H
#define FIVECHECK_SCENE_MOTION_INTERVAL_H

#include <stdbool.h>
#include <stddef.h>

#include "base/axes.h"
#include "geom/boxes.h"
#include "geom/bvh.h"
#include "geom/xform.h"
#include "machine/chain.h"
#include "machine/motion_bound.h"

struct body_shapes;
struct coherence;

/* Two bodies and the joints between them. Borrows everything. */
struct body_pair {
	const struct bvh *a, *b;
	xform place_a, place_b;	/* mesh -> machine coordinates at the zero pose */
	xform to_a;	/* the inverse of place_a */
	bool turned[2];	/* A, B: the place turns the mesh */
	const struct chain *chain;	/* from a to b */
	struct ball ball_a, ball_b;	/* bounding balls at the zero pose */
	double rounding;	/* mm: of both meshes together */
	double extent;	/* mm: at least the sum of the largest corner distances from the origin in both meshes */
	struct body_shapes *shapes[2];	/* of A, B; NULL: no other pair shares them */
	struct coherence *coherence;	/* axes and triangles that succeeded last time; NULL: none are kept */
};

void body_pair_init(struct body_pair *pair, const struct bvh *a, const struct bvh *b, const xform *place_a,
		    const xform *place_b, const struct chain *chain);

/* The place of b's mesh in the coordinates of A's link, if B's link has the pose. */
xform body_pair_place_b(const struct body_pair *pair, const xform *pose);

/* The place of b's mesh in a's mesh coordinates, from its place in those of A's link. */
xform body_pair_in_a(const struct body_pair *pair, const xform *place);

/* b's mesh coordinates in a's when the axes are at q. */
xform body_pair_pose(const struct body_pair *pair, const axis_values *q);

/* mm: a bound on the rounding error of a distance at q, where the pose's translation is t. */
double body_pair_rounding(const struct body_pair *pair, const axis_values *q, vec3 t);

/*
 * mm: how far the path tolerance can move one body in the frame of the other, at the instant of the nominal position q:
 * the sum over the joints of tolerance times lever, at the corner with the largest sum, in the better of both views.
 */
double body_pair_path_displacement(const struct body_pair *pair, const axis_values *q, const axis_values *tolerance);

/*
 * Axis positions over a piece of a move: within `chord_error` of the straight line from q0 to q1. The halves of a curve
 * deviate less than the whole, and `halve` computes them; NULL: the piece is straight, and both halves have its
 * deviation. The control may leave the move by `tolerance`, which halving does not change (borrowed; NULL: no
 * tolerance).
 */
struct chord {
	axis_values q0, q1;
	axis_values chord_error;	/* mm, radians */
	const axis_values *tolerance;	/* mm, radians */
	const void *curve;
	double u0, u1;	/* the piece of the curve */
	void (*halve)(const struct chord *whole, struct chord *first, struct chord *second);
};

/*
 * CHORD: one motion; its time s goes from 0 to 1 over the whole sweep.
 * BOX: every position between the chord's q0 (least) and q1 (greatest), axis by axis, without a time.
 */
enum interval_kind { INTERVAL_CHORD, INTERVAL_BOX };

struct motion_interval {
	enum interval_kind kind;
	struct chord chord;
	double s0, s1;
	int depth;	/* number of halvings */
	struct chain_state states[2];	/* CHORD: at both ends; BOX: [0] in the middle */
	xform poses[2];	/* of the meshes at the states; BOX: both are the same */
	double displacement[VIEWS]; /* mm: CHORD: distance of a point from its chord, with rounding; BOX: rounding */
	double path;	/* mm: CHORD: the largest path displacement, in the better view (motion_bound.h) */
	double path_growth[VIEWS];	/* mm: how much `path` can exceed the larger value at the ends */
	/* mm: BOX: bound of a point's displacement along the axes of the fixed mesh */
	vec3 axis_displacement[VIEWS];
	struct box_bound bound;	/* BOX */
	double reach;	/* mm, with rounding: CHORD: L/2 + d; BOX: from the middle to any position */
	struct box_motion boxes;
	bool halved;
	struct motion_interval *halves[2];	/* the earlier first; valid once halved */
	size_t users;	/* see interval_pool.h */
};

/* Fills in an interval that covers the whole chord or box. */
void motion_interval_init(struct motion_interval *interval, const struct body_pair *pair, enum interval_kind kind,
			  const struct chord *chord);

/* Fills in the two halves, whose storage the caller provides. */
void motion_interval_halve(struct motion_interval *interval, const struct body_pair *pair,
			   struct motion_interval *first, struct motion_interval *second);

/* BOX: a bound of the displacement of b's points along n, a unit vector in a's mesh coordinates, mm. */
double motion_interval_displacement_along(const struct motion_interval *interval, const struct body_pair *pair, vec3 n);

#endif
