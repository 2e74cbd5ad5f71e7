#include "check/pair_result.h"

#include <stdlib.h>

#include "base/mem.h"
#include "check/step.h"

bool pair_result_ends(const struct pair_result *result, const struct batch *batch, const struct check_options *options)
{
	if (result->answer == QUERY_CONTACT)
		return !options->all;
	return result->exhausted && !step_is_box(&batch->steps[result->step].motion);
}

static void make_room(struct pair_results *results, size_t more)
{
	results->items =
	    mem_grow(results->items, &results->capacity, results->count + more, sizeof(*results->items));
}

void pair_results_add(struct pair_results *results, const struct pair_result *result)
{
	make_room(results, 1);
	results->items[results->count++] = *result;
}

void pair_results_append(struct pair_results *results, const struct pair_results *more)
{
	make_room(results, more->count);
	for (size_t i = 0; i < more->count; i++)
		results->items[results->count++] = more->items[i];
}

void pair_results_release(struct pair_results *results)
{
	free(results->items);
	*results = (struct pair_results){0};
}
