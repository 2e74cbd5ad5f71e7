/* sink.h - the callbacks that receive the results of a check while it runs. */
#ifndef FIVECHECK_CHECK_SINK_H
#define FIVECHECK_CHECK_SINK_H

#include <stdbool.h>
#include <stddef.h>

#include "check/finding.h"

/* The clearance of a pair in a block. */
struct pair_clearance {
	size_t pair;	/* of the scene */
	double clearance;	/* mm: proven; at most the cap (check_options.block_clearance_cap) */
	bool capped;
	/* with check_options.least_clearances: not measured in this block, but proved for all blocks up to here */
	bool so_far;
};

/* A block that was checked. Valid only during the call that hands it over. */
struct check_block {
	const char *file;
	long line;
	long number;	/* number among the executed blocks, from 1 */
	double seconds;	/* of motion, dwells excluded */
	long steps;	/* number of straight pieces that were checked */
	double interpret, check;	/* s of wall time; with check_options.times */
	/* in the order of the pairs; with check_options.block_clearances */
	const struct pair_clearance *clearances;
	size_t clearance_count;
};

struct check_sink {
	void *context;
	/* False: stop. Findings come in the order of time. */
	bool (*finding)(void *context, const struct finding *finding);
	/*
	 * Called now and then with the number of lines read so far. False: stop after the present batch; the check is
	 * then incomplete, and this is reported. During a long batch it is called again with the same line, from any
	 * thread, but never by two threads at a time. May be NULL.
	 */
	bool (*progress)(void *context, long lines);
	/*
	 * Receives each block up to the one that ended the check, in order. NULL without `block_clearances` and
	 * `times`.
	 */
	void (*block)(void *context, const struct check_block *block);
};

#endif
