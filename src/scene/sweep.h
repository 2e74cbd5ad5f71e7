/*
 * sweep.h - traverses the trees of two bodies over an interval of motion: proves the bodies apart, or finds the first
 * contact.
 */
#ifndef FIVECHECK_SCENE_SWEEP_H
#define FIVECHECK_SCENE_SWEEP_H

#include <stdbool.h>
#include <stddef.h>

#include "base/callbacks.h"
#include "geom/tri.h"
#include "scene/bvh_pair.h"
#include "scene/interval_pool.h"
#include "scene/motion_interval.h"
#include "scene/tri_pair.h"

struct sweep_entry;

/* Working storage and counters, used by one sweep after another; each thread has its own. All zero is ready. */
struct sweep {
	struct sweep_entry *stack;
	size_t stack_capacity;
	struct bvh_pair *queue;
	size_t queue_capacity;
	struct interval_pool intervals;
	long certificates;	/* node and triangle pairs proved apart over an interval */
	long bisections;	/* intervals halved */
	long visits;	/* node pairs examined */
	const struct cancel *cancel;	/* borrowed; or NULL */
	long ask_at;	/* the number of visits at which `cancel` is asked next */
	bool broken_off;	/* `cancel` said stop: since then nothing is proved or found */
	long effort;	/* the most node pairs for one chord or box; 0: no limit */
	bool exhausted;	/* `effort` was reached; reset it before a query */
};

/* Must the traversal stop? Call it repeatedly during a traversal. */
bool sweep_breaks_off(struct sweep *sweep);

/* Makes room for `count` entries of the queue, which traversals at a single pose use. */
struct bvh_pair *sweep_queue_reserve(struct sweep *sweep, size_t count);

void sweep_release(struct sweep *sweep);

enum sweep_answer {
	SWEEP_APART,	/* proved: farther apart than the clearance at every instant */
	SWEEP_CONTACT,	/* *contact is the first instant, to within the tolerance */
	SWEEP_UNDECIDED	/* the effort is used up, `cancel` said stop, or rounding alone exceeds the tolerance */
};

/*
 * Sweeps the motion along a chord. An interval in which no point moves more than `tolerance` (mm) counts as one
 * instant: triangles that are not proved apart by then touch, and are at most clearance + tolerance apart.
 */
enum sweep_answer sweep_chord(struct sweep *sweep, const struct body_pair *pair, const struct chord *chord,
			      double clearance, double tolerance, struct contact *contact);

/* The same, but any contact will do: use it to ask whether a clearance holds. */
enum sweep_answer sweep_chord_any(struct sweep *sweep, const struct body_pair *pair, const struct chord *chord,
				  double clearance, double tolerance, struct contact *contact);

/* All positions between low and high. */
struct swept_box {
	const axis_values *low, *high;
	/*
	 * The box is halved if the test of two subtrees' boxes loses more than this share of the larger one's size
	 * because the axes may be anywhere in it. It changes how fast an answer comes, and which contact is found.
	 */
	double lost;
	long max_visits;	/* examine at most this number of node pairs; 0: no limit */
};

/* The same for every position in a box. */
enum sweep_answer sweep_box(struct sweep *sweep, const struct body_pair *pair, const struct swept_box *box,
			    double clearance, double tolerance, struct contact *contact);

/*
 * A lower bound of the distance (mm) at the axis positions q: at least `share` (0 to 1) of it, minus rounding. A large
 * share costs more. The search ends early with a weaker bound if the distance turns out to be below `enough`, after
 * max_visits node pairs (0: no limit), or if `cancel` says stop.
 */
double sweep_distance(struct sweep *sweep, const struct body_pair *pair, const axis_values *q, double share,
		      double enough, long max_visits);

/* Two triangles in a's mesh coordinates, with their nearest points. */
struct nearest_triangles {
	tri a, b;
	vec3 on_a, on_b;
	double distance;	/* mm */
};

/*
 * The triangles of a pair that are nearest to each other at the axis positions q. With a share below 1 it may return
 * others, which costs less: `share` of their distance is less than the smallest distance.
 */
void sweep_nearest_triangles(struct sweep *sweep, const struct body_pair *pair, const axis_values *q, double share,
			     struct nearest_triangles *nearest);

/*
 * Sets the contact's distance and point to those of the nearest triangles at its q. A sweep stops at the first
 * triangles within the clearance, which need not be the nearest.
 */
void sweep_nearest(struct sweep *sweep, const struct body_pair *pair, struct contact *contact);

#endif
