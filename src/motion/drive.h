/* drive.h - the canon_sink behind motion_run: makes steps of canonical moves, watches the limits, keeps the clock. */
#ifndef FIVECHECK_MOTION_DRIVE_H
#define FIVECHECK_MOTION_DRIVE_H

#include <stdbool.h>

#include "gcode/canon.h"
#include "gcode/kinematics.h"
#include "motion/motion.h"

/* Plain data; owns nothing. */
struct drive {
	const struct machine *machine;
	const struct motion_options *options;
	const struct motion_sink *sink;
	struct diag *diag;
	const char *name;	/* of the program, for messages */
	axis_values position;	/* of the machine's axes */
	axis_values controller;	/* the same place as the last move's end named it */
	bool controller_guided;	/* `controller` is meant under TCP */
	struct tcp tcp;	/* meaningful while tcp.state.on */
	int tool;
	double time, block_time;
	struct motion_event event;	/* the last one told; its summary is the run's, whose lines are not counted here */
};

/* Stands at home with the setup's first tool. All pointers are borrowed; setup may be NULL. */
void drive_init(struct drive *drive, const struct machine *machine, const struct setup *setup,
		const struct motion_options *options, const struct motion_sink *sink, struct diag *diag,
		const char *name);

/* The callback of a canon_sink whose context is a struct drive. */
bool drive_event(void *context, const struct canon_event *event);

/* The machine's kinematics; `drive` is its context. */
struct kinematics drive_kinematics(struct drive *drive);

#endif
