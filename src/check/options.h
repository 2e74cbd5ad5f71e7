/* options.h - how a program is to be checked. */
#ifndef FIVECHECK_CHECK_OPTIONS_H
#define FIVECHECK_CHECK_OPTIONS_H

#include <stdbool.h>

#include "gcode/read_options.h"

struct setup_change;
struct path_record;

enum check_method {
	CHECK_CERTIFIED,	/* proof in continuous time */
	CHECK_INTERPOLATED,	/* the paper's: axes interpolated between a motion's ends; unsafe between samples */
	CHECK_CONVENTIONAL,	/* samples, axes computed anew at each; unsafe between samples */
	CHECK_NOTHING	/* interpret and watch the limits only (--parse-only) */
};

/* About four minutes on a processor of 2020: steps of real programs take a thousandth of it. */
#define CHECK_EFFORT 1000000000L

/* Of a program that is shared out, shards take turns in runs of so many blocks. */
enum { SHARE_BLOCKS = 1024 };

struct check_options {
	enum check_method method;
	double step;	/* s between samples of the two sampled methods */
	double tolerance;	/* mm: e of the verdict contract */
	bool all;	/* go on after the first finding: the first per block and pair */
	/* Its cancel is asked in the middle of a batch, too; of a batch that is broken off nothing is told. */
	struct read_options read;
	long effort;	/* node pairs to look at for one step of one pair before the check gives up; 0: CHECK_EFFORT */
	int threads;	/* >= 1 */
	bool block_clearances;	/* measures what clearance remains in each block, which takes more time */
	double block_clearance_cap;	/* mm: and no more than this of it */
	bool times;	/* checks each block by itself and takes its time, which takes more of it */
	double measure_cap;	/* mm: more than this, above its clearance, is not looked for in a pair; 0: no cap */
	const struct setup_change *change;	/* the setup is checked as if it were changed so; or NULL */
	struct path_record *record;	/* records the path of the program, or compares the path with a record; or NULL */
	/*
	 * Checks the shard-th, from 1, of so many parts of the blocks; shards 0: all blocks. Each shard interprets the
	 * whole program. Each block, with its limits and what stands in it, is checked by exactly one shard;
	 * together the shards find what one run with `all` finds.
	 */
	int shard, shards;
};

#endif
