#include "check/pending_batch.h"

#include <stdlib.h>
#include <string.h>

#include "base/mem.h"

void pending_batch_keep_results(struct pending_batch *pending, const struct scheduler *scheduler)
{
	pending->results = mem_grow(pending->results, &pending->result_capacity, scheduler->result_count,
				    sizeof(*pending->results));
	pending->result_count = scheduler->result_count;
	if (pending->result_count)
		memcpy(pending->results, scheduler->results, pending->result_count * sizeof(*pending->results));
}

void pending_batch_release(struct pending_batch *pending)
{
	batch_release(&pending->batch);
	block_page_release(&pending->page);
	file_names_release(&pending->opened);
	event_copies_release(&pending->heard);
	free(pending->results);
}
