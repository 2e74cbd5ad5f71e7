/* pair_check.h - one pair that must be checked, on its way through the batches. */
#ifndef FIVECHECK_CHECK_PAIR_CHECK_H
#define FIVECHECK_CHECK_PAIR_CHECK_H

#include <stdbool.h>
#include <stddef.h>

#include "check/batch.h"
#include "check/certified/strategy.h"
#include "check/measure/block_clearance.h"
#include "check/options.h"
#include "check/sampled/sampler.h"
#include "scene/scene.h"

/* What a pair met with. */
struct pair_check_result {
	size_t pair;	/* of the scene */
	size_t step;	/* of the batch */
	enum query_answer answer;	/* CONTACT or UNDECIDED */
	bool exhausted;	/* UNDECIDED, as it would take more than check_options.effort */
	struct contact contact;
};

/* What clearance the pair keeps in those steps of a block that the batch holds. */
struct pair_check_room {
	long block;
	double clearance;	/* mm: proven, up to the cap */
};

struct pair_check {
	struct scene *scene;	/* borrowed */
	size_t pair;	/* of the scene */
	int tool;	/* the tool that one of the bodies belongs to; 0: none */
	unsigned steps;	/* bits of enum step_class: the steps in which it is checked */
	bool past_limits_only;	/* out of reach as long as no axis leaves its travel */
	long found_block;	/* the last block with a finding of this pair; -1: none */
	long unknown_block;	/* the first block in which one body may have been inside the other, unseen; -1: none */
	bool maybe_inside;	/* it has met or may have, and its surfaces may have parted with one body inside the other */
	struct strategy strategy;	/* CERTIFIED */
	struct sampler sampler;	/* the sampled methods */
	struct pair_check_result *results;	/* of this batch */
	size_t result_count, result_capacity;
	struct block_clearance block;
	struct pair_check_room *rooms;	/* of this batch */
	size_t room_count, room_capacity;
};

/*
 * measure: find the smallest clearance (strategy_init). False: a mesh is faulty,
 * reported. Not to be moved afterwards.
 */
bool pair_check_init(struct pair_check *check, struct scene *scene, size_t pair, const struct check_options *options,
		 bool measure, struct diag *diag);
void pair_check_release(struct pair_check *check);

/* Is the check's pair there while this tool is in the spindle? */
bool pair_check_is_active(const struct pair_check *check, int tool);

/* Has the pair to stay apart in steps of this class? */
bool pair_check_watches(const struct pair_check *check, enum step_class class);

/* The pair has a finding in this block already. */
void pair_check_found(struct pair_check *check, long block);

/* Steps were left out of which nothing is known: the bodies may even be one inside the other by now. */
void pair_check_jump(struct pair_check *check);

/*
 * Goes through the batch's steps from `from`, which starts a chunk, to before
 * `to` and leaves its results: with options->all the first of each block, else the first.
 */
void pair_check_run(struct pair_check *check, struct sweep *sweep, const struct batch *batch, size_t from, size_t to,
		const struct check_options *options);

/* Measures the clearance where the axes stand, as pair_check_run does where they move. The pair is apart there. */
void pair_check_stand(struct pair_check *check, struct sweep *sweep, const axis_values *at);

/*
 * Measures what clearance the pair keeps in the batch's blocks, one room for each in which it is checked. To
 * be called after pair_check_run, whose findings it does not depend on.
 */
void pair_check_measure(struct pair_check *check, struct sweep *sweep, const struct batch *batch,
		  const struct check_options *options);

#endif
