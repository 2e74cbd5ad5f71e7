#include "stock/cell_part.h"

static void add_point(struct cell_part *part, vec3 point)
{
	if (!part->count)
		part->low = part->high = point;
	part->low = vec3_min(part->low, point);
	part->high = vec3_max(part->high, point);
	part->middle = vec3_add(part->middle, point);
	part->points[part->count++] = point;
}

void cell_part_init(struct cell_part *part, vec3 centre, vec3 half, const struct half_space *space)
{
	vec3 corners[8];
	double beyond[8];	/* mm: below 0 inside the half-space */

	*part = (struct cell_part){.count = 0};
	for (int i = 0; i < 8; i++) {
		const vec3 off = {i & 1 ? half.x : -half.x, i & 2 ? half.y : -half.y, i & 4 ? half.z : -half.z};

		corners[i] = vec3_add(centre, off);
		beyond[i] = vec3_dot(space->normal, off) - space->offset;
		if (beyond[i] <= 0)
			add_point(part, corners[i]);
	}
	for (int i = 0; i < 8; i++)
		for (int bit = 1; bit < 8; bit *= 2) {
			const int k = i | bit;

			if (k != i && (beyond[i] <= 0) != (beyond[k] <= 0))
				add_point(part, vec3_lerp(corners[i], corners[k], beyond[i] / (beyond[i] - beyond[k])));
		}
	if (part->count)
		part->middle = vec3_scale(1.0 / part->count, part->middle);
}
