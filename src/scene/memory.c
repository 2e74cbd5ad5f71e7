#include "scene/memory.h"

#include <math.h>

#include "base/ablation.h"
#include "base/extremes.h"

/* Unit vectors closer than this are one axis. */
#define SAME_AXIS 1e-3

static void put_first(struct memory *memory, struct memory_axis axis)
{
	int last = memory->axis_count < MEMORY_AXES ? memory->axis_count++ : MEMORY_AXES - 1;

	for (int i = last; i > 0; i--)
		memory->axes[i] = memory->axes[i - 1];
	memory->axes[0] = axis;
}

static void learn_in(struct memory *memory, vec3 n, int frame)
{
	for (int i = 0; i < memory->axis_count; i++) {
		struct memory_axis *known = &memory->axes[i];

		if (known->frame == frame && vec3_norm2(vec3_sub(known->n, n)) < SAME_AXIS * SAME_AXIS) {
			known->n = n;
			memory_prefer(memory, i);
			return;
		}
	}
	put_first(memory, (struct memory_axis){n, frame});
}

void memory_learn(struct memory *memory, vec3 n, const xform *pose)
{
	if (!WITH_CACHED_AXES)
		return;
	learn_in(memory, mat3_apply_transposed(&pose->rotation, n), 1);
	learn_in(memory, n, 0);
}

void memory_prefer(struct memory *memory, int axis)
{
	struct memory_axis first = memory->axes[axis];

	for (; axis > 0; axis--)
		memory->axes[axis] = memory->axes[axis - 1];
	memory->axes[0] = first;
}

/* The axis in a's mesh coordinates at a pose. */
static vec3 axis_at(const struct memory_axis *axis, const xform *pose)
{
	return axis->frame ? mat3_apply(&pose->rotation, axis->n) : axis->n;
}

/* The extent of a box, |n| . half. */
static double extent(vec3 n, const struct box *box)
{
	return fabs(n.x) * box->half[0] + fabs(n.y) * box->half[1] + fabs(n.z) * box->half[2];
}

static vec3 centre_of(const struct bvh *bvh, const struct box *box)
{
	return (vec3){bvh->origin.x + box->centre[0], bvh->origin.y + box->centre[1], bvh->origin.z + box->centre[2]};
}

/* The gap along n (a's mesh coordinates) between a's box and b's at a pose. */
static double box_gap(const struct body_pair *pair, const xform *pose, vec3 n, const struct box *a,
		      const struct box *b)
{
	vec3 to = vec3_sub(xform_apply(pose, centre_of(pair->b, b)), centre_of(pair->a, a));

	return vec3_dot(n, to) - extent(n, a) - extent(mat3_apply_transposed(&pose->rotation, n), b);
}

bool memory_parts_triangles(struct memory *memory, const struct region *region, const tri *a, const tri *b0,
			    const tri *b1, double clearance)
{
	for (int i = 0; i < memory->axis_count; i++) {
		const struct memory_axis *axis = &memory->axes[i];
		double apart = clearance + region->stray[axis->frame];

		if (tri_gap(a, b0, axis_at(axis, &region->poses[0])) > apart &&
		    tri_gap(a, b1, axis_at(axis, &region->poses[1])) > apart) {
			memory_prefer(memory, i);
			return true;
		}
	}
	return false;
}

double memory_gap(struct memory *memory, const xform *pose, const struct body_pair *pair, const struct box *a,
		  const struct box *b)
{
	double best = -INFINITY;

	for (int i = 0; i < memory->axis_count; i++)
		best = larger(best, box_gap(pair, pose, axis_at(&memory->axes[i], pose), a, b));
	return best;
}
