#include "check/tape.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"

/* A tape is handed on after so many entries, or bytes of text. */
#define ENTRIES_ENOUGH 2048
#define TEXT_ENOUGH 1000000

/* A text that was not there. */
#define NO_TEXT SIZE_MAX

enum tape_kind { TAPE_LIMIT, TAPE_STEP, TAPE_TOOL, TAPE_BLOCK, TAPE_DIAG, TAPE_OPENED };

struct tape_entry {
	enum tape_kind kind;
	struct motion_summary summary;
	size_t index;	/* of the step or limit */
	size_t file, text, excerpt;	/* offsets in texts */
	union {
		struct {
			int number;
			axis_values position;
		} tool;
		struct {
			long line;
			double seconds;
			int moves;
		} block;
		struct {
			enum diag_severity severity;
			struct srcloc loc;
		} diag;
	} of;
};

void tape_release(struct tape *tape)
{
	free(tape->entries);
	free(tape->limits);
	batch_release(&tape->steps);
	strbuf_release(&tape->texts);
	*tape = (struct tape){0};
}

void tape_clear(struct tape *tape)
{
	tape->count = tape->limit_count = 0;
	batch_clear(&tape->steps);
	strbuf_clear(&tape->texts);
}

bool tape_is_full(const struct tape *tape)
{
	return tape->count >= ENTRIES_ENOUGH || tape->texts.length >= TEXT_ENOUGH;
}

static struct tape_entry *add(struct tape *tape, enum tape_kind kind, const struct motion_summary *summary)
{
	struct tape_entry *entry;

	tape->entries = mem_grow(tape->entries, &tape->capacity, tape->count + 1, sizeof(*tape->entries));
	entry = &tape->entries[tape->count++];
	*entry = (struct tape_entry){.kind = kind, .file = NO_TEXT, .text = NO_TEXT, .excerpt = NO_TEXT};
	if (summary)
		entry->summary = *summary;
	return entry;
}

static size_t add_text(struct tape *tape, const char *text)
{
	size_t offset = tape->texts.length;

	if (!text)
		return NO_TEXT;
	strbuf_add(&tape->texts, text, strlen(text) + 1);
	return offset;
}

/* Mostly that of the entry before. */
static size_t add_file(struct tape *tape, const char *file)
{
	size_t last = tape->count > 1 ? tape->entries[tape->count - 2].file : NO_TEXT;

	return last != NO_TEXT && file && !strcmp(tape->texts.text + last, file) ? last : add_text(tape, file);
}

void tape_limit(struct tape *tape, const struct motion_summary *summary, const struct motion_limit *limit)
{
	struct tape_entry *entry = add(tape, TAPE_LIMIT, summary);

	entry->file = add_file(tape, limit->file);
	entry->index = tape->limit_count;
	tape->limits = mem_grow(tape->limits, &tape->limit_capacity, tape->limit_count + 1, sizeof(*tape->limits));
	tape->limits[tape->limit_count++] = *limit;
}

void tape_step(struct tape *tape, const struct motion_summary *summary, const struct motion_step *step)
{
	struct tape_entry *entry = add(tape, TAPE_STEP, summary);

	entry->file = add_file(tape, step->file);
	entry->index = tape->steps.step_count;
	batch_add(&tape->steps, step, 0);
}

void tape_tool(struct tape *tape, const struct motion_summary *summary, int tool, const axis_values *position)
{
	struct tape_entry *entry = add(tape, TAPE_TOOL, summary);

	entry->of.tool.number = tool;
	entry->of.tool.position = *position;
}

void tape_block(struct tape *tape, const struct motion_summary *summary, const char *file, long line,
		const char *text, double seconds, int moves)
{
	struct tape_entry *entry = add(tape, TAPE_BLOCK, summary);

	entry->file = add_file(tape, file);
	entry->text = add_text(tape, text);
	entry->of.block.line = line;
	entry->of.block.seconds = seconds;
	entry->of.block.moves = moves;
}

void tape_diag(struct tape *tape, const struct diag_entry *of)
{
	struct tape_entry *entry = add(tape, TAPE_DIAG, NULL);

	entry->file = add_file(tape, of->loc.file);
	entry->text = add_text(tape, of->text);
	entry->excerpt = add_text(tape, of->excerpt);
	entry->of.diag.severity = of->severity;
	entry->of.diag.loc = of->loc;
}

void tape_opened(struct tape *tape, const char *path)
{
	add(tape, TAPE_OPENED, NULL)->text = add_text(tape, path);
}

void tape_close(struct tape *tape)
{
	batch_settle(&tape->steps);
}

static const char *text_at(const struct tape *tape, size_t offset)
{
	return offset == NO_TEXT ? NULL : tape->texts.text + offset;
}

static void play_diag(const struct tape *tape, const struct tape_entry *entry, struct diag *diag)
{
	struct diag_entry of = {entry->of.diag.severity, entry->of.diag.loc, text_at(tape, entry->text),
				text_at(tape, entry->excerpt)};

	of.loc.file = text_at(tape, entry->file);
	diag_pass(diag, &of);
}

static bool play_move(const struct tape *tape, const struct tape_entry *entry, const struct motion_sink *sink)
{
	if (entry->kind == TAPE_LIMIT) {
		struct motion_limit limit = tape->limits[entry->index];

		limit.file = text_at(tape, entry->file);
		return sink->limit(sink->context, &limit);
	} else {
		struct motion_step step = tape->steps.steps[entry->index].motion;

		step.file = text_at(tape, entry->file);
		return sink->step(sink->context, &step);
	}
}

bool tape_play(const struct tape *tape, const struct motion_sink *sink, struct diag *diag, const struct file_opened *opened,
	       struct motion_summary *summary)
{
	bool goes_on = true;

	for (size_t i = 0; i < tape->count && goes_on; i++) {
		const struct tape_entry *entry = &tape->entries[i];

		if (entry->kind < TAPE_DIAG)
			*summary = entry->summary;
		switch (entry->kind) {
		case TAPE_LIMIT:
		case TAPE_STEP:
			goes_on = play_move(tape, entry, sink);
			break;
		case TAPE_TOOL:
			goes_on = sink->tool(sink->context, entry->of.tool.number, &entry->of.tool.position);
			break;
		case TAPE_BLOCK:
			goes_on = sink->block(sink->context, text_at(tape, entry->file), entry->of.block.line,
					      text_at(tape, entry->text), entry->of.block.seconds,
					      entry->of.block.moves);
			break;
		case TAPE_DIAG:
			play_diag(tape, entry, diag);
			break;
		case TAPE_OPENED:
			opened->call(opened->context, text_at(tape, entry->text));
			break;
		}
	}
	return goes_on;
}
