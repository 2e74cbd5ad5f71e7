/* file_names.h - keeps each file name once, so that others can borrow it. */
#ifndef FIVECHECK_BASE_FILE_NAMES_H
#define FIVECHECK_BASE_FILE_NAMES_H

#include <stddef.h>

/* All zero is empty. A run has few names: those of the program and its subprograms. */
struct file_names {
	char **items;	/* owned */
	size_t count, capacity;
};

/*
 * The kept copy of the name: equal names give equal pointers, which are valid until file_names_release. Other threads
 * may read names that they received, but only one thread may call this.
 */
const char *file_names_keep(struct file_names *names, const char *name);

void file_names_release(struct file_names *names);

#endif
