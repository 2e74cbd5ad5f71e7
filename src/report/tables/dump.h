/* dump.h - the path of the axes through a program, one row per span (--dump-path). */
#ifndef FIVECHECK_REPORT_TABLES_DUMP_H
#define FIVECHECK_REPORT_TABLES_DUMP_H

#include <stdbool.h>
#include <stdio.h>

#include "base/diag.h"
#include "machine/machine.h"
#include "machine/setup.h"
#include "motion/motion.h"
#include "report/output.h"

/*
 * Runs the program and writes a tab separated table of its spans with a header. Columns: line, move, tool; the axes of
 * the machine in the order X Y Z A B C U V W at the end of the span (mm and degrees); time at the end of the span (s,
 * dwells included); deviation (mm: an upper bound on the distance of any linear axis from the true path). Warns when
 * the path first leaves the travel of an axis. False: an error was reported, or the output cannot be written.
 */
bool dump_path(struct output *out, const struct machine *machine, const struct setup *setup,
	       const struct motion_options *options, FILE *in, const char *name, struct diag *diag);

#endif
