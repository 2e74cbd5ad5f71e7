#include "machine/doubt.h"

#include <stdlib.h>

#include "base/mem.h"

void doubts_add(struct doubts *doubts, const struct doubt *doubt)
{
	doubts->items = mem_grow(doubts->items, &doubts->capacity, doubts->count + 1, sizeof(*doubts->items));
	doubts->items[doubts->count++] = *doubt;
}

void doubts_add_all(struct doubts *doubts, const struct doubts *others)
{
	for (size_t i = 0; i < others->count; i++)
		doubts_add(doubts, &others->items[i]);
}

void doubts_release(struct doubts *doubts)
{
	free(doubts->items);
	*doubts = (struct doubts){0};
}
