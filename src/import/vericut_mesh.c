#include "import/vericut_mesh.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/file_bytes.h"
#include "base/mem.h"
#include "import/mesh_build.h"

static const char head[] = "VERICUT-model\nversion-2.0\n1\n0 1 0\n";
static const char magic[] = "VERICUT-model\n";

/* A count, three corners and a normal. */
enum { CORNERS = 3, RECORD = 1 + 8 * 3 * (CORNERS + 1) };

bool vericut_mesh_is(const char *bytes, size_t count)
{
	return count >= strlen(magic) && !memcmp(bytes, magic, strlen(magic));
}

static double get_double(const unsigned char *from)
{
	uint64_t bits = 0;
	double value;

	for (int i = 7; i >= 0; i--)
		bits = bits << 8 | from[i];
	memcpy(&value, &bits, sizeof(value));
	return value;
}

/* False: a corner is not finite or too far away. */
static bool add_triangle(struct mesh_build *build, const unsigned char *record)
{
	vec3 corners[CORNERS];

	for (int i = 0; i < CORNERS; i++) {
		const unsigned char *at = record + 1 + 24 * i;

		corners[i] = (vec3){get_double(at), get_double(at + 8), get_double(at + 16)};
	}
	return mesh_build_add(build, corners);
}

static bool fault(const char *path, struct diag *diag, size_t offset, const char *what)
{
	diag_error(diag, (struct srcloc){.file = path}, "byte %zu: %s", offset, what);
	return false;
}

static bool read_polygons(struct mesh_build *build, const struct file_bytes *file, const char *path, struct diag *diag)
{
	const unsigned char *bytes = (const unsigned char *)file->bytes;
	size_t at = strlen(head);

	if (file->count < at || memcmp(bytes, head, at) != 0)
		return fault(path, diag, 0,
			     "this is not a VERICUT-model of the known version 2.0: save the mesh as STL and name "
			     "that");
	for (; at < file->count; at += RECORD) {
		if (bytes[at] != CORNERS)
			return fault(path, diag, at,
				     "only polygons with three corners are supported: save the mesh as STL and name "
				     "that");
		if (file->count - at < RECORD)
			return fault(path, diag, at, "the file ends inside a triangle");
		if (!add_triangle(build, bytes + at))
			return fault(path, diag, at, "a corner of this triangle is not finite, or beyond 10 km");
	}
	return build->mesh.count || fault(path, diag, at, "the file has no triangles");
}

bool vericut_mesh_read(struct mesh *out, const char *path, double scale, struct diag *diag)
{
	struct file_bytes file;
	struct mesh_build build = {.scale = scale};
	bool good;

	if (!file_bytes_read(&file, path, diag))
		return false;
	good = read_polygons(&build, &file, path, diag);
	file_bytes_release(&file);
	if (good)
		mesh_build_finish(&build, out);
	else
		mesh_build_discard(&build);
	return good;
}
