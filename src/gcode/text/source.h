/* source.h - the files that a program consists of: its own, and those of the subprograms that it calls. */
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

/* Files of subprograms that can be open at once. */
#define SOURCE_MAX 200

struct source {
	const char *name;	/* as messages call it; one of the names that are kept */
	FILE *file;	/* to be closed; NULL: borrowed */
	struct reader reader;
};

/* The first is the program itself. All zero is none. */
struct sources {
	struct source *items[SOURCE_MAX];
	size_t count;
	bool led_out;	/* a file that was looked for is outside of the input root */
	struct file_names *names;	/* where names are kept */
	struct file_names own_names;	/* the same, if nobody else keeps them */
	const struct file_opened *opened;	/* is told what else is opened; or NULL */
};

/* Where a line starts. */
struct position {
	struct source *source;
	long long offset;
	long line;
};

/* The program itself; `in` is borrowed. names: who keeps the files' names, or NULL: sources, until sources_release. */
void sources_open_main(struct sources *sources, FILE *in, const char *name, struct file_names *names);

/*
 * Subprograms are looked for in folders: number 0 is the program's own, which
 * standard input does not have, and the others are those of the options.
 */
size_t sources_folder_count(const struct read_options *options);

/*
 * The file of this name in one folder, opened once; NULL: it is not there, or
 * outside of the input root, which sources_check_root tells. The name has no folders in it.
 */
struct source *sources_open(struct sources *sources, const struct read_options *options, size_t folder,
			    const char *name);

/* Is there room for one more file? False: reported at the column. */
bool sources_check_room(const struct sources *sources, const struct line_place *at, int column);

/* Were all files that were looked for inside of the input root? False: reported at the column. */
bool sources_check_root(const struct sources *sources, const struct read_options *options,
			const struct line_place *at, int column);

/*
 * The first file of this name in the folders; *source is NULL if there is none.
 * False: reported at the column.
 */
bool sources_find(struct sources *sources, const struct read_options *options, const char *name,
		  const struct line_place *at, int column, struct source **source);

/* Closes the files; the sources and their names stay until sources_release. */
void sources_close(struct sources *sources);
void sources_release(struct sources *sources);

/* Where the line in hand starts, and the one after it. */
struct position source_here(struct source *source);
struct position source_next(struct source *source);

#endif
