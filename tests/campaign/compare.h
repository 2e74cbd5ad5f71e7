/*
 * compare.h - compares fivecheck's verdict with the truth of samples: a difference that neither explains is a
 * disagreement.
 */
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
	std::vector<std::string> disagreements;	/* MISS, LATE, FALSE ALARM, ... with the bodies and the place */
	long contacts = 0;	/* blocks and pairs that are violated in a sample; fivecheck has found all of them */
	long between = 0;	/* findings that no sample shows, but whose distance is right */
	int first_line = 0;	/* the first block that is violated in a sample, or leaves the travel; 0: none */
};

/* `all` is the verdict of a run with --all, which has the first finding of each block and pair. */
Comparison compare(const Machine &machine, const Program &program, const Truth &truth, const Verdict &all,
		   const Terms &terms);

#endif
