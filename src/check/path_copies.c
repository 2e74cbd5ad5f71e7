#include "check/path_copies.h"

#include <string.h>

void path_copies_release(struct path_copies *copies)
{
	arena_release(&copies->arena);
	*copies = (struct path_copies){0};
}

void path_copies_clear(struct path_copies *copies)
{
	arena_clear(&copies->arena);
	copies->path = NULL;
	copies->tcp = NULL;
}

/* Is the last copy also one of this span's path? */
static bool is_copied(const struct path_copies *copies, const struct span *span)
{
	const struct path *path = span->path;

	if (!copies->path)
		return false;
	return span->u0 > 0 || (path_is_straight(path) && copies->path->kind == path->kind);
}

const struct path *path_copies_add(struct path_copies *copies, const struct span *span)
{
	const struct tcp *tcp = span->path->tcp;

	if (is_copied(copies, span))
		return copies->path;
	copies->path = arena_copy(&copies->arena, span->path, sizeof(*span->path));
	if (!tcp)
		return copies->path;
	/* NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): of two that differ in padding alone both are kept. */
	if (!copies->tcp || memcmp(copies->tcp, tcp, sizeof(*tcp)) != 0)
		copies->tcp = arena_copy(&copies->arena, tcp, sizeof(*tcp));
	copies->path->tcp = copies->tcp;
	return copies->path;
}
