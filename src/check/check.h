/* check.h - runs a program on a scene and finds what comes too close, first in time. */
#ifndef FIVECHECK_CHECK_CHECK_H
#define FIVECHECK_CHECK_CHECK_H

#include <stdbool.h>
#include <stdio.h>

#include "base/diag.h"
#include "check/finding.h"
#include "gcode/read_options.h"
#include "motion/motion.h"
#include "scene/scene.h"

enum check_method {
	CHECK_CERTIFIED,	/* proof in continuous time */
	CHECK_INTERPOLATED,	/* the paper's: axes interpolated between a motion's ends; unsafe between samples */
	CHECK_CONVENTIONAL,	/* samples, axes computed anew at each; unsafe between samples */
	CHECK_NOTHING	/* interpret and watch the limits only (--parse-only) */
};

struct check_options {
	enum check_method method;
	double step;	/* s between samples of the two sampled methods */
	double tolerance;	/* mm: e of the verdict contract */
	bool all;	/* go on after the first finding: the first per block and pair */
	/* How the program is read. Its cancel also breaks off in the middle of a batch, of which nothing is told then. */
	struct read_options read;
	int threads;	/* >= 1 */
	bool gauges;	/* measures what clearance remains in each block, which takes more time */
	double gauge_cap;	/* mm: and no more than this of it */
	bool times;	/* checks each block by itself and takes its time, which takes more of it */
	double measure_cap;	/* mm: more than this, above its clearance, is not looked for in a pair; 0: no cap */
	const struct setup_change *change;	/* the setup is checked as if it were changed so; or NULL */
	struct course *course;	/* records the way that the program takes, or compares it; or NULL */
	int shard, shards;	/* check the shard-th, from 1, of so many parts of the blocks; shards 0: all blocks */
};

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
	double interpret, check;	/* s of wall time; with `times` */
	const struct check_room *rooms;	/* in the order of the pairs; with `gauges` */
	size_t room_count;
};

struct check_stats {
	struct motion_summary motion;
	long blocks_checked;	/* of the shard; else all */
	long findings;
	size_t pairs_required, pairs_excused, pairs_skipped;	/* checked; adjacent; rigid, out of reach, waived */
	size_t pairs_unknown;	/* apart as surfaces, but one body may have been inside the other */
	size_t first_unknown;	/* the first of those pairs of the scene */
	long budgets;	/* steps of pairs passed on a proven distance alone */
	long queries;	/* distance queries */
	long certificates;	/* node and triangle pairs certified over an interval */
	long bisections;	/* intervals halved */
	long samples;	/* poses evaluated by the sampled methods */
	double seconds_interpret, seconds_check;	/* wall time */
};

struct check_sink {
	void *context;
	/* False: stop. Findings come in the order of time. */
	bool (*finding)(void *context, const struct finding *finding);
	/* Now and then: how far the program is. False: break off, which is a fault of its own. May be NULL. */
	bool (*progress)(void *context, long lines);
	/* Each block up to the one that ended the check, in order. NULL without `gauges` and `times`. */
	void (*block)(void *context, const struct check_block *block);
};

enum check_result {
	CHECK_CLEAR,	/* everything was checked, nothing found */
	CHECK_FOUND,	/* at least one finding */
	CHECK_INCOMPLETE	/* a fault was reported to diag: not everything was checked */
};

/*
 * Of a program that is shared out, each shard interprets everything and checks every shards-th
 * run of SHARE_BLOCKS blocks: each block, with its limits and what stands in it, is
 * checked by exactly one shard. Together they find what one run with `all` finds.
 */
enum { SHARE_BLOCKS = 1024 };

/*
 * Checks one program. Without `all` it stops at the first finding. Statistics
 * are filled in whatever the result. proven[i], if not NULL (it takes more time), receives for
 * each of the scene's pairs the smallest clearance in mm that was proven over
 * the program (INFINITY: never looked at).
 */
enum check_result check_run(struct scene *scene, const struct check_options *options, FILE *in, const char *name,
			    const struct check_sink *sink, struct diag *diag, struct check_stats *stats,
			    double *proven);

#endif
