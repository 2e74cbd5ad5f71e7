/*
 * recorded_planes.h - the separating planes that a report shows: between the nearest bodies at the ends of some blocks.
 */
#ifndef FIVECHECK_REPORT_HTML_RECORDED_PLANES_H
#define FIVECHECK_REPORT_HTML_RECORDED_PLANES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/axes.h"
#include "scene/scene.h"
#include "scene/sweep.h"

/* The columns of a row; the scales are in record_scales.h. */
enum {
	PLANE_TIME,
	PLANE_PAIR,
	PLANE_POINT,
	PLANE_NORMAL = PLANE_POINT + 3,
	PLANE_DISTANCE = PLANE_NORMAL + 3,
	PLANE_COLUMNS
};

/* At most this number of planes is kept, and as many again beside findings. */
enum { PLANES_MAX = 64 };

/* A request to show the plane between the bodies of this pair, with the axes at these positions. */
struct plane_wish {
	double time;	/* s */
	axis_values axes;
	size_t pair;
	bool forced;	/* the block is beside a finding */
};

/* In the order of time. Initialise with `stride` 1, else zero. */
struct recorded_planes {
	struct plane_wish *wishes;
	size_t wish_count, wish_capacity, forced_count;
	long stride;	/* a plane is wanted at intervals of this many blocks, and beside findings */
	int64_t (*rows)[PLANE_COLUMNS];	/* made at the end */
	size_t count;
};

/* Is there room for one more block beside a finding? */
bool recorded_planes_has_room(const struct recorded_planes *planes);

void recorded_planes_add(struct recorded_planes *planes, const struct plane_wish *wish);

/* Makes the rows. Most wishes are dropped before: a plane costs an exact distance. */
void recorded_planes_make(struct recorded_planes *planes, struct scene *scene, struct sweep *sweep);

void recorded_planes_release(struct recorded_planes *planes);

#endif
