/* same_file.h - do two results of stat belong to one file? */
#ifndef FIVECHECK_BASE_SAME_FILE_H
#define FIVECHECK_BASE_SAME_FILE_H

#include <stdbool.h>
#include <sys/stat.h>

/* False if the file system gives its files no numbers (0): then only their names tell. */
static inline bool same_file(const struct stat *a, const struct stat *b)
{
	return a->st_ino && a->st_dev == b->st_dev && a->st_ino == b->st_ino;
}

#endif
