/* check.h - runs a program on a scene and finds what comes too close, first in time. */
#ifndef FIVECHECK_CHECK_CHECK_H
#define FIVECHECK_CHECK_CHECK_H

#include <stdbool.h>
#include <stdio.h>

#include "base/diag.h"
#include "base/watch.h"
#include "check/finding.h"
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
	bool block_delete;
	bool last_duplicate_wins;
	const char *const *includes;	/* folders of subprogram files, after the program's own */
	size_t include_count;
	const char *input_root;	/* or NULL: files of subprograms must be in this folder */
	const struct watch *watch;	/* is told which files of subprograms are opened; or NULL */
	int max_blocks;	/* of loops and subprograms; 0: a default that ends endless loops */
	int threads;	/* >= 1 */
	int shard, shards;	/* check the shard-th, from 1, of so many parts of the blocks; shards 0: all blocks */
};

struct check_stats {
	struct motion_summary motion;
	long blocks_checked;	/* of the shard; else all */
	long findings;
	size_t pairs_required, pairs_excused, pairs_skipped;	/* checked; adjacent; rigid, out of reach, waived */
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
