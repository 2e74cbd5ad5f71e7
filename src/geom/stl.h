/* stl.h - reads STL files, binary and ASCII. */
#ifndef FIVECHECK_GEOM_STL_H
#define FIVECHECK_GEOM_STL_H

#include <stdbool.h>

#include "base/diag.h"
#include "geom/mesh.h"

/* The most triangles of a file, so that 31 bits number the corners. */
#define STL_TRIANGLES_MAX 700000000

/*
 * Reads the triangles of a file; the content decides between binary and ASCII, not the word "solid". A file that is
 * missing, not a regular file, truncated, oversized, empty of triangles, not written to its end (a binary file that
 * ends in two or more triangles of zeros), or not finite is reported with the byte or line of the error; then *out is
 * unchanged and the result false. Coordinates are as in the file, the nearest floats; the rounding includes that of
 * decimals (binary files: 0), in the file's unit.
 */
bool stl_read(struct mesh *out, const char *path, struct diag *diag);

/* The same; a file outside the folder `root` (NULL: no such folder) is also an error. */
bool stl_read_below(struct mesh *out, const char *root, const char *path, struct diag *diag);

#endif
