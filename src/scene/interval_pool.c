#include "scene/interval_pool.h"

#include <stdlib.h>

#include "base/mem.h"

struct motion_interval *interval_pool_take(struct interval_pool *pool)
{
	struct motion_interval *interval = pool->spare;

	if (interval) {
		pool->spare = interval->halves[0];
	} else {
		interval = mem_alloc(sizeof(*interval));
		pool->all = mem_grow(pool->all, &pool->capacity, pool->count + 1, sizeof(struct motion_interval *));
		pool->all[pool->count++] = interval;
	}
	interval->users = 1;
	return interval;
}

struct motion_interval *interval_pool_copy(struct interval_pool *pool, const struct motion_interval *other)
{
	struct motion_interval *copy = interval_pool_take(pool);

	*copy = *other;
	copy->users = 1;
	copy->halved = false;
	return copy;
}

/* The recursion ends, because a half is smaller than the whole. */
void interval_pool_leave(struct interval_pool *pool, struct motion_interval *interval)
{
	if (--interval->users)
		return;
	if (interval->halved) {
		interval_pool_leave(pool, interval->halves[0]);
		interval_pool_leave(pool, interval->halves[1]);
	}
	interval->halves[0] = pool->spare;
	pool->spare = interval;
}

void interval_pool_release(struct interval_pool *pool)
{
	for (size_t i = 0; i < pool->count; i++)
		free(pool->all[i]);
	free(pool->all);
	*pool = (struct interval_pool){0};
}
