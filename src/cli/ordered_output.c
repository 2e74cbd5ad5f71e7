#include "cli/ordered_output.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"

static bool is_heard(const struct voice *voice)
{
	return voice == &voice->stage->voices[voice->stage->turn];
}

static void report(void *context, const struct diag_entry *entry)
{
	struct voice *voice = context;

	faults_keep(&voice->faults, entry);
	pthread_mutex_lock(&voice->stage->lock);
	diag_pass(is_heard(voice) ? &voice->stage->console->diag : &voice->held.diag, entry);
	pthread_mutex_unlock(&voice->stage->lock);
}

void stage_init(struct stage *stage, size_t count, struct console *console, struct channels *channels)
{
	*stage = (struct stage){.console = console, .channels = channels, .count = count};
	pthread_mutex_init(&stage->lock, NULL);
	stage->voices = mem_zalloc(count + 1, sizeof(*stage->voices));
	for (size_t i = 0; i < count; i++) {
		struct voice *voice = &stage->voices[i];

		voice->stage = stage;
		voice->diag = (struct diag){.handle = report, .context = voice};
		held_init(&voice->held);
	}
}

void stage_release(struct stage *stage)
{
	for (size_t i = 0; i < stage->count; i++) {
		struct voice *voice = &stage->voices[i];

		held_release(&voice->held);
		for (size_t k = 0; k < FORMAT_COUNT; k++)
			strbuf_release(&voice->text[k]);
		faults_release(&voice->faults);
	}
	free(stage->voices);
	pthread_mutex_destroy(&stage->lock);
}

bool stage_is_lost(struct stage *stage)
{
	bool lost;

	pthread_mutex_lock(&stage->lock);
	lost = channels_are_lost(stage->channels);
	pthread_mutex_unlock(&stage->lock);
	return lost;
}

static bool say_aloud(struct stage *stage, size_t index, struct strbuf *text)
{
	struct channel *channel = &stage->channels->items[index];

	console_clear(stage->console);
	channel_say(channel, text);
	return channel_flush(channel);
}

bool voice_say(struct voice *voice, size_t channel, struct strbuf *text)
{
	struct stage *stage = voice->stage;
	bool good;

	pthread_mutex_lock(&stage->lock);
	if (is_heard(voice)) {
		good = say_aloud(stage, channel, text);
	} else {
		strbuf_add(&voice->text[channel], strbuf_text(text), text->length);
		strbuf_clear(text);
		good = !channels_are_lost(stage->channels);
	}
	pthread_mutex_unlock(&stage->lock);
	return good;
}

void voice_progress(struct voice *voice, const char *file, long lines, double share)
{
	pthread_mutex_lock(&voice->stage->lock);
	if (is_heard(voice))
		console_progress(voice->stage->console, file, lines, share);
	pthread_mutex_unlock(&voice->stage->lock);
}

/* What has waited until now. */
static void catch_up(struct voice *voice)
{
	held_deliver(&voice->held, &voice->stage->console->diag, LONG_MAX);
	for (size_t i = 0; i < voice->stage->channels->count; i++) {
		if (voice->text[i].length)
			say_aloud(voice->stage, i, &voice->text[i]);
	}
}

void voice_end(struct voice *voice)
{
	struct stage *stage = voice->stage;

	pthread_mutex_lock(&stage->lock);
	voice->ended = true;
	console_done(stage->console);
	while (stage->turn < stage->count && stage->voices[stage->turn].ended) {
		stage->turn++;
		if (stage->turn < stage->count)
			catch_up(&stage->voices[stage->turn]);
	}
	pthread_mutex_unlock(&stage->lock);
}
