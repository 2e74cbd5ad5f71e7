#include "report/pose.h"

#include <stdint.h>
#include <string.h>

#include "report/output.h"

enum { STL_HEADER = 80, STL_TRIANGLE = 50 };

static void put_u32(unsigned char *to, uint32_t value)
{
	for (int i = 0; i < 4; i++)
		to[i] = (unsigned char)(value >> (8 * i));
}

static void put_vec3(unsigned char *to, vec3 v)
{
	const float values[3] = {(float)v.x, (float)v.y, (float)v.z};

	for (int i = 0; i < 3; i++) {
		uint32_t bits;

		memcpy(&bits, &values[i], sizeof(bits));
		put_u32(to + 4 * i, bits);
	}
}

static bool is_present(const struct scene_body *body, int tool)
{
	return body->body->tool == 0 || body->body->tool == tool;
}

/* A degenerate triangle has no normal; readers compute a normal that is 0 0 0. */
static vec3 normal_of(const vec3 corners[3])
{
	vec3 n = vec3_cross(vec3_sub(corners[1], corners[0]), vec3_sub(corners[2], corners[0]));
	double length = vec3_norm(n);

	return length > 0 ? vec3_scale(1 / length, n) : (vec3){0, 0, 0};
}

static void write_body(struct output *out, const struct bvh *bvh, const xform *pose)
{
	for (size_t i = 0; i < bvh->mesh.count; i++) {
		unsigned char bytes[STL_TRIANGLE] = {0};
		vec3 corners[3];

		for (int k = 0; k < 3; k++) {
			corners[k] = xform_apply(pose, mesh_corner(&bvh->mesh.triangles[i], k));
			put_vec3(bytes + 12 * (k + 1), corners[k]);
		}
		put_vec3(bytes, normal_of(corners));
		output_write(out, (const char *)bytes, sizeof(bytes));
	}
}

/* Builds the trees that are still missing and counts the triangles. */
static bool count_triangles(struct scene *scene, int tool, uint32_t *count, struct diag *diag)
{
	size_t sum = 0;

	for (size_t i = 0; i < scene->body_count; i++) {
		const struct bvh *bvh;

		if (!is_present(&scene->bodies[i], tool))
			continue;
		bvh = scene_body_bvh(scene, (int)i, diag);
		if (!bvh)
			return false;
		sum += bvh->mesh.count;
	}
	*count = (uint32_t)sum;
	if (sum > UINT32_MAX)
		diag_error(diag, (struct srcloc){0}, "the pose has %zu triangles, more than an STL file can hold", sum);
	return sum <= UINT32_MAX;
}

bool pose_write(const char *path, struct scene *scene, const axis_values *axes, int tool, struct diag *diag)
{
	unsigned char head[STL_HEADER + 4] = "fivecheck pose, binary STL, mm";
	struct output out;
	uint32_t count;

	if (!count_triangles(scene, tool, &count, diag) || !output_open(&out, path, diag))
		return false;
	put_u32(head + STL_HEADER, count);
	output_write(&out, (const char *)head, sizeof(head));
	for (size_t i = 0; i < scene->body_count; i++) {
		const struct scene_body *body = &scene->bodies[i];
		xform pose = machine_pose(scene->machine, body->body->link, axes);

		pose = xform_mul(&pose, &body->body->placement);
		if (is_present(body, tool))
			write_body(&out, body->bvh, &pose);
	}
	return output_commit(&out, diag);
}
