/* stl_bytes.h - the bytes of a binary STL file. */
#ifndef FIVECHECK_GEOM_STL_BYTES_H
#define FIVECHECK_GEOM_STL_BYTES_H

#include <stdint.h>

#include "geom/mesh.h"
#include "geom/vec3.h"

enum { STL_HEAD_BYTES = 84, STL_TRIANGLE_BYTES = 50 };

/* The title, at most 80 characters, and the number of triangles that follow. */
void stl_bytes_head(unsigned char bytes[STL_HEAD_BYTES], const char *title, uint32_t count);

/* A degenerate triangle has no normal; readers compute one that is 0 0 0. */
void stl_bytes_triangle(unsigned char bytes[STL_TRIANGLE_BYTES], const mesh_triangle *triangle);

#endif
