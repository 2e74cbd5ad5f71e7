/* github.h - findings as workflow commands, which GitHub shows beside the lines of a pull request. */
#ifndef FIVECHECK_REPORT_WRITERS_GITHUB_H
#define FIVECHECK_REPORT_WRITERS_GITHUB_H

#include "report/report.h"

/*
 * A line "::error file=...,line=...,col=...,title=...::text" for each finding
 * and each fault, ten at most, which is what GitHub shows of a step (GitHub,
 * "Workflow commands for GitHub Actions"); then how many more there are.
 */
extern const struct report_writer github_writer;

#endif
