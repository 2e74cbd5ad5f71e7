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
		     const vec3 *play, const double *stray)
{
	const struct bvh *own[2] = {a, b}, *other[2] = {b, a};

	motion->still = !memcmp(&poses[0], &poses[1], sizeof(poses[0]));
	for (int v = 0; v < 2; v++) {
		struct box_view *view = &motion->views[v];
		double size = a->radius + b->radius;

		for (int e = 0; e < 2; e++) {
			xform pose = v ? xform_inverse(&poses[e]) : poses[e];

			map_init(&view->ends[e], &pose, other[v]->origin, own[v]->origin);
		}
		size += fmax(map_reach(&view->ends[0]), map_reach(&view->ends[1]));
		size += stray[v] + vec3_norm(play[v]);
		view->play[0] = (float)play[v].x;
		view->play[1] = (float)play[v].y;
		view->play[2] = (float)play[v].z;
		view->stray = (float)(stray[v] + BOX_ROUNDING * size);
	}
}

struct box box_whole(const struct bvh *bvh)
{
	const double half[3] = {bvh->half.x, bvh->half.y, bvh->half.z};
	struct box box = {0};

	for (int k = 0; k < 3; k++)
		box.half[k] = (float)(half[k] * (1 + 0x1p-20)) + 0x1p-126f;
	return box;
}

/* Where a box of the other body stands in a frame at one end: middle and half sizes. */
static inline void place(const struct box_map *map, const struct box *box, float c[3], float h[3])
{
	for (int i = 0; i < 3; i++) {
		const float *r = map->r[i], *s = map->abs_r[i];

		c[i] = r[0] * box->centre[0] + r[1] * box->centre[1] + r[2] * box->centre[2] + map->t[i];
		h[i] = s[0] * box->half[0] + s[1] * box->half[1] + s[2] * box->half[2];
	}
}

/* The hull, in a frame, of a box of the other body at both ends of the motion. */
static inline void hull_of(const struct box_view *view, bool still, const struct box *box, float low[3], float high[3],
			   float shift[3])
{
	float c0[3], h0[3], c1[3], h1[3];

	place(&view->ends[0], box, c0, h0);
	if (still) {
		for (int i = 0; i < 3; i++) {
			low[i] = c0[i] - h0[i] - view->play[i];
			high[i] = c0[i] + h0[i] + view->play[i];
			shift[i] = 2 * view->play[i];
		}
		return;
	}
	place(&view->ends[1], box, c1, h1);
	for (int i = 0; i < 3; i++) {
		low[i] = (c0[i] - h0[i] < c1[i] - h1[i] ? c0[i] - h0[i] : c1[i] - h1[i]) - view->play[i];
		high[i] = (c0[i] + h0[i] > c1[i] + h1[i] ? c0[i] + h0[i] : c1[i] + h1[i]) + view->play[i];
		shift[i] = fabsf(c1[i] - c0[i]) + 2 * view->play[i];
	}
}

/* A hull is tight along one straight shift and loose by what goes across it: the second largest. */
static inline float second_largest(const float shift[3])
{
	float ab_least = shift[0] < shift[1] ? shift[0] : shift[1];
	float ab_most = shift[0] < shift[1] ? shift[1] : shift[0];
	float c_or_less = ab_most < shift[2] ? ab_most : shift[2];

	return ab_least > c_or_less ? ab_least : c_or_less;
}

/* In the node's frame: the moving box has one hull, the children stand still. */
static void apart_in_own(const struct box_view *view, bool still, const struct bvh_node *node, const struct box *other,
			 float square[BVH_WIDTH], float *loose)
{
	float low[3], high[3], shift[3];

	hull_of(view, still, other, low, high, shift);
	for (int l = 0; l < BVH_WIDTH; l++)
		square[l] = 0;
	for (int i = 0; i < 3; i++) {
		for (int l = 0; l < BVH_WIDTH; l++) {
			float below = low[i] - (node->centre[i][l] + node->half[i][l]);
			float above = (node->centre[i][l] - node->half[i][l]) - high[i];
			float gap = below > above ? below : above;

			gap = gap > 0 ? gap : 0;
			square[l] += gap * gap;
		}
	}
	*loose = second_largest(shift) + view->stray;
}

/* One axis of the box's frame: where each child stands on it at one end. */
static inline void place_children(const struct box_map *map, int axis, const struct bvh_node *node,
				  float low[BVH_WIDTH], float high[BVH_WIDTH], float centre[BVH_WIDTH])
{
	const float *r = map->r[axis], *s = map->abs_r[axis];

	for (int l = 0; l < BVH_WIDTH; l++) {
		float c = r[0] * node->centre[0][l] + r[1] * node->centre[1][l] + r[2] * node->centre[2][l] + map->t[axis];
		float h = s[0] * node->half[0][l] + s[1] * node->half[1][l] + s[2] * node->half[2][l];

		centre[l] = c;
		low[l] = c - h;
		high[l] = c + h;
	}
}

/* In the box's frame: every child has a hull of its own. */
static void apart_in_other(const struct box_view *view, bool still, const struct bvh_node *node,
			   const struct box *other, float square[BVH_WIDTH], float loose[BVH_WIDTH])
{
	float shift[3][BVH_WIDTH];

	for (int l = 0; l < BVH_WIDTH; l++)
		square[l] = 0;
	for (int i = 0; i < 3; i++) {
		float low[BVH_WIDTH], high[BVH_WIDTH], c0[BVH_WIDTH];
		float least = other->centre[i] - other->half[i] - view->play[i];
		float most = other->centre[i] + other->half[i] + view->play[i];

		place_children(&view->ends[0], i, node, low, high, c0);
		for (int l = 0; l < BVH_WIDTH; l++)
			shift[i][l] = 2 * view->play[i];
		if (!still) {
			float low1[BVH_WIDTH], high1[BVH_WIDTH], c1[BVH_WIDTH];

			place_children(&view->ends[1], i, node, low1, high1, c1);
			for (int l = 0; l < BVH_WIDTH; l++) {
				low[l] = low[l] < low1[l] ? low[l] : low1[l];
				high[l] = high[l] > high1[l] ? high[l] : high1[l];
				shift[i][l] += fabsf(c1[l] - c0[l]);
			}
		}
		for (int l = 0; l < BVH_WIDTH; l++) {
			float below = least - high[l], above = low[l] - most;
			float gap = below > above ? below : above;

			gap = gap > 0 ? gap : 0;
			square[l] += gap * gap;
		}
	}
	for (int l = 0; l < BVH_WIDTH; l++)
		loose[l] = second_largest((float[3]){shift[0][l], shift[1][l], shift[2][l]}) + view->stray;
}

void boxes_apart(const struct box_motion *motion, int side, const struct bvh_node *node, const struct box *other,
		 float apart[BVH_WIDTH], float loose[BVH_WIDTH])
{
	float own[BVH_WIDTH], others[BVH_WIDTH], own_loose;

	apart_in_own(&motion->views[side], motion->still, node, other, own, &own_loose);
	apart_in_other(&motion->views[1 - side], motion->still, node, other, others, loose);
	for (int l = 0; l < BVH_WIDTH; l++) {
		float in_own = sqrtf(own[l]) * (1 - 0x1p-20f) - motion->views[side].stray;
		float in_other = sqrtf(others[l]) * (1 - 0x1p-20f) - motion->views[1 - side].stray;
		float best = in_own > in_other ? in_own : in_other;

		apart[l] = best > 0 ? best : 0;
		loose[l] = loose[l] < own_loose ? loose[l] : own_loose;
	}
}

float box_pair_apart(const struct box_motion *motion, const struct box *a, const struct box *b, float *loose)
{
	struct bvh_node node = {0};
	float apart[BVH_WIDTH], looses[BVH_WIDTH];

	for (int k = 0; k < 3; k++) {
		for (int l = 0; l < BVH_WIDTH; l++) {
			node.centre[k][l] = a->centre[k];
			node.half[k][l] = a->half[k];
		}
	}
	boxes_apart(motion, 0, &node, b, apart, looses);
	*loose = looses[0];
	return apart[0];
}
