#include "motion/limit_report.h"

static bool send_limit(const struct limit_report *report, const struct path *path, double before,
		       const struct limit_crossing *crossing)
{
	const struct canon_move *move = report->move;
	const double since = before + crossing->u * path->seconds;
	const int slot = crossing->slot;
	struct motion_event event = {.kind = MOTION_LIMIT};

	event.of.limit = (struct motion_limit){
	    .travel = {
		.slot = slot,
		.bound = crossing->bound,
		.target = report->legs[report->leg_count - 1].span.q1.v[slot],
		.excess = crossing->excess,
		.path_tolerance = crossing->room,
		.work_offset = move->machine_coordinates ? NULL : move->origin->work_offset,
		.work = move->origin->work.v[slot],
		.shift = move->origin->shift.v[slot],
		.length_acts = slot == SLOT_Z || (move->tcp && !slot_is_rotary(slot)),
		.length = move->origin->length,
	    },
	    .position = path_position(path, crossing->u), .time = report->time + since,
	    .block_time = report->block_time + since, .file = move->file,
	    .line = move->line, .move = move->number, .tool = report->tool};
	return report->sink->event(report->sink->context, &event);
}

bool limit_report_legs(const struct limit_report *report, const axis_values *room, bool reported[SLOT_COUNT])
{
	struct limit_crossing crossings[SLOT_COUNT];
	const size_t count = limits_crossed(report->machine, report->legs, report->leg_count, room, crossings);

	for (size_t i = 0; i < count; i++) {
		double before = 0;

		for (size_t k = 0; k < crossings[i].leg; k++)
			before += report->legs[k].path.seconds;
		reported[crossings[i].slot] = true;
		if (!send_limit(report, &report->legs[crossings[i].leg].path, before, &crossings[i]))
			return false;
	}
	return true;
}

bool limit_report_guided(const struct limit_report *report, const struct leg *guided, const axis_values *swing,
			 bool reported[SLOT_COUNT])
{
	struct limit_crossing crossings[SLOT_COUNT];
	const size_t count = limits_crossed(report->machine, guided, 1, NULL, crossings);

	for (size_t i = 0; i < count; i++) {
		const int slot = crossings[i].slot;

		crossings[i].room = swing->v[slot];
		if (reported[slot])
			continue;
		reported[slot] = true;
		if (!send_limit(report, &guided->path, 0, &crossings[i]))
			return false;
	}
	return true;
}
