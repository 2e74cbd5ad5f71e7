#include "cli/list.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "base/mem.h"
#include "base/strbuf.h"

static const struct srcloc nowhere;

/* All of it; false: errno says why not. */
static bool read_all(struct strbuf *text, FILE *in)
{
	char bytes[4096];
	size_t count;

	errno = 0;
	while ((count = fread(bytes, 1, sizeof(bytes), in)) > 0)
		strbuf_add(text, bytes, count);
	return !ferror(in);
}

/* Cuts the text into lines in place; names cannot be empty. */
static void add_names(struct options *options, char *text)
{
	size_t capacity = options->program_count;

	for (char *end; *text; text = end) {
		size_t length = strcspn(text, "\n");

		end = text + length + (text[length] == '\n');
		/* A list from another system. */
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

bool list_read(struct options *options, struct diag *diag)
{
	const char *path = options->files_from;
	bool standard = !strcmp(path, "-");
	FILE *in = standard ? stdin : fopen(path, "rb");
	struct strbuf text = {0};
	bool good = in && read_all(&text, in);

	if (!good)
		diag_error(diag, nowhere, "cannot read the list %s: %s", path, strerror(errno ? errno : EIO));
	if (good && strlen(strbuf_text(&text)) != text.length) {
		diag_error(diag, nowhere, "the list %s has a byte 0: it takes one name a line", path);
		good = false;
	}
	if (in && !standard)
		fclose(in);
	options->list = text.text;
	if (!good || !text.text)
		return good;
	add_names(options, text.text);
	return true;
}

void list_share(struct options *options)
{
	size_t count = 0;

	if (!options->shards)
		return;
	for (size_t i = (size_t)options->shard - 1; i < options->program_count; i += (size_t)options->shards)
		options->programs[count++] = options->programs[i];
	options->program_count = count;
}
