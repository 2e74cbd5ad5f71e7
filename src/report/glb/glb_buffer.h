/* glb_buffer.h - the binary part of a glTF file and the accessors into it. */
#ifndef FIVECHECK_REPORT_GLB_GLB_BUFFER_H
#define FIVECHECK_REPORT_GLB_GLB_BUFFER_H

#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/strbuf.h"
#include "geom/mesh.h"
#include "geom/xform.h"

/* Constants of glTF 2.0 (section 5). */
enum { GLB_FLOATS = 5126, GLB_UNSIGNED_INTS = 5125, GLB_VERTICES = 34962, GLB_INDICES = 34963, GLB_NO_TARGET = 0 };

struct glb_buffer {
	struct strbuf binary;
	json_t *views, *accessors;	/* arrays */
};

void glb_add_u32(struct strbuf *out, uint32_t value);
void glb_add_float(struct strbuf *out, double value);
void glb_add_vec3(struct strbuf *out, vec3 v);

/* [x, y, z] */
json_t *glb_three(double x, double y, double z);

/*
 * Makes an accessor for everything from `start` to the end of the binary; returns its number. Takes over `bounds`,
 * which may be NULL.
 */
int glb_accessor(struct glb_buffer *buffer, size_t start, int target, int component, const char *type, size_t count,
		 json_t *bounds);

/* Adds a mesh, its vertices moved by `place`. False: it has no triangle with an area. */
bool glb_mesh(struct glb_buffer *buffer, const struct mesh *mesh, const xform *place, int *positions, int *indices);

#endif
