/* stl.h - reads STL files, binary and ASCII. */
#ifndef FIVECHECK_GEOM_STL_H
#define FIVECHECK_GEOM_STL_H

#include <stdbool.h>

#include "base/diag.h"
#include "geom/mesh.h"

/* No file may have more, so that 31 bits number its corners. */
#define STL_TRIANGLES_MAX 700000000

/*
 * Reads the triangles of a file; binary and ASCII are told apart by the
 * content, not by the word "solid". What is missing, not a regular file,
 * truncated, oversized, empty of triangles, not written to its end (two or more
 * triangles of zeros there in a binary file), or not finite is reported with the
 * byte or line where it stands; then *out is untouched and the result false.
 * Coordinates are as in the file, the nearest floats; the rounding accounts for the
 * rounding of decimals (binary files: 0), in the file's unit.
 */
bool stl_read(struct mesh *out, const char *path, struct diag *diag);

/* The same; a file outside of the folder `root` (NULL: no such folder) is an error, too. */
bool stl_read_below(struct mesh *out, const char *root, const char *path, struct diag *diag);

#endif
