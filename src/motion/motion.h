/* motion.h - runs a program: turns the interpreter's moves into spans, checks the axis limits, and keeps the time. */
#ifndef FIVECHECK_MOTION_MOTION_H
#define FIVECHECK_MOTION_MOTION_H

#include <stdbool.h>
#include <stdio.h>

#include "base/diag.h"
#include "base/file_names.h"
#include "gcode/read_options.h"
#include "machine/machine.h"
#include "machine/setup.h"
#include "motion/events.h"

/* An assumed error of the setup: mm, added to the control's values. */
struct setup_change {
	vec3 work;	/* every work offset, X Y Z */
	double length;	/* of every tool's length offset; the tool's body stays */
};

struct motion_options {
	double flatness;	/* mm: no axis of a step's chord deviates by more */
	struct read_options read;
	struct file_names *names;	/* holds the events' file names; NULL: they live as long as the run */
	const struct setup_change *change;	/* or NULL */
	bool modes;	/* send MOTION_MODES */
	bool counts_steps;	/* send no MOTION_STEP: the summary counts them */
};

/*
 * Runs the program from home to its end; setup may be NULL. Memory does not grow with the program. False: a fault was
 * reported to diag, or the sink stopped. In either case *summary has the totals of the run. While an event is sent, it
 * has the totals so far, and its `lines` counts to the last complete block.
 */
bool motion_run(const struct machine *machine, const struct setup *setup, const struct motion_options *options,
		FILE *in, const char *name, const struct motion_sink *sink, struct diag *diag,
		struct motion_summary *summary);

#endif
