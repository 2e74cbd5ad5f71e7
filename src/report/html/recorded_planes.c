#include "report/html/recorded_planes.h"

#include <stdlib.h>

#include "base/mem.h"
#include "report/html/record_scales.h"

/* The triangles beside a plane are the nearest ones to within this share: the exact ones cost several times as much. */
#define PLANE_SHARE 0.8

/* Removes every second one of the wishes at regular intervals. */
static void thin(struct recorded_planes *planes)
{
	size_t kept = 0, turn = 0;

	for (size_t i = 0; i < planes->wish_count; i++) {
		if (planes->wishes[i].forced || turn++ % 2 == 0)
			planes->wishes[kept++] = planes->wishes[i];
	}
	planes->wish_count = kept;
	planes->stride *= 2;
}

bool recorded_planes_has_room(const struct recorded_planes *planes)
{
	return planes->forced_count < PLANES_MAX;
}

void recorded_planes_add(struct recorded_planes *planes, const struct plane_wish *wish)
{
	if (planes->wish_count - planes->forced_count >= PLANES_MAX)
		thin(planes);
	planes->wishes =
	    mem_grow(planes->wishes, &planes->wish_capacity, planes->wish_count + 1, sizeof(*planes->wishes));
	planes->wishes[planes->wish_count++] = *wish;
	planes->forced_count += wish->forced;
}

static void make_plane(struct recorded_planes *planes, struct scene *scene, struct sweep *sweep,
		       const struct plane_wish *wish)
{
	const struct scene_pair *pair = &scene->pairs[wish->pair];
	const struct body_pair bodies = scene_pair_bodies(scene, pair);
	const xform *placement = &scene->bodies[pair->a].body->placement;
	struct nearest_triangles nearest;
	vec3 middle, normal;
	int64_t *row;

	sweep_nearest_triangles(sweep, &bodies, &wish->axes, PLANE_SHARE, &nearest);
	if (!(nearest.distance > RECORD_NORMAL))
		return;
	middle = xform_apply(placement, vec3_lerp(nearest.on_a, nearest.on_b, 0.5));
	normal = mat3_apply(&placement->rotation,
			    vec3_scale(1 / nearest.distance, vec3_sub(nearest.on_b, nearest.on_a)));
	row = planes->rows[planes->count++];
	row[PLANE_TIME] = record_whole(wish->time, RECORD_TIME);
	row[PLANE_PAIR] = (int64_t)wish->pair;
	row[PLANE_POINT] = record_whole(middle.x, RECORD_LENGTH);
	row[PLANE_POINT + 1] = record_whole(middle.y, RECORD_LENGTH);
	row[PLANE_POINT + 2] = record_whole(middle.z, RECORD_LENGTH);
	row[PLANE_NORMAL] = record_whole(normal.x, RECORD_NORMAL);
	row[PLANE_NORMAL + 1] = record_whole(normal.y, RECORD_NORMAL);
	row[PLANE_NORMAL + 2] = record_whole(normal.z, RECORD_NORMAL);
	row[PLANE_DISTANCE] = record_whole(nearest.distance, RECORD_CLEARANCE);
}

void recorded_planes_make(struct recorded_planes *planes, struct scene *scene, struct sweep *sweep)
{
	planes->rows = mem_alloc((planes->wish_count + 1) * sizeof(*planes->rows));
	for (size_t i = 0; i < planes->wish_count; i++)
		make_plane(planes, scene, sweep, &planes->wishes[i]);
}

void recorded_planes_release(struct recorded_planes *planes)
{
	free(planes->wishes);
	free(planes->rows);
}
