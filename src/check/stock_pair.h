/* stock_pair.h - checks one body against the remaining stock in the steps of each batch. */
#ifndef FIVECHECK_CHECK_STOCK_PAIR_H
#define FIVECHECK_CHECK_STOCK_PAIR_H

#include <stdbool.h>
#include <stddef.h>

#include "check/batch.h"
#include "check/certified/clearance_query.h"
#include "check/certified/motion_budget.h"
#include "check/open_boxes.h"
#include "check/options.h"
#include "check/pair_result.h"
#include "check/pair_watch.h"
#include "scene/scene.h"
#include "stock/stock_sweep.h"

/*
 * The exact answer comes from stock_sweep and depends only on the step, the blank and the earlier cuts. A motion budget
 * saves work: a distance that was proved once. The stock only ever shrinks, so the budget stays valid until the axes
 * have used it up. It covers only motion that stays farther from the stock than the sweep would report.
 */
struct stock_pair {
	size_t pair;	/* of the scene */
	struct pair_watch watch;
	bool feeds_too;	/* a cutter that may not touch at a feed either (a rule of the user) */
	bool open;	/* the body's mesh is open: it has no defined inside */
	struct open_boxes open_boxes;
	long effort;	/* cells: for a step */
	long unknown_block;	/* the first block in which the stock may have been inside the body; -1: none */
	struct body_pair bodies;
	struct revolved revolved;	/* the surface of a tool's piece that is given by sections */
	struct obstacle obstacle;
	struct stock_sweep sweep;
	double margin;	/* mm: the least room with which a budget begins */
	struct motion_budget budget;
	bool clear_at_end;	/* proved where the last step ended: the pair is apart there */
	bool asked;	/* a distance was proved, or a step was swept */
	long queries, covered_steps;
	struct pair_results results;	/* of the batch */
};

/*
 * `tolerance` (mm): how exactly the stock must be known. *check must not be moved afterwards. False: the mesh of a
 * cutter is open, reported.
 */
bool stock_pair_init(struct stock_pair *check, struct scene *scene, size_t pair, struct stock_cells *cells,
		     double tolerance, const struct check_options *options, const struct cancel *cancel,
		     struct diag *diag);
void stock_pair_release(struct stock_pair *check);

/*
 * Checks the batch's steps before `to`. Stores the first result of each block, up to the first one that ends the check.
 */
void stock_pair_run(struct stock_pair *check, const struct batch *batch, size_t to,
		    const struct check_options *options);

/* The exact answer for one step, by the pair's own `sweep`, or a copy of it with another clearance. */
enum query_answer stock_pair_sweep(struct stock_pair *check, struct stock_sweep *sweep, const struct motion_step *step,
				   long number, struct contact *contact);

/* Checks the position q, where the axes are at rest before the step `number`. */
enum query_answer stock_pair_stand(struct stock_pair *check, const axis_values *q, long number,
				   struct contact *contact);

/* Leaves out the rest of this block: the pair has a finding in it, or was not decided. */
void stock_pair_leave_block(struct stock_pair *check, long block);

#endif
