#include "base/arena.h"

#include <stdalign.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"

#define CHUNK_SIZE ((size_t)32 * 1024)

struct arena_chunk {
	struct arena_chunk *next;
	size_t size;
	alignas(max_align_t) unsigned char bytes[];
};

/* A chunk with room for `size` bytes; the first spare one if it is large enough. */
static struct arena_chunk *next_chunk(struct arena *arena, size_t size)
{
	struct arena_chunk *chunk = arena->spare;
	size_t room = size > CHUNK_SIZE ? size : CHUNK_SIZE;

	if (chunk && chunk->size >= size) {
		arena->spare = chunk->next;
		return chunk;
	}
	chunk = mem_alloc(sizeof(*chunk) + room);
	chunk->size = room;
	return chunk;
}

static void *reserve(struct arena *arena, size_t size)
{
	const size_t align = alignof(max_align_t);
	size_t start = (arena->used + align - 1) / align * align;
	struct arena_chunk *chunk = arena->chunks;

	if (!chunk || size > chunk->size || start > chunk->size - size) {
		chunk = next_chunk(arena, size);
		chunk->next = arena->chunks;
		arena->chunks = chunk;
		start = 0;
	}
	arena->used = start + size;
	return chunk->bytes + start;
}

void *arena_alloc(struct arena *arena, size_t size)
{
	return memset(reserve(arena, size), 0, size);
}

void *arena_copy(struct arena *arena, const void *bytes, size_t size)
{
	return memcpy(reserve(arena, size), bytes, size);
}

char *arena_strdup(struct arena *arena, const char *text)
{
	return arena_copy(arena, text, strlen(text) + 1);
}

void arena_clear(struct arena *arena)
{
	while (arena->chunks) {
		struct arena_chunk *chunk = arena->chunks;

		arena->chunks = chunk->next;
		chunk->next = arena->spare;
		arena->spare = chunk;
	}
	arena->used = 0;
}

static void free_chunks(struct arena_chunk *chunk)
{
	while (chunk) {
		struct arena_chunk *next = chunk->next;

		free(chunk);
		chunk = next;
	}
}

void arena_release(struct arena *arena)
{
	free_chunks(arena->chunks);
	free_chunks(arena->spare);
	*arena = (struct arena){0};
}
