#include "check/journal.h"

#include <stdlib.h>
#include <string.h>

#include "base/mem.h"

void journal_release(struct journal *journal)
{
	free(journal->blocks);
	free(journal->rooms);
	free(journal->out);
	strbuf_release(&journal->files);
	*journal = (struct journal){0};
}

void journal_add_room(struct journal *journal, long block, const struct check_room *room)
{
	journal->rooms = mem_grow(journal->rooms, &journal->room_capacity, journal->room_count + 1,
				  sizeof(*journal->rooms));
	journal->rooms[journal->room_count++] = (struct journal_room){block, *room};
}

/* The name's offset; blocks of one file follow each other. */
static size_t keep_file(struct journal *journal, const char *file)
{
	size_t at = journal->block_count ? journal->blocks[journal->block_count - 1].file : 0;

	if (journal->block_count && !strcmp(journal->files.text + at, file))
		return at;
	at = journal->files.length;
	strbuf_add(&journal->files, file, strlen(file) + 1);
	return at;
}

void journal_close_block(struct journal *journal, const struct journal_block *block, const char *file)
{
	struct journal_block copy = *block;

	copy.file = keep_file(journal, file);
	journal->blocks = mem_grow(journal->blocks, &journal->block_capacity, journal->block_count + 1,
				   sizeof(*journal->blocks));
	journal->blocks[journal->block_count++] = copy;
}

static int compare(const void *a, const void *b)
{
	const struct journal_room *x = a, *y = b;

	if (x->block != y->block)
		return x->block < y->block ? -1 : 1;
	return (x->room.pair > y->room.pair) - (x->room.pair < y->room.pair);
}

/* Gathers the rooms of one block, each pair once, from those at *next on. */
static size_t gather(struct journal *journal, long block, size_t *next)
{
	size_t count = 0;

	for (; *next < journal->room_count && journal->rooms[*next].block <= block; ++*next) {
		const struct check_room *room = &journal->rooms[*next].room;

		if (count && journal->out[count - 1].pair == room->pair) {
			if (room->clearance < journal->out[count - 1].clearance)
				journal->out[count - 1] = *room;
			continue;
		}
		journal->out = mem_grow(journal->out, &journal->out_capacity, count + 1, sizeof(*journal->out));
		journal->out[count++] = *room;
	}
	return count;
}

/* The blocks in the journal have been dealt with; rooms from `next` on are of a block that is not complete. */
static void forget(struct journal *journal, size_t next)
{
	journal->room_count -= next;
	if (journal->room_count)
		memmove(journal->rooms, journal->rooms + next, journal->room_count * sizeof(*journal->rooms));
	journal->block_count = 0;
	strbuf_clear(&journal->files);
}

void journal_emit(struct journal *journal, long last, const struct check_sink *sink)
{
	size_t next = 0;

	if (journal->room_count)
		qsort(journal->rooms, journal->room_count, sizeof(*journal->rooms), compare);
	for (size_t i = 0; i < journal->block_count; i++) {
		const struct journal_block *block = &journal->blocks[i];
		size_t count = gather(journal, block->block, &next);
		struct check_block out = {
			.file = journal->files.text + block->file, .line = block->line, .number = block->block + 1,
			.seconds = block->seconds, .steps = block->steps, .interpret = block->interpret,
			.check = block->check, .rooms = journal->out, .room_count = count,
		};

		if (block->block <= last)
			sink->block(sink->context, &out);
	}
	forget(journal, next);
}
