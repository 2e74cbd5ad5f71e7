#include "report/glb/glb_buffer.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "geom/weld.h"
#include "report/format/json.h"

void glb_add_u32(struct strbuf *out, uint32_t value)
{
	char bytes[4];

	for (int i = 0; i < 4; i++)
		bytes[i] = (char)(value >> 8 * i & 255);
	strbuf_add(out, bytes, sizeof(bytes));
}

void glb_add_float(struct strbuf *out, double value)
{
	const float number = (float)value;
	uint32_t bits;

	memcpy(&bits, &number, sizeof(bits));
	glb_add_u32(out, bits);
}

void glb_add_vec3(struct strbuf *out, vec3 v)
{
	glb_add_float(out, v.x);
	glb_add_float(out, v.y);
	glb_add_float(out, v.z);
}

int glb_accessor(struct glb_buffer *buffer, size_t start, int target, int component, const char *type, size_t count,
		 json_t *bounds)
{
	json_t *view = json_object(), *accessor = json_object();

	json_put(view, "buffer", json_integer(0));
	json_put(view, "byteOffset", json_integer((json_int_t)start));
	json_put(view, "byteLength", json_integer((json_int_t)(buffer->binary.length - start)));
	if (target)
		json_put(view, "target", json_integer(target));
	json_push(buffer->views, view);
	json_put(accessor, "bufferView", json_integer((json_int_t)json_array_size(buffer->views) - 1));
	json_put(accessor, "componentType", json_integer(component));
	json_put(accessor, "count", json_integer((json_int_t)count));
	json_put(accessor, "type", json_string(type));
	if (bounds) {
		json_object_update(accessor, bounds);
		json_decref(bounds);
	}
	json_push(buffer->accessors, accessor);
	return (int)json_array_size(buffer->accessors) - 1;
}

static float least(float a, float b)
{
	return a < b ? a : b;
}

static float most(float a, float b)
{
	return a > b ? a : b;
}

/* Adds the vertices, each once, moved by `place`; returns the number of their accessor. */
static int add_vertices(struct glb_buffer *buffer, const struct mesh *mesh, const struct soup *soup, const xform *place)
{
	const size_t start = buffer->binary.length;
	float low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
	size_t *corner_of = mem_alloc((soup->vertex_count + 1) * sizeof(*corner_of));
	json_t *bounds = json_object();

	for (size_t i = 0; i < soup->corner_count; i++)
		corner_of[soup->vertex[i]] = i;
	for (size_t v = 0; v < soup->vertex_count; v++) {
		const size_t i = corner_of[v];
		const vec3 p = xform_apply(place, mesh_corner(&mesh->triangles[i / 3], (int)(i % 3)));
		const float at[3] = {(float)p.x, (float)p.y, (float)p.z};

		glb_add_vec3(&buffer->binary, p);
		for (int k = 0; k < 3; k++) {
			low[k] = least(low[k], at[k]);
			high[k] = most(high[k], at[k]);
		}
	}
	free(corner_of);
	json_put(bounds, "min", glb_three((double)low[0], (double)low[1], (double)low[2]));
	json_put(bounds, "max", glb_three((double)high[0], (double)high[1], (double)high[2]));
	return glb_accessor(buffer, start, GLB_VERTICES, GLB_FLOATS, "VEC3", soup->vertex_count, bounds);
}

/* -1: the body has no triangle with an area. */
static int add_triangles(struct glb_buffer *buffer, const struct mesh *mesh, const struct soup *soup)
{
	const size_t start = buffer->binary.length;

	for (size_t i = 0; i < mesh->count; i++) {
		for (size_t k = 0; k < 3 && !soup_is_degenerate(soup, i); k++)
			glb_add_u32(&buffer->binary, soup->vertex[3 * i + k]);
	}
	if (buffer->binary.length == start)
		return -1;
	return glb_accessor(buffer, start, GLB_INDICES, GLB_UNSIGNED_INTS, "SCALAR",
			    (buffer->binary.length - start) / 4, NULL);
}

json_t *glb_three(double x, double y, double z)
{
	json_t *array = json_array();

	json_push(array, json_real(x));
	json_push(array, json_real(y));
	json_push(array, json_real(z));
	return array;
}

bool glb_mesh(struct glb_buffer *buffer, const struct mesh *mesh, const xform *place, int *positions, int *indices)
{
	struct soup soup;
	int triangles;

	soup_init(&soup, mesh);
	triangles = add_triangles(buffer, mesh, &soup);
	if (triangles >= 0) {
		*indices = triangles;
		*positions = add_vertices(buffer, mesh, &soup, place);
	}
	soup_release(&soup);
	return triangles >= 0;
}
