/* read_ahead.h - motion_run in two threads: one reads the program while the other works on what was read. */
#ifndef FIVECHECK_CHECK_READ_AHEAD_H
#define FIVECHECK_CHECK_READ_AHEAD_H

#include <stdbool.h>
#include <stdio.h>

#include "check/shared_loop.h"
#include "motion/motion.h"

/*
 * The same as motion_run, event for event. But until read_ahead_run returns another thread calls the sink, diag and
 * options->read.opened, while the calling thread reads a few thousand events ahead. *summary is filled in unless the
 * sink stops. If the calling thread waits for input, it notices only with the next input that the sink has stopped.
 * options->names is required. When the calling thread has read far enough ahead, and after the end of the program, it
 * helps with the loops that the other thread runs (shared_loop_run). If no thread can be started, this is motion_run.
 */
bool read_ahead_run(const struct machine *machine, const struct setup *setup, const struct motion_options *options,
		    FILE *in, const char *name, const struct motion_sink *sink, struct diag *diag,
		    struct motion_summary *summary, struct shared_loop *loop);

#endif
