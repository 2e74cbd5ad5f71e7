/*
 * cut_store.h - keeps the chunks of a cut log: the first ones in memory, all others in a temporary file without a
 * name.
 */
#ifndef FIVECHECK_STOCK_CUT_STORE_H
#define FIVECHECK_STOCK_CUT_STORE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include "stock/cutter.h"

enum { CUT_CHUNK = 16 };

/* The place and time at which one cut ends and the next one begins. */
struct cut_end {
	struct cutter_place place;
	double time;
	double error;	/* mm: of the cut that ends here */
};

/* Cuts of one cutter; each begins at the end of the one before. */
struct cut_chunk {
	int cutter;
	int count;	/* cuts; they have count + 1 ends */
	bool region;	/* one cut whose box alone is known */
	struct cut_end ends[CUT_CHUNK + 1];
};

/* The number of chunks that stay in memory: 16 MB, some 250,000 cuts. */
#define CUT_STORE_CHUNKS 15000

struct cut_store {
	struct cut_chunk *chunks;	/* the first chunks: those in memory */
	size_t chunk_capacity;
	size_t limit;	/* the largest number of chunks in memory */
	size_t count;	/* of all chunks */
	struct cut_chunk last;	/* the last chunk, if it is beyond the limit */
	FILE *file;	/* all other chunks beyond the limit; NULL: there are none */
	struct cut_slot *cache;	/* chunks that were read from the file last */
	int fault;	/* errno of the first write or read that failed; 0: none did */
	uint64_t gets;	/* number of chunk accesses: the cost of work with the log */
};

void cut_store_init(struct cut_store *store, size_t limit);
void cut_store_release(struct cut_store *store);

/* A new chunk at the end, all zero. It may be changed until the next one is added. */
struct cut_chunk *cut_store_add(struct cut_store *store);

/* The last chunk; NULL: there is none. */
struct cut_chunk *cut_store_last(struct cut_store *store);

/* Valid until the next call. After a fault it may be an empty chunk. */
const struct cut_chunk *cut_store_get(struct cut_store *store, size_t number);

#endif
