#include "base/held.h"

#include <stdlib.h>
#include <string.h>

#include "base/mem.h"

struct held_entry {
	enum diag_severity severity;
	struct srcloc loc;
	char *file, *text, *excerpt;	/* owned; file and excerpt may be NULL */
	long block;
};

static char *copy_of(const char *text)
{
	return text ? mem_strndup(text, strlen(text)) : NULL;
}

static void hold(void *context, const struct diag_entry *entry)
{
	struct held *held = context;
	struct held_entry *copy;

	held->entries = mem_grow(held->entries, &held->capacity, held->count + 1, sizeof(*held->entries));
	copy = &held->entries[held->count++];
	*copy = (struct held_entry){entry->severity, entry->loc,	    copy_of(entry->loc.file),
				    copy_of(entry->text), copy_of(entry->excerpt), held->block};
	copy->loc.file = copy->file;
}

void held_init(struct held *held)
{
	*held = (struct held){0};
	held->diag.handle = hold;
	held->diag.context = held;
}

void held_deliver(struct held *held, struct diag *out, long last_block)
{
	for (size_t i = 0; i < held->count; i++) {
		struct held_entry *entry = &held->entries[i];

		if (entry->block <= last_block)
			diag_pass(out, &(struct diag_entry){entry->severity, entry->loc, entry->text, entry->excerpt});
		free(entry->file);
		free(entry->text);
		free(entry->excerpt);
	}
	held->count = 0;
}

void held_release(struct held *held)
{
	struct diag nowhere = {0};

	held_deliver(held, &nowhere, -1);
	free(held->entries);
	*held = (struct held){0};
}
