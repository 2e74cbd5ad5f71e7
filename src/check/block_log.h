/* block_log.h - what waits until its NC block is complete: findings, measurements and diagnostics. */
#ifndef FIVECHECK_CHECK_BLOCK_LOG_H
#define FIVECHECK_CHECK_BLOCK_LOG_H

#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"
#include "base/diag_queue.h"
#include "check/sink.h"

/* A finding whose block may still be incomplete. Place, text, moves and fraction are filled in from the block later. */
struct block_finding {
	struct finding finding;
	long block;	/* from 0 */
	double block_time;	/* s of motion in the block before the finding */
	/*
	 * Orders findings of one instant, as a check comes to them that ends with the first: 2 n where the axes stand
	 * before step n, 2 n + 1 in that step, or in the move that begins with it.
	 */
	long order;
	int rank;	/* orders those that have the same place there: -1 for a limit, else the number of the pair */
};

/* The clearance that a pair keeps in a part of a block. */
struct block_pair_clearance {
	long block;
	struct pair_clearance least;
};

/* Clearances in a row of which no later one is of an earlier block, as a rule those of one pair in a batch. */
struct clearance_run {
	size_t next, end;	/* indices: of the first one that was not handed over, and behind the last one */
};

/* A complete block. */
struct block_record {
	long block;	/* from 0 */
	const char *file;	/* outlives the log */
	long line;
	const char *text;
	double seconds;	/* of motion */
	int moves;
	const struct srcloc *callers;	/* of the subprogram that it stands in: call_chain.h */
	size_t caller_count;
	bool measured;	/* it is handed to check_sink.block, with steps, interpret and check */
	long steps;
	double interpret, check;	/* s */
};

/* Complete blocks, in order, without a gap. All zero is empty. */
struct block_page {
	struct block_record *blocks;
	size_t block_count, block_capacity;
	struct arena texts;	/* the blocks' */
};

/* Not to be moved after block_log_init. */
struct block_log {
	struct diag_queue diags;	/* what is reported to its diag waits for its block */
	struct block_finding *findings;
	size_t finding_count, finding_capacity;
	struct block_page open;	/* the blocks since block_log_turn */
	struct block_page page;	/* those that can be handed on (block_log_show) */
	/* in any order; a pair may have several in one block: the least counts */
	struct block_pair_clearance *clearances;
	size_t clearance_count, clearance_capacity;
	struct clearance_run *runs;	/* all clearances, while they are handed over */
	size_t run_count, run_capacity;
	struct pair_clearance *out;	/* the clearances of one block while it is handed over */
	size_t out_capacity;
};

void block_log_init(struct block_log *log);
void block_log_release(struct block_log *log);

/* The block with this number begins: what is reported to diags from now on belongs to it. */
void block_log_begin(struct block_log *log, long block);

void block_log_add_finding(struct block_log *log, const struct block_finding *finding);

/* Makes room for so many clearances. */
void block_log_expect_clearances(struct block_log *log, size_t count);

/* Room for it was made. */
static inline void block_log_add_expected(struct block_log *log, long block, struct pair_clearance least)
{
	log->clearances[log->clearance_count++] = (struct block_pair_clearance){.block = block, .least = least};
}

void block_log_add_clearance(struct block_log *log, long block, const struct pair_clearance *least);

/* The block is complete. Its text and its callers are copied. The result may be changed until the log is used again. */
struct block_record *block_log_complete(struct block_log *log, const struct block_record *block);

/* Moves the blocks that are complete to *page, which has none. Those that follow are collected apart. */
void block_log_turn(struct block_log *log, struct block_page *page);

/*
 * Makes the page's blocks those that can be handed on, and leaves *page empty; the last ones must be forgotten. To the
 * functions below these are the only complete blocks. Pages are shown in their order.
 */
void block_log_show(struct block_log *log, struct block_page *page);

void block_page_release(struct block_page *page);

/* Orders the findings by block, time, then rank. */
void block_log_sort(struct block_log *log);

/* Fills in the i-th finding. *out is valid until the log changes. False: its block is not complete. */
bool block_log_finding(const struct block_log *log, size_t i, struct finding *out);

/* The first `count` findings have been dealt with. */
void block_log_drop_findings(struct block_log *log, size_t count);

/* Hands the measured blocks up to the number `last` to sink->block. */
void block_log_measured(struct block_log *log, long last, const struct check_sink *sink);

/* Forgets the page's blocks and their measurements. Findings that remain belong to blocks behind it. */
void block_log_forget(struct block_log *log);

#endif
