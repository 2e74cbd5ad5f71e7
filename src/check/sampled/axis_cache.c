#include "check/sampled/axis_cache.h"

#include <stdlib.h>

#include "base/mem.h"

/* Open addressing; a slot is taken when its motion is the current one. */
struct slot {
	uint64_t key;
	uint64_t motion;
	size_t entry;
};

struct axis_cache {
	struct slot *slots;
	size_t slot_count;	/* a power of two */
	struct axis_pair *entries;
	size_t count, capacity;
	uint64_t motion;
};

struct axis_cache *axis_cache_new(void)
{
	struct axis_cache *cache = mem_zalloc(1, sizeof(*cache));

	cache->slot_count = 1024;
	cache->slots = mem_zalloc(cache->slot_count, sizeof(*cache->slots));
	cache->motion = 1;
	return cache;
}

void axis_cache_free(struct axis_cache *cache)
{
	if (!cache)
		return;
	free(cache->slots);
	free(cache->entries);
	free(cache);
}

void axis_cache_clear(struct axis_cache *cache)
{
	cache->motion++;
	cache->count = 0;
}

static uint64_t key_of(uint32_t i, uint32_t j)
{
	return (uint64_t)i << 32 | j;
}

/* The slot of the key, or the free slot for it. */
static struct slot *slot_for(const struct axis_cache *cache, uint64_t key)
{
	size_t at = (size_t)(key * 0x9e3779b97f4a7c15u >> 20);

	for (;; at++) {
		struct slot *slot = &cache->slots[at & (cache->slot_count - 1)];

		if (slot->motion != cache->motion || slot->key == key)
			return slot;
	}
}

static void grow(struct axis_cache *cache)
{
	struct slot *old = cache->slots;
	size_t old_count = cache->slot_count;

	cache->slot_count *= 2;
	cache->slots = mem_zalloc(cache->slot_count, sizeof(*cache->slots));
	for (size_t i = 0; i < old_count; i++)
		if (old[i].motion == cache->motion)
			*slot_for(cache, old[i].key) = old[i];
	free(old);
}

const struct axis_pair *axis_cache_find(const struct axis_cache *cache, uint32_t i, uint32_t j)
{
	const struct slot *slot = slot_for(cache, key_of(i, j));

	return slot->motion == cache->motion ? &cache->entries[slot->entry] : NULL;
}

struct axis_pair *axis_cache_add(struct axis_cache *cache, uint32_t i, uint32_t j)
{
	struct slot *slot;

	if (2 * (cache->count + 1) > cache->slot_count)
		grow(cache);
	cache->entries = mem_grow(cache->entries, &cache->capacity, cache->count + 1, sizeof(*cache->entries));
	slot = slot_for(cache, key_of(i, j));
	*slot = (struct slot){key_of(i, j), cache->motion, cache->count};
	return &cache->entries[cache->count++];
}

void paper_axes(const tri *a, const tri *b, vec3 axes[PAPER_AXES])
{
	vec3 ea[3], eb[3];

	for (int i = 0; i < 3; i++) {
		ea[i] = vec3_sub(a->p[(i + 1) % 3], a->p[i]);
		eb[i] = vec3_sub(b->p[(i + 1) % 3], b->p[i]);
	}
	axes[0] = vec3_cross(ea[0], ea[1]);
	axes[1] = vec3_cross(eb[0], eb[1]);
	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 3; j++)
			axes[2 + 3 * i + j] = vec3_cross(ea[i], eb[j]);
}
