/* event_queue.h - a bounded queue from the thread that reads a program to the thread that checks it. */
#ifndef FIVECHECK_CHECK_EVENT_QUEUE_H
#define FIVECHECK_CHECK_EVENT_QUEUE_H

#include <stdbool.h>

#include "base/callbacks.h"
#include "base/diag.h"
#include "motion/events.h"

/* Holds motion events, diagnostics and names of opened files in the order in which they came, as copies. */
struct event_queue;

struct event_queue *event_queue_new(void);
void event_queue_free(struct event_queue *queue);

/*
 * For the reading thread. Where the queue is full, it waits until the receiver has taken something. False: the
 * receiver has stopped, and nothing more will be taken.
 */
bool event_queue_add(struct event_queue *queue, const struct motion_event *event);

/* The same for what may be told between events, without waiting. */
void event_queue_add_diag(struct event_queue *queue, const struct diag_entry *entry);
void event_queue_add_opened(struct event_queue *queue, const char *path);

/* Nothing more will come. */
void event_queue_end(struct event_queue *queue);

/* Who is told what is in the queue. All pointers are borrowed. */
struct event_receiver {
	const struct motion_sink *sink;
	struct diag *diag;
	const struct file_opened *opened;	/* NULL: nobody; then no opened file may be in the queue */
};

/* For the checking thread: tells the receiver everything until event_queue_end. False: the sink said stop before. */
bool event_queue_receive(struct event_queue *queue, const struct event_receiver *receiver);

#endif
