/* pair_result.h - what the check of a pair found in a step of a batch. */
#ifndef FIVECHECK_CHECK_PAIR_RESULT_H
#define FIVECHECK_CHECK_PAIR_RESULT_H

#include <stdbool.h>
#include <stddef.h>

#include "check/batch.h"
#include "check/certified/clearance_query.h"
#include "check/options.h"

/* A contact or an undecided step of a pair. */
struct pair_result {
	size_t pair;	/* of the scene */
	size_t step;	/* of the batch */
	enum query_answer answer;	/* CONTACT or UNDECIDED */
	bool exhausted;	/* undecided because the effort was used up */
	struct contact contact;
	bool certain;	/* with the stock: the contact holds for every possible remaining stock */
};

/*
 * Does the check end with this result of the batch? Without options->all the first contact ends it. Always a step ends
 * it that has used up check_options.effort, because the next one would probably do so, too. A rapid whose path is not
 * known does not end it.
 */
bool pair_result_ends(const struct pair_result *result, const struct batch *batch,
		      const struct check_options *options);

/* All zero is empty. */
struct pair_results {
	struct pair_result *items;	/* owned */
	size_t count, capacity;
};

void pair_results_add(struct pair_results *results, const struct pair_result *result);

/* Adds all of the other list. */
void pair_results_append(struct pair_results *results, const struct pair_results *more);

/* Frees the storage; the list is then empty. */
void pair_results_release(struct pair_results *results);

#endif
