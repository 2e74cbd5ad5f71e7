/* file_names.h - file names that are kept once each, so that who holds one need not copy it. */
#ifndef FIVECHECK_BASE_FILE_NAMES_H
#define FIVECHECK_BASE_FILE_NAMES_H

#include <stddef.h>

/* All zero is empty. A run has few names: the program's and those of its subprograms. */
struct file_names {
	char **items;	/* owned */
	size_t count, capacity;
};

/*
 * The kept copy of the name: equal names give equal pointers, which are valid until file_names_release. Other threads
 * may read a name that was handed to them, but only one thread may call this.
 */
const char *file_names_keep(struct file_names *names, const char *name);

void file_names_release(struct file_names *names);

#endif
