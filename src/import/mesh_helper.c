#include "import/mesh_helper.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "import/mesh_program.h"

void mesh_parts_release(struct mesh_parts *parts)
{
	for (size_t i = 0; i < parts->count; i++)
		mesh_build_discard(&parts->items[i].build);
	free(parts->items);
	*parts = (struct mesh_parts){0};
}

static bool fault(struct diag *diag, const char *path, const char *what)
{
	diag_error(diag, (struct srcloc){.file = path}, "%s", what);
	return false;
}

/* ------------------------------------------------------------- triangles */

/* mesh_build rejects coordinates that are not finite, or too far away. */
static bool read_triangle(FILE *in, bool y_up, vec3 corners[3])
{
	unsigned char bytes[36];
	float v[9];

	if (fread(bytes, 1, sizeof(bytes), in) != sizeof(bytes))
		return false;
	for (int i = 0; i < 9; i++) {
		uint32_t bits = 0;

		for (int k = 0; k < 4; k++)
			bits |= (uint32_t)bytes[4 * i + k] << (8 * k);
		memcpy(&v[i], &bits, sizeof(bits));
	}
	for (int i = 0; i < 3; i++) {
		const float *p = &v[3 * i];

		corners[i] = y_up ? (vec3){p[0], -(double)p[2], p[1]} : (vec3){p[0], p[1], p[2]};
	}
	return true;
}

static bool read_part(struct mesh_parts *parts, const char *line, FILE *in, double scale, bool y_up)
{
	struct mesh_part part = {.build = {.scale = scale}};
	char *rest;
	unsigned long count = strtoul(line, &rest, 10);
	vec3 corners[3];
	bool good = true;

	rest += *rest == ' ';
	snprintf(part.name, sizeof(part.name), "%.*s", (int)strcspn(rest, "\n"), rest);
	for (unsigned long i = 0; good && i < count; i++)
		good = read_triangle(in, y_up, corners) && mesh_build_add(&part.build, corners);
	if (!good) {
		mesh_build_discard(&part.build);
		return false;
	}
	parts->items = mem_grow(parts->items, &parts->capacity, parts->count + 1, sizeof(part));
	parts->items[parts->count++] = part;
	return true;
}

/* Reads the output of the program (src/mesh/main.c). */
static bool read_output(struct mesh_parts *parts, const char *path, FILE *in, double scale, bool y_up,
			struct diag *diag)
{
	char line[512];

	while (fgets(line, sizeof(line), in)) {
		line[strcspn(line, "\n")] = '\0';
		if (!strcmp(line, "end"))
			return parts->count > 0 || fault(diag, path, "the file has no triangles");
		if (!strncmp(line, "fault ", 6)) {
			diag_error(diag, (struct srcloc){.file = path}, "the file cannot be read: %s", line + 6);
			return false;
		}
		if (strncmp(line, "mesh ", 5) != 0 || !read_part(parts, line + 5, in, scale, y_up))
			return fault(diag, path, "a triangle is missing, not finite, or beyond 10 km");
	}
	return fault(diag, path,
		     "the meshes cannot be read: fivecheck-mesh is not installed (it needs libassimp), or it failed on "
		     "a broken or very large file; convert the file to STL with another program");
}

bool mesh_helper_read(struct mesh_parts *parts, const char *path, double scale, bool y_up, struct diag *diag)
{
	struct mesh_program program;
	bool good;

	if (!mesh_program_start(&program, path))
		return fault(diag, path, "cannot start fivecheck-mesh: convert the file to STL with another program");
	good = read_output(parts, path, program.out, scale, y_up, diag);
	mesh_program_end(&program);
	return good;
}
