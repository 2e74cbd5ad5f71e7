#include "scene/box_query.h"

void box_query_init(struct box_query *query, const struct bvh *a, const struct bvh *b, const xform *pose)
{
	const vec3 no_axis_displacement[] = {{0, 0, 0}, {0, 0, 0}};
	const double no_displacement[] = {0, 0};
	const xform ends[2] = {*pose, *pose};

	query->bodies[0] = a;
	query->bodies[1] = b;
	box_motion_init(&query->boxes, a, b, ends, no_axis_displacement, no_displacement);
}

bool box_query_parts_boxes(const struct box_query *query)
{
	const struct box a = box_whole(query->bodies[0]), b = box_whole(query->bodies[1]);
	float lost;

	return box_pair_apart(&query->boxes, &a, &b, &lost) > 0;
}

/* Are the triangles below the node apart from the other body's box? The recursion is as deep as the tree. */
static bool parts_node(const struct box_query *query, int side, const struct bvh_node *node, const struct box *other)
{
	float apart[BVH_WIDTH], lost[BVH_WIDTH];

	boxes_apart(&query->boxes, side, node, other, 0, apart, lost);
	for (int lane = 0; lane < node->used; lane++) {
		if (apart[lane] > 0)
			continue;
		if (node->count[lane] ||
		    !parts_node(query, side, &query->bodies[side]->nodes[node->first[lane]], other))
			return false;
	}
	return true;
}

bool box_query_parts_surface(const struct box_query *query, int side)
{
	const struct box other = box_whole(query->bodies[1 - side]);

	return parts_node(query, side, &query->bodies[side]->nodes[0], &other);
}
