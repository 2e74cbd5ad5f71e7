/* check.h - checks a program on a scene and reports what comes too close, in the order of time. */
#ifndef FIVECHECK_CHECK_CHECK_H
#define FIVECHECK_CHECK_CHECK_H

#include <stdio.h>

#include "base/diag.h"
#include "check/options.h"
#include "check/sink.h"
#include "check/stats.h"
#include "scene/scene.h"

enum check_result {
	CHECK_CLEAR,	/* everything was checked, nothing found */
	CHECK_FOUND,	/* at least one finding */
	CHECK_INCOMPLETE	/* a fault was reported to diag: not everything was checked */
};

/*
 * Checks one program. Without options->all it stops at the first finding. Statistics are always filled in. If proven is
 * not NULL, proven[i] receives the smallest clearance in mm that was proved for pair i of the scene over the whole
 * program (INFINITY: the pair was never checked); this takes more time.
 */
enum check_result check_run(struct scene *scene, const struct check_options *options, FILE *in, const char *name,
			    const struct check_sink *sink, struct diag *diag, struct check_stats *stats,
			    double *proven);

#endif
