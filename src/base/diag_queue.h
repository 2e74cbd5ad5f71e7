/* diag_queue.h - diagnostics that wait until it is known whether, or when, to report them. */
#ifndef FIVECHECK_BASE_DIAG_QUEUE_H
#define FIVECHECK_BASE_DIAG_QUEUE_H

#include <stdbool.h>
#include <stddef.h>

#include "base/diag.h"

struct queued_diag;

/* Report to `diag`. Not to be moved after diag_queue_init. */
struct diag_queue {
	struct diag diag;
	long mark;	/* of new entries: the NC block being read, or 0 */
	bool of_blocks;	/* the marks are blocks in the order of execution, from 0: gives diag_entry.block */
	long order;	/* of new entries: their place among those with the same mark; usually 0 */
	struct queued_diag *items;
	size_t count, capacity;
};

void diag_queue_init(struct diag_queue *queue);
void diag_queue_release(struct diag_queue *queue);

/*
 * Passes the entries with a mark up to `last` on to `out`, and keeps the rest. Entries are passed on by mark and order,
 * those with the same ones as they came.
 */
void diag_queue_deliver(struct diag_queue *queue, struct diag *out, long last);

#endif
