#include "cli/program_list.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "base/mem.h"
#include "base/strbuf.h"
#include "report/format/digest.h"

static const struct srcloc nowhere;

/* Bytes: about a million names. The limit ends the reading of a pipe that never ends. */
#define PROGRAM_LIST_MAX ((size_t)64 << 20)

/* Reads to the end; returns the fault, or NULL. */
static const char *read_all(struct strbuf *text, FILE *in)
{
	char bytes[4096];
	size_t count;

	errno = 0;
	while ((count = fread(bytes, 1, sizeof(bytes), in)) > 0) {
		if (memchr(bytes, 0, count))
			return "it has a NUL byte, but a list has one name per line";
		if (text->length + count > PROGRAM_LIST_MAX)
			return "it is larger than 64 MB";
		strbuf_add(text, bytes, count);
	}
	return ferror(in) ? strerror(errno ? errno : EIO) : NULL;
}

/* Divides the text into lines in place and skips empty ones. */
static void add_names(struct options *options, char *text)
{
	size_t capacity = options->program_count;

	for (char *end; *text; text = end) {
		size_t length = strcspn(text, "\n");

		end = text + length + (text[length] == '\n');
		/* Lines of other systems end in CR LF. */
		if (length > 0 && text[length - 1] == '\r')
			length--;
		text[length] = '\0';
		if (!length)
			continue;
		options->programs = mem_grow(options->programs, &capacity, options->program_count + 1,
					     sizeof(*options->programs));
		options->programs[options->program_count++] = text;
	}
}

bool program_list_read(struct options *options, struct diag *diag)
{
	const char *path = options->files_from;
	bool standard = !strcmp(path, "-");
	FILE *in = standard ? stdin : fopen(path, "rb");
	struct strbuf text = {0};
	const char *fault = in ? read_all(&text, in) : strerror(errno);

	if (fault)
		diag_error(diag, nowhere, "cannot read the list %s: %s", path, fault);
	if (in && !standard)
		fclose(in);
	options->list = text.text;
	if (fault || !text.text)
		return !fault;
	add_names(options, text.text);
	return true;
}

void program_list_take_shard(struct options *options)
{
	struct strbuf names = {0};
	size_t count = 0;

	if (!options->shards)
		return;
	for (size_t i = 0; i < options->program_count; i++)
		strbuf_addf(&names, "%s\n", options->programs[i]);
	digest_bytes(options->program_list, strbuf_text(&names), names.length);
	strbuf_release(&names);
	for (size_t i = (size_t)options->shard - 1; i < options->program_count; i += (size_t)options->shards)
		options->programs[count++] = options->programs[i];
	options->program_count = count;
}
