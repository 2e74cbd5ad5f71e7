/* sweep.h - walks two bodies' trees and a stretch of motion together: they stay apart, or here they do not. */
#ifndef FIVECHECK_SCENE_SWEEP_H
#define FIVECHECK_SCENE_SWEEP_H

#include <stdbool.h>
#include <stddef.h>

#include "base/callbacks.h"
#include "scene/bvh_pair.h"
#include "scene/motion_interval.h"
#include "scene/tri_pair.h"

struct sweep_entry;

/* Working storage and counters, reused from sweep to sweep; one a thread. All zero is ready. */
struct sweep {
	struct sweep_entry *stack;
	size_t stack_capacity;
	struct bvh_pair *queue;
	size_t queue_capacity;
	struct motion_interval **intervals;
	size_t interval_count, interval_capacity;	/* in use, allocated */
	size_t interval_slots;
	long certificates;	/* node and triangle pairs proved apart over an interval */
	long bisections;	/* intervals halved */
	long visits;	/* node pairs looked at */
	const struct cancel *cancel;	/* borrowed; or NULL */
	long ask_at;	/* visits when it is asked next */
	bool broken_off;	/* it said yes: since then nothing is proved, nor found */
	long effort;	/* node pairs to look at for one chord or box before it stays undecided; 0: no limit */
	bool exhausted;	/* that limit was reached; whoever asks why resets it before */
};

/* Must the walk break off? To be called again and again on the way. */
bool sweep_breaks_off(struct sweep *sweep);

/* Room for `count` entries of the queue, which is for the walks that look at one pose. */
struct bvh_pair *sweep_queue_reserve(struct sweep *sweep, size_t count);

void sweep_release(struct sweep *sweep);

enum sweep_answer {
	SWEEP_APART,	/* proved: farther apart than the clearance all the way */
	SWEEP_CONTACT,	/* *contact is the first instant, to within the tolerance */
	SWEEP_UNDECIDED	/* the limit of work is reached, the sweep was broken off, or rounding alone exceeds the tolerance */
};

/*
 * An interval whose motion is at most tolerance (mm) is one instant: what is not
 * proved apart by then touches, and is at most clearance + tolerance apart.
 *
 * The motion along a chord:
 */
enum sweep_answer sweep_chord(struct sweep *sweep, const struct body_pair *pair, const struct chord *chord,
			      double clearance, double tolerance, struct contact *contact);

/* The same, but any contact will do, not just the first: for asking whether a clearance holds. */
enum sweep_answer sweep_chord_any(struct sweep *sweep, const struct body_pair *pair, const struct chord *chord,
				  double clearance, double tolerance, struct contact *contact);

/* Every position in the box between low and high; looks at no more than max_visits node pairs (0: no limit). */
enum sweep_answer sweep_box(struct sweep *sweep, const struct body_pair *pair, const axis_values *low,
			    const axis_values *high, double clearance, double tolerance, long max_visits,
			    struct contact *contact);

/*
 * A lower bound on the distance (mm) when the axes stand at q: at least `share`
 * (0 to 1) of it, less rounding; a large share costs more. As soon as the distance turns out
 * to be below `enough`, after max_visits node pairs (0: no limit), or when the sweep is broken off, the search ends
 * and the result is just some lower bound.
 */
double sweep_distance(struct sweep *sweep, const struct body_pair *pair, const axis_values *q, double share,
		      double enough, long max_visits);

/*
 * Makes the contact's distance and point those of the nearest triangles at its
 * q: a sweep is content with the first that it finds within the clearance.
 */
void sweep_nearest(struct sweep *sweep, const struct body_pair *pair, struct contact *contact);

#endif
