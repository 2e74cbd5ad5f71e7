#include "check/relay.h"

#include <pthread.h>
#include <stdatomic.h>

#include "check/tape.h"

/* Tapes between reader and listener: one is written while the other is heard. Measured: more bring nothing. */
enum { TAPES = 2 };

/* What reader and listener share; what comes after `lock` only while holding it. */
struct relay {
	const struct motion_sink *sink;
	struct diag *diag;
	const struct file_opened *opened_by;
	struct motion_summary *heard;	/* the listener's */
	struct motion_summary read;	/* the reader's */
	atomic_bool stopped;	/* by the listener */
	struct tape tapes[TAPES];	/* those from `played` to `written` are the listener's, the others the reader's */
	pthread_mutex_t lock;
	pthread_cond_t changed;
	size_t written, played;	/* tapes in all */
	bool ended;
};

/* --------------------------------------------------------------- listener */

/* The next tape to play; NULL: there are no more. */
static struct tape *next_tape(struct relay *relay)
{
	struct tape *tape;

	pthread_mutex_lock(&relay->lock);
	while (relay->played == relay->written && !relay->ended)
		pthread_cond_wait(&relay->changed, &relay->lock);
	tape = relay->played < relay->written ? &relay->tapes[relay->played % TAPES] : NULL;
	pthread_mutex_unlock(&relay->lock);
	return tape;
}

static void put_back(struct relay *relay, bool goes_on)
{
	pthread_mutex_lock(&relay->lock);
	relay->played++;
	if (!goes_on)
		relay->stopped = true;
	pthread_cond_signal(&relay->changed);
	pthread_mutex_unlock(&relay->lock);
}

static void *listen(void *context)
{
	struct relay *relay = context;
	struct tape *tape;
	bool goes_on = true;

	while (goes_on && (tape = next_tape(relay))) {
		goes_on = tape_play(tape, relay->sink, relay->diag, relay->opened_by, relay->heard);
		tape_clear(tape);
		put_back(relay, goes_on);
	}
	return NULL;
}

/* ----------------------------------------------------------------- reader */

/* The tape that is being written: nobody else counts those written. */
static struct tape *tape_of(struct relay *relay)
{
	return &relay->tapes[relay->written % TAPES];
}

/* Gives the tape to the listener and waits for an empty one. */
static void hand_on(struct relay *relay)
{
	tape_close(tape_of(relay));
	pthread_mutex_lock(&relay->lock);
	relay->written++;
	pthread_cond_signal(&relay->changed);
	while (relay->written - relay->played == TAPES && !relay->stopped)
		pthread_cond_wait(&relay->changed, &relay->lock);
	pthread_mutex_unlock(&relay->lock);
}

static bool go_on(struct relay *relay)
{
	if (tape_is_full(tape_of(relay)))
		hand_on(relay);
	return !relay->stopped;
}

static bool on_limit(void *context, const struct motion_limit *limit)
{
	struct relay *relay = context;

	tape_limit(tape_of(relay), &relay->read, limit);
	return go_on(relay);
}

static bool on_step(void *context, const struct motion_step *step)
{
	struct relay *relay = context;

	tape_step(tape_of(relay), &relay->read, step);
	return go_on(relay);
}

static bool on_tool(void *context, int tool, const axis_values *position)
{
	struct relay *relay = context;

	tape_tool(tape_of(relay), &relay->read, tool, position);
	return go_on(relay);
}

static bool on_block(void *context, const char *file, long line, const char *text, double seconds, int moves)
{
	struct relay *relay = context;

	tape_block(tape_of(relay), &relay->read, file, line, text, seconds, moves);
	return go_on(relay);
}

static void on_diag(void *context, const struct diag_entry *entry)
{
	struct relay *relay = context;

	tape_diag(tape_of(relay), entry);
}

static void on_opened(void *context, const char *path)
{
	struct relay *relay = context;

	tape_opened(tape_of(relay), path);
}

/* Lets the listener hear the rest, unless he has stopped. */
static void end(struct relay *relay)
{
	if (!relay->stopped)
		hand_on(relay);
	pthread_mutex_lock(&relay->lock);
	relay->ended = true;
	pthread_cond_signal(&relay->changed);
	pthread_mutex_unlock(&relay->lock);
}

bool relay_run(const struct machine *machine, const struct setup *setup, const struct motion_options *options,
	       FILE *in, const char *name, const struct motion_sink *sink, struct diag *diag,
	       struct motion_summary *summary)
{
	struct relay relay = {.sink = sink, .diag = diag, .opened_by = options->read.opened, .heard = summary,
			      .lock = PTHREAD_MUTEX_INITIALIZER, .changed = PTHREAD_COND_INITIALIZER};
	const struct motion_sink writer = {&relay, on_limit, on_step, on_tool, on_block};
	const struct file_opened opened = {&relay, on_opened};
	struct diag teller = {.handle = on_diag, .context = &relay};
	struct motion_options own = *options;
	pthread_t listener;
	bool ok;

	if (pthread_create(&listener, NULL, listen, &relay))
		return motion_run(machine, setup, options, in, name, sink, diag, summary);
	own.read.opened = options->read.opened ? &opened : NULL;
	ok = motion_run(machine, setup, &own, in, name, &writer, &teller, &relay.read);
	end(&relay);
	pthread_join(listener, NULL);
	for (int i = 0; i < TAPES; i++)
		tape_release(&relay.tapes[i]);
	if (!relay.stopped)
		*summary = relay.read;
	return ok && !relay.stopped;
}
