/* path_copies.h - copies of the paths that steps lie on, for who keeps steps longer than their event lasts. */
#ifndef FIVECHECK_CHECK_PATH_COPIES_H
#define FIVECHECK_CHECK_PATH_COPIES_H

#include "base/arena.h"
#include "motion/span.h"

/* All zero is empty. */
struct path_copies {
	struct arena arena;
	struct path *path;	/* the last one copied; NULL: none since the last clear */
	struct tcp *tcp;	/* the same */
};

void path_copies_release(struct path_copies *copies);

/* Forgets the copies and keeps their storage. */
void path_copies_clear(struct path_copies *copies);

/*
 * A copy of the span's path, which stays where it is until the next clear. To be called for the steps of a program in
 * their order: pieces of one move share a copy.
 */
const struct path *path_copies_add(struct path_copies *copies, const struct span *span);

#endif
