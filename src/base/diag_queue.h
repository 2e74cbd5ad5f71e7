/* held.h - diagnostics that wait until it is known whether, or when, they are to be heard. */
#ifndef FIVECHECK_BASE_HELD_H
#define FIVECHECK_BASE_HELD_H

#include <stddef.h>

#include "base/diag.h"

struct held_entry;

/* Give `diag` to whom reports; set `block` to the number of the block that is being read. */
struct held {
	struct diag diag;
	long block;
	struct held_entry *entries;
	size_t count, capacity;
};

void held_init(struct held *held);
void held_release(struct held *held);

/* Hands on to `out` what was reported up to the given block, drops the rest. */
void held_deliver(struct held *held, struct diag *out, long last_block);

#endif
