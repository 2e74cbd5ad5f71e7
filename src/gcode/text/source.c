#include "gcode/text/source.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/path_sandbox.h"
#include "base/mem.h"
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

/* A regular file; a pipe of that name must not make the program wait. */
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

/* The file of a folder, which ends in '/' or is empty; NULL: not there, or outside of the root. */
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
	if (!source && (file = open_regular(sources, root, path.text))) {
		source = add(sources, file, path.text);
		source->file = file;
		if (sources->opened)
			sources->opened->call(sources->opened->context, path.text);
	}
	strbuf_release(&path);
	return source;
}

/* The folder of the program itself, which may be "", or NULL: standard input has none. */
static const char *own_folder(const struct sources *sources, size_t *length)
{
	const char *name = sources->items[0]->name, *slash = strrchr(name, '/');

	*length = slash ? (size_t)(slash + 1 - name) : 0;
	return strcmp(name, "<stdin>") ? name : NULL;
}

/* False: a file that would do is outside of the root, which was reported. */
static bool stays_in(const struct sources *sources, const char *root, const struct line_place *at, int column)
{
	return !sources->led_out ||
	       fault(at, column, "the subprogram's file is outside of the input root %s, or a link leads there", root);
}

bool sources_find(struct sources *sources, const struct read_options *options, const char *label,
		  const struct line_place *at, int column, struct source **source)
{
	struct strbuf name = {0};
	const char *folder;
	size_t length;

	*source = NULL;
	if (strpbrk(label, "/\\") || strstr(label, "..") || label[0] == '.' || label[0] == '\0')
		return fault(at, column, "a subprogram's file has a plain name, without folders; '%s' is none", label);
	if (sources->count == SOURCE_MAX)
		return fault(at, column, "more than %d files of subprograms", SOURCE_MAX - 1);
	strbuf_addf(&name, "%s.ngc", label);
	folder = own_folder(sources, &length);
	if (folder)
		*source = find_in(sources, options->input_root, folder, length, name.text);
	for (size_t i = 0; i < options->include_count && !*source; i++)
		*source =
		    find_in(sources, options->input_root, options->includes[i], strlen(options->includes[i]), name.text);
	strbuf_release(&name);
	return stays_in(sources, options->input_root, at, column);
}

/* The one file of the folder that has a name of the program. False: there are two, which was reported. */
static bool find_program_in(struct sources *sources, const char *root, const char *folder, size_t length, int number,
			    const struct line_place *at, int column, struct source **source)
{
	static const char *const endings[] = {"", ".nc", ".NC", ".cnc", ".CNC", ".tap", ".TAP", ".txt", ".TXT"};
	char names[6][24];

	for (size_t i = 0; i < sizeof(names) / sizeof(*names); i++) {
		static const int digits[] = {1, 4, 5};
		bool known = false;

		snprintf(names[i], sizeof(names[i]), "%s%0*d", i < 3 ? "O" : "", digits[i % 3], number);
		for (size_t j = 0; j < i; j++)
			known = known || !strcmp(names[i], names[j]);
		for (size_t j = 0; j < sizeof(endings) / sizeof(*endings) && !known; j++) {
			char name[32];
			struct source *next;

			snprintf(name, sizeof(name), "%.23s%.7s", names[i], endings[j]);
			next = sources->count < SOURCE_MAX ? find_in(sources, root, folder, length, name) : NULL;
			if (next && *source)
				return fault(at, column, "both %s and %s may be the program O%d", (*source)->name,
					     next->name, number);
			*source = next ? next : *source;
		}
	}
	return true;
}

bool sources_find_program(struct sources *sources, const struct read_options *options, int number,
			  const struct line_place *at, int column, struct source **source)
{
	const char *folder;
	size_t length;

	*source = NULL;
	if (sources->count == SOURCE_MAX)
		return fault(at, column, "more than %d files of subprograms", SOURCE_MAX - 1);
	folder = own_folder(sources, &length);
	if (folder && !find_program_in(sources, options->input_root, folder, length, number, at, column, source))
		return false;
	for (size_t i = 0; i < options->include_count && !*source; i++) {
		if (!find_program_in(sources, options->input_root, options->includes[i], strlen(options->includes[i]),
				     number, at, column, source))
			return false;
	}
	return stays_in(sources, options->input_root, at, column);
}
