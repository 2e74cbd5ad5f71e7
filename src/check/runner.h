/* runner.h - one pair that must be checked, on its way through the batches. */
#ifndef FIVECHECK_CHECK_RUNNER_H
#define FIVECHECK_CHECK_RUNNER_H

#include <stdbool.h>
#include <stddef.h>

#include "check/batch.h"
#include "check/certified.h"
#include "check/options.h"
#include "check/gauge.h"
#include "check/sampled.h"
#include "scene/scene.h"

/* What a pair met with. */
struct runner_result {
	size_t pair;	/* of the scene */
	size_t step;	/* of the batch */
	enum passage passage;	/* CONTACT or UNDECIDED */
	struct contact contact;
};

/* What clearance the pair keeps in those steps of a block that the batch holds. */
struct runner_room {
	long block;
	double clearance;	/* mm: proven, up to the cap */
};

struct runner {
	struct scene *scene;	/* borrowed */
	size_t pair;	/* of the scene */
	int tool;	/* the tool that one of the bodies belongs to; 0: none */
	bool past_limits_only;	/* out of reach as long as no axis leaves its travel */
	long found_block;	/* the last block with a finding of this pair; -1: none */
	long unknown_block;	/* the first block in which one body may have been inside the other, unseen; -1: none */
	bool entangled;	/* it has met or may have, and its surfaces may have parted with one body inside the other */
	struct follower follower;	/* CERTIFIED */
	struct sampler sampler;	/* the sampled methods */
	struct runner_result *results;	/* of this batch */
	size_t result_count, result_capacity;
	struct gauge gauge;
	struct runner_room *rooms;	/* of this batch */
	size_t room_count, room_capacity;
};

/*
 * measure: find the smallest clearance (follower_init). False: a mesh is faulty,
 * reported. Not to be moved afterwards.
 */
bool runner_init(struct runner *runner, struct scene *scene, size_t pair, const struct check_options *options,
		 bool measure, struct diag *diag);
void runner_release(struct runner *runner);

/* Is the runner's pair there while this tool is in the spindle? */
bool runner_is_active(const struct runner *runner, int tool);

/* The pair has a finding in this block already. */
void runner_found(struct runner *runner, long block);

/* Steps were left out of which nothing is known: the bodies may even be one inside the other by now. */
void runner_jump(struct runner *runner);

/*
 * Goes through the batch's steps from `from`, which starts a chunk, to before
 * `to` and leaves its results: with options->all the first of each block, else the first.
 */
void runner_run(struct runner *runner, struct sweep *sweep, const struct batch *batch, size_t from, size_t to,
		const struct check_options *options);

/* Measures the clearance where the axes stand, as runner_run does where they move. The pair is apart there. */
void runner_stand(struct runner *runner, struct sweep *sweep, const axis_values *at);

/*
 * Measures what clearance the pair keeps in the batch's blocks, one room for each in which it is checked. To
 * be called after runner_run, whose findings it does not depend on.
 */
void runner_gauge(struct runner *runner, struct sweep *sweep, const struct batch *batch,
		  const struct check_options *options);

#endif
