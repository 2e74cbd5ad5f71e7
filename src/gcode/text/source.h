/* source.h - the files of a program: its own file and the files of subprograms that it calls. */
#ifndef FIVECHECK_GCODE_TEXT_SOURCE_H
#define FIVECHECK_GCODE_TEXT_SOURCE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "base/callbacks.h"
#include "base/file_names.h"
#include "gcode/read_options.h"
#include "gcode/text/fault.h"
#include "gcode/text/reader.h"

/* The most files that can be open at the same time. */
#define SOURCE_MAX 200

struct source {
	const char *name;	/* for messages; owned by sources.names */
	FILE *file;	/* owned; NULL: the file is borrowed */
	struct reader reader;
};

/* The first item is the program itself. All zero: no files. */
struct sources {
	struct source *items[SOURCE_MAX];
	size_t count;
	bool led_out;	/* a file that was searched is outside of the input root */
	struct file_names *names;	/* owner of the names */
	struct file_names own_names;	/* this owner, if the caller gave none */
	const struct file_opened *opened;	/* called for each further file that is opened; or NULL */
};

/* The start of a line. */
struct position {
	struct source *source;
	long long offset;
	long line;
};

static inline bool position_is_same(const struct position *a, const struct position *b)
{
	return a->source == b->source && a->offset == b->offset;
}

/* Opens the program itself; `in` is borrowed. names: the owner of the file names; NULL: sources owns them. */
void sources_open_main(struct sources *sources, FILE *in, const char *name, struct file_names *names);

/*
 * The number of folders in which subprograms are searched. Number 0 is the program's own folder, which standard input
 * does not have; the others are those of the options.
 */
size_t sources_folder_count(const struct read_options *options);

/*
 * The file of this name in one folder; a file is opened only once, also if it has several names. The name contains no
 * folder. NULL: there is no such file, or it is outside of the input root, which sources_check_root reports.
 */
struct source *sources_open(struct sources *sources, const struct read_options *options, size_t folder,
			    const char *name);

/* Is there room for one more file? False: reported at the column. */
bool sources_check_room(const struct sources *sources, const struct line_place *at, int column);

/* Were all files that were searched inside of the input root? False: reported at the column. */
bool sources_check_root(const struct sources *sources, const struct read_options *options,
			const struct line_place *at, int column);

/*
 * The first file of this name in the folders; *source is NULL if there is none.
 * False: reported at the column.
 */
bool sources_find(struct sources *sources, const struct read_options *options, const char *name,
		  const struct line_place *at, int column, struct source **source);

/* Closes the files; the sources and their names remain until sources_release. */
void sources_close(struct sources *sources);
void sources_release(struct sources *sources);

/* The start of the current line, and of the next line. */
struct position source_here(struct source *source);
struct position source_next(struct source *source);

#endif
