/* travelling_plane.h - a plane between two bodies that travels with a link of the machine: the gap that it leaves. */
#ifndef FIVECHECK_CHECK_CERTIFIED_TRAVELLING_PLANE_H
#define FIVECHECK_CHECK_CERTIFIED_TRAVELLING_PLANE_H

#include <stdbool.h>
#include <stddef.h>

#include "base/axes.h"
#include "scene/convex.h"
#include "scene/motion_interval.h"

struct position_errors;

/*
 * A unit vector n is fixed in the frame of link k: the first k joints of the chain are between it and body A, the
 * others between it and body B. Seen from the link, the gap is g(q) = min n.b - max n.a over the points a of A and b of
 * B; the bodies are at least g apart. The gap is measured at the position `at`. Elsewhere only motion along n can make
 * it smaller, and with dq = q - at
 *
 *	g(q) >= g(at) + sum over the joints of min(dq low, dq high) - second(|dq|).
 *
 * Proof. Number the joints of one body outward from the link, F_1 to F_m. A point p of the body moves by
 *
 *	F_1(q)...F_m(q) p - F_1(at)...F_m(at) p
 *		= sum over j of F_1(q)...F_(j-1)(q) [F_j(q) - F_j(at)] F_(j+1)(at)...F_m(at) p.
 *
 * Along n, term j is n'.[F_j(q) - F_j(at)] z, where n' is n as seen behind the first j-1 joints at q. It differs from
 * the same at `at`, n_j, by at most the sum over the rotary joints i < j of |n_i x a_i| |dq_i|, since a turn by dq
 * about the unit vector a moves a vector v by at most |dq| |v x a|.
 *   Linear joint along d: n_j.d dq, exactly, and for the difference of n' and n_j at most that sum times |dq|.
 *   Rotary joint about a through o, with w = F_j(at) z - o: n_j.[sin dq a x w - (1 - cos dq) w'], where w' is w without
 *   its part along a. This is dq (n_j x a).w, up to |n_j x a| |w'| (dq^2/2 + |dq|^3/6); with n' - n_j, at most that sum
 *   times |w'| |dq|.
 * (n_j x a).w lies between its least and its greatest value over the body: these are `low` and `high`, and the greatest
 * |w'| is `lever`. A's joints turn the other way about, and A counts with the other sign: the formulas are the same. []
 *
 * All of n_j, a and w are taken at `at`, so they can be computed in any one frame there.
 *
 * Revolution. If the joint next to a body is rotary, the body may be replaced by all places that the joint can turn it
 * to (struct profile). They hold the body at every position of this joint, which drops out of the sum.
 */
struct travelling_plane {
	double gap;	/* mm at `at`, minus rounding */
	double rounding;	/* mm: the rounding bound; twice as much if the normal was also rounded there */
	double at[SLOT_COUNT];	/* mm, radians; by joint of the chain, like the arrays below */
	double low[SLOT_COUNT], high[SLOT_COUNT];	/* mm per mm or radian */
	double rate[SLOT_COUNT];	/* the larger absolute value of both */
	double turn[SLOT_COUNT];	/* |n x a|; 0: linear, or removed by a profile */
	double lever[SLOT_COUNT];	/* mm; 0: linear, or removed by a profile */
	size_t link;	/* k */
	vec3 normal;	/* in the coordinates of link k, for the next measurement */
};

/* The position at which planes are measured. */
struct plane_pose {
	const struct body_pair *bodies;
	axis_values q;
	double rounding;	/* mm: of a gap or a lever at q, including the meshes */
	double slack;	/* of a product of unit vectors at q */
	/* The following members are in the coordinates of A's link. */
	xform places[2];	/* of both meshes */
	mat3 turned[SLOT_COUNT + 1];	/* of each link k: from its own coordinates, directions only */
	vec3 direction[SLOT_COUNT];	/* of each joint */
	vec3 location[SLOT_COUNT];	/* of each rotary joint's axis */
};

void plane_pose_init(struct plane_pose *pose, const struct body_pair *bodies, const axis_values *q);

/*
 * Parts a and b of both bodies at the pose, in the coordinates of A's link. A part with a profile is turned by the
 * joint next to its body, which must be on the body's side of the link.
 */
void travelling_plane_init(struct travelling_plane *plane, const struct plane_pose *pose, const struct convex *a,
			   const struct convex *b, vec3 n, size_t link, double gap, long *visits);

/* The unit normal of a plane that was measured elsewhere, turned with its link to the pose. */
vec3 travelling_plane_normal(const struct travelling_plane *plane, const struct plane_pose *pose);

/* Was the plane measured at q? */
bool travelling_plane_is_at(const struct travelling_plane *plane, const struct chain *chain, const axis_values *q);

/* mm: the gap along n at the pose, minus rounding, or at most 2 `slack` less. */
double travelling_plane_gap(const struct plane_pose *pose, const struct convex *a, const struct convex *b, vec3 n,
			    double slack, long *visits);

/*
 * A motion of the chain's joints. `straight`: from q0 to q1, all joints together. Otherwise each joint may be anywhere
 * between them. In both cases each joint may also be off by its chord error.
 */
struct plane_motion {
	bool straight;
	axis_values q0, q1, chord_error;
};

axis_values plane_motion_middle(const struct plane_motion *motion);

/* mm: no path displacement (motion_bound.h) of the bodies is larger at any position of the motion. */
double plane_motion_path(const struct plane_motion *motion, const struct body_pair *bodies,
			 const struct position_errors *errors);

/*
 * mm: the gap is larger than this, at every position of a straight motion, at whose ends gap0 and gap1 are left, from
 * which the rounding of a normal has been taken off, too.
 *
 * With both bodies' points on chords the gap along n would be concave, and so least at an end. A point's path has
 *
 *	n.x'' = sum over rotary j of dq_j^2 (n' x a_j).(a_j x w) + 2 sum over i < j, i rotary, of dq_i (n' x a_i).v_j
 *
 * where v_j is what joint j does to the point. So it leaves its chord along n by at most an eighth of
 *
 *	sum dq_j^2 turn_j lever_j + 2 sum dq_i turn_i u_j,	u_j = dq_j lever_j (rotary) or dq_j (linear),
 *
 * with the joints numbered as above; dq is the whole motion's. turn and lever are as they are at `at`, and what the
 * joints between it and the motion can add: to turn_j the inner ones, to lever_j the outer ones.
 */
double travelling_plane_between(const struct travelling_plane *plane, const struct chain *chain,
				const struct plane_motion *motion, double gap0, double gap1);

/*
 * mm: the gap is larger than this, at every position of the motion. -INFINITY may be returned instead of a value of at
 * most `beyond`.
 */
double travelling_plane_rest(const struct travelling_plane *plane, const struct chain *chain,
			     const struct plane_motion *motion, double beyond);

#endif
