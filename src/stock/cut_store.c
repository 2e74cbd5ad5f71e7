#include "stock/cut_store.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/mem.h"

/* Chunks that were read stay in memory, in this number of slots; a chunk's number determines its slot. */
#define SLOTS 1024

struct cut_slot {
	bool used;
	size_t number;
	struct cut_chunk chunk;
};

void cut_store_init(struct cut_store *store, size_t limit)
{
	*store = (struct cut_store){.limit = limit};
}

void cut_store_release(struct cut_store *store)
{
	if (store->file)
		fclose(store->file);
	free(store->chunks);
	free(store->cache);
	*store = (struct cut_store){.count = 0};
}

static off_t offset_of(const struct cut_store *store, size_t number)
{
	return (off_t)((number - store->limit) * sizeof(struct cut_chunk));
}

/* Writes or reads the whole chunk, unless there was a fault before. False: there is a fault. */
static bool transfer(struct cut_store *store, size_t number, struct cut_chunk *chunk, bool to_file)
{
	const size_t size = sizeof(*chunk);
	size_t done = 0;

	while (!store->fault && done < size) {
		char *at = (char *)chunk + done;
		const off_t offset = offset_of(store, number) + (off_t)done;
		const ssize_t count = to_file ? pwrite(fileno(store->file), at, size - done, offset)
					      : pread(fileno(store->file), at, size - done, offset);

		if (count > 0)
			done += (size_t)count;
		else if (count == 0 || errno != EINTR)
			store->fault = count == 0 ? EIO : errno;
	}
	return !store->fault;
}

/* Writes the last chunk to the file. */
static void spill(struct cut_store *store)
{
	if (!store->fault && !store->file) {
		store->file = tmpfile();
		if (!store->file)
			store->fault = errno ? errno : EIO;
		else
			store->cache = mem_zalloc(SLOTS, sizeof(*store->cache));
	}
	transfer(store, store->count - 1, &store->last, true);
}

struct cut_chunk *cut_store_add(struct cut_store *store)
{
	struct cut_chunk *chunk = &store->last;

	if (store->count > store->limit)
		spill(store);
	if (store->count < store->limit) {
		store->chunks = mem_grow(store->chunks, &store->chunk_capacity, store->count + 1,
					 sizeof(*store->chunks));
		chunk = &store->chunks[store->count];
	}
	memset(chunk, 0, sizeof(*chunk));
	store->count++;
	return chunk;
}

struct cut_chunk *cut_store_last(struct cut_store *store)
{
	if (!store->count)
		return NULL;
	return store->count > store->limit ? &store->last : &store->chunks[store->count - 1];
}

const struct cut_chunk *cut_store_get(struct cut_store *store, size_t number)
{
	struct cut_slot *slot;

	store->gets++;
	if (number < store->limit)
		return &store->chunks[number];
	if (number == store->count - 1 || !store->cache)
		return &store->last;
	slot = &store->cache[number % SLOTS];
	if (!slot->used || slot->number != number) {
		slot->used = true;
		slot->number = number;
		if (!transfer(store, number, &slot->chunk, false))
			memset(&slot->chunk, 0, sizeof(slot->chunk));
	}
	return &slot->chunk;
}
