/* programs.h - the NC programs of a run, several at a time, and what they come to. */
#ifndef FIVECHECK_CLI_PROGRAMS_H
#define FIVECHECK_CLI_PROGRAMS_H

#include "cli/input_files.h"
#include "cli/options.h"
#include "cli/ordered_output.h"
#include "report/baseline.h"
#include "report/sink.h"
#include "report/tables/block_tables.h"
#include "scene/scene.h"

/*
 * Checks the programs that the options name, on as many threads as they allow, and
 * reports in the order in which they were given. `seconds` is what loading took,
 * the files
 * of subprograms are added to the inputs, which are then sorted and complete; the baseline may be NULL, and so may
 * the tables: with them programs are checked one after the other. If a file that is to be written turns out
 * to be an input, that is reported, and the channels are discarded.
 */
enum run_status programs_check(const struct options *options, struct scene *scene, double seconds, struct stderr_ui *ui,
			       struct sinks *sinks, struct input_files *inputs, const struct baseline *baseline,
			       const struct waiver_match *waiving, struct block_tables *tables);

#endif
