/* limit_report.h - the events of the axis limits that a move passes, or may pass. */
#ifndef FIVECHECK_MOTION_LIMIT_REPORT_H
#define FIVECHECK_MOTION_LIMIT_REPORT_H

#include "gcode/canon.h"
#include "motion/events.h"
#include "motion/limits.h"

/* A move with its legs. Plain data; owns nothing. */
struct limit_report {
	const struct machine *machine;
	const struct canon_move *move;
	const struct leg *legs;
	size_t leg_count;	/* at least 1 */
	double time, block_time;	/* at the start of the move, s */
	int tool;
	const struct motion_sink *sink;
};

/*
 * Sends a MOTION_LIMIT for each axis that passes a limit, or that may pass one by its room (limits_crossed), and marks
 * its slot. False: the sink wants no more.
 */
bool limit_report_legs(const struct limit_report *report, const axis_values *room, bool reported[SLOT_COUNT]);

/*
 * The same for a rapid that is only known to stay in a box, if the control keeps the tip on a line: the axes then leave
 * the box by up to `swing`. Slots that are marked already are left out.
 */
bool limit_report_guided(const struct limit_report *report, const struct leg *guided, const axis_values *swing,
			 bool reported[SLOT_COUNT]);

#endif
