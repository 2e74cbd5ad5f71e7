/* event_copies.h - copies of a program's events, to be sent later. */
#ifndef FIVECHECK_CHECK_EVENT_COPIES_H
#define FIVECHECK_CHECK_EVENT_COPIES_H

#include <stddef.h>

#include "base/arena.h"
#include "check/path_copies.h"
#include "motion/events.h"

/* All zero is empty. */
struct event_copies {
	struct motion_event *events;
	size_t count, capacity;
	struct path_copies paths;
	struct arena texts;	/* of blocks, with their callers */
};

void event_copies_release(struct event_copies *copies);

/* Copies the event and everything that it points to. */
void event_copies_add(struct event_copies *copies, const struct motion_event *event);

/* Sends the events to the sink in their order, whatever it answers, and removes them. */
void event_copies_tell(struct event_copies *copies, const struct motion_sink *sink);

#endif
