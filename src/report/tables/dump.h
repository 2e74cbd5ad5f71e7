/* dump.h - the path that a program makes the axes take, one span a row (--dump-path). */
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
 * Runs the program and writes its spans, tab separated, a header first: line
 * move tool, the machine's axes in the order X Y Z A B C U V W (at the end of
 * the span, mm and degrees), time (s, at the end of the span, dwells
 * included), deviation (mm: no linear axis of the true path strays farther
 * from the span). The first time that the path leaves an axis' travel is a
 * warning. False: a fault was reported, or the output cannot be written.
 */
bool dump_path(struct output *out, const struct machine *machine, const struct setup *setup,
	       const struct motion_options *options, FILE *in, const char *name, struct diag *diag);

#endif
