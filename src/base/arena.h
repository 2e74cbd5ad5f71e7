/* arena.h - storage that is filled piece by piece and freed whole. */
#ifndef FIVECHECK_BASE_ARENA_H
#define FIVECHECK_BASE_ARENA_H

#include <stddef.h>

struct arena_chunk;

/* All zero is an empty arena. */
struct arena {
	struct arena_chunk *chunks;
	size_t used;	/* bytes of the newest chunk */
};

/* Zeroed storage, aligned for any object; it lives until the arena is released. */
void *arena_alloc(struct arena *arena, size_t size);
char *arena_strdup(struct arena *arena, const char *text);

/* Frees everything; the arena is then empty and can be used again. */
void arena_release(struct arena *arena);

#endif
