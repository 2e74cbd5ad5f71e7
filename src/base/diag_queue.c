#include "base/diag_queue.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"

struct queued_diag {
	struct diag_entry entry;
	char *file, *text, *excerpt;	/* the entry's, owned; file and excerpt may be NULL */
	long mark, order;
	size_t number;	/* of those added before it */
};

static char *copy_of(const char *text)
{
	return text ? mem_strndup(text, strlen(text)) : NULL;
}

static void add_entry(void *context, const struct diag_entry *entry)
{
	struct diag_queue *queue = context;
	struct queued_diag *item;

	queue->items = mem_grow(queue->items, &queue->capacity, queue->count + 1, sizeof(*queue->items));
	item = &queue->items[queue->count++];
	*item = (struct queued_diag){*entry, copy_of(entry->loc.file), copy_of(entry->text), copy_of(entry->excerpt),
				     queue->mark, queue->order, queue->count - 1};
	item->entry.loc.file = item->file;
	item->entry.text = item->text;
	item->entry.excerpt = item->excerpt;
}

void diag_queue_init(struct diag_queue *queue)
{
	*queue = (struct diag_queue){.diag = {.handle = add_entry, .context = queue}};
}

static int by_mark(const void *left, const void *right)
{
	const struct queued_diag *a = left, *b = right;

	if (a->mark != b->mark)
		return a->mark < b->mark ? -1 : 1;
	if (a->order != b->order)
		return a->order < b->order ? -1 : 1;
	return (a->number > b->number) - (a->number < b->number);
}

void diag_queue_deliver(struct diag_queue *queue, struct diag *out, long last)
{
	size_t kept = 0;

	if (queue->count)
		qsort(queue->items, queue->count, sizeof(*queue->items), by_mark);
	for (size_t i = 0; i < queue->count; i++) {
		struct queued_diag *item = &queue->items[i];

		if (item->mark > last) {
			queue->items[kept] = *item;
			queue->items[kept].number = kept;
			kept++;
			continue;
		}
		if (queue->of_blocks)
			item->entry.block = item->mark + 1;
		diag_pass(out, &item->entry);
		free(item->file);
		free(item->text);
		free(item->excerpt);
	}
	queue->count = kept;
}

void diag_queue_release(struct diag_queue *queue)
{
	struct diag nowhere = {0};

	diag_queue_deliver(queue, &nowhere, LONG_MAX);
	free(queue->items);
	*queue = (struct diag_queue){0};
}
