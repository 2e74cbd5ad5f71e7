/* pair_check.h - checks one pair in the steps of each batch. */
#ifndef FIVECHECK_CHECK_PAIR_CHECK_H
#define FIVECHECK_CHECK_PAIR_CHECK_H

#include <stdbool.h>
#include <stddef.h>

#include "check/batch.h"
#include "check/certified/strategy.h"
#include "check/measure/block_clearance.h"
#include "check/open_boxes.h"
#include "check/options.h"
#include "check/pair_result.h"
#include "check/pair_watch.h"
#include "check/sampled/sampler.h"
#include "scene/scene.h"

/* The clearance of the pair in those steps of a block that are in the batch; or the cap, in each of several blocks. */
struct pair_check_clearance {
	long block, last;	/* the first and the last block */
	double clearance;	/* mm: proven, at most `most` */
	double most;	/* mm: larger clearances were not needed */
	bool so_far;	/* as in struct pair_clearance */
};

/* Whether the smallest clearance of a pair is measured. */
struct pair_measuring {
	double up_to;	/* mm above the required clearance; INFINITY: without a cap; 0: not measured */
	bool coarsely;	/* STRATEGY_MEASURES_COARSELY */
};

/* The methods that check the pair; a large struct. */
struct pair_methods {
	struct sampler sampler;	/* the sampled methods */
	struct strategy strategy;	/* CERTIFIED */
	struct block_clearance block;
};

struct pair_check {
	/* The pair, and when it is checked. */
	struct scene *scene;	/* borrowed */
	size_t pair;	/* of the scene */
	struct pair_watch watch;
	struct pair_measuring measuring;
	struct pair_methods *methods; /* NULL until pair_check_prepare */

	/* The state at the end of the last step. */
	bool has_started;	/* the sampled methods have examined the start of the first step */
	bool maybe_inside;	/* after a contact: one body may be inside the other, with the surfaces apart */
	struct open_boxes open_boxes;
	long unknown_block;	/* the first block in which one body may have been inside the other; -1: none */

	/* The results of this batch. */
	struct pair_results results;
	struct pair_check_clearance *clearances;
	size_t clearance_count, clearance_capacity;
	long nearest_block;	/* the last block of the batch that lowered the smallest clearance; -1: none */

	/*
	 * If the batch was measured before the check, only the `open` steps are checked, in their order. In every other
	 * step the pair is proved to be farther apart than required plus tolerance.
	 */
	bool measured_first;
	size_t *open;
	size_t open_count, open_capacity;
	long measured_steps;	/* steps left out so far because they were measured */
};

/* *check must be all zero before the call. */
void pair_check_init(struct pair_check *check, struct scene *scene, size_t pair, struct pair_measuring measuring);

/*
 * Allocates the methods, unless they exist. Call it before the pair is checked for the first time; most pairs belong to
 * tools that a program does not use.
 */
void pair_check_prepare(struct pair_check *check, const struct check_options *options);
void pair_check_release(struct pair_check *check);

/* Leaves out the rest of this block: the pair has a finding in it, or was not decided. */
void pair_check_leave_block(struct pair_check *check, long block);

/* The tool that one of the bodies belongs to has come into the spindle, or left it. */
void pair_check_change_tool(struct pair_check *check);

/* Steps were left out, and nothing is known about them: one body may even be inside the other now. */
void pair_check_jump(struct pair_check *check);

/*
 * Checks the batch's steps from `from`, which must begin a chunk, to before `to`. Stores the first result of each
 * block, up to the first one that ends the check. Returns the number of boxes and single steps examined.
 */
long pair_check_run(struct pair_check *check, struct sweep *sweep, const struct batch *batch, size_t from, size_t to,
		    const struct check_options *options);

/* Measures the clearance at a position with the axes at rest, where the pair is known to be apart. */
void pair_check_stand(struct pair_check *check, struct sweep *sweep, const axis_values *at);

#endif
