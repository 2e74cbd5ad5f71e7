#include "check/event_copies.h"

#include <stdlib.h>

#include "base/mem.h"

void event_copies_release(struct event_copies *copies)
{
	free(copies->events);
	path_copies_release(&copies->paths);
	arena_release(&copies->texts);
	*copies = (struct event_copies){0};
}

static void keep_block(struct event_copies *copies, struct motion_block *block)
{
	block->text = block->text ? arena_strdup(&copies->texts, block->text) : NULL;
	if (block->caller_count)
		block->callers =
		    arena_copy(&copies->texts, block->callers, block->caller_count * sizeof(*block->callers));
}

void event_copies_add(struct event_copies *copies, const struct motion_event *event)
{
	struct motion_event *copy;

	copies->events = mem_grow(copies->events, &copies->capacity, copies->count + 1, sizeof(*copies->events));
	copy = &copies->events[copies->count++];
	*copy = *event;
	if (event->kind == MOTION_STEP)
		copy->of.step.span.path = path_copies_add(&copies->paths, &event->of.step.span);
	else if (event->kind == MOTION_BLOCK)
		keep_block(copies, &copy->of.block);
}

void event_copies_tell(struct event_copies *copies, const struct motion_sink *sink)
{
	for (size_t i = 0; i < copies->count; i++)
		sink->event(sink->context, &copies->events[i]);
	copies->count = 0;
	path_copies_clear(&copies->paths);
	arena_clear(&copies->texts);
}
