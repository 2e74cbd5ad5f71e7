#include "stock/cut_log.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#include "base/mem.h"
#include "base/same_double.h"

void cut_log_init(struct cut_log *log, const struct cutter *cutters)
{
	*log = (struct cut_log){.cutters = cutters, .store = mem_zalloc(1, sizeof(*log->store))};
	cut_store_init(log->store, CUT_STORE_CHUNKS);
}

void cut_log_release(struct cut_log *log)
{
	if (log->store)
		cut_store_release(log->store);
	free(log->store);
	free(log->starts);
	for (int level = 0; level < CUT_LEVELS; level++)
		free(log->boxes[level]);
	*log = (struct cut_log){.store = NULL};
}

int cut_log_fault(const struct cut_log *log)
{
	return log->store ? log->store->fault : 0;
}

static bool same_place(const struct cutter_place *a, const struct cutter_place *b)
{
	return same_vec3(a->origin, b->origin) && same_vec3(a->up, b->up);
}

static struct cut_chunk *new_chunk(struct cut_log *log, int cutter, double start)
{
	struct cut_chunk *chunk = cut_store_add(log->store);

	log->starts = mem_grow(log->starts, &log->start_capacity, log->store->count, sizeof(*log->starts));
	log->starts[log->store->count - 1] = start;
	chunk->cutter = cutter;
	chunk->ends[0].time = start;
	return chunk;
}

/* The chunk that the cut continues, or a new one. */
static struct cut_chunk *chunk_for(struct cut_log *log, const struct cut *cut)
{
	struct cut_chunk *last = cut_store_last(log->store);

	if (last && !last->region && last->cutter == cut->cutter && last->count < CUT_CHUNK &&
	    same_double(last->ends[last->count].time, cut->from) &&
	    same_place(&last->ends[last->count].place, &cut->way.from))
		return last;
	last = new_chunk(log, cut->cutter, cut->from);
	last->ends[0].place = cut->way.from;
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

/* Widens the boxes of the last chunk. */
static void widen_all(struct cut_log *log, vec3 low, vec3 high)
{
	size_t number = log->store->count - 1;

	for (int level = 0; level < CUT_LEVELS; level++) {
		widen(log, level, number, low, high);
		number /= CUT_FAN;
	}
}

void cut_log_add(struct cut_log *log, const struct cut *cut)
{
	struct cut_chunk *chunk = chunk_for(log, cut);
	const vec3 error = {cut->error, cut->error, cut->error};
	vec3 low, high;

	chunk->ends[++chunk->count] = (struct cut_end){cut->way.to, cut->to, cut->error};
	cutter_way_bounds(&log->cutters[cut->cutter], &cut->way, &low, &high);
	widen_all(log, vec3_sub(low, error), vec3_add(high, error));
}

void cut_log_add_region(struct cut_log *log, const struct cut_region *region)
{
	struct cut_chunk *chunk = new_chunk(log, region->cutter, region->from);

	chunk->region = true;
	chunk->count = 1;
	chunk->ends[1].time = region->to;
	widen_all(log, region->low, region->high);
}

/* The number of cuts of the chunk that begin before the time. */
static int cuts_before(const struct cut_chunk *chunk, double time)
{
	int count = 0;

	while (count < chunk->count && chunk->ends[count].time < time)
		count++;
	return count;
}

uint64_t cut_log_end(const struct cut_log *log, double time)
{
	size_t low = 0, high = log->store->count;

	/* Find the number of chunks that begin before the time. */
	while (low < high) {
		const size_t middle = low + (high - low) / 2;

		if (log->starts[middle] < time)
			low = middle + 1;
		else
			high = middle;
	}
	if (!low)
		return 0;
	return (uint64_t)(low - 1) * CUT_CHUNK + (uint64_t)cuts_before(cut_store_get(log->store, low - 1), time);
}

static bool holds(const struct cut_box *box, vec3 low, vec3 high)
{
	return low.x >= box->low.x && high.x <= box->high.x && low.y >= box->low.y && high.y <= box->high.y &&
	       low.z >= box->low.z && high.z <= box->high.z;
}

static bool holds_cube(const struct cut_box *box, const struct cube *cube)
{
	const vec3 half = {cube->half, cube->half, cube->half};

	return holds(box, vec3_sub(cube->centre, half), vec3_add(cube->centre, half));
}

/* The number of places of the log, one for each cut, below a box of this level. */
static uint64_t places_below(int level)
{
	uint64_t span = CUT_CHUNK;

	for (int i = 0; i < level; i++)
		span *= CUT_FAN;
	return span;
}

static double search_chunk(const struct cut_log *log, size_t number, const struct cube *cube, uint64_t from,
			   uint64_t end)
{
	const struct cut_chunk *chunk = cut_store_get(log->store, number);
	const uint64_t first = (uint64_t)number * CUT_CHUNK;

	if (chunk->region)
		return INFINITY;
	for (int i = from > first ? (int)(from - first) : 0; i < chunk->count && first + (uint64_t)i < end; i++) {
		const struct cut_end *a = &chunk->ends[i], *b = &chunk->ends[i + 1];
		const struct cutter_way way = {a->place, b->place};
		const double s = cutter_removes(&log->cutters[chunk->cutter], &way, cube, b->error);

		if (s <= 1)
			return a->time + s * (b->time - a->time);
	}
	return INFINITY;
}

/* Searches all chunks below a box, earliest first; the recursion is as deep as the levels. */
static double search_box(const struct cut_log *log, int level, size_t number, const struct cube *cube, uint64_t from,
			 uint64_t end)
{
	const uint64_t span = places_below(level);
	double found = INFINITY;

	if ((number + 1) * span <= from || number * span >= end || !holds_cube(&log->boxes[level][number], cube))
		return INFINITY;
	if (level == 0)
		return search_chunk(log, number, cube, from, end);
	for (size_t i = number * CUT_FAN; i < (number + 1) * CUT_FAN && i < log->box_count[level - 1] && isinf(found);
	     i++)
		found = search_box(log, level - 1, i, cube, from, end);
	return found;
}

/* The lowest level that has few boxes. */
static int top_level(const struct cut_log *log)
{
	int top = 0;

	while (top + 1 < CUT_LEVELS && log->box_count[top] > 1)
		top++;
	return top;
}

double cut_log_search(const struct cut_log *log, const struct cube *cube, uint64_t *place, uint64_t end)
{
	const int top = top_level(log);
	double found = INFINITY;

	if (*place >= end)
		return INFINITY;
	for (size_t i = 0; i < log->box_count[top] && isinf(found); i++)
		found = search_box(log, top, i, cube, *place, end);
	if (isinf(found))
		*place = end;
	return found;
}

/* A query about a part of a cell. */
struct part_query {
	const struct cut_log *log;
	const struct cell_part *part;
	double time;
	uint64_t end;
	size_t *chunk;
};

static bool chunk_removes(const struct part_query *query, size_t number)
{
	const struct cut_chunk *chunk = cut_store_get(query->log->store, number);
	const uint64_t first = (uint64_t)number * CUT_CHUNK;

	if (chunk->region)
		return false;
	for (int i = 0; i < chunk->count && first + (uint64_t)i < query->end; i++) {
		const struct cut_end *a = &chunk->ends[i], *b = &chunk->ends[i + 1];
		const struct cutter_way way = {a->place, b->place};
		const double latest = b->time > query->time ? (query->time - a->time) / (b->time - a->time) : 1;

		if (cutter_removes_part(&query->log->cutters[chunk->cutter], &way, query->part, b->error, latest)) {
			*query->chunk = number;
			return true;
		}
	}
	return false;
}

/* Searches below a box; the recursion is as deep as the levels. */
static bool box_removes(const struct part_query *query, int level, size_t number)
{
	const struct cut_log *log = query->log;

	if (number * places_below(level) >= query->end ||
	    !holds(&log->boxes[level][number], query->part->low, query->part->high))
		return false;
	if (level == 0)
		return chunk_removes(query, number);
	for (size_t i = number * CUT_FAN; i < (number + 1) * CUT_FAN && i < log->box_count[level - 1]; i++)
		if (box_removes(query, level - 1, i))
			return true;
	return false;
}

bool cut_log_removes_part(const struct cut_log *log, const struct cell_part *part, double time, uint64_t end,
			  size_t *chunk)
{
	const struct part_query query = {log, part, time, end, chunk};
	const int top = top_level(log);

	if (!end)
		return false;
	if (*chunk < log->store->count && box_removes(&query, 0, *chunk))
		return true;
	for (size_t i = 0; i < log->box_count[top]; i++)
		if (box_removes(&query, top, i))
			return true;
	return false;
}

/* A query about a ball. */
struct ball_query {
	const struct cut_log *log;
	vec3 centre;
	double radius;
	double time;
};

static bool touches(const struct cut_box *box, const struct ball_query *query)
{
	const vec3 c = query->centre;
	const double r = query->radius;

	return c.x + r >= box->low.x && c.x - r <= box->high.x && c.y + r >= box->low.y && c.y - r <= box->high.y &&
	       c.z + r >= box->low.z && c.z - r <= box->high.z;
}

/* The cutter's part of the way from a to b before the time. */
static struct cutter_way way_before(const struct cut_end *a, const struct cut_end *b, double time)
{
	const double s = b->time > time ? (time - a->time) / (b->time - a->time) : 1;

	return (struct cutter_way){a->place, cutter_place_between(&a->place, &b->place, s)};
}

static bool chunk_reaches(const struct ball_query *query, size_t number)
{
	const struct cut_chunk *chunk = cut_store_get(query->log->store, number);
	const int count = cuts_before(chunk, query->time);

	if (chunk->region)
		return count > 0;
	for (int i = 0; i < count; i++) {
		const struct cutter_way way = way_before(&chunk->ends[i], &chunk->ends[i + 1], query->time);

		if (cutter_comes_within(&query->log->cutters[chunk->cutter], &way, query->centre,
					query->radius + chunk->ends[i + 1].error))
			return true;
	}
	return false;
}

/* Searches below a box; the recursion is as deep as the levels. */
static bool box_reaches(const struct ball_query *query, int level, size_t number)
{
	const struct cut_log *log = query->log;
	size_t first = number;

	for (int i = 0; i < level; i++)
		first *= CUT_FAN;
	if (!(log->starts[first] < query->time) || !touches(&log->boxes[level][number], query))
		return false;
	if (level == 0)
		return chunk_reaches(query, number);
	for (size_t i = number * CUT_FAN; i < (number + 1) * CUT_FAN && i < log->box_count[level - 1]; i++)
		if (box_reaches(query, level - 1, i))
			return true;
	return false;
}

bool cut_log_reaches(const struct cut_log *log, vec3 centre, double radius, double time)
{
	const struct ball_query query = {log, centre, radius, time};
	const int top = top_level(log);

	for (size_t i = 0; i < log->box_count[top]; i++)
		if (box_reaches(&query, top, i))
			return true;
	return false;
}
