/* path_sandbox.h - keeps the files that an input may name inside one folder. */
#ifndef FIVECHECK_BASE_PATH_SANDBOX_H
#define FIVECHECK_BASE_PATH_SANDBOX_H

#include <stdbool.h>

/*
 * Is the file inside of the folder, once every symbolic link and every ".." is
 * followed? Of a file that is not there the folder that would hold it counts. A
 * root of NULL confines nothing; a root that cannot be resolved holds nothing.
 * It holds for now only: what is opened is opened by path_sandbox_open.
 */
bool path_sandbox_holds(const char *root, const char *path);

/*
 * Opens the file for reading, without waiting where it is a pipe. With a root what is opened is inside
 * of it, whoever exchanges links and folders meanwhile. -1: errno says why not; EXDEV: it is outside.
 */
int path_sandbox_open(const char *root, const char *path);

#endif
