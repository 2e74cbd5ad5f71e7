/* stats.h - statistics about the work and the time of a run. */
#ifndef FIVECHECK_REPORT_TABLES_STATS_H
#define FIVECHECK_REPORT_TABLES_STATS_H

#include <stdbool.h>
#include <stddef.h>

#include "base/strbuf.h"
#include "check/check.h"
#include "scene/scene.h"

/* Sums over the programs of a run; all zero at the start. */
struct run_stats {
	size_t programs;
	size_t clear, incomplete, accepted;	/* programs; accepted: with findings that do not fail the run */
	long waived;	/* findings */
	size_t pairs_required;	/* of the program that has the most */
	struct check_stats check;
	double seconds_load;	/* for machine, setup, meshes and pairs */
	double seconds_wall, seconds_processor;	/* of the whole process, all threads */
};

/* Adds a program: counts and times are summed; the pairs are the scene's. */
void stats_sum(struct run_stats *sums, const struct check_stats *stats, enum check_result result,
	       bool accepted);

/*
 * Appends one line: blocks, pairs, times and the rate. If the processor was busy with other work for more than a
 * quarter of the time, the line gives the time that it had for this process.
 */
void stats_add_line(struct strbuf *out, const struct run_stats *sums, enum check_method method);

/* Appends the whole table. */
void stats_add(struct strbuf *out, const struct run_stats *sums, struct scene *scene, enum check_method method);

#endif
