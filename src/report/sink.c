#include "report/sink.h"

#include <string.h>

bool channels_open(struct channels *channels, enum report_format format, const char *path, bool colour,
		   struct diag *diag)
{
	struct channel *channel = &channels->items[channels->count];

	*channel = (struct channel){.writer = report_writers[format], .path = path, .colour = colour};
	if (!output_open(&channel->out, path, diag))
		return false;
	channels->count++;
	return true;
}

void channels_begin(struct channels *channels, const struct report_run *run)
{
	struct strbuf text = {0};

	for (size_t i = 0; i < channels->count; i++) {
		channels->items[i].writer->begin(&text, run);
		output_text(&channels->items[i].out, &text);
		output_flush(&channels->items[i].out);
	}
	strbuf_release(&text);
}

static void say_item(struct channel *channel, const char *item, size_t length)
{
	const struct report_writer *writer = channel->writer;

	if (writer->limit && channel->count == writer->limit) {
		channel->left_out++;
		return;
	}
	if (channel->count++ && writer->separator)
		output_write(&channel->out, writer->separator, strlen(writer->separator));
	output_write(&channel->out, item, length);
}

bool channel_say(struct channel *channel, struct strbuf *text)
{
	const struct report_writer *writer = channel->writer;
	const char *item = strbuf_text(text);

	if (writer->collects) {
		strbuf_add(&channel->items, item, text->length);
	} else if (writer->limit || writer->separator) {
		for (const char *end; (end = strchr(item, '\n')); item = end + 1)
			say_item(channel, item, (size_t)(end + 1 - item));
	} else {
		output_write(&channel->out, item, text->length);
	}
	strbuf_clear(text);
	return !channel->out.error;
}

bool channel_flush(struct channel *channel)
{
	return output_flush(&channel->out);
}

void channels_end(struct channels *channels, const struct report_run *run, struct report_end *end)
{
	struct strbuf text = {0};

	for (size_t i = 0; i < channels->count; i++) {
		struct channel *channel = &channels->items[i];

		end->left_out = channel->left_out;
		channel->writer->end(&text, run, end, &channel->items);
		output_text(&channel->out, &text);
	}
	strbuf_release(&text);
}

bool channels_are_lost(const struct channels *channels)
{
	for (size_t i = 0; i < channels->count; i++) {
		if (channels->items[i].out.error)
			return true;
	}
	return false;
}

bool channels_commit(struct channels *channels, struct diag *diag)
{
	bool good = true;

	for (size_t i = 0; i < channels->count; i++)
		good = output_commit(&channels->items[i].out, diag) && good;
	channels_discard(channels);
	return good;
}

void channels_discard(struct channels *channels)
{
	for (size_t i = 0; i < channels->count; i++) {
		output_discard(&channels->items[i].out);
		strbuf_release(&channels->items[i].items);
	}
	channels->count = 0;
}
