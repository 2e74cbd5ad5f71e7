#include "report/html/selection.h"

#include <stdint.h>
#include <stdlib.h>

#include "base/mem.h"

struct ranked {
	size_t distance, piece;
};

static int compare(const void *a, const void *b)
{
	const struct ranked *x = a, *y = b;

	if (x->distance != y->distance)
		return x->distance < y->distance ? -1 : 1;
	return (x->piece > y->piece) - (x->piece < y->piece);
}

/* Lowers each distance to at most one more than that of the piece before, or after. */
static void spread(struct ranked *ranked, size_t pieces)
{
	for (size_t i = 1; i < pieces; i++) {
		if (ranked[i - 1].distance < SIZE_MAX && ranked[i - 1].distance + 1 < ranked[i].distance)
			ranked[i].distance = ranked[i - 1].distance + 1;
	}
	for (size_t i = pieces; i-- > 1;) {
		if (ranked[i].distance < SIZE_MAX && ranked[i].distance + 1 < ranked[i - 1].distance)
			ranked[i - 1].distance = ranked[i].distance + 1;
	}
}

void selection_order(size_t *order, size_t pieces, const size_t *marks, size_t count)
{
	struct ranked *ranked = mem_zalloc(pieces + 1, sizeof(*ranked));

	for (size_t i = 0; i < pieces; i++)
		ranked[i] = (struct ranked){SIZE_MAX, i};
	for (size_t i = 0; i < count; i++)
		ranked[marks[i]].distance = 0;
	spread(ranked, pieces);
	qsort(ranked, pieces, sizeof(*ranked), compare);
	for (size_t i = 0; i < pieces; i++)
		order[i] = ranked[i].piece;
	free(ranked);
}
