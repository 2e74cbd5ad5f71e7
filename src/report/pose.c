#include "report/pose.h"

#include <stdint.h>

#include "geom/stl_bytes.h"
#include "report/output.h"

static bool is_present(const struct scene_body *body, int tool)
{
	return body->body->tool == 0 || body->body->tool == tool;
}

static void write_body(struct output *out, const struct bvh *bvh, const xform *pose)
{
	for (size_t i = 0; i < bvh->mesh.count; i++) {
		unsigned char bytes[STL_TRIANGLE_BYTES];
		mesh_triangle placed;

		for (int k = 0; k < 3; k++) {
			const vec3 corner = xform_apply(pose, mesh_corner(&bvh->mesh.triangles[i], k));

			placed.v[k][0] = (float)corner.x;
			placed.v[k][1] = (float)corner.y;
			placed.v[k][2] = (float)corner.z;
		}
		stl_bytes_triangle(bytes, &placed);
		output_write(out, (const char *)bytes, sizeof(bytes));
	}
}

/* Builds the trees that are still missing and counts the triangles. */
static bool count_triangles(struct scene *scene, int tool, uint32_t *count, struct diag *diag)
{
	size_t sum = 0;

	for (size_t i = 0; i < scene->body_count; i++) {
		if (is_present(&scene->bodies[i], tool))
			sum += scene_body_bvh(scene, (int)i)->mesh.count;
	}
	*count = (uint32_t)sum;
	if (sum > UINT32_MAX)
		diag_error(diag, (struct srcloc){0}, "the pose has %zu triangles, more than an STL file can hold", sum);
	return sum <= UINT32_MAX;
}

bool pose_write(const char *path, struct scene *scene, const axis_values *axes, int tool, struct diag *diag)
{
	unsigned char head[STL_HEAD_BYTES];
	struct output out;
	uint32_t count;

	if (!count_triangles(scene, tool, &count, diag) || !output_open(&out, path, diag))
		return false;
	stl_bytes_head(head, "fivecheck pose, binary STL, mm", count);
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
