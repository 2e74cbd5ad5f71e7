/* event_copies.h - events of a program that are told later. */
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

/* Copies the event and all that it points to during the call. */
void event_copies_add(struct event_copies *copies, const struct motion_event *event);

/* Tells the sink the events in the order in which they came, whatever it answers, and forgets them. */
void event_copies_tell(struct event_copies *copies, const struct motion_sink *sink);

#endif
