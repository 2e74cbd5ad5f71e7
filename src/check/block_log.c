#include "check/block_log.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"

void block_log_init(struct block_log *log)
{
	*log = (struct block_log){0};
	diag_queue_init(&log->diags);
	log->diags.of_blocks = true;
}

void block_page_release(struct block_page *page)
{
	arena_release(&page->texts);
	free(page->blocks);
	*page = (struct block_page){0};
}

void block_log_release(struct block_log *log)
{
	diag_queue_release(&log->diags);
	block_page_release(&log->open);
	block_page_release(&log->page);
	free(log->findings);
	free(log->clearances);
	free(log->runs);
	free(log->out);
	*log = (struct block_log){0};
}

void block_log_begin(struct block_log *log, long block)
{
	log->diags.mark = block;
}

struct block_record *block_log_complete(struct block_log *log, const struct block_record *block)
{
	struct block_page *page = &log->open;
	struct block_record *copy;

	if (page->block_count == page->block_capacity)
		page->blocks =
		    mem_grow(page->blocks, &page->block_capacity, page->block_count + 1, sizeof(*page->blocks));
	copy = &page->blocks[page->block_count++];
	*copy = *block;
	copy->text = arena_strdup(&page->texts, block->text);
	if (block->caller_count)
		copy->callers =
		    arena_copy(&page->texts, block->callers, block->caller_count * sizeof(*block->callers));
	return copy;
}

static void swap(struct block_page *a, struct block_page *b)
{
	const struct block_page page = *a;

	*a = *b;
	*b = page;
}

void block_log_turn(struct block_log *log, struct block_page *page)
{
	swap(&log->open, page);
}

void block_log_show(struct block_log *log, struct block_page *page)
{
	swap(&log->page, page);
}

void block_log_forget(struct block_log *log)
{
	size_t kept = 0;

	if (!log->page.block_count)
		return;
	for (size_t i = 0; i < log->clearance_count; i++)
		if (log->clearances[i].last > log->page.blocks[log->page.block_count - 1].block)
			log->clearances[kept++] = log->clearances[i];
	log->clearance_count = kept;
	log->page.block_count = 0;
	arena_clear(&log->page.texts);
}

/* --------------------------------------------------------------- findings */

void block_log_add_finding(struct block_log *log, const struct block_finding *finding)
{
	log->findings = mem_grow(log->findings, &log->finding_capacity, log->finding_count + 1, sizeof(*log->findings));
	log->findings[log->finding_count] = *finding;
	log->findings[log->finding_count++].number = log->findings_added++;
}

/* No two findings are equal: sorting functions of C libraries differ in the order of equal elements. */
static int by_time(const void *left, const void *right)
{
	const struct block_finding *a = left, *b = right;

	if (a->block != b->block)
		return a->block < b->block ? -1 : 1;
	if (a->finding.time < b->finding.time || a->finding.time > b->finding.time)
		return a->finding.time < b->finding.time ? -1 : 1;
	if (a->order != b->order)
		return a->order < b->order ? -1 : 1;
	if (a->rank != b->rank)
		return a->rank < b->rank ? -1 : 1;
	return (a->number > b->number) - (a->number < b->number);
}

void block_log_sort(struct block_log *log)
{
	if (log->finding_count)
		qsort(log->findings, log->finding_count, sizeof(*log->findings), by_time);
}

static const struct block_record *find_block(const struct block_log *log, long block)
{
	if (!log->page.block_count || block < log->page.blocks[0].block ||
	    block - log->page.blocks[0].block >= (long)log->page.block_count)
		return NULL;
	return &log->page.blocks[block - log->page.blocks[0].block];
}

bool block_log_finding(const struct block_log *log, size_t i, struct finding *out)
{
	const struct block_finding *finding = &log->findings[i];
	const struct block_record *block = find_block(log, finding->block);

	if (!block)
		return false;
	*out = finding->finding;
	out->file = block->file;
	out->line = block->line;
	out->column = 1;
	out->text = block->text;
	out->moves = block->moves;
	out->callers = block->callers;
	out->caller_count = block->caller_count;
	out->fraction = block->seconds > 0 ? fmin(finding->block_time / block->seconds, 1) : 0;
	return true;
}

void block_log_drop_findings(struct block_log *log, size_t count)
{
	log->finding_count -= count;
	if (log->finding_count)
		memmove(log->findings, log->findings + count, log->finding_count * sizeof(*log->findings));
}

/* ----------------------------------------------------------- measurements */

void block_log_expect_clearances(struct block_log *log, size_t count)
{
	log->clearances = mem_grow(log->clearances, &log->clearance_capacity, log->clearance_count + count,
				   sizeof(*log->clearances));
}

void block_log_add_clearance(struct block_log *log, long block, const struct pair_clearance *least)
{
	block_log_expect_clearances(log, 1);
	block_log_add_expected(log, block, block, *least);
}

/* Divides the clearances into runs, in order of arrival. */
static void find_runs(struct block_log *log)
{
	log->run_count = 0;
	for (size_t i = 0; i < log->clearance_count; i++) {
		if (!i || log->clearances[i].block <= log->clearances[i - 1].last) {
			log->runs = mem_grow(log->runs, &log->run_capacity, log->run_count + 1, sizeof(*log->runs));
			log->runs[log->run_count++].next = i;
		}
		log->runs[log->run_count - 1].end = i + 1;
	}
}

/*
 * Inserts a clearance among the `count` ones in log->out, which are in the order of the pairs. Returns the new count.
 */
static size_t put_in(struct block_log *log, size_t count, const struct pair_clearance *least)
{
	size_t at = count;

	while (at && log->out[at - 1].pair > least->pair)
		at--;
	if (at && log->out[at - 1].pair == least->pair) {
		if (least->clearance < log->out[at - 1].clearance)
			log->out[at - 1] = *least;
		return count;
	}
	if (count == log->out_capacity)
		log->out = mem_grow(log->out, &log->out_capacity, count + 1, sizeof(*log->out));
	if (at < count)
		memmove(&log->out[at + 1], &log->out[at], (count - at) * sizeof(*log->out));
	log->out[at] = *least;
	return count + 1;
}

/* The same, faster: usually the pair comes after the others. */
static inline size_t add_to_out(struct block_log *log, size_t count, const struct pair_clearance *least)
{
	if (count == log->out_capacity || (count && log->out[count - 1].pair >= least->pair))
		return put_in(log, count, least);
	log->out[count] = *least;
	return count + 1;
}

/* Collects the clearances of one block in log->out. Each pair gets one: its smallest. */
static size_t gather(struct block_log *log, const struct block_record *of)
{
	size_t count = 0;

	for (size_t i = 0; i < log->run_count; i++) {
		struct clearance_run *run = &log->runs[i];
		const struct block_pair_clearance *it = &log->clearances[run->next], *end = &log->clearances[run->end];

		for (; it < end && it->block <= of->block; it++) {
			const bool one = it->block == it->last;

			if (it->last >= of->block && (one || of->steps))
				count = add_to_out(log, count, &it->least);
			if (it->last > of->block)
				break;
		}
		run->next = (size_t)(it - log->clearances);
	}
	return count;
}

void block_log_measured(struct block_log *log, long last, const struct check_sink *sink)
{
	if (!log->page.block_count)
		return;
	find_runs(log);
	for (size_t i = 0; i < log->page.block_count && log->page.blocks[i].block <= last; i++) {
		const struct block_record *block = &log->page.blocks[i];
		size_t count = gather(log, block);
		struct check_block out = {
			.file = block->file, .line = block->line, .number = block->block + 1,
			.seconds = block->seconds, .steps = block->steps, .interpret = block->interpret,
			.check = block->check, .clearances = log->out, .clearance_count = count,
		};

		if (block->measured)
			sink->block(sink->context, &out);
	}
}
