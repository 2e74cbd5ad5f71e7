/* interval_pool.h - storage for the intervals of a sweep; few are needed at a time. */
#ifndef FIVECHECK_SCENE_INTERVAL_POOL_H
#define FIVECHECK_SCENE_INTERVAL_POOL_H

#include <stddef.h>

#include "scene/motion_interval.h"

/*
 * An interval is kept as long as it has users: entries of the traversal's stack, and its own halves. All zero is ready.
 */
struct interval_pool {
	struct motion_interval **all;
	size_t count, capacity;
	struct motion_interval *spare;	/* those without users, linked by halves[0] */
};

/* An interval with one user, the caller; the caller fills it in. */
struct motion_interval *interval_pool_take(struct interval_pool *pool);

/* The same with the contents of *other, except its halves. */
struct motion_interval *interval_pool_copy(struct interval_pool *pool, const struct motion_interval *other);

/* Adds a user. */
static inline void interval_pool_share(struct motion_interval *interval)
{
	interval->users++;
}

/* Removes a user. An interval without users becomes spare and no longer uses its halves. */
void interval_pool_leave(struct interval_pool *pool, struct motion_interval *interval);

/* Frees all intervals, including those with users. */
void interval_pool_release(struct interval_pool *pool);

#endif
