#include "geom/boxes.h"

#include <math.h>
#include <string.h>

#include "geom/tolerance.h"

static void map_init(struct box_map *map, const xform *pose, vec3 from_origin, vec3 to_origin)
{
	const mat3 *m = &pose->rotation;
	vec3 t = vec3_sub(xform_apply(pose, from_origin), to_origin);
	const double rows[3][3] = {{m->x.x, m->y.x, m->z.x}, {m->x.y, m->y.y, m->z.y}, {m->x.z, m->y.z, m->z.z}};

	for (int i = 0; i < 3; i++) {
		for (int j = 0; j < 3; j++) {
			map->r[i][j] = (float)rows[i][j];
			map->abs_r[i][j] = fabsf(map->r[i][j]);
		}
	}
	map->t[0] = (float)t.x;
	map->t[1] = (float)t.y;
	map->t[2] = (float)t.z;
}

static double map_reach(const struct box_map *map)
{
	return sqrt((double)map->t[0] * map->t[0] + (double)map->t[1] * map->t[1] + (double)map->t[2] * map->t[2]);
}

void box_motion_init(struct box_motion *motion, const struct bvh *a, const struct bvh *b, const xform *poses,
		     const vec3 *axis_displacement, const double *displacement)
{
	const struct bvh *own[2] = {a, b}, *other[2] = {b, a};

	motion->apart = simd_kernels_at_level(a->simd_level)->boxes_apart;
	/* NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): -0 and 0 may count as a motion. */
	motion->still = !memcmp(&poses[0], &poses[1], sizeof(poses[0]));
	for (int v = 0; v < 2; v++) {
		struct box_view *view = &motion->views[v];
		double size = a->radius + b->radius;

		for (int e = 0; e < 2; e++) {
			xform pose = v ? xform_inverse(&poses[e]) : poses[e];

			map_init(&view->ends[e], &pose, other[v]->origin, own[v]->origin);
		}
		size += fmax(map_reach(&view->ends[0]), map_reach(&view->ends[1]));
		size += displacement[v] + vec3_norm(axis_displacement[v]);
		view->axis_displacement[0] = (float)axis_displacement[v].x;
		view->axis_displacement[1] = (float)axis_displacement[v].y;
		view->axis_displacement[2] = (float)axis_displacement[v].z;
		view->displacement = (float)(displacement[v] + BOX_ROUNDING * size);
	}
}

struct box box_whole(const struct bvh *bvh)
{
	const double half[3] = {bvh->half.x, bvh->half.y, bvh->half.z};
	struct box box = {0};

	for (int k = 0; k < 3; k++)
		box.half[k] = (float)(half[k] * (1 + FLOAT_MARGIN)) + 0x1p-126f;
	return box;
}

void boxes_apart(const struct box_motion *motion, int side, const struct bvh_node *node, const struct box *other,
		 float enough, float apart[BVH_WIDTH], float lost[BVH_WIDTH])
{
	motion->apart(motion, side, node, other, enough, apart, lost);
}

float box_pair_apart(const struct box_motion *motion, const struct box *a, const struct box *b, float *lost)
{
	struct bvh_node node = {0};
	float apart[BVH_WIDTH], lost_of_one[BVH_WIDTH];

	for (int k = 0; k < 3; k++) {
		for (int l = 0; l < BVH_WIDTH; l++) {
			node.centre[k][l] = a->centre[k];
			node.half[k][l] = a->half[k];
		}
	}
	boxes_apart(motion, 0, &node, b, INFINITY, apart, lost_of_one);
	*lost = lost_of_one[0];
	return apart[0];
}
