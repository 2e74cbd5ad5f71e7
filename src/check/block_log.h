/* block_log.h - keeps findings, measurements and diagnostics until their NC block is complete. */
#ifndef FIVECHECK_CHECK_BLOCK_LOG_H
#define FIVECHECK_CHECK_BLOCK_LOG_H

#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"
#include "base/diag_queue.h"
#include "check/sink.h"

/* A finding whose block may be incomplete. Place, text, moves and fraction are filled in later, from the block. */
struct block_finding {
	struct finding finding;
	long block;	/* from 0 */
	double block_time;	/* s of motion in the block before the finding */
	/*
	 * Orders findings at one instant like a check that ends with the first one: 2 n with the axes at rest before
	 * step n, 2 n + 1 in that step, or in the move that begins with it.
	 */
	long order;
	int rank;	/* order of those with the same `order`: -1 for a limit, else the number of the pair */
	long number;	/* order of those with the same rank: set by block_log_add_finding */
};

/* The clearance of a pair in a part of a block; or in each block with steps from the first to the last. */
struct block_pair_clearance {
	long block, last;
	struct pair_clearance least;
};

/* Successive clearances in the order of their blocks, usually those of one pair in a batch. */
struct clearance_run {
	size_t next, end;	/* indices: of the first one not yet reported, and after the last one */
};

/* A complete block. */
struct block_record {
	long block;	/* from 0 */
	const char *file;	/* outlives the log */
	long line;
	const char *text;
	double seconds;	/* of motion */
	int moves;
	const struct srcloc *callers;	/* of its subprogram: call_chain.h */
	size_t caller_count;
	bool measured;	/* passed to check_sink.block, with steps, interpret and check */
	long steps;
	double interpret, check;	/* s */
};

/* Complete blocks, in order, without gaps. All zero is empty. */
struct block_page {
	struct block_record *blocks;
	size_t block_count, block_capacity;
	struct arena texts;	/* of the blocks */
};

/* Not to be moved after block_log_init. */
struct block_log {
	struct diag_queue diags;	/* messages that wait for their block */
	struct block_finding *findings;
	size_t finding_count, finding_capacity;
	long findings_added;
	struct block_page open;	/* the blocks since block_log_turn */
	struct block_page page;	/* the blocks that can be reported (block_log_show) */
	/* in any order; of several for a pair in one block the smallest counts */
	struct block_pair_clearance *clearances;
	size_t clearance_count, clearance_capacity;
	struct clearance_run *runs;	/* all clearances, while they are reported */
	size_t run_count, run_capacity;
	struct pair_clearance *out;	/* the clearances of one block while it is reported */
	size_t out_capacity;
};

void block_log_init(struct block_log *log);
void block_log_release(struct block_log *log);

/* The block with this number begins: messages reported to `diags` from now on belong to it. */
void block_log_begin(struct block_log *log, long block);

void block_log_add_finding(struct block_log *log, const struct block_finding *finding);

/* Reserves room for this number of clearances. */
void block_log_expect_clearances(struct block_log *log, size_t count);

/* block_log_expect_clearances has reserved the room. */
static inline void block_log_add_expected(struct block_log *log, long block, long last, struct pair_clearance least)
{
	log->clearances[log->clearance_count++] = (struct block_pair_clearance){block, last, least};
}

void block_log_add_clearance(struct block_log *log, long block, const struct pair_clearance *least);

/* The block is complete. Its text and its callers are copied. The result may be changed until the log is used again. */
struct block_record *block_log_complete(struct block_log *log, const struct block_record *block);

/* Moves the complete blocks to *page, which must be empty. Later blocks are collected separately. */
void block_log_turn(struct block_log *log, struct block_page *page);

/*
 * Makes the blocks of the page those that can be reported, and leaves *page empty; the earlier ones must be forgotten.
 * For the functions below they are the only complete blocks. Pages are shown in their order.
 */
void block_log_show(struct block_log *log, struct block_page *page);

void block_page_release(struct block_page *page);

/* Orders the findings by block, time, then rank. */
void block_log_sort(struct block_log *log);

/* Fills in the i-th finding. *out is valid until the log changes. False: its block is not complete. */
bool block_log_finding(const struct block_log *log, size_t i, struct finding *out);

/* Removes the first `count` findings. */
void block_log_drop_findings(struct block_log *log, size_t count);

/* Passes the measured blocks up to the number `last` to sink->block. */
void block_log_measured(struct block_log *log, long last, const struct check_sink *sink);

/* Forgets the blocks of the page and their measurements. Remaining findings belong to later blocks. */
void block_log_forget(struct block_log *log);

#endif
