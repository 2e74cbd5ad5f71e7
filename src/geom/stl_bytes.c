#include "geom/stl_bytes.h"

#include <string.h>

enum { TITLE = 80 };

static void put_u32(unsigned char *to, uint32_t value)
{
	for (int i = 0; i < 4; i++)
		to[i] = (unsigned char)(value >> (8 * i));
}

static void put_float(unsigned char *to, float value)
{
	uint32_t bits;

	memcpy(&bits, &value, sizeof(bits));
	put_u32(to, bits);
}

static vec3 normal_of(const mesh_triangle *triangle)
{
	const vec3 corner = mesh_corner(triangle, 0);
	const vec3 n =
	    vec3_cross(vec3_sub(mesh_corner(triangle, 1), corner), vec3_sub(mesh_corner(triangle, 2), corner));
	const double length = vec3_norm(n);

	return length > 0 ? vec3_scale(1 / length, n) : (vec3){0, 0, 0};
}

void stl_bytes_head(unsigned char bytes[STL_HEAD_BYTES], const char *title, uint32_t count)
{
	const size_t length = strlen(title);

	memset(bytes, 0, STL_HEAD_BYTES);
	memcpy(bytes, title, length < TITLE ? length : TITLE);
	put_u32(bytes + TITLE, count);
}

void stl_bytes_triangle(unsigned char bytes[STL_TRIANGLE_BYTES], const mesh_triangle *triangle)
{
	const vec3 n = normal_of(triangle);

	memset(bytes, 0, STL_TRIANGLE_BYTES);
	put_float(bytes, (float)n.x);
	put_float(bytes + 4, (float)n.y);
	put_float(bytes + 8, (float)n.z);
	for (int k = 0; k < 9; k++)
		put_float(bytes + 12 + 4 * k, triangle->v[k / 3][k % 3]);
}
