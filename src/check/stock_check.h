/*
 * stock_check.h - the stock of a program: logs what its cutters cut, and checks what must not touch what remains.
 *
 * The data flow: <stock> of the setup becomes a body of the scene, whose mesh is the blank (machine/stock_build.h). Its
 * pairs are marked (scene_pair.stock), and the scheduler leaves them to this file. Each step of the program comes here
 * first, in the order of time, whichever shard checks it: where a turning cutter feeds, what it surely removes goes to
 * the log (stock/cutting.h, stock/cut_log.h). Then each batch is checked pair by pair (check/stock_pair.h). A question
 * goes to the cells (stock/stock_cells.h), which ask the log for the cuts before its time, and divide where that is not
 * enough.
 *
 * A finding is `rapid-contact` of a cutter at rapid or standing, `collision` (or `clearance`) of everything else.
 */
#ifndef FIVECHECK_CHECK_STOCK_CHECK_H
#define FIVECHECK_CHECK_STOCK_CHECK_H

#include <stdbool.h>
#include <stddef.h>

#include "check/batch.h"
#include "check/stats.h"
#include "check/measure/stock_clearance.h"
#include "check/stock_pair.h"
#include "stock/cutter.h"
#include "stock/stock_mesh.h"

/* A tool that cuts, with the pair that tells how it moves over the stock. */
struct stock_tool {
	int tool;
	bool surely;	/* what it removes is known: a cutter of sections; else it may remove what it passes */
	struct body_pair bodies;	/* the stock is a, the cutter b */
};

struct stock_check {
	struct stock_pair *pairs;	/* in the order of the scene's pairs */
	struct stock_clearance *clearances;	/* of the pairs, if clearances are measured; else NULL */
	size_t pair_count;	/* 0: there is no stock, or nothing that could touch it */
	struct cutter *cutters;	/* of the log: one for each of the tools */
	struct stock_tool *tools;
	size_t tool_count;
	double chord_error;	/* mm: how exactly the ways of cutters are logged */
	vec3 low, high;	/* the box around the blank */
	struct cut_log log;
	struct stock_cells cells;
	struct pair_check_result *results;	/* of the last batch */
	size_t result_count, result_capacity;
};

/* Must not be moved afterwards. False: something is faulty or not supported with stock, reported. */
bool stock_check_init(struct stock_check *check, struct scene *scene, const struct check_options *options,
		      const struct cancel *cancel, struct diag *diag);
void stock_check_release(struct stock_check *check);

/* Logs what the step cuts; `number` counts all steps of the program from 0. */
void stock_check_log(struct stock_check *check, const struct motion_step *step, long number);

/*
 * errno of the first fault of the log's temporary file; 0: there was none. After a fault nothing holds that was said of
 * the stock: no finding, and no absence of findings.
 */
int stock_check_fault(const struct stock_check *check);

/* The next step may not begin where a pair was looked at last: a tool was changed, or steps were left out. */
void stock_check_jump(struct stock_check *check);

/*
 * Checks the batch up to and including the step `last`, and collects the results in the order of the pairs. False:
 * interrupted; then the results are invalid.
 */
bool stock_check_run(struct stock_check *check, const struct batch *batch, size_t last, int tool,
		     const struct check_options *options);

/*
 * Measures the clearances in the batch's blocks (stock_clearance_measure), each in `blocks` of its `clearances`.
 * Call it after stock_check_run. False: interrupted; then they are invalid.
 */
bool stock_check_measure(struct stock_check *check, const struct batch *batch, int tool);

/* What remains of the stock before the step `number`; nothing is known of it after a fault of the log. */
void stock_check_remainder(struct stock_check *check, long number, struct stock_remainder *remainder);

/* Fills in what the view asks for, at the latest before the step `number`. Without stock it stays as it is. */
void stock_check_view(struct stock_check *check, long number, struct stock_view *view);

/*
 * Adds up the counters and the pairs that became unknown up to last_block, which ended the check. proven may be NULL.
 */
void stock_check_collect(const struct stock_check *check, const struct scene *scene, long last_block,
			 struct check_stats *stats, double *proven);

#endif
