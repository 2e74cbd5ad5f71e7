/*
 * stock_check.h - the stock of a program: logs the cuts, and checks the bodies that must not touch the remaining stock.
 *
 * The data flow: <stock> of the setup becomes a body of the scene, whose mesh is the blank (machine/stock_build.h). Its
 * pairs are marked (scene_pair.stock), and the scheduler leaves them to this file. Each step of the program comes here
 * first, in the order of time, whichever shard checks it: where a turning cutter feeds, the material that it certainly
 * removes goes to the log (stock/cutting.h, stock/cut_log.h). Then each batch is checked pair by pair
 * (check/stock_pair.h). A query goes to the cells (stock/stock_cells.h); they ask the log for the cuts before its time,
 * and divide if that is not enough.
 *
 * A finding is `rapid-contact` for a cutter at rapid or at rest, `collision` (or `clearance`) for everything else.
 */
#ifndef FIVECHECK_CHECK_STOCK_CHECK_H
#define FIVECHECK_CHECK_STOCK_CHECK_H

#include <stdbool.h>
#include <stddef.h>

#include "check/batch.h"
#include "check/measure/stock_clearance.h"
#include "check/stats.h"
#include "check/stock_pair.h"
#include "stock/cutter.h"
#include "stock/stock_mesh.h"

/* A tool that cuts, with the pair that describes its motion relative to the stock. */
struct stock_tool {
	int tool;
	bool surely;	/* a cutter given by sections, whose cuts are known; else they are only possible */
	struct body_pair bodies;	/* the stock is a, the cutter b */
};

struct stock_check {
	struct stock_pair *pairs;	/* in the order of the scene's pairs */
	struct stock_clearance *clearances;	/* of the pairs, if clearances are measured; else NULL */
	size_t pair_count;	/* 0: there is no stock, or nothing that could touch it */
	struct cutter *cutters;	/* of the log: one for each of the tools */
	struct stock_tool *tools;
	size_t tool_count;
	double chord_error;	/* mm: how exactly the paths of cutters are logged */
	vec3 low, high;	/* the box around the blank */
	struct cut_log log;
	struct stock_cells cells;
	struct pair_results results;	/* of the last batch */
};

/* *check must not be moved afterwards. False: an error, or something that is not supported with stock, reported. */
bool stock_check_init(struct stock_check *check, struct scene *scene, const struct check_options *options,
		      const struct cancel *cancel, struct diag *diag);
void stock_check_release(struct stock_check *check);

/* Logs the cuts of the step; `number` counts all steps of the program from 0. */
void stock_check_log(struct stock_check *check, const struct motion_step *step, long number);

/*
 * errno of the first error of the log's temporary file; 0: none. After an error no statement about the stock is valid:
 * neither a finding, nor that there is none.
 */
int stock_check_fault(const struct stock_check *check);

/* The next step may not begin where a pair was last examined: a tool was changed, or steps were left out. */
void stock_check_jump(struct stock_check *check);

/*
 * Checks the batch up to and including the step `last`, and collects the results in the order of the pairs. False:
 * interrupted; then the results are invalid.
 */
bool stock_check_run(struct stock_check *check, const struct batch *batch, size_t last, int tool,
		     const struct check_options *options);

/*
 * Measures the clearances in the batch's blocks (stock_clearance_measure), into `blocks` of each of its `clearances`.
 * Call it after stock_check_run. False: interrupted; the clearances are invalid.
 */
bool stock_check_measure(struct stock_check *check, const struct batch *batch, int tool);

/* The remaining stock before the step `number`; invalid after an error of the log. */
void stock_check_remainder(struct stock_check *check, long number, struct stock_remainder *remainder);

/* Fills in the view, at the latest before the step `number`. Without stock the view is unchanged. */
void stock_check_view(struct stock_check *check, long number, struct stock_view *view);

/*
 * Adds up the counters, and the pairs that became unknown up to last_block, where the check ended. proven may be NULL.
 */
void stock_check_collect(const struct stock_check *check, const struct scene *scene, long last_block,
			 struct check_stats *stats, double *proven);

#endif
