/* stats.h - the counters of a check. */
#ifndef FIVECHECK_CHECK_STATS_H
#define FIVECHECK_CHECK_STATS_H

#include <stddef.h>

#include "check/cutter_approach.h"
#include "motion/events.h"

struct check_stats {
	struct motion_summary motion;
	long blocks_checked;	/* of this shard; all blocks if there is no shard */
	long findings;
	size_t pairs_required, pairs_excused, pairs_skipped;	/* checked; adjacent; rigid, out of reach, waived */
	size_t pairs_unknown;	/* the surfaces stayed apart, but one body may have been inside the other */
	size_t first_unknown;	/* the first of those pairs, as an index of scene->pairs */
	struct far_cutters far_cutters;	/* all 0 unless the program was checked to its end */
	long budgets;	/* steps of pairs proved by a motion budget alone */
	long planes;	/* the same by travelling planes */
	long measured;	/* steps of pairs that were measured as clear, and therefore not checked again */
	long queries;	/* distance queries */
	long certificates;	/* node and triangle pairs proved apart over an interval */
	long bisections;	/* intervals halved */
	long samples;	/* poses evaluated by the sampled methods */
	double seconds_interpret, seconds_check;	/* wall time */
};

#endif
