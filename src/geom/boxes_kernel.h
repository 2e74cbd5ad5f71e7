/*
 * boxes_kernel.h - the box tests of boxes.h for one level of SIMD.
 *
 * Included through level_kernels.h once by each of simd_scalar.c, simd_sse2.c and simd_avx2.c, which define
 * LANES_LEVEL and AT_LEVEL(name), the name at that level of the one function that comes out.
 */
#include "geom/boxes.h"
#include "geom/lanes.h"
#include "geom/tolerance.h"

_Static_assert((int)BVH_WIDTH == (int)LANES, "a lane a child");

/* The extent of each child along an axis. */
struct extent {
	lanes low, high, middle;
};

/* The position of a box of the other body on an axis of a frame at one end: middle and half size. */
static inline void place(const struct box_map *map, int axis, const struct box *box, float *middle, float *half)
{
	const float *r = map->r[axis], *s = map->abs_r[axis];

	*middle = r[0] * box->centre[0] + r[1] * box->centre[1] + r[2] * box->centre[2] + map->t[axis];
	*half = s[0] * box->half[0] + s[1] * box->half[1] + s[2] * box->half[2];
}

/* The same for the children of a node. */
LANES_FUNCTION struct extent place_children(const struct box_map *map, int axis, const struct bvh_node *node)
{
	struct extent e = {lanes_all(0), lanes_all(0), lanes_all(0)};
	lanes half = e.low;

	for (int k = 0; k < 3; k++) {
		lanes c = lanes_mul(lanes_all(map->r[axis][k]), lanes_load(node->centre[k]));
		lanes h = lanes_mul(lanes_all(map->abs_r[axis][k]), lanes_load(node->half[k]));

		e.middle = k ? lanes_add(e.middle, c) : c;
		half = k ? lanes_add(half, h) : h;
	}
	e.middle = lanes_add(e.middle, lanes_all(map->t[axis]));
	e.low = lanes_sub(e.middle, half);
	e.high = lanes_add(e.middle, half);
	return e;
}

/* Adds the square of the gap between two intervals, 0 if they overlap, to `sum`. */
LANES_FUNCTION lanes add_gap(lanes sum, lanes low_a, lanes high_a, lanes low_b, lanes high_b)
{
	lanes gap = lanes_max(lanes_sub(low_a, high_b), lanes_sub(low_b, high_a));

	gap = lanes_max(gap, lanes_all(0));
	return lanes_add(sum, lanes_mul(gap, gap));
}

/* A hull is tight along one straight shift; the loss is across it: the second largest. */
LANES_FUNCTION lanes second_largest(lanes a, lanes b, lanes c)
{
	return lanes_max(lanes_min(a, b), lanes_min(lanes_max(a, b), c));
}

/* In the node's frame the moving box has one hull, and the children are fixed. */
LANES_FUNCTION lanes apart_in_own(const struct box_view *view, bool still, const struct bvh_node *node,
				  const struct box *other, lanes *lost)
{
	lanes square = lanes_all(0), shift[3];

	for (int i = 0; i < 3; i++) {
		lanes centre = lanes_load(node->centre[i]), half = lanes_load(node->half[i]);
		float displacement = view->axis_displacement[i], moved = 2 * displacement, low, high, middle, size;

		place(&view->ends[0], i, other, &middle, &size);
		low = middle - size;
		high = middle + size;
		if (!still) {
			float middle1;

			place(&view->ends[1], i, other, &middle1, &size);
			low = middle1 - size < low ? middle1 - size : low;
			high = middle1 + size > high ? middle1 + size : high;
			moved += middle1 > middle ? middle1 - middle : middle - middle1;
		}
		square = add_gap(square, lanes_all(low - displacement), lanes_all(high + displacement),
				 lanes_sub(centre, half), lanes_add(centre, half));
		shift[i] = lanes_all(moved);
	}
	*lost = lanes_add(second_largest(shift[0], shift[1], shift[2]), lanes_all(view->displacement));
	return square;
}

/* In the box's frame every child has its own hull. */
LANES_FUNCTION lanes apart_in_other(const struct box_view *view, bool still, const struct bvh_node *node,
				    const struct box *other, lanes *lost)
{
	lanes square = lanes_all(0), shift[3];

	for (int i = 0; i < 3; i++) {
		struct extent e = place_children(&view->ends[0], i, node);
		float displacement = view->axis_displacement[i];

		shift[i] = lanes_all(2 * displacement);
		if (!still) {
			struct extent late = place_children(&view->ends[1], i, node);

			e.low = lanes_min(e.low, late.low);
			e.high = lanes_max(e.high, late.high);
			shift[i] = lanes_add(shift[i], lanes_abs(lanes_sub(late.middle, e.middle)));
		}
		square = add_gap(square, e.low, e.high, lanes_all(other->centre[i] - other->half[i] - displacement),
				 lanes_all(other->centre[i] + other->half[i] + displacement));
	}
	*lost = lanes_add(second_largest(shift[0], shift[1], shift[2]), lanes_all(view->displacement));
	return square;
}

/* A lower bound of the distance: the root is rounded down, and the displacement subtracted. */
LANES_FUNCTION lanes distance_of(lanes square, float displacement)
{
	return lanes_sub(lanes_mul(lanes_sqrt(square), lanes_all(1 - FLOAT_MARGIN)), lanes_all(displacement));
}

static LANES_TARGET void AT_LEVEL(boxes_apart)(const struct box_motion *motion, int side, const struct bvh_node *node,
					       const struct box *other, float enough, float *apart,
					       float *lost)
{
	const struct box_view *own = &motion->views[side], *others = &motion->views[1 - side];
	lanes own_lost, others_lost;
	lanes a = distance_of(apart_in_own(own, motion->still, node, other, &own_lost), own->displacement);
	lanes b;

	/* Often one view alone excludes the whole node. */
	if (lanes_above(a, lanes_all(enough))) {
		lanes_store(apart, a);
		lanes_store(lost, own_lost);
		return;
	}
	b = distance_of(apart_in_other(others, motion->still, node, other, &others_lost), others->displacement);
	lanes_store(apart, lanes_max(lanes_max(a, b), lanes_all(0)));
	lanes_store(lost, lanes_min(others_lost, own_lost));
}
