#include "check/pending_batch.h"

void pending_batch_keep_results(struct pending_batch *pending, const struct scheduler *scheduler)
{
	pending->results.count = 0;
	pair_results_append(&pending->results, &scheduler->results);
}

void pending_batch_release(struct pending_batch *pending)
{
	batch_release(&pending->batch);
	block_page_release(&pending->page);
	file_names_release(&pending->opened);
	event_copies_release(&pending->heard);
	pair_results_release(&pending->results);
}
