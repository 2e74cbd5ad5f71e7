/* options.h - the options of a check. */
#ifndef FIVECHECK_CHECK_OPTIONS_H
#define FIVECHECK_CHECK_OPTIONS_H

#include <stdbool.h>

#include "gcode/read_options.h"

struct motion_sink;
struct setup_change;
struct spare_threads;
struct path_record;
struct stock_remainder;
struct stock_view;

enum check_method {
	CHECK_CERTIFIED,	/* proof in continuous time */
	CHECK_INTERPOLATED,	/* samples; axes interpolated between the ends of a motion; unsafe between samples */
	CHECK_CONVENTIONAL,	/* samples; axes computed anew at each; unsafe between samples */
	CHECK_NOTHING	/* interpret the program and check axis limits only (--parse-only) */
};

/* About four minutes on a processor of 2020. Steps of real programs take a thousandth of that. */
#define CHECK_EFFORT 1000000000L

/*
 * A share of a program is this many blocks, or more, up to one that moves an axis. Shards of one program take turns:
 * after each share the next shard checks.
 */
enum { SHARE_BLOCKS = 1024 };

struct check_options {
	enum check_method method;
	double step;	/* s between samples of the two sampled methods */
	double tolerance;	/* mm: e of the verdict contract */
	double stock_tolerance;	/* mm: the tolerance of the remaining stock; 0: STOCK_TOLERANCE */
	bool all;	/* report the first finding of each pair in each block; false: stop at the first */
	/* read.cancel is asked during a batch, too. If a batch is interrupted, none of its findings is reported. */
	struct read_options read;
	long effort;	/* the most node pairs examined for one pair in one step; 0: CHECK_EFFORT */
	int threads;	/* >= 1 */
	struct spare_threads *spare;	/* threads that other programs have released, to borrow; or NULL */
	bool block_clearances;	/* measure the clearance in each block; the check takes longer */
	double block_clearance_cap;	/* mm: larger clearances are reported as this value */
	/*
	 * Report only the smallest clearance of each block, and only below the cap. It is measured less exactly, and in
	 * a long program only for some blocks; for the others it is the value proved for all blocks so far.
	 */
	bool least_clearances;
	bool times;	/* check each block by itself and measure its time; the check takes longer */
	double measure_cap;	/* mm: measure the smallest clearance up to the required one plus this; 0: no cap */
	const struct setup_change *change;	/* check with the setup changed like this; or NULL */
	/* receives every event before it is checked; its answer is ignored; or NULL */
	const struct motion_sink *watch;
	struct path_record *record;	/* records the path of the program, or compares it with a record; or NULL */
	struct stock_remainder *remainder;	/* all 0 before; receives the remaining stock; or NULL */
	struct stock_view *stock_view;	/* receives the stock at a given time, also after a finding; or NULL */
	/*
	 * Check only part number `shard`, from 1, of `shards` parts of the blocks; shards 0: all blocks. Each shard
	 * interprets the whole program, and each block is checked by exactly one shard. Together the shards find what
	 * one run with `all` finds.
	 */
	int shard, shards;
};

#endif
