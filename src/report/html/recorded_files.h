/* recorded_files.h - the names of the files of a program, in the order in which the program reaches them. */
#ifndef FIVECHECK_REPORT_HTML_RECORDED_FILES_H
#define FIVECHECK_REPORT_HTML_RECORDED_FILES_H

#include <stddef.h>

/* The name of a file as used by the check, and a copy that outlives the check. */
struct recorded_file {
	const char *interned;
	char *name;
};

/* All zero is empty. The program itself comes first. */
struct recorded_files {
	struct recorded_file *items;
	size_t count, capacity;
};

/* The index of this file, which is added if it is new. */
size_t recorded_files_index(struct recorded_files *files, const char *name);

void recorded_files_release(struct recorded_files *files);

#endif
