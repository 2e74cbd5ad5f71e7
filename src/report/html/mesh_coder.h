/*
 * mesh_coder.h - triangles between points of a grid, coded as report_data.h, "MESHES", describes: in a walk from each
 * triangle to its neighbours (as in Rossignac, Edgebreaker, 1999), new vertices foretold from the triangle before (as
 * in Touma and Gotsman, Triangle mesh compression, 1998).
 */
#ifndef FIVECHECK_REPORT_HTML_MESH_CODER_H
#define FIVECHECK_REPORT_HTML_MESH_CODER_H

#include <stddef.h>
#include <stdint.h>

#include "base/strbuf.h"

/*
 * Appends the code of the triangles, three different points each, fewer than 2^30. Triangles that begin a part of the
 * mesh keep their order. The result: how many points are used, which the reader must know besides the number of
 * triangles.
 */
size_t mesh_coder_add(struct strbuf *out, const uint16_t (*points)[3], size_t point_count, const uint32_t *corners,
		      size_t triangles);

#endif
