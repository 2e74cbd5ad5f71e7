#include "check/event_queue.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

#include "base/arena.h"
#include "base/mem.h"
#include "check/path_copies.h"
#include "check/step_packing.h"

/*
 * Parts of the queue: one is written while others wait to be read. Who has to wait, waits until half of them are ready:
 * to sleep and to be woken costs about as much as reading ten blocks.
 */
enum { PARTS = 4 };

/* Bytes: a part is handed over once its entries and texts are so large. All parts fit into a processor's own cache. */
#define PART_BYTES 200000

enum entry_kind { ENTRY_EVENT, ENTRY_STEP, ENTRY_DIAG, ENTRY_OPENED };

/* Followed by what the entry is about, as bytes. */
struct entry {
	enum entry_kind kind;
	enum motion_event_kind event;	/* EVENT: its kind */
	size_t size;	/* bytes, with this head */
};

struct part {
	unsigned char *bytes;	/* entries, one behind the other */
	size_t size, capacity;
	struct path_copies paths;
	struct arena texts;
	size_t text_size;	/* bytes */
};

/*
 * In this order what one thread writes at every step is not in one line of the processors' caches with what the other
 * thread looks at as often.
 */
struct event_queue {
	atomic_bool stopped;	/* by the receiver */
	struct shared_loop *loop;	/* its lock is for the next four */
	size_t given, taken;	/* parts in all */
	bool ended, done;	/* by the reader, and by the receiver */
	struct step_packing packs;	/* the reader's */
	struct part parts[PARTS];	/* `taken` to `given` are the receiver's, the others the reader's */
	struct step_packing unpacks;	/* the receiver's */
};

struct event_queue *event_queue_new(struct shared_loop *loop)
{
	struct event_queue *queue = mem_zalloc(1, sizeof(*queue));

	queue->loop = loop;
	return queue;
}

void event_queue_free(struct event_queue *queue)
{
	for (int i = 0; i < PARTS; i++) {
		free(queue->parts[i].bytes);
		path_copies_release(&queue->parts[i].paths);
		arena_release(&queue->parts[i].texts);
	}
	free(queue);
}

/* ----------------------------------------------------------------- reader */

/* The part that is being written: only the reader changes `given`. */
static struct part *open_part(struct event_queue *queue)
{
	return &queue->parts[queue->given % PARTS];
}

/* Room for an entry about so many bytes, aligned for any of them. */
static struct entry *add(struct part *part, enum entry_kind kind, size_t size)
{
	const size_t all = sizeof(struct entry) + (size + sizeof(double) - 1) / sizeof(double) * sizeof(double);
	struct entry *entry;

	part->bytes = mem_grow(part->bytes, &part->capacity, part->size + all, 1);
	entry = (void *)(part->bytes + part->size);
	*entry = (struct entry){.kind = kind, .size = all};
	part->size += all;
	return entry;
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

/* Waits until the receiver has changed something; meanwhile carries out a round of its loop, if there is one. */
static void help_or_wait(struct event_queue *queue)
{
	if (!shared_loop_help(queue->loop))
		pthread_cond_wait(&queue->loop->changed, &queue->loop->lock);
}

/* Gives the open part to the receiver and waits for an empty one. */
static void hand_over(struct event_queue *queue)
{
	pthread_mutex_lock(&queue->loop->lock);
	queue->given++;
	if (queue->given - queue->taken >= PARTS / 2)
		pthread_cond_signal(&queue->loop->changed);
	if (queue->given - queue->taken == PARTS)
		while (queue->given - queue->taken > PARTS / 2 && !queue->stopped)
			help_or_wait(queue);
	pthread_mutex_unlock(&queue->loop->lock);
}

/* Bytes of what an event of this kind says. */
static size_t size_of(enum motion_event_kind kind)
{
	static const size_t sizes[] = {
		[MOTION_STEP] = sizeof(struct motion_step), [MOTION_LIMIT] = sizeof(struct motion_limit),
		[MOTION_TOOL] = sizeof(struct motion_tool), [MOTION_MODES] = sizeof(struct motion_modes),
		[MOTION_SPINDLE_STOP] = sizeof(struct motion_spindle_stop),
		[MOTION_BLOCK] = sizeof(struct motion_block)};

	return sizes[kind];
}

static void add_step(struct event_queue *queue, struct part *part, const struct motion_event *event)
{
	struct entry *entry = add(part, ENTRY_STEP, sizeof(event->summary) + step_packing_most());
	struct motion_summary *summary = (void *)(entry + 1);
	const size_t size =
	    sizeof(*entry) + sizeof(*summary) +
	    step_packing_pack(&queue->packs, &event->of.step, &part->paths, summary + 1);

	*summary = event->summary;
	part->size -= entry->size - size;
	entry->size = size;
}

static void add_event(struct part *part, const struct motion_event *event)
{
	struct entry *entry = add(part, ENTRY_EVENT, sizeof(event->summary) + size_of(event->kind));
	struct motion_summary *summary = (void *)(entry + 1);

	entry->event = event->kind;
	*summary = event->summary;
	memcpy(summary + 1, &event->of, size_of(event->kind));
	if (event->kind == MOTION_BLOCK)
		keep_block(part, (void *)(summary + 1));
}

bool event_queue_add(struct event_queue *queue, const struct motion_event *event)
{
	struct part *part = open_part(queue);

	if (event->kind == MOTION_STEP)
		add_step(queue, part, event);
	else
		add_event(part, event);
	if (part->size + part->text_size >= PART_BYTES)
		hand_over(queue);
	return !queue->stopped;
}

void event_queue_add_diag(struct event_queue *queue, const struct diag_entry *entry)
{
	struct part *part = open_part(queue);
	struct diag_entry *copy = (void *)(add(part, ENTRY_DIAG, sizeof(*copy)) + 1);

	*copy = *entry;
	/* Diagnostics are few, and not all of their names are kept elsewhere. */
	copy->loc.file = keep_text(part, entry->loc.file);
	copy->text = keep_text(part, entry->text);
	copy->excerpt = keep_text(part, entry->excerpt);
}

void event_queue_add_opened(struct event_queue *queue, const char *path)
{
	struct part *part = open_part(queue);
	const char *copy = keep_text(part, path);

	memcpy(add(part, ENTRY_OPENED, sizeof(copy)) + 1, &copy, sizeof(copy));
}

void event_queue_end(struct event_queue *queue)
{
	if (!queue->stopped)
		hand_over(queue);
	pthread_mutex_lock(&queue->loop->lock);
	queue->ended = true;
	pthread_cond_signal(&queue->loop->changed);
	while (!queue->done)
		help_or_wait(queue);
	pthread_mutex_unlock(&queue->loop->lock);
}

/* --------------------------------------------------------------- receiver */

/* Waits for the next part; NULL: there are no more. */
static struct part *wait_for_part(struct event_queue *queue)
{
	struct part *part;

	pthread_mutex_lock(&queue->loop->lock);
	if (queue->taken == queue->given)
		while (queue->given - queue->taken < PARTS / 2 && !queue->ended)
			pthread_cond_wait(&queue->loop->changed, &queue->loop->lock);
	part = queue->taken < queue->given ? &queue->parts[queue->taken % PARTS] : NULL;
	pthread_mutex_unlock(&queue->loop->lock);
	return part;
}

static void give_back(struct event_queue *queue, struct part *part, bool goes_on)
{
	part->size = part->text_size = 0;
	path_copies_clear(&part->paths);
	arena_clear(&part->texts);
	pthread_mutex_lock(&queue->loop->lock);
	queue->taken++;
	if (!goes_on)
		queue->stopped = true;
	if (queue->given - queue->taken <= PARTS / 2 || queue->stopped)
		pthread_cond_signal(&queue->loop->changed);
	pthread_mutex_unlock(&queue->loop->lock);
}

static bool tell_event(struct event_queue *queue, const struct event_receiver *receiver, const struct entry *entry)
{
	const struct motion_summary *summary = (const void *)(entry + 1);
	struct motion_event event;

	event.kind = entry->kind == ENTRY_STEP ? MOTION_STEP : entry->event;
	event.summary = *summary;
	if (entry->kind == ENTRY_STEP)
		step_packing_unpack(&queue->unpacks, summary + 1, &event.of.step);
	else
		memcpy(&event.of, summary + 1, size_of(event.kind));
	return receiver->sink->event(receiver->sink->context, &event);
}

/* False: the sink stopped. */
static bool tell(struct event_queue *queue, const struct event_receiver *receiver, const struct entry *entry)
{
	const char *path;

	switch (entry->kind) {
	case ENTRY_EVENT:
	case ENTRY_STEP:
		return tell_event(queue, receiver, entry);
	case ENTRY_DIAG:
		diag_pass(receiver->diag, (const void *)(entry + 1));
		break;
	case ENTRY_OPENED:
		memcpy(&path, entry + 1, sizeof(path));
		receiver->opened->call(receiver->opened->context, path);
		break;
	}
	return true;
}

bool event_queue_receive(struct event_queue *queue, const struct event_receiver *receiver)
{
	struct part *part;
	bool goes_on = true;

	while (goes_on && (part = wait_for_part(queue))) {
		for (size_t at = 0; at < part->size && goes_on;) {
			const struct entry *entry = (const void *)(part->bytes + at);

			at += entry->size;
			goes_on = tell(queue, receiver, entry);
		}
		give_back(queue, part, goes_on);
	}
	pthread_mutex_lock(&queue->loop->lock);
	queue->done = true;
	pthread_cond_signal(&queue->loop->changed);
	pthread_mutex_unlock(&queue->loop->lock);
	return goes_on;
}
