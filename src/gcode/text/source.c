#include "gcode/text/source.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/mem.h"
#include "base/path_sandbox.h"
#include "base/same_file.h"
#include "base/strbuf.h"

static struct source *add(struct sources *sources, FILE *in, const char *name)
{
	struct source *source = mem_zalloc(1, sizeof(*source));

	source->name = file_names_keep(sources->names, name);
	reader_init(&source->reader, in);
	sources->items[sources->count++] = source;
	return source;
}

void sources_open_main(struct sources *sources, FILE *in, const char *name, struct file_names *names)
{
	sources->names = names ? names : &sources->own_names;
	add(sources, in, name);
}

void sources_close(struct sources *sources)
{
	for (size_t i = 0; i < sources->count; i++) {
		struct source *source = sources->items[i];

		reader_release(&source->reader);
		if (source->file)
			fclose(source->file);
		source->file = NULL;
	}
}

void sources_release(struct sources *sources)
{
	sources_close(sources);
	for (size_t i = 0; i < sources->count; i++)
		free(sources->items[i]);
	sources->count = 0;
	file_names_release(&sources->own_names);
}

struct position source_here(struct source *source)
{
	return (struct position){source, source->reader.start, source->reader.line};
}

struct position source_next(struct source *source)
{
	return (struct position){source, reader_position(&source->reader), source->reader.line + 1};
}

/* Opens only a regular file: the program would wait for a pipe of this name. */
static FILE *open_regular(struct sources *sources, const char *root, const char *path)
{
	int fd = path_sandbox_open(root, path);
	struct stat status;
	FILE *file = NULL;

	if (fd < 0) {
		sources->led_out |= errno == EXDEV;
		return NULL;
	}
	if (!fstat(fd, &status) && S_ISREG(status.st_mode))
		file = fdopen(fd, "rb");
	if (!file)
		close(fd);
	return file;
}

/* The further source that is this file, also under another name: a folder may ignore the case of names. */
static struct source *find_open(const struct sources *sources, FILE *file)
{
	struct stat status, other;

	if (fstat(fileno(file), &status))
		return NULL;
	for (size_t i = 1; i < sources->count; i++) {
		struct source *source = sources->items[i];

		if (source->file && !fstat(fileno(source->file), &other) && same_file(&status, &other))
			return source;
	}
	return NULL;
}

static struct source *add_further(struct sources *sources, FILE *file, const char *path)
{
	struct source *source = find_open(sources, file);

	if (source) {
		fclose(file);
		return source;
	}
	source = add(sources, file, path);
	source->file = file;
	if (sources->opened)
		sources->opened->call(sources->opened->context, path);
	return source;
}

/* Finds the file in a folder, whose name ends in '/' or is empty; NULL: no such file, or outside of the root. */
static struct source *find_in(struct sources *sources, const char *root, const char *folder, size_t length,
			      const char *name)
{
	struct source *source = NULL;
	struct strbuf path = {0};
	FILE *file = NULL;

	strbuf_add(&path, folder, length);
	if (length > 0 && folder[length - 1] != '/')
		strbuf_add(&path, "/", 1);
	strbuf_addf(&path, "%s", name);
	for (size_t i = 1; i < sources->count && !source; i++) {
		if (!strcmp(sources->items[i]->name, path.text))
			source = sources->items[i];
	}
	if (!source && (file = open_regular(sources, root, path.text)))
		source = add_further(sources, file, path.text);
	strbuf_release(&path);
	return source;
}

/* The folder of the program itself, which may be ""; NULL for standard input. */
static const char *own_folder(const struct sources *sources, size_t *length)
{
	const char *name = sources->items[0]->name, *slash = strrchr(name, '/');

	*length = slash ? (size_t)(slash + 1 - name) : 0;
	return strcmp(name, "<stdin>") ? name : NULL;
}

size_t sources_folder_count(const struct read_options *options)
{
	return 1 + options->include_count;
}

struct source *sources_open(struct sources *sources, const struct read_options *options, size_t folder,
			    const char *name)
{
	const char *path;
	size_t length;

	if (sources->count == SOURCE_MAX)
		return NULL;
	if (folder > 0) {
		path = options->includes[folder - 1];
		length = strlen(path);
	} else {
		path = own_folder(sources, &length);
	}
	return path ? find_in(sources, options->input_root, path, length, name) : NULL;
}

bool sources_check_room(const struct sources *sources, const struct line_place *at, int column)
{
	return sources->count < SOURCE_MAX ||
	       fault(at, column, "more than %d files of subprograms", SOURCE_MAX - 1);
}

bool sources_check_root(const struct sources *sources, const struct read_options *options,
			const struct line_place *at, int column)
{
	if (!sources->led_out)
		return true;
	return fault(at, column, "the subprogram's file is outside the input root %s, or a link leads there",
		     options->input_root);
}

bool sources_find(struct sources *sources, const struct read_options *options, const char *name,
		  const struct line_place *at, int column, struct source **source)
{
	*source = NULL;
	if (!sources_check_room(sources, at, column))
		return false;
	for (size_t folder = 0; folder < sources_folder_count(options) && !*source; folder++)
		*source = sources_open(sources, options, folder, name);
	return sources_check_root(sources, options, at, column);
}
