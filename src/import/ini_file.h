/* ini_file.h - the entries of an ini file of LinuxCNC: [SECTION], KEY = value, # or ; for comments, #INCLUDE. */
#ifndef FIVECHECK_IMPORT_INI_FILE_H
#define FIVECHECK_IMPORT_INI_FILE_H

#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"
#include "base/diag.h"

struct ini_entry {
	const char *section, *key, *value;	/* in the arena */
	struct srcloc at;
};

struct ini_file {
	struct arena arena;
	struct ini_entry *entries;	/* in the order of the file; owned */
	size_t count, capacity;
};

/* False, reported: the file cannot be read, or a line is not one of an ini file. Release it in either case. */
bool ini_file_read(struct ini_file *ini, const char *path, struct diag *diag);
void ini_file_release(struct ini_file *ini);

/* The first entry with this name after `after` (NULL: from the first entry on), or NULL. */
const struct ini_entry *ini_file_next(const struct ini_file *ini, const struct ini_entry *after, const char *section,
				      const char *key);

/* The value of the first entry with this name, or NULL. */
const char *ini_file_text(const struct ini_file *ini, const char *section, const char *key);

/* A number; *value is not changed if there is no such entry. False, reported: it is not a number. */
bool ini_file_number(const struct ini_file *ini, const char *section, const char *key, double *value,
		     struct diag *diag);

/*
 * The path of the file `name` that the file `path` refers to: in the folder of `path`, unless the name is absolute. In
 * the arena.
 */
const char *ini_file_beside(struct arena *arena, const char *path, const char *name);

#endif
