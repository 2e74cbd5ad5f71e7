/* stock_sweep.h - the exact query: does a body keep its distance from the remaining stock during a motion? */
#ifndef FIVECHECK_STOCK_STOCK_SWEEP_H
#define FIVECHECK_STOCK_STOCK_SWEEP_H

#include <stdbool.h>

#include "base/callbacks.h"
#include "scene/motion_interval.h"
#include "scene/sweep.h"
#include "stock/stock_cells.h"

/* Borrows everything. */
struct stock_sweep {
	struct stock_cells *cells;
	const struct body_pair *bodies;
	bool stock_is_a;	/* else it is b */
	const struct obstacle *obstacle;	/* the other body */
	double clearance;	/* mm */
	/* mm: a piece of motion in which no point moves more than twice this counts as an instant */
	double least_way;
	long effort;	/* the most cells to examine; beyond, the answer is UNDECIDED; 0: no limit */
	const struct cancel *cancel;	/* asked during long work; or NULL */
	bool broken_off;	/* `cancel` said stop: the answer is UNDECIDED */
	bool exhausted;	/* `effort` was used up: the answer is UNDECIDED */
};

/* The obstacle with the axes at q. */
struct placed_obstacle stock_sweep_place(const struct stock_sweep *sweep, const axis_values *q);

/*
 * With the axes at q of the chord, is there stock nearer to the obstacle than the clearance? True is certain for every
 * motion that the chord represents: at this time (as in the log) no cutter can have touched that place.
 */
bool stock_sweep_proves(struct stock_sweep *sweep, const struct chord *chord, const axis_values *q, double time);

/*
 * Sweeps the motion along a chord, the step with this number. The stock at an instant is what remains after everything
 * that was cut before that instant. APART: at every instant the body is farther from the stock than the clearance.
 * CONTACT: the first instant at which a smallest cell is not proved so far away; then the body is at most `least_way`
 * plus the diagonal of such a cell too near to a place that is not proved to be cut. The answer depends only on the
 * step, the blank and the cuts.
 */
enum sweep_answer stock_sweep_chord(struct stock_sweep *sweep, const struct chord *chord, double number,
				    struct contact *contact);

/* The same for every position in the box between low and high, against the stock before the step. */
enum sweep_answer stock_sweep_box(struct stock_sweep *sweep, const axis_values *low, const axis_values *high,
				  double number, struct contact *contact);

#endif
