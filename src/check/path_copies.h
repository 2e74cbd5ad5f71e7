/* path_copies.h - copies of paths, for steps that are kept longer than their event lasts. */
#ifndef FIVECHECK_CHECK_PATH_COPIES_H
#define FIVECHECK_CHECK_PATH_COPIES_H

#include "base/arena.h"
#include "motion/span.h"

/* All zero is empty. */
struct path_copies {
	struct arena arena;
	struct path *path;	/* the last copy; NULL: none since the last clear */
	struct tcp *tcp;	/* its TCP; NULL as for path */
};

void path_copies_release(struct path_copies *copies);

/* Forgets the copies and keeps their storage. */
void path_copies_clear(struct path_copies *copies);

/*
 * A copy of the span's path; it stays in place until the next clear. Call it for the steps in the order of the program:
 * pieces of one move share a copy. Successive straight paths of one kind share one, too, because a span has the ends of
 * its straight path: only the kind of the copy is valid then.
 */
const struct path *path_copies_add(struct path_copies *copies, const struct span *span);

#endif
