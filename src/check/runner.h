/* runner.h - all pairs that must be checked, each followed through the batches by itself, on as many threads as wanted. */
#ifndef FIVECHECK_CHECK_RUNNER_H
#define FIVECHECK_CHECK_RUNNER_H

#include <stdbool.h>
#include <stddef.h>

#include "check/batch.h"
#include "check/certified.h"
#include "check/check.h"
#include "check/sampled.h"
#include "scene/scene.h"

/* What a pair met with. */
struct runner_result {
	size_t pair;	/* of the scene */
	size_t step;	/* of the batch */
	enum passage passage;	/* CONTACT or UNDECIDED */
	struct contact contact;
};

struct runner {
	size_t pair;	/* of the scene */
	int tool;	/* the tool that one of the bodies belongs to; 0: none */
	bool past_limits_only;	/* out of reach as long as no axis leaves its travel */
	long found_block;	/* the last block with a finding of this pair; -1: none */
	bool entangled;	/* it has met, and its surfaces may have parted with one body inside the other */
	struct follower follower;	/* CERTIFIED */
	struct sampler sampler;	/* the sampled methods */
	struct runner_result *results;	/* of this batch */
	size_t result_count, result_capacity;
};

struct runners {
	struct scene *scene;
	struct runner *runners;	/* in the order of the pairs */
	size_t count;
	struct sweep *sweeps;	/* one a thread */
	int threads;
	struct runner_result *results;	/* of the last batch, of all runners in order */
	size_t result_count, result_capacity;
};

/* measure: find the smallest clearances (follower_init). False: a mesh is faulty, reported. */
bool runners_init(struct runners *runners, struct scene *scene, const struct check_options *options, bool measure,
		  struct diag *diag);
void runners_release(struct runners *runners);

/* Is the runner's pair there while this tool is in the spindle? */
bool runner_is_active(const struct runner *runner, int tool);

/*
 * Sends every active runner through the batch and gathers the results: with
 * options->all the first of each pair and block, else the first of each pair. The
 * result does not depend on the number of threads.
 */
void runners_run(struct runners *runners, const struct batch *batch, int tool, const struct check_options *options);

/* Runner i has a finding in this block already. */
void runners_found(struct runners *runners, size_t i, long block);

/* Another tool is in the spindle: what its pairs knew of their position holds no longer. */
void runners_change_tool(struct runners *runners);

/* Adds up the counters; proven may be NULL. */
void runners_collect(const struct runners *runners, struct check_stats *stats, double *proven);

#endif
