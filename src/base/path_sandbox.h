/* path_sandbox.h - restricts the files that an input may name to one folder. */
#ifndef FIVECHECK_BASE_PATH_SANDBOX_H
#define FIVECHECK_BASE_PATH_SANDBOX_H

#include <stdbool.h>

/*
 * Is the file inside the folder, after every symbolic link and every ".." is followed? For a missing file, the folder
 * that would contain it counts. A root of NULL restricts nothing; nothing is inside a root that cannot be resolved. The
 * answer can become wrong later: open files with path_sandbox_open.
 */
bool path_sandbox_holds(const char *root, const char *path);

/*
 * Opens the file for reading, without waiting if it is a pipe. With a root, the opened file is inside it, even if links
 * and folders are exchanged meanwhile. -1: errno has the reason; EXDEV: it is outside.
 */
int path_sandbox_open(const char *root, const char *path);

#endif
