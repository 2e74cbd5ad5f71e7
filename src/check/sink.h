/* sink.h - what a check tells while it runs. */
#ifndef FIVECHECK_CHECK_SINK_H
#define FIVECHECK_CHECK_SINK_H

#include <stdbool.h>
#include <stddef.h>

#include "check/finding.h"

/* What clearance a pair keeps in a block. */
struct check_room {
	size_t pair;	/* of the scene */
	double clearance;	/* mm: proven; the cap is the most that is told */
	bool capped;
};

/* A block that was checked. Lives during the call that hands it over. */
struct check_block {
	const char *file;
	long line;
	long number;	/* of the blocks carried out, from 1 */
	double seconds;	/* of motion, dwells excluded */
	long steps;	/* straight pieces of it that were checked */
	double interpret, check;	/* s of wall time; with check_options.times */
	const struct check_room *rooms;	/* in the order of the pairs; with check_options.block_clearances */
	size_t room_count;
};

struct check_sink {
	void *context;
	/* False: stop. Findings come in the order of time. */
	bool (*finding)(void *context, const struct finding *finding);
	/*
	 * Now and then: how far the program is. False: break off after the batch under way, which is a fault of its
	 * own. During a long batch it is called again with the same line, from any thread, one at a time. May be NULL.
	 */
	bool (*progress)(void *context, long lines);
	/* Each block up to the one that ended the check, in order. NULL without `gauges` and `times`. */
	void (*block)(void *context, const struct check_block *block);
};

#endif
