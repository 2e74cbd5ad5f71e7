/*
 * vericut_mesh.h - reads meshes in the VERICUT-model format, which are named .ply although they are not Stanford PLY.
 */
#ifndef FIVECHECK_IMPORT_VERICUT_MESH_H
#define FIVECHECK_IMPORT_VERICUT_MESH_H

#include <stdbool.h>

#include "base/diag.h"
#include "geom/mesh.h"

/* Do the first bytes of a file show that it has this format? */
bool vericut_mesh_is(const char *bytes, size_t count);

/*
 * Reads the triangles of version 2.0: a head of four lines, then polygons to the end of the file. A polygon is a byte
 * with the number of its corners, their coordinates, and its normal, little-endian doubles; only triangles occur. The
 * format was derived from public files; a file that differs is an error, reported with its byte. The coordinates are
 * multiplied by `scale`.
 */
bool vericut_mesh_read(struct mesh *out, const char *path, double scale, struct diag *diag);

#endif
