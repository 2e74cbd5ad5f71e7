#include "geom/weld.h"

#include <stdlib.h>
#include <string.h>

#include "base/mem.h"

/*
 * Equal corners and sides are found by sorting 64-bit keys, one for each corner or side, never by a hash table: no file
 * can make this slow.
 */

/* Buckets with at most this number of keys are sorted by insertion. */
enum { FEW_KEYS = 24 };

static int compare_keys(const void *a, const void *b)
{
	const uint64_t *p = a, *q = b;

	return *p < *q ? -1 : *p > *q;
}

static void sort_bucket(uint64_t *keys, size_t count)
{
	if (count > FEW_KEYS) {
		qsort(keys, count, sizeof(*keys), compare_keys);
		return;
	}
	for (size_t i = 1; i < count; i++) {
		uint64_t key = keys[i];
		size_t at = i;

		for (; at > 0 && keys[at - 1] > key; at--)
			keys[at] = keys[at - 1];
		keys[at] = key;
	}
}

/* The upper bits of a key give its bucket, one of about count / 4. */
void soup_sort_keys(struct soup *soup, size_t count, int bits)
{
	uint64_t *const sorted = soup->scratch;
	int bucket_bits = 1, shift;
	size_t buckets, first = 0;
	uint32_t *end;

	while (bucket_bits < 32 && count >> (bucket_bits + 2))
		bucket_bits++;
	shift = bits - bucket_bits;
	buckets = (size_t)1 << bucket_bits;
	end = mem_zalloc(buckets + 1, sizeof(*end));
	for (size_t i = 0; i < count; i++)
		end[(soup->keys[i] >> shift) + 1]++;
	for (size_t b = 0; b < buckets; b++)
		end[b + 1] += end[b];
	/* end[b] is the position of the next key of bucket b; after the loop it is the end of the bucket. */
	for (size_t i = 0; i < count; i++)
		sorted[end[soup->keys[i] >> shift]++] = soup->keys[i];
	for (size_t b = 0; b < buckets; b++) {
		sort_bucket(sorted + first, end[b] - first);
		first = end[b];
	}
	free(end);
	soup->scratch = soup->keys;
	soup->keys = sorted;
}

static const float *corner_at(const struct soup *soup, size_t corner)
{
	return soup->mesh->triangles[corner / 3].v[corner % 3];
}

/* The bits of a coordinate, the same for -0 as for 0. */
static uint32_t coordinate_bits(float value)
{
	uint32_t bits;

	value += 0.0f;
	memcpy(&bits, &value, sizeof(bits));
	return bits;
}

static uint32_t corner_hash(const float *v)
{
	uint64_t h = coordinate_bits(v[0]) * UINT64_C(0x9e3779b97f4a7c15);

	h = (h ^ h >> 32 ^ coordinate_bits(v[1])) * UINT64_C(0xbf58476d1ce4e5b9);
	h = (h ^ h >> 29 ^ coordinate_bits(v[2])) * UINT64_C(0x94d049bb133111eb);
	return (uint32_t)(h >> 32);
}

static int compare_coordinates(const float *a, const float *b)
{
	for (int k = 0; k < 3; k++) {
		if (a[k] < b[k] || a[k] > b[k])
			return a[k] < b[k] ? -1 : 1;
	}
	return 0;
}

struct corner {
	float v[3];
	uint32_t index;
};

static int compare_corners(const void *a, const void *b)
{
	const struct corner *p = a, *q = b;

	return compare_coordinates(p->v, q->v);
}

/* Numbers the vertices among keys[first..last): corners with one hash but different places. */
static void weld_mixed(struct soup *soup, size_t first, size_t last)
{
	struct corner *corners = mem_alloc((last - first) * sizeof(*corners));

	for (size_t i = first; i < last; i++) {
		corners[i - first].index = (uint32_t)soup->keys[i];
		memcpy(corners[i - first].v, corner_at(soup, (uint32_t)soup->keys[i]), sizeof(corners->v));
	}
	qsort(corners, last - first, sizeof(*corners), compare_corners);
	for (size_t i = 0; i < last - first; i++) {
		if (i == 0 || compare_corners(&corners[i - 1], &corners[i]) != 0)
			soup->vertex_count++;
		soup->vertex[corners[i].index] = soup->vertex_count - 1;
	}
	free(corners);
}

static void weld(struct soup *soup)
{
	for (size_t i = 0; i < soup->corner_count; i++)
		soup->keys[i] = (uint64_t)corner_hash(corner_at(soup, i)) << 32 | i;
	soup_sort_keys(soup, soup->corner_count, 64);
	for (size_t first = 0, last; first < soup->corner_count; first = last) {
		const float *place = corner_at(soup, (uint32_t)soup->keys[first]);
		uint64_t hash = soup->keys[first] >> 32;
		bool mixed = false;

		for (last = first; last < soup->corner_count && soup->keys[last] >> 32 == hash; last++) {
			mixed |= compare_coordinates(place, corner_at(soup, (uint32_t)soup->keys[last])) != 0;
			soup->vertex[(uint32_t)soup->keys[last]] = soup->vertex_count;
		}
		if (mixed)
			weld_mixed(soup, first, last);
		else
			soup->vertex_count++;
	}
}

void soup_init(struct soup *soup, const struct mesh *mesh)
{
	*soup = (struct soup){.mesh = mesh, .corner_count = 3 * mesh->count};
	soup->vertex = mem_alloc(soup->corner_count * sizeof(*soup->vertex));
	soup->keys = mem_alloc(soup->corner_count * sizeof(*soup->keys));
	soup->scratch = mem_alloc(soup->corner_count * sizeof(*soup->scratch));
	weld(soup);
}

void soup_release(struct soup *soup)
{
	free(soup->vertex);
	free(soup->keys);
	free(soup->scratch);
	*soup = (struct soup){0};
}
