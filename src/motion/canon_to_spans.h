/* canon_to_spans.h - turns canonical moves into spans, checks the axis limits, and keeps the time. */
#ifndef FIVECHECK_MOTION_CANON_TO_SPANS_H
#define FIVECHECK_MOTION_CANON_TO_SPANS_H

#include <stdbool.h>

#include "gcode/canon.h"
#include "machine/machine.h"
#include "machine/setup.h"
#include "motion/axis_table.h"
#include "motion/blend.h"
#include "motion/cutter_hand.h"
#include "motion/events.h"
#include "motion/length_check.h"
#include "motion/tcp.h"

/* Plain data; owns nothing. */
struct canon_to_spans {
	const struct machine *machine;
	struct axis_table axes;	/* of the machine */
	const struct setup *setup;	/* or NULL */
	double flatness;	/* mm: no axis of a span's chord deviates by more */
	const struct motion_sink *sink;
	struct diag *diag;
	const char *name;	/* of the program, for messages */
	axis_values position;	/* of the machine's axes */
	axis_values controller;	/* the same position as the controller sees it: the end of the last move */
	bool inside;	/* the position is known to be inside the axis limits */
	bool controller_guided;	/* `controller` is a position under TCP */
	struct tcp tcp;	/* valid while tcp.state.on */
	int tool;
	bool probes;	/* the tool is a probe */
	struct cutter_hand hand;	/* of the tool */
	struct length_check length;	/* of the tool */
	struct blend blend;	/* of the last move */
	double time, block_time;
	bool tells_steps, tells_modes;
	struct motion_modes modes;	/* the last ones sent */
	bool modes_told;
	struct motion_summary *summary;	/* the caller's: the totals so far; `lines` to the last complete block */
	struct motion_event event;	/* storage for events */
};

/*
 * Begins at home with the setup's first tool, and with a summary of zeros. All pointers are borrowed, and the machine
 * must not change; setup may be NULL.
 */
void canon_to_spans_init(struct canon_to_spans *converter, const struct machine *machine, const struct setup *setup,
			 double flatness, const struct motion_sink *sink, struct diag *diag, const char *name,
			 struct motion_summary *summary);

/* The callback of a canon_sink whose context is a struct canon_to_spans. */
bool canon_to_spans_event(void *context, const struct canon_event *event);

#endif
