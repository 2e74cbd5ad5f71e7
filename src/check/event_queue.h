/* event_queue.h - a bounded queue from the thread that reads a program to the thread that checks it. */
#ifndef FIVECHECK_CHECK_EVENT_QUEUE_H
#define FIVECHECK_CHECK_EVENT_QUEUE_H

#include <stdbool.h>

#include "base/callbacks.h"
#include "base/diag.h"
#include "check/shared_loop.h"
#include "motion/events.h"

/* Holds motion events, diagnostics and names of opened files in the order in which they came, as copies. */
struct event_queue;

/*
 * While the reading thread waits it helps with the loop that the checking thread runs. The queue borrows the loop, and
 * uses its lock.
 */
struct event_queue *event_queue_new(struct shared_loop *loop);
void event_queue_free(struct event_queue *queue);

/* For the reading thread. It waits while the queue is full. False: the receiver has stopped and takes nothing more. */
bool event_queue_add(struct event_queue *queue, const struct motion_event *event);

/* The same for diagnostics and opened files between events. These never wait. */
void event_queue_add_diag(struct event_queue *queue, const struct diag_entry *entry);
void event_queue_add_opened(struct event_queue *queue, const char *path);

/* Nothing more will come. Returns when the receiver is done, and helps it meanwhile. */
void event_queue_end(struct event_queue *queue);

/* Receives the contents of the queue. All pointers are borrowed. */
struct event_receiver {
	const struct motion_sink *sink;
	struct diag *diag;
	const struct file_opened *opened;	/* NULL: nobody; then the queue may hold no opened file */
};

/* For the checking thread: hands everything to the receiver until event_queue_end. False: the sink stopped before. */
bool event_queue_receive(struct event_queue *queue, const struct event_receiver *receiver);

#endif
