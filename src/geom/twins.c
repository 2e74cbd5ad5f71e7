#include "geom/twins.h"

#include <stdbool.h>
#include <stdlib.h>

#include "base/mem.h"

struct place {
	uint32_t v[3];	/* the vertices, the least first */
	uint32_t triangle;
	bool back;	/* v is an odd permutation of the triangle's corners */
};

static void order(struct place *place, int i, int j)
{
	uint32_t swap = place->v[i];

	if (place->v[i] <= place->v[j])
		return;
	place->v[i] = place->v[j];
	place->v[j] = swap;
	place->back = !place->back;
}

static struct place place_of(const struct soup *soup, size_t triangle)
{
	const uint32_t *v = &soup->vertex[3 * triangle];
	struct place place = {{v[0], v[1], v[2]}, (uint32_t)triangle, false};

	order(&place, 0, 1);
	order(&place, 1, 2);
	order(&place, 0, 1);
	return place;
}

/* Hash and triangle in one key. Equal places have equal hashes; different places may have, too. */
static uint64_t place_key(const struct place *place)
{
	uint64_t h = place->v[0] * UINT64_C(0x9e3779b97f4a7c15);

	h = (h ^ h >> 32 ^ place->v[1]) * UINT64_C(0xbf58476d1ce4e5b9);
	h = (h ^ h >> 29 ^ place->v[2]) * UINT64_C(0x94d049bb133111eb);
	return (h >> 32) << 32 | place->triangle;
}

static int compare_vertices(const struct place *a, const struct place *b)
{
	for (int k = 0; k < 3; k++) {
		if (a->v[k] != b->v[k])
			return a->v[k] < b->v[k] ? -1 : 1;
	}
	return 0;
}

static int compare_places(const void *a, const void *b)
{
	const struct place *p = a, *q = b;
	int order_of_vertices = compare_vertices(p, q);

	if (order_of_vertices)
		return order_of_vertices;
	return p->triangle < q->triangle ? -1 : p->triangle > q->triangle;
}

/* Pairs up the triangles in one place; returns the number of dropped ones. */
static size_t pair_up(const struct place *places, size_t count, uint8_t *twins)
{
	size_t sides[2] = {0, 0}, pairs, left[2], dropped = 0;
	bool kept;

	for (size_t i = 0; i < count; i++)
		sides[places[i].back]++;
	pairs = sides[0] < sides[1] ? sides[0] : sides[1];
	left[0] = left[1] = pairs;
	/* A surplus triangle represents the place itself. */
	kept = sides[0] != sides[1];
	for (size_t i = 0; i < count; i++) {
		if (!left[places[i].back])
			continue;
		left[places[i].back]--;
		twins[places[i].triangle] = kept ? TWIN_DROPPED : TWIN_KEPT;
		dropped += kept;
		kept = true;
	}
	return dropped;
}

/* The same for the triangles with one hash. */
static size_t pair_up_group(const struct soup *soup, size_t first, size_t last, uint8_t *twins)
{
	struct place *places = mem_alloc((last - first) * sizeof(*places));
	size_t dropped = 0;

	for (size_t i = first; i < last; i++)
		places[i - first] = place_of(soup, (uint32_t)soup->keys[i]);
	qsort(places, last - first, sizeof(*places), compare_places);
	for (size_t i = 0, next; i < last - first; i = next) {
		for (next = i + 1; next < last - first && compare_vertices(&places[i], &places[next]) == 0;)
			next++;
		dropped += pair_up(&places[i], next - i, twins);
	}
	free(places);
	return dropped;
}

size_t twins_find(struct soup *soup, uint8_t *twins)
{
	size_t count = 0, dropped = 0;

	for (size_t t = 0; t < soup->mesh->count; t++) {
		struct place place = place_of(soup, t);

		if (!soup_is_degenerate(soup, t))
			soup->keys[count++] = place_key(&place);
	}
	soup_sort_keys(soup, count, 64);
	for (size_t first = 0, last; first < count; first = last) {
		for (last = first + 1; last < count && soup->keys[last] >> 32 == soup->keys[first] >> 32;)
			last++;
		if (last - first > 1)
			dropped += pair_up_group(soup, first, last, twins);
	}
	return dropped;
}
