/* stats.h - what a check counted. */
#ifndef FIVECHECK_CHECK_STATS_H
#define FIVECHECK_CHECK_STATS_H

#include <stddef.h>

#include "motion/events.h"

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

#endif
