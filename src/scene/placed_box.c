#include "scene/placed_box.h"

#include <math.h>

struct placed_box placed_box_empty(void)
{
	return (struct placed_box){{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
}

struct placed_box placed_box_union(struct placed_box a, struct placed_box b)
{
	return (struct placed_box){vec3_min(a.least, b.least), vec3_max(a.greatest, b.greatest)};
}

struct placed_box placed_box_of(const struct scene *scene, int body)
{
	const struct bvh *bvh = scene->bodies[body].bvh;
	struct placed_box box = placed_box_empty();

	for (int k = 0; k < 8; k++) {
		vec3 corner = {k & 1 ? bvh->half.x : -bvh->half.x, k & 2 ? bvh->half.y : -bvh->half.y,
			       k & 4 ? bvh->half.z : -bvh->half.z};

		corner = xform_apply(&scene->bodies[body].body->placement, vec3_add(bvh->origin, corner));
		box = placed_box_union(box, (struct placed_box){corner, corner});
	}
	return box;
}

double placed_box_size(struct placed_box box)
{
	vec3 size = vec3_sub(box.greatest, box.least);

	return fmax(size.x, fmax(size.y, size.z));
}

double placed_box_distance(struct placed_box box, vec3 p)
{
	vec3 nearest = vec3_max(box.least, vec3_min(p, box.greatest));

	return vec3_norm(vec3_sub(p, nearest));
}

double placed_box_overlap(struct placed_box a, struct placed_box b)
{
	vec3 over = vec3_sub(vec3_min(a.greatest, b.greatest), vec3_max(a.least, b.least));

	return fmin(over.x, fmin(over.y, over.z));
}
