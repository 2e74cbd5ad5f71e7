#include "check/read_ahead.h"

#include <pthread.h>

#include "check/event_queue.h"

struct read_ahead {
	struct event_queue *queue;
	struct event_receiver receiver;
	bool heard;	/* the receiver got everything */
};

static void *receive(void *context)
{
	struct read_ahead *ahead = context;

	ahead->heard = event_queue_receive(ahead->queue, &ahead->receiver);
	return NULL;
}

static bool on_event(void *context, const struct motion_event *event)
{
	return event_queue_add(context, event);
}

static void on_diag(void *context, const struct diag_entry *entry)
{
	event_queue_add_diag(context, entry);
}

static void on_opened(void *context, const char *path)
{
	event_queue_add_opened(context, path);
}

bool read_ahead_run(const struct machine *machine, const struct setup *setup, const struct motion_options *options,
		    FILE *in, const char *name, const struct motion_sink *sink, struct diag *diag,
		    struct motion_summary *summary, struct shared_loop *loop)
{
	struct event_queue *queue = event_queue_new(loop);
	struct read_ahead ahead = {.queue = queue, .receiver = {sink, diag, options->read.opened}};
	const struct motion_sink to_queue = {queue, on_event};
	const struct file_opened opened_to_queue = {queue, on_opened};
	struct diag diag_to_queue = {.handle = on_diag, .context = queue};
	struct motion_options own = *options;
	struct motion_summary read;	/* *summary may be in use by the receiving thread */
	pthread_t receiver;
	bool ok;

	if (pthread_create(&receiver, NULL, receive, &ahead)) {
		event_queue_free(queue);
		return motion_run(machine, setup, options, in, name, sink, diag, summary);
	}
	own.read.opened = options->read.opened ? &opened_to_queue : NULL;
	ok = motion_run(machine, setup, &own, in, name, &to_queue, &diag_to_queue, &read);
	event_queue_end(queue);
	pthread_join(receiver, NULL);
	event_queue_free(queue);
	if (ahead.heard)
		*summary = read;
	return ok && ahead.heard;
}
