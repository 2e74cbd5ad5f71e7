/* arena.h - storage that grows piece by piece and is freed as a whole. */
#ifndef FIVECHECK_BASE_ARENA_H
#define FIVECHECK_BASE_ARENA_H

#include <stddef.h>

struct arena_chunk;

/* All zero is an empty arena. */
struct arena {
	struct arena_chunk *chunks;	/* in use, the newest first */
	struct arena_chunk *spare;	/* emptied by arena_clear */
	size_t used;	/* bytes of the newest chunk */
};

/* Zeroed storage, aligned for any object; it lives until the arena is cleared or released. */
void *arena_alloc(struct arena *arena, size_t size);

/* A copy of `size` bytes, aligned for any object. */
void *arena_copy(struct arena *arena, const void *bytes, size_t size);
char *arena_strdup(struct arena *arena, const char *text);

/* Empties the arena and keeps its storage for later use. */
void arena_clear(struct arena *arena);

/* Frees everything; the arena is then empty and can be used again. */
void arena_release(struct arena *arena);

#endif
