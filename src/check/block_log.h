/* ledger.h - findings that wait until their block is complete, and come out in the order of time. */
#ifndef FIVECHECK_CHECK_LEDGER_H
#define FIVECHECK_CHECK_LEDGER_H

#include <stdbool.h>
#include <stddef.h>

#include "base/strbuf.h"
#include "check/finding.h"

/* A finding whose block is known by its number only; its texts and totals follow. */
struct ledger_entry {
	struct finding finding;
	long block;
	double block_time;	/* s of motion in the block before it */
	int rank;	/* breaks ties in time: -1 a limit, else the number of the pair */
};

struct ledger_block {
	long block;
	long line;
	size_t file, text;	/* offsets in texts */
	double seconds;	/* of motion */
	int moves;
};

struct ledger {
	struct ledger_entry *entries;
	size_t entry_count, entry_capacity;
	struct ledger_block *blocks;	/* complete ones, in order */
	size_t block_count, block_capacity;
	struct strbuf texts;
};

void ledger_release(struct ledger *ledger);
void ledger_add(struct ledger *ledger, const struct ledger_entry *entry);
void ledger_close_block(struct ledger *ledger, long block, const char *file, long line, const char *text,
			double seconds, int moves);

/* Orders the entries by time, then rank. */
void ledger_sort(struct ledger *ledger);

/*
 * The finding of entry i with its block's place, text, number of moves and the fraction filled
 * in; valid until the ledger changes. False: its block is not complete yet.
 */
bool ledger_finding(const struct ledger *ledger, size_t i, struct finding *out);

/* Drops the first `entries` entries, and all blocks that no entry needs. */
void ledger_drop(struct ledger *ledger, size_t entries);

#endif
