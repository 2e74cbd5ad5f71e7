/*
 * mesh_coder.h - triangles between points of a grid, coded as report_data.h, "MESHES", describes: by a walk from each
 * triangle to its neighbours (as in Rossignac, Edgebreaker, 1999); new vertices are predicted from the last triangle
 * (as in Touma and Gotsman, Triangle mesh compression, 1998).
 */
#ifndef FIVECHECK_REPORT_HTML_MESH_CODER_H
#define FIVECHECK_REPORT_HTML_MESH_CODER_H

#include <stddef.h>
#include <stdint.h>

#include "base/strbuf.h"

/*
 * Appends the code of the triangles, each with three different points, fewer than 2^30. Triangles that begin a part of
 * the mesh keep their order. Returns the number of points in use, which the reader must know in addition to the number
 * of triangles.
 */
size_t mesh_coder_add(struct strbuf *out, const uint16_t (*points)[3], size_t point_count, const uint32_t *corners,
		      size_t triangles);

#endif
