/* confine.h - keeps the files that an input may name inside one folder. */
#ifndef FIVECHECK_BASE_CONFINE_H
#define FIVECHECK_BASE_CONFINE_H

#include <stdbool.h>

/*
 * Is the file inside of the folder, once every symbolic link and every ".." is
 * followed? Of a file that is not there the folder that would hold it counts. A
 * root of NULL confines nothing; a root that cannot be resolved holds nothing.
 */
bool confine_holds(const char *root, const char *path);

#endif
