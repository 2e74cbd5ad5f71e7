/* compare.h - fivecheck's verdict held against the truth of samples: whatever neither excuses is a disagreement. */
#ifndef CAMPAIGN_COMPARE_H
#define CAMPAIGN_COMPARE_H

#include <string>
#include <vector>

#include "truth.h"
#include "verdict.h"

struct Terms {
	double tolerance, clearance;	/* mm */
};

struct Comparison {
	std::vector<std::string> disagreements;	/* MISS, LATE, FALSE ALARM, ... with what and where */
	long contacts = 0;	/* blocks and pairs that violate in a sample, all found by fivecheck */
	long between = 0;	/* findings that no sample shows; at their instants the distance is right */
	int first_line = 0;	/* the first block that violates in a sample, or goes beyond the travel; 0: none */
};

/* `all` is the verdict of a run with --all: the first finding of each block and pair. */
Comparison compare(const Machine &machine, const Program &program, const Truth &truth, const Verdict &all,
		   const Terms &terms);

#endif
