/* pair_check.h - the check of one pair: takes it through the steps of each batch. */
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

/* A contact or an undecided step of a pair. */
struct pair_check_result {
	size_t pair;	/* of the scene */
	size_t step;	/* of the batch */
	enum query_answer answer;	/* CONTACT or UNDECIDED */
	bool exhausted;	/* undecided because check_options.effort was used up */
	struct contact contact;
	bool certain;	/* with the stock: it holds for every stock that the cuts can have left */
};

/* The clearance that the pair keeps in those steps of a block that are in the batch. */
struct pair_check_clearance {
	long block;
	double clearance;	/* mm: proven, at most `most` */
	double most;	/* mm: a larger one was of no interest */
	bool so_far;	/* as in struct pair_clearance */
};

/* Where only least clearances are measured: what is wanted of a block. Else every block is measured. */
enum measure_wish {
	MEASURE_NOTHING,	/* the smallest clearance of all steps so far is given */
	MEASURE_CURVE,	/* a point of the curve, while effort lasts */
	MEASURE_NEAREST	/* it lowered the smallest clearance of a pair */
};

/* What is to be measured of a batch, with options->least_clearances; else effort and wishes do not matter. */
struct measure_plan {
	const double *most;	/* mm, above 0: for each step that of its block; a larger clearance is given as this */
	double largest;	/* mm: of what `most` begins with; none is larger */
	const enum measure_wish *wishes;	/* for each step that of its block */
	/*
	 * After so many node pairs a point of the curve is no longer measured, and what must be measured is measured
	 * roughly.
	 */
	long effort;
};

/* Whether the smallest clearance of a pair is found. */
struct pair_measuring {
	double up_to;	/* mm: beyond what is required; INFINITY: all of it; 0: do not */
	bool coarsely;	/* STRATEGY_MEASURES_COARSELY */
};

/* What takes the pair through the steps; large. */
struct pair_methods {
	struct sampler sampler;	/* the sampled methods */
	struct strategy strategy;	/* CERTIFIED */
	struct block_clearance block;
};

struct pair_check {
	struct scene *scene;	/* borrowed */
	size_t pair;	/* of the scene */
	int tool;	/* the tool that one of the bodies belongs to; 0: none */
	unsigned steps;	/* bits of enum step_class: the steps in which it is checked */
	bool past_limits_only;	/* out of reach as long as no axis leaves its travel */
	struct pair_measuring measuring;
	bool has_started;	/* the sampled methods need not look at where the first step begins */
	long found_block;	/* the last block with a finding of this pair; -1: none */
	long nearest_block;	/* the last block of the batch that lowered the smallest clearance; -1: none */
	long unknown_block;	/* the first block in which one body may have been inside the other, unseen; -1: none */
	bool maybe_inside;	/* it has met or may have: one body may be inside the other, surfaces apart */
	struct pair_check_result *results;	/* of this batch */
	size_t result_count, result_capacity;
	struct pair_check_clearance *clearances;	/* of this batch */
	size_t clearance_count, clearance_capacity;
	/*
	 * The batch was measured before it is checked: then only these steps are checked, in their order. Throughout
	 * each other one the pair is proved to be farther apart than required, by more than the tolerance.
	 */
	bool measured_first;
	size_t *open;
	size_t open_count, open_capacity;
	long measured_steps;	/* that were left out so far */
	struct pair_methods *methods; /* NULL until pair_check_prepare; most pairs belong to tools that are not used */
};

/* The check is all zero before. */
void pair_check_init(struct pair_check *check, struct scene *scene, size_t pair, struct pair_measuring measuring);

/*
 * Makes a check ready, unless it is: to be called before the pair is checked for the first time. Most checks are of
 * tools that a program does not use.
 */
void pair_check_prepare(struct pair_check *check, const struct check_options *options);
void pair_check_release(struct pair_check *check);

/* Is the pair present while this tool is in the spindle? */
bool pair_check_is_active(const struct pair_check *check, int tool);

/* Must the pair stay apart in steps of this class? */
bool pair_check_watches(const struct pair_check *check, enum step_class class);

/* The pair has a finding in this block already. */
void pair_check_found(struct pair_check *check, long block);

/* The tool that one of the bodies belongs to has come into the spindle, or left it. */
void pair_check_change_tool(struct pair_check *check);

/* Steps were left out, and nothing is known about them: one body may even be inside the other by now. */
void pair_check_jump(struct pair_check *check);

/*
 * Checks the batch's steps from `from`, which begins a chunk, to before `to`. Stores the results: with options->all the
 * first of each block, else the first.
 */
void pair_check_run(struct pair_check *check, struct sweep *sweep, const struct batch *batch, size_t from, size_t to,
		const struct check_options *options);

/* Measures the clearance at a position where the axes stand, where the pair is known to be apart. */
void pair_check_stand(struct pair_check *check, struct sweep *sweep, const axis_values *at);

/* Is the clearance of this pair measured? Not that of a pair which may meet in some steps. */
bool pair_check_has_clearance(const struct pair_check *check);

/*
 * Measures the clearance that the pair keeps in each block of the batch in which it is checked. Returns how many node
 * pairs were looked at. Where every block is measured, call it before pair_check_run, which then leaves out what was
 * proved; else after it.
 */
long pair_check_measure(struct pair_check *check, struct sweep *sweep, const struct batch *batch,
			const struct measure_plan *plan, const struct check_options *options);

#endif
