/* verdict.h - the verdict of fivecheck on a program. */
#ifndef CAMPAIGN_VERDICT_H
#define CAMPAIGN_VERDICT_H

#include <string>
#include <vector>

#include "machine.h"

struct Finding {
	std::string kind, a, b, axis, text;
	int line;
	double fraction;
	Position at;
};

struct Verdict {
	int status = -1;	/* 128 and more: a signal; 124: it took too long */
	std::vector<Finding> findings;
	std::string rows;	/* of the findings, as they were printed */
	std::string errors;	/* the messages on standard error */
};

/* Runs fivecheck in the folder on m.xml, s.xml if there is a setup, and p.nc. Throws std::runtime_error. */
Verdict ask_fivecheck(const std::string &fivecheck, const std::string &folder, const Machine &machine,
		      const std::vector<std::string> &options);

#endif
