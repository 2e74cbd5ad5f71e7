#include "check/ledger.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"

void ledger_release(struct ledger *ledger)
{
	free(ledger->entries);
	free(ledger->blocks);
	strbuf_release(&ledger->texts);
	*ledger = (struct ledger){0};
}

void ledger_add(struct ledger *ledger, const struct ledger_entry *entry)
{
	ledger->entries = mem_grow(ledger->entries, &ledger->entry_capacity, ledger->entry_count + 1,
				   sizeof(*ledger->entries));
	ledger->entries[ledger->entry_count++] = *entry;
}

/* Offset of the text, which is added. */
static size_t add_text(struct ledger *ledger, const char *text)
{
	size_t offset = ledger->texts.length;

	strbuf_add(&ledger->texts, text, strlen(text) + 1);
	return offset;
}

void ledger_close_block(struct ledger *ledger, long block, const char *file, long line, const char *text,
			double seconds, int moves)
{
	struct ledger_block new = {.block = block, .line = line, .seconds = seconds, .moves = moves};
	const struct ledger_block *last = ledger->block_count ? &ledger->blocks[ledger->block_count - 1] : NULL;

	/* Most blocks come from the same file as the one before. */
	new.file = last && !strcmp(ledger->texts.text + last->file, file) ? last->file : add_text(ledger, file);
	new.text = add_text(ledger, text);
	ledger->blocks = mem_grow(ledger->blocks, &ledger->block_capacity, ledger->block_count + 1,
				  sizeof(*ledger->blocks));
	ledger->blocks[ledger->block_count++] = new;
}

static int by_time(const void *left, const void *right)
{
	const struct ledger_entry *a = left, *b = right;

	if (a->block != b->block)
		return a->block < b->block ? -1 : 1;
	if (a->finding.time < b->finding.time || a->finding.time > b->finding.time)
		return a->finding.time < b->finding.time ? -1 : 1;
	return (a->rank > b->rank) - (a->rank < b->rank);
}

void ledger_sort(struct ledger *ledger)
{
	if (ledger->entry_count)
		qsort(ledger->entries, ledger->entry_count, sizeof(*ledger->entries), by_time);
}

static const struct ledger_block *find_block(const struct ledger *ledger, long block)
{
	if (!ledger->block_count || block < ledger->blocks[0].block ||
	    block - ledger->blocks[0].block >= (long)ledger->block_count)
		return NULL;
	return &ledger->blocks[block - ledger->blocks[0].block];
}

bool ledger_finding(const struct ledger *ledger, size_t i, struct finding *out)
{
	const struct ledger_entry *entry = &ledger->entries[i];
	const struct ledger_block *block = find_block(ledger, entry->block);

	if (!block)
		return false;
	*out = entry->finding;
	out->file = strbuf_text(&ledger->texts) + block->file;
	out->line = block->line;
	out->column = 1;
	out->text = strbuf_text(&ledger->texts) + block->text;
	out->moves = block->moves;
	out->fraction = block->seconds > 0 ? fmin(entry->block_time / block->seconds, 1) : 0;
	return true;
}

void ledger_drop(struct ledger *ledger, size_t entries)
{
	ledger->entry_count -= entries;
	if (ledger->entry_count) {
		memmove(ledger->entries, ledger->entries + entries, ledger->entry_count * sizeof(*ledger->entries));
		return;
	}
	/* Entries that are left belong to the block that is still open: no closed one is needed. */
	ledger->block_count = 0;
	strbuf_clear(&ledger->texts);
}
