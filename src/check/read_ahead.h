/* relay.h - motion_run with the program read by one thread, while another hears what it says. */
#ifndef FIVECHECK_CHECK_RELAY_H
#define FIVECHECK_CHECK_RELAY_H

#include <stdbool.h>
#include <stdio.h>

#include "motion/motion.h"

/*
 * As motion_run, call for call, but the sink, diag and options->watch are called from a thread of their own, until
 * relay_run returns; the reader is a few thousand steps ahead of them. A reader that waits for input notices that the
 * sink has stopped when input comes. Where no thread is to be had it is motion_run.
 */
bool relay_run(const struct machine *machine, const struct setup *setup, const struct motion_options *options,
	       FILE *in, const char *name, const struct motion_sink *sink, struct diag *diag,
	       struct motion_summary *summary);

#endif
