#include "stock/cut_log.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#include "base/mem.h"
#include "base/same_double.h"

void cut_log_init(struct cut_log *log, const struct cutter *cutters)
{
	*log = (struct cut_log){.cutters = cutters};
}

void cut_log_release(struct cut_log *log)
{
	free(log->chunks);
	for (int level = 0; level < CUT_LEVELS; level++)
		free(log->boxes[level]);
	*log = (struct cut_log){.chunk_count = 0};
}

static bool same_place(const struct cutter_place *a, const struct cutter_place *b)
{
	return same_double(a->origin.x, b->origin.x) && same_double(a->origin.y, b->origin.y) &&
	       same_double(a->origin.z, b->origin.z) && same_double(a->up.x, b->up.x) &&
	       same_double(a->up.y, b->up.y) && same_double(a->up.z, b->up.z);
}

/* The chunk that the cut continues, or a new one. */
static struct cut_chunk *chunk_for(struct cut_log *log, const struct cut *cut)
{
	struct cut_chunk *last = log->chunk_count ? &log->chunks[log->chunk_count - 1] : NULL;

	if (last && last->cutter == cut->cutter && last->count < CUT_CHUNK &&
	    same_double(last->ends[last->count].time, cut->from) &&
	    same_place(&last->ends[last->count].place, &cut->way.from))
		return last;
	log->chunks = mem_grow(log->chunks, &log->chunk_capacity, log->chunk_count + 1, sizeof(*log->chunks));
	last = &log->chunks[log->chunk_count++];
	last->cutter = cut->cutter;
	last->count = 0;
	last->ends[0] = (struct cut_end){cut->way.from, cut->from, 0};
	return last;
}

static void widen(struct cut_log *log, int level, size_t number, vec3 low, vec3 high)
{
	struct cut_box *box;

	if (number == log->box_count[level]) {
		log->boxes[level] = mem_grow(log->boxes[level], &log->box_capacity[level], number + 1,
					     sizeof(*log->boxes[level]));
		log->boxes[level][number] = (struct cut_box){low, high};
		log->box_count[level]++;
		return;
	}
	box = &log->boxes[level][number];
	box->low = vec3_min(box->low, low);
	box->high = vec3_max(box->high, high);
}

void cut_log_add(struct cut_log *log, const struct cut *cut)
{
	struct cut_chunk *chunk = chunk_for(log, cut);
	const struct cutter *cutter = &log->cutters[cut->cutter];
	size_t number = log->chunk_count - 1;
	vec3 low, high, other_low, other_high;

	chunk->ends[++chunk->count] = (struct cut_end){cut->way.to, cut->to, cut->error};
	cutter_bounds(cutter, &cut->way.from, &low, &high);
	cutter_bounds(cutter, &cut->way.to, &other_low, &other_high);
	low = vec3_min(low, other_low);
	high = vec3_max(high, other_high);
	for (int level = 0; level < CUT_LEVELS; level++) {
		widen(log, level, number, low, high);
		number /= CUT_FAN;
	}
}

uint64_t cut_log_end(const struct cut_log *log, double time)
{
	size_t low = 0, high = log->chunk_count;

	/* The chunks that begin before the time. */
	while (low < high) {
		const size_t middle = low + (high - low) / 2;

		if (log->chunks[middle].ends[0].time < time)
			low = middle + 1;
		else
			high = middle;
	}
	if (!low)
		return 0;
	for (int i = 0; i < log->chunks[low - 1].count; i++) {
		if (!(log->chunks[low - 1].ends[i].time < time))
			return (uint64_t)(low - 1) * CUT_CHUNK + (uint64_t)i;
	}
	return (uint64_t)(low - 1) * CUT_CHUNK + (uint64_t)log->chunks[low - 1].count;
}

static bool holds(const struct cut_box *box, const struct cube *cube)
{
	const vec3 c = cube->centre;
	const double h = cube->half;

	return c.x - h >= box->low.x && c.x + h <= box->high.x && c.y - h >= box->low.y && c.y + h <= box->high.y &&
	       c.z - h >= box->low.z && c.z + h <= box->high.z;
}

static double search_chunk(const struct cut_log *log, size_t number, const struct cube *cube, uint64_t from,
			   uint64_t end)
{
	const struct cut_chunk *chunk = &log->chunks[number];
	const uint64_t first = (uint64_t)number * CUT_CHUNK;

	for (int i = from > first ? (int)(from - first) : 0; i < chunk->count && first + (uint64_t)i < end; i++) {
		const struct cut_end *a = &chunk->ends[i], *b = &chunk->ends[i + 1];
		const struct cutter_way way = {a->place, b->place};
		const double s = cutter_removes(&log->cutters[chunk->cutter], &way, cube, b->error);

		if (s <= 1)
			return a->time + s * (b->time - a->time);
	}
	return INFINITY;
}

/* Searches all chunks below a box, earliest first; as deep as the levels. */
static double search_box(const struct cut_log *log, int level, size_t number, const struct cube *cube, uint64_t from,
			 uint64_t end)
{
	uint64_t span = CUT_CHUNK;
	double found = INFINITY;

	for (int i = 0; i < level; i++)
		span *= CUT_FAN;
	if ((number + 1) * span <= from || number * span >= end || !holds(&log->boxes[level][number], cube))
		return INFINITY;
	if (level == 0)
		return search_chunk(log, number, cube, from, end);
	for (size_t i = number * CUT_FAN; i < (number + 1) * CUT_FAN && i < log->box_count[level - 1] && isinf(found);
	     i++)
		found = search_box(log, level - 1, i, cube, from, end);
	return found;
}

double cut_log_search(const struct cut_log *log, const struct cube *cube, uint64_t *place, uint64_t end)
{
	double found = INFINITY;
	int top = 0;

	if (*place >= end)
		return INFINITY;
	while (top + 1 < CUT_LEVELS && log->box_count[top] > 1)
		top++;
	for (size_t i = 0; i < log->box_count[top] && isinf(found); i++)
		found = search_box(log, top, i, cube, *place, end);
	if (isinf(found))
		*place = end;
	return found;
}
