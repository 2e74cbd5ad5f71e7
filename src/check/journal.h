/* journal.h - what is measured of each block, until it is complete and the check is known to have gone so far. */
#ifndef FIVECHECK_CHECK_JOURNAL_H
#define FIVECHECK_CHECK_JOURNAL_H

#include <stdbool.h>
#include <stddef.h>

#include "base/strbuf.h"
#include "check/check.h"

/* A complete block; rooms of all blocks are in one list. */
struct journal_block {
	long block;	/* from 0 */
	long line, steps;
	size_t file;	/* offset in files */
	double seconds, interpret, check;
};

struct journal_room {
	long block;
	struct check_room room;
};

/* All zero is empty. */
struct journal {
	struct journal_block *blocks;	/* in order */
	size_t block_count, block_capacity;
	struct journal_room *rooms;	/* in any order; a pair may have several in one block: the least counts */
	size_t room_count, room_capacity;
	struct check_room *out;	/* of one block, while it is handed over */
	size_t out_capacity;
	struct strbuf files;	/* names, each with its NUL */
};

void journal_release(struct journal *journal);

void journal_add_room(struct journal *journal, long block, const struct check_room *room);

/* The block is complete; the file is copied. */
void journal_close_block(struct journal *journal, const struct journal_block *block, const char *file);

/* Hands over the complete blocks up to `last`, and forgets all complete ones. */
void journal_emit(struct journal *journal, long last, const struct check_sink *sink);

#endif
