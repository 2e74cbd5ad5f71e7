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

void *arena_alloc(struct arena *arena, size_t size)
{
	const size_t align = alignof(max_align_t);
	size_t start = (arena->used + align - 1) / align * align;
	struct arena_chunk *chunk = arena->chunks;

	if (!chunk || size > chunk->size || start > chunk->size - size) {
		size_t room = size > CHUNK_SIZE ? size : CHUNK_SIZE;

		chunk = mem_zalloc(1, sizeof(*chunk) + room);
		chunk->next = arena->chunks;
		chunk->size = room;
		arena->chunks = chunk;
		start = 0;
	}
	arena->used = start + size;
	return chunk->bytes + start;
}

char *arena_strdup(struct arena *arena, const char *text)
{
	size_t length = strlen(text) + 1;

	return memcpy(arena_alloc(arena, length), text, length);
}

void arena_release(struct arena *arena)
{
	struct arena_chunk *chunk = arena->chunks;

	while (chunk) {
		struct arena_chunk *next = chunk->next;

		free(chunk);
		chunk = next;
	}
	arena->chunks = NULL;
	arena->used = 0;
}
