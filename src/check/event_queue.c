#include "check/event_queue.h"

#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

#include "base/arena.h"
#include "base/mem.h"
#include "check/path_copies.h"

/* Parts of the queue: one is written while another is read. Measured: more gain nothing. */
enum { PARTS = 2 };

/* A part is handed over once it holds so many entries or bytes of text: smaller parts cost more locking. */
#define PART_ENTRIES 2048
#define PART_TEXT 1000000

enum entry_kind { ENTRY_EVENT, ENTRY_DIAG, ENTRY_OPENED };

struct entry {
	enum entry_kind kind;
	union {
		struct motion_event event;
		struct diag_entry diag;
		const char *path;
	} of;
};

struct part {
	struct entry *entries;
	size_t count, capacity;
	struct path_copies paths;
	struct arena texts;
	size_t text_size;	/* bytes */
};

struct event_queue {
	struct part parts[PARTS];	/* `taken` to `given` are the receiver's, the others the reader's */
	atomic_bool stopped;	/* by the receiver */
	pthread_mutex_t lock;	/* for what follows */
	pthread_cond_t changed;
	size_t given, taken;	/* parts in all */
	bool ended;
};

struct event_queue *event_queue_new(void)
{
	struct event_queue *queue = mem_zalloc(1, sizeof(*queue));

	pthread_mutex_init(&queue->lock, NULL);
	pthread_cond_init(&queue->changed, NULL);
	return queue;
}

void event_queue_free(struct event_queue *queue)
{
	for (int i = 0; i < PARTS; i++) {
		free(queue->parts[i].entries);
		path_copies_release(&queue->parts[i].paths);
		arena_release(&queue->parts[i].texts);
	}
	pthread_cond_destroy(&queue->changed);
	pthread_mutex_destroy(&queue->lock);
	free(queue);
}

/* ----------------------------------------------------------------- reader */

/* The part that is being written: only the reader changes `given`. */
static struct part *open_part(struct event_queue *queue)
{
	return &queue->parts[queue->given % PARTS];
}

static struct entry *add(struct part *part, enum entry_kind kind)
{
	part->entries = mem_grow(part->entries, &part->capacity, part->count + 1, sizeof(*part->entries));
	part->entries[part->count].kind = kind;
	return &part->entries[part->count++];
}

static const char *keep_text(struct part *part, const char *text)
{
	size_t size = text ? strlen(text) + 1 : 0;

	part->text_size += size;
	return text ? arena_copy(&part->texts, text, size) : NULL;
}

static void keep_block(struct part *part, struct motion_block *block)
{
	const size_t size = block->caller_count * sizeof(*block->callers);

	block->text = keep_text(part, block->text);
	part->text_size += size;
	if (size)
		block->callers = arena_copy(&part->texts, block->callers, size);
}

/* Gives the open part to the receiver and waits for an empty one. */
static void hand_over(struct event_queue *queue)
{
	pthread_mutex_lock(&queue->lock);
	queue->given++;
	pthread_cond_signal(&queue->changed);
	while (queue->given - queue->taken == PARTS && !queue->stopped)
		pthread_cond_wait(&queue->changed, &queue->lock);
	pthread_mutex_unlock(&queue->lock);
}

bool event_queue_add(struct event_queue *queue, const struct motion_event *event)
{
	struct part *part = open_part(queue);
	struct motion_event *copy = &add(part, ENTRY_EVENT)->of.event;

	*copy = *event;
	if (event->kind == MOTION_STEP)
		copy->of.step.span.path = path_copies_add(&part->paths, &event->of.step.span);
	else if (event->kind == MOTION_BLOCK)
		keep_block(part, &copy->of.block);
	if (part->count >= PART_ENTRIES || part->text_size >= PART_TEXT)
		hand_over(queue);
	return !queue->stopped;
}

void event_queue_add_diag(struct event_queue *queue, const struct diag_entry *entry)
{
	struct part *part = open_part(queue);
	struct diag_entry *copy = &add(part, ENTRY_DIAG)->of.diag;

	*copy = *entry;
	/* Diagnostics are few, and not all of their names are kept elsewhere. */
	copy->loc.file = keep_text(part, entry->loc.file);
	copy->text = keep_text(part, entry->text);
	copy->excerpt = keep_text(part, entry->excerpt);
}

void event_queue_add_opened(struct event_queue *queue, const char *path)
{
	struct part *part = open_part(queue);

	add(part, ENTRY_OPENED)->of.path = keep_text(part, path);
}

void event_queue_end(struct event_queue *queue)
{
	if (!queue->stopped)
		hand_over(queue);
	pthread_mutex_lock(&queue->lock);
	queue->ended = true;
	pthread_cond_signal(&queue->changed);
	pthread_mutex_unlock(&queue->lock);
}

/* --------------------------------------------------------------- receiver */

/* Waits for the next part; NULL: there are no more. */
static struct part *wait_for_part(struct event_queue *queue)
{
	struct part *part;

	pthread_mutex_lock(&queue->lock);
	while (queue->taken == queue->given && !queue->ended)
		pthread_cond_wait(&queue->changed, &queue->lock);
	part = queue->taken < queue->given ? &queue->parts[queue->taken % PARTS] : NULL;
	pthread_mutex_unlock(&queue->lock);
	return part;
}

static void give_back(struct event_queue *queue, struct part *part, bool goes_on)
{
	part->count = part->text_size = 0;
	path_copies_clear(&part->paths);
	arena_clear(&part->texts);
	pthread_mutex_lock(&queue->lock);
	queue->taken++;
	if (!goes_on)
		queue->stopped = true;
	pthread_cond_signal(&queue->changed);
	pthread_mutex_unlock(&queue->lock);
}

/* False: the sink stopped. */
static bool tell(const struct event_receiver *receiver, const struct entry *entry)
{
	switch (entry->kind) {
	case ENTRY_EVENT:
		return receiver->sink->event(receiver->sink->context, &entry->of.event);
	case ENTRY_DIAG:
		diag_pass(receiver->diag, &entry->of.diag);
		break;
	case ENTRY_OPENED:
		receiver->opened->call(receiver->opened->context, entry->of.path);
		break;
	}
	return true;
}

bool event_queue_receive(struct event_queue *queue, const struct event_receiver *receiver)
{
	struct part *part;
	bool goes_on = true;

	while (goes_on && (part = wait_for_part(queue))) {
		for (size_t i = 0; i < part->count && goes_on; i++)
			goes_on = tell(receiver, &part->entries[i]);
		give_back(queue, part, goes_on);
	}
	return goes_on;
}
