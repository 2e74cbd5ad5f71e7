#include "scene/bvh_pair.h"

void leaf_box(const struct bvh *bvh, struct leaf leaf, vec3 *centre, vec3 *half)
{
	vec3 least, greatest;

	if (leaf.count) {
		least = greatest = mesh_corner(&bvh->mesh.triangles[leaf.first], 0);
		for (uint32_t i = 0; i < 3u * leaf.count; i++) {
			vec3 p = mesh_corner(&bvh->mesh.triangles[leaf.first + i / 3], (int)(i % 3));

			least = vec3_min(least, p);
			greatest = vec3_max(greatest, p);
		}
		least = vec3_sub(least, bvh->origin);
		greatest = vec3_sub(greatest, bvh->origin);
	} else {
		const struct bvh_node *node = &bvh->nodes[leaf.first];

		least = vec3_sub(bvh_child_centre(node, 0), bvh_child_half(node, 0));
		greatest = vec3_add(bvh_child_centre(node, 0), bvh_child_half(node, 0));
		for (int i = 1; i < node->used; i++) {
			least = vec3_min(least, vec3_sub(bvh_child_centre(node, i), bvh_child_half(node, i)));
			greatest = vec3_max(greatest, vec3_add(bvh_child_centre(node, i), bvh_child_half(node, i)));
		}
	}
	*centre = vec3_scale(0.5, vec3_add(least, greatest));
	*half = vec3_scale(0.5, vec3_sub(greatest, least));
}
