#include "report/sink.h"

#include <string.h>

bool sinks_open(struct sinks *sinks, enum report_format format, const char *path, bool colour,
		struct diag *diag)
{
	struct sink *sink = &sinks->items[sinks->count];

	*sink = (struct sink){.writer = report_writers[format], .path = path, .colour = colour};
	if (!output_open(&sink->out, path, diag))
		return false;
	sinks->count++;
	return true;
}

void sinks_begin(struct sinks *sinks, const struct report_run *run)
{
	struct strbuf text = {0};

	for (size_t i = 0; i < sinks->count; i++) {
		sinks->items[i].writer->begin(&text, run);
		output_text(&sinks->items[i].out, &text);
		output_flush(&sinks->items[i].out);
	}
	strbuf_release(&text);
}

static void write_item(struct sink *sink, const char *item, size_t length)
{
	const struct report_writer *writer = sink->writer;

	bool exempt = writer->free && !strncmp(item, writer->free, strlen(writer->free));
	size_t written = exempt ? sink->free_count : sink->count - sink->free_count;

	if (writer->limit && written == writer->limit) {
		sink->left_out += !exempt;
		return;
	}
	sink->free_count += exempt;
	if (sink->count++ && writer->separator)
		output_write(&sink->out, writer->separator, strlen(writer->separator));
	output_write(&sink->out, item, length);
}

bool sink_write(struct sink *sink, struct strbuf *text)
{
	const struct report_writer *writer = sink->writer;
	const char *item = strbuf_text(text);

	if (writer->collects) {
		strbuf_add(&sink->items, item, text->length);
	} else if (writer->limit || writer->separator) {
		for (const char *end; (end = strchr(item, '\n')); item = end + 1)
			write_item(sink, item, (size_t)(end + 1 - item));
	} else {
		output_write(&sink->out, item, text->length);
	}
	strbuf_clear(text);
	return !sink->out.error;
}

bool sink_flush(struct sink *sink)
{
	return output_flush(&sink->out);
}

void sinks_end(struct sinks *sinks, const struct report_run *run, struct report_end *end)
{
	struct strbuf text = {0};

	for (size_t i = 0; i < sinks->count; i++) {
		struct sink *sink = &sinks->items[i];

		end->left_out = sink->left_out;
		sink->writer->end(&text, run, end, &sink->items);
		output_text(&sink->out, &text);
	}
	strbuf_release(&text);
}

bool sinks_are_lost(const struct sinks *sinks)
{
	for (size_t i = 0; i < sinks->count; i++) {
		if (sinks->items[i].out.error)
			return true;
	}
	return false;
}

bool sinks_commit(struct sinks *sinks, struct diag *diag)
{
	bool good = true;

	for (size_t i = 0; i < sinks->count; i++)
		good = output_commit(&sinks->items[i].out, diag) && good;
	sinks_discard(sinks);
	return good;
}

void sinks_discard(struct sinks *sinks)
{
	for (size_t i = 0; i < sinks->count; i++) {
		output_discard(&sinks->items[i].out);
		strbuf_release(&sinks->items[i].items);
	}
	sinks->count = 0;
}
