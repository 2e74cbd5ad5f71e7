#include "motion/motion_modes.h"

#include <stddef.h>

#include "base/same_double.h"

struct motion_modes motion_modes_of(const struct canon_move *move)
{
	const struct canon_origin *origin = move->origin;

	return (struct motion_modes){
		.work_offset = move->machine_coordinates ? NULL : origin->work_offset,
		.work = origin->work,
		.shift = origin->shift,
		.length = origin->length,
		.tcp = move->tcp,
		.turned = origin->turned,
		.feed = move->kind == CANON_RAPID ? 0 : move->feed.linear,
		.spindle_speed = move->spindle_speed,
	};
}

bool motion_modes_same(const struct motion_modes *a, const struct motion_modes *b)
{
	return a->work_offset == b->work_offset && axis_values_same(&a->work, &b->work) &&
	       axis_values_same(&a->shift, &b->shift) && same_double(a->length, b->length) &&
	       a->tcp == b->tcp && a->turned == b->turned &&
	       same_double(a->feed, b->feed) && same_double(a->spindle_speed, b->spindle_speed);
}
