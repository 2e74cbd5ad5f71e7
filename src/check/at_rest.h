/* at_rest.h - checks positions where the axes are at rest. */
#ifndef FIVECHECK_CHECK_AT_REST_H
#define FIVECHECK_CHECK_AT_REST_H

#include "check/checker.h"

/* Checks the pairs at the current position, with the axes at rest. tool_only: only the pairs of the tool. */
void checker_at_rest(struct checker *c, bool tool_only, int move);

/* Checks at the current position the cutters that may be in the part only while they cut. */
void checker_spindle_stops(struct checker *c, int move);

#endif
