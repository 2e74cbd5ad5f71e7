#include "base/spare_threads.h"

#include <stddef.h>

void spare_threads_give(struct spare_threads *spare, int count)
{
	atomic_fetch_add(&spare->count, count);
}

bool spare_threads_take(struct spare_threads *spare)
{
	int count = spare ? atomic_load(&spare->count) : 0;

	while (count > 0 && !atomic_compare_exchange_weak(&spare->count, &count, count - 1))
		;
	return count > 0;
}
