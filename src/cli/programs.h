/* programs.h - the NC programs of a run, several at a time, and what they come to. */
#ifndef FIVECHECK_CLI_PROGRAMS_H
#define FIVECHECK_CLI_PROGRAMS_H

#include "cli/inputs.h"
#include "cli/options.h"
#include "cli/voice.h"
#include "report/baseline.h"
#include "report/channel.h"
#include "report/tables.h"
#include "scene/scene.h"

/*
 * Checks the programs that the options name, on as many threads as they allow, and
 * reports in the order in which they were given. `seconds` is what loading took,
 * the files
 * of subprograms are added to the inputs, which are then sorted and complete; the baseline may be NULL, and so may the
 * tables, without which programs are checked one after the other.
 */
enum run_status programs_check(const struct options *options, struct scene *scene, double seconds,
			       struct console *console, struct channels *channels, struct inputs *inputs,
			       const struct baseline *baseline, struct tables *tables);

#endif
