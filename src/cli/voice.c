#include "cli/voice.h"

#include <limits.h>
#include <stdlib.h>

#include "base/mem.h"

static bool is_heard(const struct voice *voice)
{
	return voice == &voice->stage->voices[voice->stage->turn];
}

static void report(void *context, const struct diag_entry *entry)
{
	struct voice *voice = context;

	pthread_mutex_lock(&voice->stage->lock);
	diag_pass(is_heard(voice) ? &voice->stage->console->diag : &voice->held.diag, entry);
	pthread_mutex_unlock(&voice->stage->lock);
}

void stage_init(struct stage *stage, size_t count, struct console *console, struct output *out)
{
	*stage = (struct stage){.console = console, .out = out, .count = count};
	pthread_mutex_init(&stage->lock, NULL);
	stage->voices = mem_zalloc(count, sizeof(*stage->voices));
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
		held_release(&stage->voices[i].held);
		strbuf_release(&stage->voices[i].text);
	}
	free(stage->voices);
	pthread_mutex_destroy(&stage->lock);
}

bool stage_is_lost(struct stage *stage)
{
	bool lost;

	pthread_mutex_lock(&stage->lock);
	lost = stage->out->error != 0;
	pthread_mutex_unlock(&stage->lock);
	return lost;
}

static bool say_aloud(struct stage *stage, struct strbuf *text)
{
	console_clear(stage->console);
	output_text(stage->out, text);
	return output_flush(stage->out);
}

bool voice_say(struct voice *voice, struct strbuf *text)
{
	struct stage *stage = voice->stage;
	bool good;

	pthread_mutex_lock(&stage->lock);
	if (is_heard(voice)) {
		good = say_aloud(stage, text);
	} else {
		strbuf_add(&voice->text, strbuf_text(text), text->length);
		strbuf_clear(text);
		good = !stage->out->error;
	}
	pthread_mutex_unlock(&stage->lock);
	return good;
}

void voice_progress(struct voice *voice, const char *file, long lines)
{
	pthread_mutex_lock(&voice->stage->lock);
	if (is_heard(voice))
		console_progress(voice->stage->console, file, lines);
	pthread_mutex_unlock(&voice->stage->lock);
}

/* What has waited until now. */
static void catch_up(struct voice *voice)
{
	held_deliver(&voice->held, &voice->stage->console->diag, LONG_MAX);
	if (voice->text.length)
		say_aloud(voice->stage, &voice->text);
}

void voice_end(struct voice *voice)
{
	struct stage *stage = voice->stage;

	pthread_mutex_lock(&stage->lock);
	voice->ended = true;
	while (stage->turn < stage->count && stage->voices[stage->turn].ended) {
		stage->turn++;
		if (stage->turn < stage->count)
			catch_up(&stage->voices[stage->turn]);
	}
	pthread_mutex_unlock(&stage->lock);
}
